#include "support/canonical.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

namespace apollonius::test {

namespace {

bool same(const Circle& a, const Circle& b) { return a.x == b.x && a.y == b.y && a.r == b.r; }

/// Index of the last of the circles equal to `circle` in a sorted vector that contains it.
int lastIndex(const Circles& sorted, const Circle& circle) {
  return static_cast<int>(std::upper_bound(sorted.begin(), sorted.end(), circle, oracleSmaller) -
                          sorted.begin()) -
         1;
}

Triple rotated(Triple t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Collects the first contradiction only: the others usually follow from it.
class Complaints {
 public:
  explicit Complaints(std::string& broken) : broken_(broken) { broken_.clear(); }
  void unless(bool fine, const std::string& what) {
    if (!fine && broken_.empty()) broken_ = what;
  }

 private:
  std::string& broken_;
};

/// The faces as vertices() and edges() tell of them: of a vertex its sites, of an edge to infinity
/// its left and right cell on the way outwards, and infinity. Checks that the two fit: each vertex
/// has three edges, one between each two of its sites.
std::vector<std::array<SiteId, 3>> facesOfListings(const Diagram& diagram, Complaints& complaints) {
  VertexArrays vertices;
  EdgeArrays edges;
  complaints.unless(diagram.vertices(vertices) == Error::kNone, "vertices() failed");
  complaints.unless(diagram.edges(edges) == Error::kNone, "edges() failed");
  const std::size_t vertexCount = vertices.clearance.size();
  complaints.unless(
      vertices.coordinates.size() == 2 * vertexCount && vertices.sites.size() == 3 * vertexCount,
      "lengths of vertices()");
  complaints.unless(edges.sites.size() == edges.vertices.size() && edges.sites.size() % 2 == 0,
                    "lengths of edges()");

  std::vector<std::array<SiteId, 3>> faces;
  using Side = std::pair<SiteId, SiteId>;
  std::vector<std::vector<Side>> sides(vertexCount);  // those that no edge has claimed yet
  for (std::size_t k = 0; k < vertexCount; ++k) {
    const SiteId* s = &vertices.sites[3 * k];
    faces.push_back({s[0], s[1], s[2]});
    sides[k] = {{s[0], s[1]}, {s[1], s[2]}, {s[2], s[0]}};
  }
  for (std::size_t k = 0; k + 1 < edges.sites.size(); k += 2) {
    const SiteId a = edges.sites[k];
    const SiteId b = edges.sites[k + 1];
    complaints.unless(a != b, "an edge between a site and itself");
    for (int end = 0; end < 2; ++end) {
      // At the end that one walks to, a is on the left and b on the right: counter-clockwise b, the
      // third, a.
      const std::int32_t vertex = edges.vertices[k + end];
      const Side side = end == 1 ? Side{a, b} : Side{b, a};
      if (vertex == -1) {
        faces.push_back({kNoSite, side.first, side.second});
      } else if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertexCount) {
        complaints.unless(false, "an edge's end is not a row of vertices()");
      } else {
        const auto found = std::find(sides[vertex].begin(), sides[vertex].end(), side);
        complaints.unless(found != sides[vertex].end(),
                          "an edge does not fit the sites of the vertex at its end");
        if (found != sides[vertex].end()) sides[vertex].erase(found);
      }
    }
  }
  for (const auto& unclaimed : sides)
    complaints.unless(unclaimed.empty(), "a vertex without three edges");
  return faces;
}

}  // namespace

bool Canonical::operator==(const Canonical& other) const {
  return std::equal(circles.begin(), circles.end(), other.circles.begin(), other.circles.end(),
                    same) &&
         visible == other.visible && triples == other.triples;
}

Canonical canonicalForm(const Diagram& diagram, std::string& broken) {
  Complaints complaints(broken);
  Canonical form;
  std::vector<SiteId> ids;
  complaints.unless(diagram.ids(ids) == Error::kNone, "ids() failed");
  complaints.unless(ids.size() == diagram.size(), "size() is not the number of ids()");
  complaints.unless(std::is_sorted(ids.begin(), ids.end()) &&
                        std::adjacent_find(ids.begin(), ids.end()) == ids.end(),
                    "ids() not ascending");

  std::map<SiteId, Circle> circleOf;
  std::map<std::array<double, 3>, SiteId> firstOf;  // least id of identical circles
  Circles visibleCircles;
  for (const SiteId id : ids) {
    Circle circle{};
    bool hidden = false;
    complaints.unless(diagram.has(id) && diagram.site(id, circle) == Error::kNone,
                      "has() or site() denies an id of ids()");
    complaints.unless(diagram.isHidden(id, hidden) == Error::kNone, "isHidden() failed");
    circleOf[id] = circle;
    form.circles.push_back(circle);
    const auto [first, isNew] = firstOf.try_emplace({circle.x, circle.y, circle.r}, id);
    complaints.unless(hidden || isNew,
                      "of identical circles, one that has not the least id is visible");
    if (!hidden) visibleCircles.push_back(circle);
  }
  complaints.unless(diagram.visibleSize() == visibleCircles.size(),
                    "visibleSize() is not the number of visible sites");
  complaints.unless(diagram.hiddenSize() + diagram.visibleSize() == diagram.size(),
                    "hiddenSize() + visibleSize() != size()");

  std::sort(form.circles.begin(), form.circles.end(), oracleSmaller);
  form.visible.assign(form.circles.size(), false);
  for (const Circle& circle : visibleCircles) {
    const int index = lastIndex(form.circles, circle);
    complaints.unless(!form.visible[index], "two identical circles are visible");
    form.visible[index] = true;
  }
  const auto indexOf = [&](SiteId id) {
    if (id == kNoSite) return kInfinity;
    bool hidden = true;
    const auto found = circleOf.find(id);
    const bool visible =
        found != circleOf.end() && diagram.isHidden(id, hidden) == Error::kNone && !hidden;
    complaints.unless(visible, "a face, vertex or edge of a site that is hidden or unknown");
    return visible ? lastIndex(form.circles, found->second) : kInfinity;
  };
  std::vector<SiteId> faces;
  complaints.unless(diagram.faces(faces) == Error::kNone && faces.size() % 3 == 0,
                    "faces() failed");
  for (std::size_t k = 0; k + 2 < faces.size(); k += 3) {
    form.triples.push_back(
        rotated({indexOf(faces[k]), indexOf(faces[k + 1]), indexOf(faces[k + 2])}));
  }
  std::sort(form.triples.begin(), form.triples.end());
  std::vector<Triple> listed;
  for (const auto& f : facesOfListings(diagram, complaints))
    listed.push_back(rotated({indexOf(f[0]), indexOf(f[1]), indexOf(f[2])}));
  std::sort(listed.begin(), listed.end());
  complaints.unless(listed == form.triples,
                    "vertices() and edges() tell of other faces than faces()");
  const std::size_t h = visibleCircles.size();
  complaints.unless(form.triples.size() == (h < 2 ? 0 : 2 * h - 2),
                    "the number of faces is not 2h - 2");
  return form;
}

Canonical canonicalByOracle(const Circles& circles) {
  const OracleDiagram diagram = oracleDiagram(circles);
  Canonical form;
  form.circles = circles;
  std::sort(form.circles.begin(), form.circles.end(), oracleSmaller);
  form.visible.assign(circles.size(), false);
  for (std::size_t k = 0; k < circles.size(); ++k) {
    if (diagram.visible[k]) form.visible[lastIndex(form.circles, circles[k])] = true;
  }
  const auto indexOf = [&](int k) {
    return k == kInfinity ? kInfinity : lastIndex(form.circles, circles[k]);
  };
  for (const Triple& t : diagram.triples)
    form.triples.push_back(rotated({indexOf(t[0]), indexOf(t[1]), indexOf(t[2])}));
  std::sort(form.triples.begin(), form.triples.end());
  return form;
}

std::string difference(const Canonical& expected, const Canonical& got) {
  if (expected == got) return {};
  std::ostringstream text;
  text << std::hexfloat;
  if (!std::equal(expected.circles.begin(), expected.circles.end(), got.circles.begin(),
                  got.circles.end(), same)) {
    text << "different circles: " << got.circles.size() << " instead of " << expected.circles.size()
         << "\n";
    return text.str();
  }
  for (std::size_t k = 0; k < expected.circles.size(); ++k) {
    const Circle& c = expected.circles[k];
    text << "  site " << k << ": " << c.x << " " << c.y << " " << c.r;
    if (!expected.visible[k]) text << ", hidden";
    if (expected.visible[k] != got.visible[k])
      text << (got.visible[k] ? ", WRONGLY VISIBLE" : ", WRONGLY HIDDEN");
    text << "\n";
    if (k == 40) break;
  }
  const auto list = [&](const char* title, const auto& from, const auto& without) {
    auto rest = from;
    rest.erase(
        std::set_difference(from.begin(), from.end(), without.begin(), without.end(), rest.begin()),
        rest.end());
    if (rest.empty()) return;
    text << title << ":";
    for (std::size_t k = 0; k < rest.size() && k < 40; ++k) {
      text << " (";
      for (const int index : rest[k]) text << " " << index;
      text << " )";
    }
    text << "\n";
  };
  list("missing faces", expected.triples, got.triples);
  list("wrong faces", got.triples, expected.triples);
  return text.str();
}

}  // namespace apollonius::test
