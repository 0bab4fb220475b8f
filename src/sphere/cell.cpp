#include "sphere/cell.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace apollonius::internal::sphere {

namespace {

/// Accuracy of a bearing where a vertex is close to the site.
constexpr double kOneDirection = 0x1p-16;

/// The turn from one bearing to another, between -pi and pi; half a turn in either direction is pi.
double turnBetween(double from, double to) {
  const double turn = std::remainder(to - from, kTurn);
  return turn < kOneDirection - kTurn / 2 ? turn + kTurn : turn;
}

/// The edges about a node as sectors. Counter-clockwise about the node, the edge of h runs from the
/// vertex of the face on the right of h to that of the face on the left. The turn between the two,
/// by turnBetween(), is too small by a whole turn for at most one edge. That is so exactly if all
/// turns of the star add up to 0, and the edge is the one with the least turn; other turns can be
/// below 0 by rounding only, however large that is.
class Star {
 public:
  Star(const ProjectedDiagram& diagram, VertexId node, SphericalVertices& vertices)
      : diagram_(diagram),
        graph_(diagram.graph()),
        vertices_(vertices),
        node_(node),
        frame_(diagram.cap(node).centre) {}

  [[nodiscard]] SphericalBisector bisectorWith(VertexId other) const {
    return {diagram_, node_, frame_, other};
  }
  [[nodiscard]] double bearingOf(FaceId f) const { return frame_.bearing(vertices_[f].point); }

  /// The bearing where the sectors of two neighbours meet, `next` being the next one
  /// counter-clockwise: that of the vertex of face `f`.
  [[nodiscard]] double bearingBetween(VertexId neighbor, const SphericalBisector& bisector,
                                      VertexId next, const SphericalBisector& nextBisector,
                                      FaceId f) const {
    // Seen from afar, two close sites have the same bisector, and only the vertex tells where their
    // sectors meet.
    const bool isFromAfar = diagram_.areClose(neighbor, next) && !diagram_.areClose(node_, next);
    return isFromAfar ? bearingOf(f)
                      : bisector.bearingOfNext(nextBisector, [&] { return bearingOf(f); });
  }

  /// The sector of the edge of h, with the turn for its width.
  [[nodiscard]] Sector edge(HalfedgeId h) const {
    const HalfedgeId twin = graph_.twin(h);
    const VertexId before = graph_.apex(twin), neighbor = graph_.target(h), after = graph_.apex(h);
    const SphericalBisector bisector = bisectorWith(neighbor);
    const double from =
        bearingBetween(before, bisectorWith(before), neighbor, bisector, faceOf(twin));
    const double to = bearingBetween(neighbor, bisector, after, bisectorWith(after), faceOf(h));
    return {bisector, from, turnBetween(from, to)};
  }

  /// Replaces turns by widths.
  static void widen(FlatArray<Sector>& sectors) {
    double sum = 0;
    for (const Sector& sector : sectors) sum += sector.width;
    Sector* const round = sum > kTurn / 2 ? nullptr : &sectors[roundOne(sectors)];
    for (Sector& sector : sectors)
      sector.width = &sector == round ? sector.width + kTurn : std::max(sector.width, 0.0);
  }

 private:
  /// The sector that is too small by a whole turn: the one with the least turn, or, if that may be
  /// rounding and all ends are in one direction, the one that is nearest in the opposite direction.
  static std::size_t roundOne(const FlatArray<Sector>& sectors) {
    constexpr double kSure = -0.5;
    double x = 0, y = 0;
    std::size_t least = 0;
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      if (sectors[k].width < sectors[least].width) least = k;
      x -= std::cos(sectors[k].from);
      y -= std::sin(sectors[k].from);
    }
    if (sectors[least].width < kSure) return least;
    const double length = std::sqrt(x * x + y * y);
    const auto distance = [&](std::size_t k) {
      return sectors[k].bisector.at(x / length, y / length).rho();
    };
    // Seen from afar, close sites are equally near.
    constexpr double kEqual = 0x1p-40;
    std::size_t best = least;
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      const double nearer = distance(best) - distance(k);
      if (nearer > kEqual || (nearer > -kEqual && sectors[k].width < sectors[best].width)) best = k;
    }
    return best;
  }

  const ProjectedDiagram& diagram_;
  const Graph& graph_;
  SphericalVertices& vertices_;
  VertexId node_;
  Frame frame_;
};

}  // namespace

Sector sectorOf(const ProjectedDiagram& diagram, HalfedgeId h, SphericalVertices& vertices) {
  const VertexId node = diagram.graph().origin(h);
  Sector sector = Star(diagram, node, vertices).edge(h);
  if (sector.width > kOneDirection) return sector;
  // Computed from the whole star, as the widths of its edges depend on each other.
  FlatArray<Sector> sectors;
  listSectors(diagram, node, vertices, sectors);
  std::size_t k = 0;
  for (const HalfedgeId g : diagram.graph().star(node)) {
    if (g == h) break;
    ++k;
  }
  return sectors[k];
}

void listSectors(const ProjectedDiagram& diagram, VertexId node, SphericalVertices& vertices,
                 FlatArray<Sector>& sectors) {
  sectors.clear();
  const Graph& graph = diagram.graph();
  const Star star(diagram, node, vertices);
  if (graph.isEmpty()) {
    if (diagram.visibleCount() == 2) {
      const SphericalBisector bisector = star.bisectorWith(otherOfTwo(diagram, node));
      sectors.push_back({bisector, bisector.middle() + kTurn / 2, kTurn});
    }
    return;
  }
  for (const HalfedgeId h : graph.star(node))
    sectors.push_back({star.bisectorWith(graph.target(h)), 0, 0});
  // Each end is computed once, for the two edges that meet there.
  const Sector* before = &sectors.back();
  Sector* sector = sectors.data();
  for (const HalfedgeId h : graph.star(node)) {
    const HalfedgeId twin = graph.twin(h);
    sector->from = star.bearingBetween(graph.apex(twin), before->bisector, graph.target(h),
                                       sector->bisector, faceOf(twin));
    before = sector++;
  }
  const Sector* after = sectors.data();
  for (std::size_t k = sectors.size(); k-- > 0;) {
    sectors[k].width = turnBetween(sectors[k].from, after->from);
    after = &sectors[k];
  }
  Star::widen(sectors);
}

}  // namespace apollonius::internal::sphere
