#include "api/builder.h"

#include <vector>

#include "diagram/bulk_insertion.h"

namespace apollonius {

using namespace internal;

template <>
struct Builder::Work {
  explicit Work(Diagram& diagram) : core(*diagram.core_), insertion(core) { diagram.change(); }

  [[nodiscard]] std::size_t size() const { return xyr.size() / 3 + ids.size(); }
  void reserve(std::size_t count) { xyr.reserve(3 * count); }
  void add(std::span<const double> sites) { xyr.insert(xyr.end(), sites.begin(), sites.end()); }

  [[nodiscard]] bool advance(std::size_t steps) {
    if (isStaged) {
      const bool isDone = insertion.insert(ids, steps);
      if (isDone) ids.clear();
      return isDone;
    }
    isStaged = insertion.stage(xyr, BulkInsertion::visits(steps, BulkInsertion::kStageVisits));
    if (isStaged) {
      ids.resize(xyr.size() / 3);
      std::vector<double>().swap(xyr);
    }
    return false;
  }
  [[nodiscard]] double progress() const { return insertion.progress(); }

  DiagramCore& core;
  std::vector<double> xyr;
  std::vector<SiteId> ids;
  bool isStaged = false;
  Error error = Error::kNone;  // that ended the work
  BulkInsertion insertion;     // last: it is undone while the ids are there
};

template class BuilderOf<Diagram>;

}  // namespace apollonius
