#include "api/builder.h"

#include <optional>
#include <vector>

#include "diagram/bulk_insertion.h"
#include "diagram/restoring.h"

namespace apollonius {

using namespace internal;

template <>
struct Builder::Work {
  using Reading = internal::Reading<DiagramCore, internal::Restoring>;

  explicit Work(Diagram& built) : diagram(built) { diagram.change(); }

  [[nodiscard]] DiagramCore& core() const { return *diagram.core_; }
  [[nodiscard]] std::size_t size() const { return xyr.size() / 3 + ids.size(); }
  void reserve(std::size_t count) { xyr.reserve(3 * count); }
  void add(std::span<const double> sites) { xyr.insert(xyr.end(), sites.begin(), sites.end()); }

  void read(std::vector<std::uint8_t> bytes, Source source) {
    auto empty = std::make_unique<DiagramCore>(core().location());
    reading = std::make_unique<Reading>(std::move(empty), std::move(bytes), source);
  }
  void become(std::unique_ptr<DiagramCore> restored) { diagram.core_ = std::move(restored); }

  [[nodiscard]] bool advance(std::size_t steps) {
    if (!insertion) insertion.emplace(core());
    if (isStaged) {
      const bool isDone = insertion->insert(ids, steps);
      if (isDone) ids.clear();
      return isDone;
    }
    isStaged = insertion->stage(xyr, BulkInsertion::visits(steps, BulkInsertion::kStageVisits));
    if (isStaged) {
      ids.resize(xyr.size() / 3);
      std::vector<double>().swap(xyr);
    }
    return false;
  }
  [[nodiscard]] double progress() const { return insertion ? insertion->progress() : 0; }

  Diagram& diagram;
  std::vector<double> xyr;
  std::vector<SiteId> ids;
  bool isStaged = false;
  Error error = Error::kNone;  // that ended the work
  std::unique_ptr<Reading> reading;
  std::optional<BulkInsertion> insertion;  // last: it is undone while the ids are there
};

template class BuilderOf<Diagram>;

}  // namespace apollonius
