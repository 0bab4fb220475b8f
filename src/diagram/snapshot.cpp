// Snapshots: docs/SNAPSHOTS.md has the format. Counts, lists, ids and the graph as a surface are
// checked as they are read. Then it is proved that the graph is the Delaunay graph of these sites
// (proof.h), or, of trusted bytes, believed: whatever they are, nothing outside of the arrays is
// ever touched, and an operation that would damage the surface finds out before it does
// (DelaunayGraph::requireConsistent).
//
// Circles, hierarchy and grid are made anew: they follow from the sites and the graph. The proof
// needs the circles; without it each waits until it is asked for. So does the hierarchy, as the
// grid answers most of what that one is asked.
#include <limits>
#include <new>
#include <vector>

#include "base/byte_stream.h"
#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "diagram/restoring.h"
#include "predicate/predicates.h"

namespace apollonius::internal {

namespace {

constexpr std::uint64_t kMagic =
    0x0A1A0A0D6C6F7041u;  // "Apol", and line ends that a transfer as text would spoil
constexpr std::uint32_t kVersion = 2;

constexpr std::size_t kHeaderWords = 8;  // with the magic number
constexpr std::size_t kChecksumWords = 2;

/// Words of all but the checksum and what makes them even.
std::uint64_t wordsFor(std::uint64_t slots, std::uint64_t idLimit, std::uint64_t sites,
                       std::uint64_t hidden, std::uint64_t faceSlots) {
  const std::uint64_t ids = slots + (slots - sites) + (idLimit - sites);
  const std::uint64_t graph = 2 + 3 * faceSlots + (slots + 1);
  return kHeaderWords + 6 * slots + ids + graph + 2 * hidden;
}
/// As many as a 32-bit machine has room for.
constexpr std::uint64_t kMostWords = std::numeric_limits<std::size_t>::max() / 8;

}  // namespace

void DiagramCore::save(std::vector<std::uint8_t>& bytes) const {
  const Graph& graph = delaunay_.graph();
  const std::size_t slots = ids_.slots();
  const std::uint64_t words =
      wordsFor(slots, ids_.idLimit(), ids_.size(), ids_.hiddenCount(), graph.faceSlots());
  if (words > kMostWords) throw std::bad_alloc();
  bytes.resize(static_cast<std::size_t>(4 * (words + words % 2 + kChecksumWords)));
  const std::span<std::uint8_t> content(bytes.data(), bytes.size() - 4 * kChecksumWords);
  if (words % 2 != 0) WordWriter(content.last(4)).word(0);
  WordWriter out(content);
  out.longWord(kMagic);
  for (const std::size_t count : {std::size_t{kVersion}, slots, ids_.idLimit(), ids_.size(),
                                  ids_.hiddenCount(), graph.faceSlots()}) {
    out.word(static_cast<std::uint32_t>(count));
  }
  for (Slot slot = 0; slot < slots; ++slot) {
    const Site s = ids_.state(slot) == SiteState::kFree ? Site{} : site(slot);
    for (const double number : {s.x, s.y, s.r}) out.number(number);
  }
  ids_.save(out);
  delaunay_.save(out, slots + 1);
  saveHidden(out);
  WordWriter(std::span(bytes).last(4 * kChecksumWords)).longWord(checksumOf(content));
}

/// Each hidden site with its parent; parents come before their children, and children in their
/// order.
void DiagramCore::saveHidden(WordWriter& out) const {
  FlatArray<Slot> reached;
  reached.reserve(ids_.hiddenCount());
  const auto saveChildren = [&](Slot parent) {
    for (Slot child = hidden_.firstChild(parent); child != HiddenForest::kNone;
         child = hidden_.nextSibling(child)) {
      out.word(child);
      out.word(parent);
      reached.push_back(child);
    }
  };
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    if (ids_.state(slot) == SiteState::kVisible) saveChildren(slot);
  }
  for (std::size_t k = 0; k < reached.size(); ++k) saveChildren(reached[k]);
}

bool DiagramCore::restore(std::span<const std::uint8_t> bytes, Source source) {
  return Restoring(*this, bytes, source).finish() == Restoring::State::kDone;
}

Restoring::Restoring(DiagramCore& diagram, std::span<const std::uint8_t> bytes, Source source)
    : diagram_(diagram), bytes_(bytes), source_(source), in_(bytes) {}

Restoring::State Restoring::advance(std::size_t most) {
  bool isRight = true;
  switch (step_) {
    case Step::kSites:
      isRight = readSites();
      step_ = Step::kGraph;
      break;
    case Step::kGraph:
      isRight = readGraph();
      step_ = Step::kHidden;
      break;
    case Step::kHidden:
      isRight = readHidden();
      if (isRight && source_ == Source::kTrusted) return State::kDone;
      step_ = Step::kProof;
      break;
    case Step::kProof:
      if (!proof_) proof_.emplace(diagram_.delaunay_.beginProof());
      if (!proof_->advance(most)) break;
      return diagram_.delaunay_.endProof(*proof_) ? State::kDone : State::kCorrupt;
  }
  return isRight ? State::kUnderWay : State::kCorrupt;
}

double Restoring::progress() const {
  if (source_ == Source::kTrusted) return 0.33 * static_cast<int>(step_);
  return proof_ ? 0.15 + 0.85 * proof_->progress() : 0.05 * static_cast<int>(step_);
}

bool Restoring::readSites() {
  if (bytes_.size() < 4 * (kHeaderWords + kChecksumWords) || bytes_.size() % 8 != 0) return false;
  const std::span<const std::uint8_t> content = bytes_.first(bytes_.size() - 4 * kChecksumWords);
  if (in_.longWord() != kMagic ||
      checksumOf(content) != WordReader(bytes_.last(4 * kChecksumWords)).longWord())
    return false;
  for (std::uint32_t* count : {&header_.version, &header_.slots, &header_.idLimit, &header_.sites,
                               &header_.hidden, &header_.faceSlots}) {
    *count = in_.word();
  }
  const std::uint64_t slots = header_.slots, idLimit = header_.idLimit, sites = header_.sites;
  if (header_.version != kVersion || slots > kMostSites || idLimit > kMostSites || sites > slots ||
      sites > idLimit)
    return false;
  if (header_.hidden > sites || header_.faceSlots >= kNoIndex / 3) return false;
  const std::uint64_t words = wordsFor(slots, idLimit, sites, header_.hidden, header_.faceSlots);
  if (4 * (words + words % 2) != content.size())
    return false;  // so the room made below is no larger than the bytes
  diagram_.reserve(header_.slots);
  for (Slot slot = 0; slot < slots; ++slot) {
    const double x = in_.number(), y = in_.number(), r = in_.number();
    if (!isInRange(x) || !isInRange(y) || !isInRange(r)) return false;
    diagram_.delaunay_.setSite(vertexOf(slot), normalized({x, y, r}));
  }
  return diagram_.ids_.restore(in_, header_.slots, header_.idLimit, header_.sites);
}

bool Restoring::readGraph() { return diagram_.delaunay_.restore(in_, header_.faceSlots); }

bool Restoring::readHidden() {
  if (!diagram_.restoreStates() || !diagram_.restoreHidden(in_, header_.hidden)) return false;
  const std::uint64_t words =
      wordsFor(header_.slots, header_.idLimit, header_.sites, header_.hidden, header_.faceSlots);
  return words % 2 == 0 || in_.word() == 0;
}

/// Sets the state of all sites in the graph to visible. Returns false if one has a free slot.
bool DiagramCore::restoreStates() {
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    if (!delaunay_.isVisible(vertexOf(slot))) continue;
    if (ids_.state(slot) == SiteState::kFree) return false;
    ids_.setState(slot, SiteState::kVisible);
  }
  index_.rebuild(delaunay_);
  return true;
}

bool DiagramCore::restoreHidden(WordReader& in, std::size_t count) {
  if (delaunay_.visibleCount() + count != ids_.size()) return false;
  hidden_.reserveChildren(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Slot child = in.word(), parent = in.word();
    if (ids_.state(child) != SiteState::kPending) return false;
    if (ids_.state(parent) != SiteState::kVisible && ids_.state(parent) != SiteState::kHidden)
      return false;
    if (!mayHang(child, parent)) return false;
    hidden_.attach(child, parent);
    ids_.setState(child, SiteState::kHidden);
  }
  return true;
}

}  // namespace apollonius::internal
