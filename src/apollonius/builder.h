// Building a diagram of many sites in steps, for a thread that must not be busy for long: a page
// goes on to answer while it is built. The same result as Diagram::insertMany, in about the time.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "apollonius/diagram.h"
#include "apollonius/export.h"

namespace apollonius {

/// First the circles are added, then the work is done; ids are 0, 1, 2, … in the order of adding.
class APOLLONIUS_EXPORT Builder {
 public:
  /// Of a diagram that is empty, stays where it is, and is left alone until the work is done. It is
  /// empty again if the builder ends before that, or with an error.
  /// Throws std::bad_alloc.
  explicit Builder(Diagram& diagram);
  ~Builder();
  Builder(Builder&&) noexcept;

  /// Room for this many circles that will be added. Errors: kOutOfMemory, kTooLarge.
  [[nodiscard]] Error reserve(std::size_t count);

  /// Adds x, y, r triples. Errors: kNotFinite, kOutOfRange, kBadLength (no multiple of 3),
  /// kTooLarge, kOutOfMemory: then none of these has been added. REQUIRES: advance() has not been
  /// called.
  [[nodiscard]] Error add(std::span<const double> xyr);

  /// Goes on by about this many steps, each of about a microsecond; `isDone` tells whether that was
  /// all. Errors: kOutOfMemory, and then again, whatever memory there is.
  [[nodiscard]] Error advance(std::size_t steps, bool& isDone);

  /// How much of the work is done, from 0 to 1.
  [[nodiscard]] double progress() const noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace apollonius
