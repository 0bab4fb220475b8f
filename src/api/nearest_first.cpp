#include "apollonius/nearest_first.h"

#include <limits>

#include "api/checks.h"
#include "diagram/nearby_search.h"

namespace apollonius {

using namespace internal;

NearestFirst::NearestFirst(const Diagram& diagram) noexcept : diagram_(&diagram) {}
NearestFirst::~NearestFirst() = default;
NearestFirst::NearestFirst(NearestFirst&&) noexcept = default;

Error NearestFirst::start(double x, double y, double maxDistance) {
  if (const Error error = checkNumbers(x, y); error != Error::kNone) return error;
  if (const Error error = checkLimit(maxDistance); error != Error::kNone) return error;
  const DiagramCore& core = *diagram_->core_;
  return guarded(core, [&] { search_ = std::make_unique<NearbySearch>(core, x, y, maxDistance); });
}

Error NearestFirst::next(SiteId& id) {
  id = kNoSite;
  if (search_ == nullptr) return Error::kNone;
  const DiagramCore& core = *diagram_->core_;
  const Error error = guarded(core, [&] {
    const Slot slot = search_->next();
    if (slot != kNoSlot) id = core.ids().idOf(slot);
  });
  if (error != Error::kNone) search_.reset();
  return error;
}

double NearestFirst::distance() const {
  return search_ == nullptr ? std::numeric_limits<double>::infinity() : search_->distance();
}

}  // namespace apollonius
