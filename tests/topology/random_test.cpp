// Random surfaces: sequences of starHole, replaceStar and replaceVertex on random regions, with
// integers alone. After each operation the graph must be a sphere (Graph::check), and must be what
// the operation says: faces outside untouched, faces inside replaced, neighbours across the
// boundary as before.
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "topology/surface.h"

namespace apollonius::test {

using namespace internal;
namespace {

// std::mt19937_64 is the same everywhere (the distributions are not, and are not used).
class RandomSurface {
 public:
  explicit RandomSurface(std::uint64_t seed) : random_(seed) {
    makePair(graph_, 1, 2);
    live_ = {1, 2};
    for (std::uint32_t v = 40; v >= 3; --v) dead_.push_back(v);
  }

  void step() {
    if (!dead_.empty() && below(8) == 0) {
      replace();
    } else if (dead_.empty() || (live_.size() > 2 && below(2) == 0)) {
      unstar();
    } else {
      star();
    }
    check();
  }

  [[nodiscard]] const Graph& graph() const { return graph_; }

 private:
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

  HalfedgeId randomHalfedge() {
    for (;;) {
      const HalfedgeId h{static_cast<std::uint32_t>(below(3 * graph_.faceSlots()))};
      if (graph_.isLive(faceOf(h))) return h;
    }
  }

  std::uint32_t takeDead() {
    const std::size_t k = below(dead_.size());
    std::swap(dead_[k], dead_.back());
    const std::uint32_t v = dead_.back();
    dead_.pop_back();
    live_.insert(v);
    return v;
  }

  void bury(std::uint32_t v) {
    live_.erase(v);
    dead_.push_back(v);
  }

  /// A random hole whose boundary is one closed curve: one face or none, then faces across random
  /// sides of the boundary; now and then a cycle is closed where two neighbours on the boundary are
  /// sides of one edge, which hides the vertex between them.
  void star() {
    std::vector<FaceId> hole;
    std::vector<HalfedgeId> boundary;
    const HalfedgeId h = randomHalfedge();
    if (below(6) == 0) {
      boundary = {h, graph_.twin(h)};
    } else {
      hole = {faceOf(h)};
      boundary = {h, next(h), previous(h)};
      std::vector<char> inHole(graph_.faceSlots(), 0);
      inHole[index(faceOf(h))] = 1;
      for (std::size_t tries = below(40); tries > 0; --tries) grow(hole, boundary, inHole);
    }
    for (std::size_t turn = below(boundary.size()); turn > 0; --turn)
      std::rotate(boundary.begin(), boundary.begin() + 1, boundary.end());

    expected_ = triplesOutside(hole);
    std::map<HalfedgeId, std::size_t> position;
    for (std::size_t k = 0; k < boundary.size(); ++k) position[boundary[k]] = k;
    std::vector<HalfedgeId> outer;
    std::set<std::uint32_t> within;
    for (const HalfedgeId r : boundary) outer.push_back(graph_.twin(r));
    for (const FaceId f : hole) {
      for (unsigned c = 0; c < 3; ++c) within.insert(number(graph_.origin(halfedgeOf(f, c))));
    }
    for (const HalfedgeId r : boundary) within.erase(number(graph_.origin(r)));
    const std::uint32_t w = takeDead();
    for (const HalfedgeId r : boundary)
      expected_.push_back({number(graph_.origin(r)), number(graph_.target(r)), w});

    const Starred starred = starHole(graph_, w, hole, boundary);
    EXPECT_EQ(starred.lost, std::vector<std::uint32_t>(within.begin(), within.end()));
    for (const std::uint32_t v : starred.lost) bury(v);
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      // With no face in the hole, the two sides of the opened edge are both outside.
      const auto partner = hole.empty() ? position.end() : position.find(outer[k]);
      EXPECT_EQ(
          graph_.twin(halfedgeOf(starred.faces[k], 0)),
          partner != position.end() ? halfedgeOf(starred.faces[partner->second], 0) : outer[k]);
    }
    EXPECT_EQ(degree(graph_, vertex(w)), boundary.size());
  }

  void grow(std::vector<FaceId>& hole, std::vector<HalfedgeId>& boundary,
            std::vector<char>& inHole) {
    const std::size_t k = below(boundary.size());
    const HalfedgeId across = graph_.twin(boundary[k]);
    if (inHole[index(faceOf(across))] == 0) {
      inHole[index(faceOf(across))] = 1;
      hole.push_back(faceOf(across));
      boundary[k] = next(across);
      boundary.insert(boundary.begin() + static_cast<std::ptrdiff_t>(k) + 1, previous(across));
      return;
    }
    const std::size_t after = (k + 1) % boundary.size();
    if (boundary[after] != across || boundary.size() < 4 || graph_.origin(across) == kInfinity)
      return;
    std::rotate(boundary.begin(), boundary.begin() + static_cast<std::ptrdiff_t>(k),
                boundary.end());
    boundary.erase(boundary.begin(), boundary.begin() + 2);
  }

  /// Takes a random vertex out. The star is filled by cutting off ears of its link (where that
  /// makes no loop) and, now and then, by a fan about a vertex that comes to life.
  void unstar() {
    auto it = live_.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(below(live_.size())));
    const std::uint32_t v = *it;
    std::vector<HalfedgeId> link = linkOf(graph_, vertex(v));
    const bool wholeSphere = link.size() == 2 && graph_.twin(link[0]) == link[1];
    if (wholeSphere && dead_.empty()) return;

    std::vector<FaceId> star;
    for (const HalfedgeId h : link) star.push_back(faceOf(h));
    expected_ = triplesOutside(star);
    std::vector<Graph::PatchFace> patch;
    if (link.size() > 2 || wholeSphere || (below(4) == 0 && !dead_.empty())) {
      patch = randomPatch(link);
    }
    for (const Graph::PatchFace& f : patch)
      expected_.push_back({number(f.corners[0]), number(f.corners[1]), number(f.corners[2])});
    bury(v);
    replaceStar(graph_, v, link, patch);
    EXPECT_FALSE(graph_.hasVertex(vertex(v)));
  }

  /// Puts a vertex in the place of another.
  void replace() {
    auto it = live_.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(below(live_.size())));
    const std::uint32_t v = *it, w = takeDead();
    expected_ = triplesOutside({});
    for (Triple& face : expected_) std::replace(face.begin(), face.end(), v, w);
    graph_.reserveVertices(w + std::size_t{1});
    graph_.replaceVertex(vertex(v), vertex(w));
    bury(v);
  }

  std::vector<Graph::PatchFace> randomPatch(const std::vector<HalfedgeId>& link) {
    struct Side {
      std::uint32_t from;
      std::uint32_t across;  // the neighbour beyond, in the form of PatchFace
    };
    std::vector<Side> sides;
    for (std::uint32_t k = 0; k < link.size(); ++k)
      sides.push_back({number(graph_.origin(link[k])), outside(k)});
    std::vector<Graph::PatchFace> patch;
    // Side c of patch face f has `across` at its other side; tell that one, too.
    const auto meet = [&](std::uint32_t f, std::uint32_t c, std::uint32_t across) {
      patch[f].across[c] = across;
      if ((across & Graph::kOutside) == 0) patch[across / 3].across[across % 3] = inside(f, c);
    };
    const auto addFace = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      patch.push_back({{vertex(a), vertex(b), vertex(c)}, {0, 0, 0}});
      return static_cast<std::uint32_t>(patch.size() - 1);
    };

    while (sides.size() > 3 && (dead_.empty() || below(8) != 0)) {
      // An ear: sides k and k+1, cut off by an edge between their outer ends.
      std::vector<std::size_t> ears;
      for (std::size_t k = 0; k < sides.size(); ++k) {
        if (sides[k].from != sides[(k + 2) % sides.size()].from) ears.push_back(k);
      }
      if (ears.empty()) break;
      std::rotate(sides.begin(),
                  sides.begin() + static_cast<std::ptrdiff_t>(ears[below(ears.size())]),
                  sides.end());
      const std::uint32_t f = addFace(sides[0].from, sides[1].from, sides[2].from);
      meet(f, 0, sides[0].across);
      meet(f, 1, sides[1].across);
      sides[0].across = inside(f, 2);
      sides.erase(sides.begin() + 1);
    }
    if (sides.size() == 3 && (dead_.empty() || below(4) != 0)) {
      const std::uint32_t f = addFace(sides[0].from, sides[1].from, sides[2].from);
      for (std::uint32_t c = 0; c < 3; ++c) meet(f, c, sides[c].across);
      return patch;
    }
    if (dead_.empty()) throw std::logic_error("a link without ears needs a vertex to come to life");
    const std::uint32_t revived = takeDead();
    const auto n = static_cast<std::uint32_t>(sides.size());
    const auto first = static_cast<std::uint32_t>(patch.size());
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t f = addFace(sides[k].from, sides[(k + 1) % n].from, revived);
      meet(f, 0, sides[k].across);
    }
    for (std::uint32_t k = 0; k < n; ++k) meet(first + k, 1, inside(first + (k + 1) % n, 2));
    return patch;
  }

  std::vector<Triple> triplesOutside(const std::vector<FaceId>& faces) const {
    std::vector<Triple> all;
    for (const FaceId f : liveFaces(graph_)) {
      if (std::find(faces.begin(), faces.end(), f) == faces.end()) all.push_back(triple(graph_, f));
    }
    return all;
  }

  void check() {
    ASSERT_EQ(broken(graph_), "");
    EXPECT_EQ(triples(graph_), sorted(expected_));
    std::size_t edges = 0;
    for (const FaceId f : liveFaces(graph_)) {
      for (unsigned c = 0; c < 3; ++c) edges += halfedgeOf(f, c) < graph_.twin(halfedgeOf(f, c));
    }
    const std::size_t vertices = live_.size() + 1;
    EXPECT_EQ(vertices + graph_.faceCount(), edges + 2) << "Euler's formula";
    for (const std::uint32_t v : live_) EXPECT_TRUE(graph_.hasVertex(vertex(v)));
    for (const std::uint32_t v : dead_) EXPECT_FALSE(graph_.hasVertex(vertex(v)));
  }

  std::mt19937_64 random_;
  Graph graph_;
  std::set<std::uint32_t> live_;  // without infinity
  std::vector<std::uint32_t> dead_;
  std::vector<Triple> expected_;  // faces after the operation
};

TEST(RandomSurface, StaysASphere) {
  bool sawDegreeTwo = false, sawMultiEdge = false;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomSurface surface(seed);
    for (int step = 0; step < 200; ++step) {
      surface.step();
      if (HasFailure()) return;
      const Graph& graph = surface.graph();
      std::set<std::pair<VertexId, VertexId>> pairs;
      for (const FaceId f : liveFaces(graph)) {
        for (unsigned c = 0; c < 3; ++c) {
          const HalfedgeId h = halfedgeOf(f, c);
          sawMultiEdge |= !pairs.insert({graph.origin(h), graph.target(h)}).second;
          sawDegreeTwo |= graph.rotateCcw(graph.rotateCcw(h)) == h;
        }
      }
    }
  }
  EXPECT_TRUE(sawDegreeTwo);
  EXPECT_TRUE(sawMultiEdge);
}

}  // namespace
}  // namespace apollonius::test
