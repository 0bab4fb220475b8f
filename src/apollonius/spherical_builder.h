// Building a diagram of many sites of the sphere in steps, for a thread that must not be busy for
// long: as Builder does in the plane. The same result as SphericalDiagram::insertMany, in about the
// time.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "apollonius/export.h"
#include "apollonius/spherical_diagram.h"

namespace apollonius {

/// First the sites are added, then the work is done; ids are 0, 1, 2, … in the order of adding.
class APOLLONIUS_EXPORT SphericalBuilder {
 public:
  /// Of a diagram that is empty, stays where it is, and is left alone until the work is done. It
  /// stays empty if the builder ends before that, or with an error. Throws std::bad_alloc.
  explicit SphericalBuilder(SphericalDiagram& diagram);
  ~SphericalBuilder();
  SphericalBuilder(SphericalBuilder&&) noexcept;

  /// Room for this many sites that will be added. Errors: kOutOfMemory, kTooLarge.
  [[nodiscard]] Error reserve(std::size_t count);

  /// Adds lon, lat, r triples. Errors: as SphericalDiagram::insertMany; kBadLength (no multiple of
  /// 3): then none of these has been added. REQUIRES: advance() has not been called.
  [[nodiscard]] Error add(std::span<const double> sites);

  /// Goes on by about this many steps, each of about a microsecond; `isDone` tells whether that was
  /// all. Errors: kOutOfMemory, and then again, whatever memory there is.
  [[nodiscard]] Error advance(std::size_t steps, bool& isDone);

  /// How much of the work is done, from 0 to 1. Never falls.
  [[nodiscard]] double progress() const noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace apollonius
