// Builds a diagram of many sites in steps, or reads a snapshot, for a thread that must not be busy
// for long: a page stays responsive meanwhile. Result and time are those of the diagram's
// insertMany and fromBytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "apollonius/diagram.h"
#include "apollonius/export.h"

namespace apollonius {

class SphericalDiagram;

/// Builds a Diagram or a SphericalDiagram. First the sites are added, whose ids are 0, 1, 2, … in
/// that order, or the bytes of a snapshot are given; then the work is done.
template <class AnyDiagram>
class APOLLONIUS_EXPORT BuilderOf {
 public:
  /// The diagram must be empty, stay where it is, and not be used until the work is done. It is
  /// empty again if the builder is destroyed before that, or ends with an error. Throws
  /// std::bad_alloc.
  explicit BuilderOf(AnyDiagram& diagram);
  ~BuilderOf();
  BuilderOf(BuilderOf&&) noexcept;

  /// Makes room for this many sites that will be added. Errors: kOutOfMemory, kTooLarge.
  [[nodiscard]] Error reserve(std::size_t count);

  /// Adds triples. Errors: as insertMany of the diagram; kBadLength (no multiple of 3). After an
  /// error none of these has been added. REQUIRES: advance() has not been called.
  [[nodiscard]] Error add(std::span<const double> sites);

  /// Takes the bytes of a snapshot instead, as fromBytes() of the diagram. Errors: kOutOfMemory.
  /// REQUIRES: nothing has been added.
  [[nodiscard]] Error read(std::vector<std::uint8_t> bytes, Source source = Source::kAnyone);

  /// Goes on by about this many steps, each of about a microsecond (three when it reads a snapshot
  /// of the plane without proving it); `isDone` tells whether all is done. Errors: kOutOfMemory,
  /// kCorruptSnapshot; later calls return the same error, whatever memory there is.
  [[nodiscard]] Error advance(std::size_t steps, bool& isDone);

  /// Share of the work that is done, from 0 to 1; never falls.
  [[nodiscard]] double progress() const noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

using Builder = BuilderOf<Diagram>;
using SphericalBuilder = BuilderOf<SphericalDiagram>;

}  // namespace apollonius
