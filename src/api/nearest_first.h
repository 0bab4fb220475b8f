// NearestFirstOf, whose instances are in nearest_first.cpp and spherical_nearest_first.cpp.
#pragma once

#include "api/checks.h"
#include "apollonius/nearest_first.h"

namespace apollonius {

template <class AnyDiagram>
NearestFirstOf<AnyDiagram>::NearestFirstOf(const AnyDiagram& diagram) noexcept
    : diagram_(&diagram) {}
template <class AnyDiagram>
NearestFirstOf<AnyDiagram>::~NearestFirstOf() = default;
template <class AnyDiagram>
NearestFirstOf<AnyDiagram>::NearestFirstOf(NearestFirstOf&&) noexcept = default;

template <class AnyDiagram>
Error NearestFirstOf<AnyDiagram>::start(double x, double y, double maxDistance) {
  const auto& core = *diagram_->core_;
  const Error error = internal::firstOf(takePoint(core, x, y), internal::takeLimit(maxDistance));
  return guarded(core, error, [&] { search_ = std::make_unique<Search>(core, x, y, maxDistance); });
}

template <class AnyDiagram>
Error NearestFirstOf<AnyDiagram>::next(SiteId& id) {
  id = kNoSite;
  if (search_ == nullptr) return Error::kNone;
  const Error error = guarded(*diagram_->core_, [&] { id = search_->nextId(); });
  if (error != Error::kNone) search_.reset();
  return error;
}

template <class AnyDiagram>
double NearestFirstOf<AnyDiagram>::distance() const {
  return search_ == nullptr ? std::numeric_limits<double>::infinity() : search_->distance();
}

}  // namespace apollonius
