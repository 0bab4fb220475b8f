// Snapshots: docs/SNAPSHOTS.md has the format. What is read is believed nowhere. Counts and lists are checked as they are read; then
// the sites and the graph prove each other: where every face has a circle, no corner beyond an edge is in conflict with it, and the hull
// turns once, this is the diagram of these sites (site_moves.h has the reason). So a snapshot that somebody made up cannot break
// anything later on, and the checksum is there for accidents only.
//
// Circles, hierarchy and grid are made anew: they follow from the sites and the graph, and a circle costs about as much as reading it would.
#include <limits>
#include <new>

#include "diagram/diagram_core.h"
#include "graph/words.h"
#include "predicate/predicates.h"

namespace apollonius {

namespace {

constexpr std::uint64_t kMagic = 0x0A1A0A0D6C6F7041u;  // "Apol", and line ends that a transfer as text would spoil
constexpr std::uint32_t kVersion = 1;

// In the order of the file, after the magic number.
struct Header {
  std::uint32_t version, slots, idLimit, sites, hidden, faceSlots;
};
constexpr std::size_t kHeaderWords = 8;
constexpr std::size_t kChecksumWords = 2;

/// Words of all but the checksum and what makes them even.
std::uint64_t wordsFor(std::uint64_t slots, std::uint64_t idLimit, std::uint64_t sites, std::uint64_t hidden, std::uint64_t faceSlots) {
  const std::uint64_t ids = slots + (slots - sites) + (idLimit - sites);
  const std::uint64_t graph = 2 + 3 * faceSlots + (slots + 1);
  return kHeaderWords + 6 * slots + ids + graph + 2 * hidden;
}
/// As many as a 32-bit machine has room for.
constexpr std::uint64_t kMostWords = std::numeric_limits<std::size_t>::max() / 8;

/// Every step is a bijection, so bytes that differ in one group of eight differ in their checksum.
std::uint64_t checksumOf(std::span<const std::uint8_t> bytes) {
  WordReader in(bytes);
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < bytes.size() / 8; ++k) {
    sum = (sum ^ in.longWord()) * 0x9E3779B97F4A7C15u;
    sum ^= sum >> 29;
  }
  return sum;
}

bool isInRange(double value) {
  const double magnitude = absolute(value);
  return value == 0 || (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude);  // false for NaN
}

/// The direction of (x, y) as a number that grows from 0 to 4 in a turn.
double turnOf(double x, double y) {
  const double share = absolute(y) / (absolute(x) + absolute(y));
  if (y >= 0) return x >= 0 ? share : 2 - share;
  return x < 0 ? 2 + share : 4 - share;
}

}  // namespace

// --- Ids ---------------------------------------------------------------------------------------------------------------------

bool SiteIds::restore(WordReader& in, std::size_t slots, std::size_t idLimit, std::size_t size) {
  ids_.assign(idLimit, kNoSlot);
  slots_.assign(slots, kNotListed);
  freeSlots_ = slots;
  for (Slot slot = 0; slot < slots; ++slot) {
    const SiteId id = in.word();
    if (id == kNoSite) continue;
    if (id >= idLimit || ids_[id] != kNoSlot) return false;
    ids_[id] = slot;
    slots_[slot] = word(SiteState::kPending, id);
    --freeSlots_;
  }
  if (this->size() != size) return false;
  std::uint32_t* last = &firstFreeSlot_;
  for (std::size_t k = 0; k < freeSlots_; ++k) {
    const Slot slot = in.word();
    if (slot >= slots || slots_[slot] != kNotListed) return false;
    *last = slot;
    last = &slots_[slot];
    *last = kEnd;
  }
  std::uint32_t freeId = 0;  // marks ids in the list
  last = &firstFreeId_;
  for (std::size_t k = size; k < idLimit; ++k) {
    const SiteId id = in.word();
    if (id >= idLimit || ids_[id] != kNoSlot) return false;
    *last = freeId | id;
    freeId = kFreeId;
    last = &ids_[id];
    *last = kFreeId | kEnd;
  }
  return true;
}

// --- The Delaunay graph --------------------------------------------------------------------------------------------------------

void DelaunayGraph::save(WordWriter& out, std::size_t vertexSlots) const {
  out.word(static_cast<std::uint32_t>(recent_));
  graph_.save(out, vertexSlots);
}

bool DelaunayGraph::restore(WordReader& in, std::size_t faceSlots) {
  recent_ = VertexId{in.word()};
  if (!graph_.restore(in, sites_.size(), faceSlots)) return false;
  if (recent_ != kNoVertex && (recent_ == kInfinity || index(recent_) >= sites_.size())) return false;
  if (graph_.isEmpty()) {
    visibleCount_ = recent_ != kNoVertex;
    return true;
  }
  if (!graph_.hasVertex(recent_)) return false;  // also if there is none
  visibleCount_ = graph_.faceCount() / 2 + 1;  // Euler, without infinity
  circles_.resize(faceSlots);
  // Star by star, as slots are close in memory where sites are in the plane; faces are not.
  const auto forEachHalfedge = [&](auto&& holds) {
    for (std::size_t v = 0; v < graph_.vertexSlots(); ++v) {
      const HalfedgeId begin = graph_.outgoing(VertexId{static_cast<std::uint32_t>(v)});
      if (begin == kNoHalfedge) continue;
      HalfedgeId h = begin;
      do {
        if (!holds(h)) return false;
        h = graph_.rotateCcw(h);
      } while (h != begin);
    }
    return true;
  };
  return forEachHalfedge([&](HalfedgeId h) {
           const bool isFirst = graph_.origin(h) < graph_.target(h) && graph_.origin(h) < graph_.apex(h);
           return !isFirst || restoreCircle(faceOf(h));
         }) &&
         forEachHalfedge([&](HalfedgeId h) { return isEmptyAcross(h); }) && hullTurnsOnce();
}

/// False if the face has no circle, or one of its sites covers another.
bool DelaunayGraph::restoreCircle(FaceId f) {
  Corner corners[3];
  for (unsigned c = 0; c < 3; ++c) corners[c] = corner(graph_.origin(halfedgeOf(f, c)));
  const bool isBounded = corners[0] != nullptr && corners[1] != nullptr && corners[2] != nullptr;
  // That a circle is certain includes that no site covers another.
  if (isBounded && findCertainVoronoiCircle(corners[0], corners[1], corners[2], circles_[index(f)])) return true;
  for (unsigned c = 0; c < 3; ++c) {
    const Corner a = corners[c], b = corners[c == 2 ? 0 : c + 1];
    if (a != nullptr && b != nullptr && covers(*a, *b)) return false;  // the other way round: the twin's turn
  }
  return findVoronoiCircle(corners[0], corners[1], corners[2], circles_[index(f)]);
}

/// Is the corner beyond h not in conflict with h's face?
bool DelaunayGraph::isEmptyAcross(HalfedgeId h) const {
  const VertexId beyond = graph_.apex(graph_.twin(h)), apex = graph_.apex(h);
  if (beyond == kInfinity || beyond == apex) return true;
  const MaybeSign filtered = circleFilter(circle(faceOf(h)), site(beyond));
  if (filtered.known) return filtered.sign != Sign::kPositive;
  // Neighbours do not cover each other, but these two need not be.
  if (apex != kInfinity && (covers(site(apex), site(beyond)) || covers(site(beyond), site(apex)))) return false;
  return !isFaceInConflictByCorners(faceOf(h), site(beyond));
}

/// Else the graph would be that of several diagrams on top of each other, sewn together. Normals that are too close or too vague to
/// tell which comes first count as one.
bool DelaunayGraph::hullTurnsOnce() const {
  constexpr double kClose = 0x1p-16;
  const HalfedgeId begin = graph_.outgoing(kInfinity);
  double turned = 0, last = -1, first = 0;
  const auto turnTo = [&](double turn) {
    const double step = turn < last ? turn - last + 4 : turn - last;
    if (step < 4 - kClose) turned += step;
    last = turn;
  };
  HalfedgeId h = begin;
  do {
    const VoronoiCircle& plane = circle(faceOf(h));
    if (plane.slope < kClose / 16) {
      const double turn = turnOf(plane.x, plane.y);
      if (last < 0) {
        first = last = turn;
      } else {
        turnTo(turn);
      }
    }
    h = graph_.rotateCw(h);
  } while (h != begin);
  if (last >= 0) turnTo(first);
  return turned < 6;
}

// --- The diagram ---------------------------------------------------------------------------------------------------------------

void DiagramCore::save(std::vector<std::uint8_t>& bytes) const {
  const Graph& graph = base_.graph();
  const std::size_t slots = ids_.slots();
  const std::uint64_t words = wordsFor(slots, ids_.idLimit(), ids_.size(), ids_.hiddenCount(), graph.faceSlots());
  if (words > kMostWords) throw std::bad_alloc();
  bytes.resize(static_cast<std::size_t>(4 * (words + words % 2 + kChecksumWords)));
  const std::span<std::uint8_t> content(bytes.data(), bytes.size() - 4 * kChecksumWords);
  if (words % 2 != 0) WordWriter(content.last(4)).word(0);
  WordWriter out(content);
  out.longWord(kMagic);
  for (const std::size_t count : {std::size_t{kVersion}, slots, ids_.idLimit(), ids_.size(), ids_.hiddenCount(), graph.faceSlots()}) {
    out.word(static_cast<std::uint32_t>(count));
  }
  for (Slot slot = 0; slot < slots; ++slot) {
    const Site s = ids_.state(slot) == SiteState::kFree ? Site{} : site(slot);
    for (const double number : {s.x, s.y, s.r}) out.number(number);
  }
  ids_.save(out);
  base_.save(out, slots + 1);
  saveHidden(out);
  WordWriter(std::span(bytes).last(4 * kChecksumWords)).longWord(checksumOf(content));
}

/// Each hidden site with its parent; parents come before their children, and children in their order.
void DiagramCore::saveHidden(WordWriter& out) const {
  std::vector<Slot> reached;
  reached.reserve(ids_.hiddenCount());
  const auto saveChildren = [&](Slot parent) {
    for (Slot child = hidden_.firstChild(parent); child != HiddenForest::kNone; child = hidden_.nextSibling(child)) {
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

bool DiagramCore::restore(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 4 * (kHeaderWords + kChecksumWords) || bytes.size() % 8 != 0) return false;
  const std::span<const std::uint8_t> content = bytes.first(bytes.size() - 4 * kChecksumWords);
  WordReader in(content);
  if (in.longWord() != kMagic || checksumOf(content) != WordReader(bytes.last(4 * kChecksumWords)).longWord()) return false;
  Header header{};
  for (std::uint32_t* count : {&header.version, &header.slots, &header.idLimit, &header.sites, &header.hidden, &header.faceSlots}) {
    *count = in.word();
  }
  const std::uint64_t slots = header.slots, idLimit = header.idLimit, sites = header.sites;
  if (header.version != kVersion || slots > kMostSites || idLimit > kMostSites || sites > slots || sites > idLimit) return false;
  if (header.hidden > sites || header.faceSlots >= kNoIndex / 3) return false;
  const std::uint64_t words = wordsFor(slots, idLimit, sites, header.hidden, header.faceSlots);
  if (4 * (words + words % 2) != content.size()) return false;  // so what is made room for below is in the bytes
  reserve(header.slots);
  for (Slot slot = 0; slot < slots; ++slot) {
    const double x = in.number(), y = in.number(), r = in.number();
    if (!isInRange(x) || !isInRange(y) || !isInRange(r)) return false;
    base_.setSite(vertexOf(slot), normalized({x, y, r}));
  }
  return ids_.restore(in, header.slots, header.idLimit, header.sites) && base_.restore(in, header.faceSlots) && restoreStates() &&
         restoreHidden(in, header.hidden);
}

/// What is in the graph is visible. False if it is a free slot.
bool DiagramCore::restoreStates() {
  isBulk_ = true;
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    if (!base_.isVisible(vertexOf(slot))) continue;
    if (ids_.state(slot) == SiteState::kFree) return false;
    ids_.setState(slot, SiteState::kVisible);
    enterLocation(slot);
  }
  endBulk();
  return true;
}

bool DiagramCore::restoreHidden(WordReader& in, std::size_t count) {
  if (base_.visibleCount() + count != ids_.size()) return false;
  for (std::size_t k = 0; k < count; ++k) {
    const Slot child = in.word(), parent = in.word();
    if (ids_.state(child) != SiteState::kPending) return false;
    if (ids_.state(parent) != SiteState::kVisible && ids_.state(parent) != SiteState::kHidden) return false;
    if (!covers(site(parent), site(child))) return false;
    hidden_.attach(child, parent);
    ids_.setState(child, SiteState::kHidden);
  }
  return true;
}

}  // namespace apollonius
