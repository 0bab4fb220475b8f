// libFuzzer target: bytes are sites in all but degenerate position (support/close_calls.h). Every
// stage of every predicate that claims to know an answer is compared with the exact stage, and the
// exact answers with the oracle. How to run: README.md beside this file.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "predicate/samples.h"
#include "support/bytes.h"
#include "support/close_calls.h"
#include "support/stage_checks.h"

namespace apollonius::test {

using namespace internal;
namespace {

void expect(bool holds, const char* what, const CloseCall& call) {
  if (holds) return;
  std::fprintf(stderr, "%s is not as the oracle has it\n%s", what, toText(call).c_str());
  std::abort();
}

/// The number of pieces of an edge that q leaves.
std::size_t piecesLeft(const EdgeCorners& e, const Site& q) {
  const bool atK = isVertexInConflict(e.i, e.j, e.k, q), atL = isVertexInConflict(e.j, e.i, e.l, q);
  if (atK != atL) return 1;
  return atK ? (isEntireEdgeInConflict(e, q) ? 0 : 1) : (isInteriorInConflict(e, q) ? 2 : 1);
}

/// All edges of the diagram of all visible circles but the last, which is the query.
void compareEdges(const Circles& visible, const CloseCall& call) {
  const Circles before(visible.begin(), visible.end() - 1);
  const std::vector<Site> sites = toSites(visible);
  const auto faces = facesByEdge(oracleDiagram(before)), left = facesByEdge(oracleDiagram(visible));
  for (const auto& [ends, thirds] : faces) {
    const auto [a, b] = ends;
    if (thirds.size() != 1) continue;  // the triples do not say which ends belong together
    const EdgeCorners edge{corner(sites, a), corner(sites, b), corner(sites, thirds.front()),
                           corner(sites, faces.at({b, a}).front())};
    const auto found = left.find(ends);
    expect(piecesLeft(edge, sites.back()) == (found == left.end() ? 0 : found->second.size()),
           "an edge", call);
  }
}

void compareWithOracle(const CloseCall& call) {
  Circles circles;
  for (const Site& s : call.sites) circles.push_back({s.x, s.y, s.r});
  for (std::size_t a = 0; a < circles.size(); ++a) {
    const std::size_t b = (a + 1) % circles.size();
    const Site &s = call.sites[a], &t = call.sites[b];
    expect(covers(s, t) == oracleCovers(circles[a], circles[b]), "covering", call);
    expect(static_cast<int>(compareDistance(call.x, call.y, s, t)) ==
               oracleCompareDistance(call.x, call.y, circles[a], circles[b]),
           "a distance", call);
  }
  const Circles visible = visibleOnly(circles);
  if (visible.size() < 3) return;
  const std::vector<Site> sites = toSites(visible);
  for (const bool isFlipped : {false, true}) {
    const int a = isFlipped ? 1 : 0, b = isFlipped ? 0 : 1;
    const CircleAnswer exists = oracleCircle(visible, a, b, 2, kInfinity);
    expect(hasVoronoiCircle(sites[a], sites[b], sites[2]) == (exists != CircleAnswer::kNoCircle),
           "a circle", call);
    for (int q = 2; q < static_cast<int>(visible.size()); ++q) {
      expect(isVertexInConflict(&sites[a], &sites[b], nullptr, sites[q]) ==
                 (oracleCircle(visible, a, b, kInfinity, q) == CircleAnswer::kInConflict),
             "a half-plane", call);
      if (q == 2 || exists == CircleAnswer::kNoCircle) continue;
      expect(isVertexInConflict(&sites[a], &sites[b], &sites[2], sites[q]) ==
                 (oracleCircle(visible, a, b, 2, q) == CircleAnswer::kInConflict),
             "a vertex", call);
    }
  }
  compareEdges(visible, call);
}

void run(Bytes bytes) {
  const bool asksOracle = bytes.next() % 8 == 1;  // it takes a hundred times as long
  const CloseCall call = closeCall([&] { return bytes.next(); });
  StageChecks checks;
  checks.ask(call);
  if (checks.disagreements() > 0) {
    std::fprintf(stderr, "%s", checks.report().c_str());
    std::abort();
  }
  if (asksOracle) compareWithOracle(call);
}

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::run(apollonius::test::Bytes({data, size}));
  return 0;
}
