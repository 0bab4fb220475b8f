// Every call of the public interface comes by here before and after its work: numbers are checked,
// those that are too small are taken as 0, and lack of memory becomes an error.
#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <stdexcept>

#include "apollonius/diagram.h"
#include "base/flat_array.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

/// kNone, or the first that is not.
inline Error firstOf(Error a, Error b, Error c = Error::kNone) {
  return a != Error::kNone ? a : b != Error::kNone ? b : c;
}

/// Checks a number of a call, and takes it (types.h).
[[nodiscard]] Error takeNumber(double& value);
/// Checks numbers that TakenNumbers takes.
[[nodiscard]] Error checkNumbers(std::span<const double> values);

/// Numbers of a call, taken. A copy if one of them becomes 0.
class TakenNumbers {
 public:
  /// Throws std::bad_alloc. REQUIRES: the given ones are there as long as this one.
  explicit TakenNumbers(std::span<const double> given);
  TakenNumbers(const TakenNumbers&) = delete;
  TakenNumbers& operator=(const TakenNumbers&) = delete;

  // NOLINTNEXTLINE(google-explicit-constructor): they are what was given
  operator std::span<const double>() const { return numbers_; }

 private:
  FlatArray<double> copy_;
  std::span<const double> numbers_;
};

/// Checks how far a search may look, which may be infinite, and takes it.
[[nodiscard]] Error takeLimit(double& maxDistance);

inline Error takePick(double& maxDistance) {
  const Error error = takeLimit(maxDistance);
  return firstOf(error, maxDistance < 0 ? Error::kOutOfRange : Error::kNone);
}

inline Error checkLength(bool isGood) { return isGood ? Error::kNone : Error::kBadLength; }

/// One id for each point, and a distance or none at all.
inline Error checkResults(std::span<const double> points, std::span<SiteId> ids,
                          std::span<double> distances) {
  return checkLength(points.size() == 2 * ids.size() &&
                     (distances.empty() || distances.size() == ids.size()));
}

/// May this many sites join the others?
inline Error checkRoom(std::size_t more, std::size_t sites) {
  return more <= kMostSites - sites ? Error::kNone : Error::kTooLarge;
}

/// Are these all sites of a diagram?
template <class AnyDiagram>
Error checkIds(const AnyDiagram& diagram, std::span<const SiteId> ids) {
  for (const SiteId id : ids) {
    if (!diagram.has(id)) return Error::kUnknownSite;
  }
  return Error::kNone;
}

// The sphere has checks of its own in place of these (spherical_checks.h).

inline Error takePoint(const DiagramCore&, double& x, double& y) {
  return firstOf(takeNumber(x), takeNumber(y));
}
/// x, y pairs.
inline Error checkPoints(const DiagramCore&, std::span<const double> xy) {
  return checkNumbers(xy);
}
/// x, y, r triples.
inline Error checkSites(const DiagramCore&, std::span<const double> xyr) {
  return checkNumbers(xyr);
}

/// Runs an operation unless there is an error `before`. Memory that runs out throws std::bad_alloc,
/// or from a vector std::length_error. std::bad_alloc also ends a call that finds out that trusted
/// bytes were no diagram, which the diagram remembers.
template <class Operation>
[[nodiscard]] Error guarded(const DiagramCore& core, Error before, Operation&& operation) {
  if (before != Error::kNone) return before;
  if (core.isBroken()) return Error::kCorruptSnapshot;
  try {
    operation();
    return Error::kNone;
  } catch (const std::bad_alloc&) {
    return core.isBroken() ? Error::kCorruptSnapshot : Error::kOutOfMemory;
  } catch (const std::length_error&) {
    return Error::kOutOfMemory;
  }
}
template <class Operation>
[[nodiscard]] Error guarded(const DiagramCore& core, Operation&& operation) {
  return guarded(core, Error::kNone, operation);
}

}  // namespace apollonius::internal
