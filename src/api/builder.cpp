#include "apollonius/builder.h"

#include <algorithm>
#include <vector>

#include "api/checks.h"
#include "diagram/bulk_insertion.h"

namespace apollonius {

using namespace internal;

struct Builder::Work {
  explicit Work(DiagramCore& diagram) : core(diagram), insertion(diagram) {}

  DiagramCore& core;
  std::vector<double> xyr;
  std::vector<SiteId> ids;
  bool isStaged = false;
  Error error = Error::kNone;  // that ended the work
  BulkInsertion insertion;     // last: it is undone while the ids are there
};

Builder::Builder(Diagram& diagram) : work_(std::make_unique<Work>(*diagram.core_)) {
  diagram.change();
}
Builder::~Builder() = default;
Builder::Builder(Builder&&) noexcept = default;

Error Builder::reserve(std::size_t count) {
  if (count > kMostSites) return Error::kTooLarge;
  return guarded(work_->core, [&] { work_->xyr.reserve(3 * count); });
}

Error Builder::add(std::span<const double> xyr) {
  if (xyr.size() % 3 != 0) return Error::kBadLength;
  if (const Error error = checkNumbers(xyr); error != Error::kNone) return error;
  std::vector<double>& all = work_->xyr;
  if ((all.size() + xyr.size()) / 3 > kMostSites) return Error::kTooLarge;
  return guarded(work_->core, [&] { all.insert(all.end(), xyr.begin(), xyr.end()); });
}

Error Builder::advance(std::size_t steps, bool& isDone) {
  Work& work = *work_;
  isDone = work.error == Error::kNone && work.xyr.empty() && work.ids.empty();
  if (isDone || work.error != Error::kNone) return work.error;
  work.error = guarded(work.core, [&] {
    if (work.isStaged) {
      isDone = work.insertion.insert(work.ids, steps);
      if (isDone) work.ids.clear();
    } else if (work.insertion.stage(work.xyr,
                                    BulkInsertion::visits(steps, BulkInsertion::kStageVisits))) {
      work.isStaged = true;
      work.ids.resize(work.xyr.size() / 3);
      std::vector<double>().swap(work.xyr);
    }
  });
  return work.error;
}

double Builder::progress() const noexcept { return work_->insertion.progress(); }

}  // namespace apollonius
