#include "support/canonical.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace apollonius::test {

namespace {

bool same(const Circle& a, const Circle& b) { return a.x == b.x && a.y == b.y && a.r == b.r; }

/// Index of the last of the circles equal to `circle` in a sorted vector that contains it.
int lastIndex(const Circles& sorted, const Circle& circle) {
  return static_cast<int>(std::upper_bound(sorted.begin(), sorted.end(), circle, oracleSmaller) - sorted.begin()) - 1;
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

/// Triples of all faces in site ids; infinity is kNoSite. Vertices and edges have to fit them, and each other.
std::vector<std::array<SiteId, 3>> idTriples(const Diagram& diagram, Complaints& complaints) {
  VertexArrays vertices;
  EdgeArrays edges;
  complaints.unless(diagram.vertices(vertices) == Error::kNone, "vertices() failed");
  complaints.unless(diagram.edges(edges) == Error::kNone, "edges() failed");
  const std::size_t vertexCount = vertices.clearance.size();
  complaints.unless(vertices.coordinates.size() == 2 * vertexCount && vertices.sites.size() == 3 * vertexCount,
                    "lengths of vertices()");
  complaints.unless(edges.sites.size() == edges.vertices.size() && edges.sites.size() % 2 == 0, "lengths of edges()");

  std::vector<SiteId> faces;
  complaints.unless(diagram.faces(faces) == Error::kNone && faces.size() % 3 == 0, "faces() failed");
  std::vector<std::array<SiteId, 3>> triples;
  std::set<std::array<SiteId, 3>> known;  // in every rotation
  for (std::size_t k = 0; k + 2 < faces.size(); k += 3) {
    triples.push_back({faces[k], faces[k + 1], faces[k + 2]});
    for (int turn = 0; turn < 3; ++turn) known.insert({faces[k + turn], faces[k + (turn + 1) % 3], faces[k + (turn + 2) % 3]});
  }
  // Each side of each vertex's triple belongs to exactly one end of one edge: count them off.
  std::vector<std::multimap<std::pair<SiteId, SiteId>, bool>> sides(vertexCount);
  for (std::size_t k = 0; k < vertexCount; ++k) {
    const SiteId* s = &vertices.sites[3 * k];
    complaints.unless(known.count({s[0], s[1], s[2]}) == 1, "a vertex is not the vertex of a face");
    for (int side = 0; side < 3; ++side) sides[k].insert({{s[side], s[(side + 1) % 3]}, true});
  }
  for (std::size_t k = 0; k + 1 < edges.sites.size(); k += 2) {
    const SiteId a = edges.sites[k];
    const SiteId b = edges.sites[k + 1];
    // At the end that one walks to, the vertex has a on the left and b on the right: counter-clockwise b, (third), a.
    for (int end = 0; end < 2; ++end) {
      const std::int32_t vertex = edges.vertices[k + end];
      const std::pair<SiteId, SiteId> side = end == 1 ? std::pair{a, b} : std::pair{b, a};
      if (vertex == -1) {
        // An unbounded end, or a vertex at infinity, which vertices() does not list.
      } else if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertexCount) {
        complaints.unless(false, "an edge's end is not a row of vertices()");
      } else {
        auto& left = sides[vertex];
        const auto found = left.find(side);
        complaints.unless(found != left.end(), "an edge does not fit the sites of the vertex at its end");
        if (found != left.end()) left.erase(found);
      }
    }
  }
  for (const auto& left : sides) complaints.unless(left.empty(), "a vertex without three edges");
  return triples;
}

}  // namespace

bool Canonical::operator==(const Canonical& other) const {
  return std::equal(circles.begin(), circles.end(), other.circles.begin(), other.circles.end(), same) &&
         visible == other.visible && triples == other.triples;
}

Canonical canonicalForm(const Diagram& diagram, std::string& broken) {
  Complaints complaints(broken);
  Canonical form;
  std::vector<SiteId> ids;
  complaints.unless(diagram.ids(ids) == Error::kNone, "ids() failed");
  complaints.unless(ids.size() == diagram.size(), "size() is not the number of ids()");
  complaints.unless(std::is_sorted(ids.begin(), ids.end()) && std::adjacent_find(ids.begin(), ids.end()) == ids.end(),
                    "ids() not ascending");

  std::map<SiteId, Circle> circleOf;
  Circles visibleCircles;
  for (const SiteId id : ids) {
    Circle circle{};
    bool hidden = false;
    complaints.unless(diagram.has(id) && diagram.site(id, circle) == Error::kNone, "has() or site() denies an id of ids()");
    complaints.unless(diagram.isHidden(id, hidden) == Error::kNone, "isHidden() failed");
    circleOf[id] = circle;
    form.circles.push_back(circle);
    if (!hidden) visibleCircles.push_back(circle);
  }
  complaints.unless(diagram.visibleSize() == visibleCircles.size(), "visibleSize() is not the number of visible sites");
  complaints.unless(diagram.hiddenSize() + diagram.visibleSize() == diagram.size(), "hiddenSize() + visibleSize() != size()");

  std::sort(form.circles.begin(), form.circles.end(), oracleSmaller);
  form.visible.assign(form.circles.size(), false);
  for (const Circle& circle : visibleCircles) {
    const int index = lastIndex(form.circles, circle);
    complaints.unless(!form.visible[index], "two identical circles are visible");
    form.visible[index] = true;
  }
  for (const std::array<SiteId, 3>& triple : idTriples(diagram, complaints)) {
    Triple indices{};
    for (int k = 0; k < 3; ++k) {
      const auto found = circleOf.find(triple[k]);
      bool hidden = false;
      if (found != circleOf.end()) {
        complaints.unless(diagram.isHidden(triple[k], hidden) == Error::kNone && !hidden, "a vertex or edge of a hidden site");
      }
      complaints.unless(found != circleOf.end() || triple[k] == kNoSite, "a vertex or edge of an unknown site");
      indices[k] = found == circleOf.end() ? kInfinity : lastIndex(form.circles, found->second);
    }
    form.triples.push_back(rotated(indices));
  }
  std::sort(form.triples.begin(), form.triples.end());
  const std::size_t h = visibleCircles.size();
  complaints.unless(form.triples.size() == (h < 2 ? 0 : 2 * h - 2), "number of vertices, those at infinity included, is not 2h - 2");
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
  for (const Triple& triple : diagram.triples) {
    Triple indices{};
    for (int k = 0; k < 3; ++k) indices[k] = triple[k] == kInfinity ? kInfinity : lastIndex(form.circles, circles[triple[k]]);
    form.triples.push_back(rotated(indices));
  }
  std::sort(form.triples.begin(), form.triples.end());
  return form;
}

std::string difference(const Canonical& expected, const Canonical& got) {
  if (expected == got) return {};
  std::ostringstream text;
  text << std::hexfloat;
  if (!std::equal(expected.circles.begin(), expected.circles.end(), got.circles.begin(), got.circles.end(), same)) {
    text << "different circles: " << got.circles.size() << " instead of " << expected.circles.size() << "\n";
    return text.str();
  }
  for (std::size_t k = 0; k < expected.circles.size(); ++k) {
    const Circle& c = expected.circles[k];
    text << "  site " << k << ": " << c.x << " " << c.y << " " << c.r;
    if (!expected.visible[k]) text << ", hidden";
    if (expected.visible[k] != got.visible[k]) text << (got.visible[k] ? ", WRONGLY VISIBLE" : ", WRONGLY HIDDEN");
    text << "\n";
    if (k == 40) break;
  }
  const auto list = [&](const char* title, const std::vector<Triple>& from, const std::vector<Triple>& without) {
    std::vector<Triple> rest;
    std::set_difference(from.begin(), from.end(), without.begin(), without.end(), std::back_inserter(rest));
    text << title << ":";
    for (std::size_t k = 0; k < rest.size() && k < 40; ++k) text << " (" << rest[k][0] << " " << rest[k][1] << " " << rest[k][2] << ")";
    text << "\n";
  };
  list("missing vertices", expected.triples, got.triples);
  list("wrong vertices", got.triples, expected.triples);
  return text.str();
}

}  // namespace apollonius::test
