// Building a diagram of many sites in steps, for a thread that must not be busy for long: a page
// goes on to answer while it is built. The same result as insertMany of the diagram, in about the
// time.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "apollonius/diagram.h"
#include "apollonius/export.h"

namespace apollonius {

class SphericalDiagram;

/// Builds a Diagram or a SphericalDiagram. First the sites are added, then the work is done; ids
/// are 0, 1, 2, … in the order of adding.
template <class AnyDiagram>
class APOLLONIUS_EXPORT BuilderOf {
 public:
  /// Of a diagram that is empty, stays where it is, and is left alone until the work is done. It is
  /// empty again if the builder ends before that, or with an error.
  /// Throws std::bad_alloc.
  explicit BuilderOf(AnyDiagram& diagram);
  ~BuilderOf();
  BuilderOf(BuilderOf&&) noexcept;

  /// Room for this many sites that will be added. Errors: kOutOfMemory, kTooLarge.
  [[nodiscard]] Error reserve(std::size_t count);

  /// Adds triples. Errors: as insertMany of the diagram; kBadLength (no multiple of 3): then none
  /// of these has been added. REQUIRES: advance() has not been called.
  [[nodiscard]] Error add(std::span<const double> sites);

  /// Goes on by about this many steps, each of about a microsecond; `isDone` tells whether that was
  /// all. Errors: kOutOfMemory, and then again, whatever memory there is.
  [[nodiscard]] Error advance(std::size_t steps, bool& isDone);

  /// How much of the work is done, from 0 to 1; never falls.
  [[nodiscard]] double progress() const noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

using Builder = BuilderOf<Diagram>;
using SphericalBuilder = BuilderOf<SphericalDiagram>;

}  // namespace apollonius
