// Builder (builder.h) of the sphere: a diagram of many sites, built in steps.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "apollonius/export.h"
#include "apollonius/spherical_diagram.h"

namespace apollonius {

/// As Builder. The result is that of SphericalDiagram::insertMany, in about the time.
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

  /// As Builder::advance.
  [[nodiscard]] Error advance(std::size_t steps, bool& isDone);

  /// From 0 to 1; never falls.
  [[nodiscard]] double progress() const noexcept;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace apollonius
