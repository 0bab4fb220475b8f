// A program that has the library's public headers and no others.
#include <apollonius/diagram.h>
#include <apollonius/voronoi.h>

#include <cstdio>
#include <vector>

using namespace apollonius;

int main() {
  const std::vector<double> circles = {0, 0, 1, 8, 0, 2, 3, 7, 0.5};
  std::vector<SiteId> ids(3);
  Diagram diagram;
  if (diagram.insertMany(circles, ids) != Error::kNone) return 1;

  SiteId nearest = kNoSite;
  double distance = 0;
  if (diagram.find(3, 0, nearest, distance) != Error::kNone) return 2;

  CellMeasures measures;
  const Voronoi voronoi(diagram, {-10, -10, 20, 20});
  if (voronoi.cellMeasures(nearest, measures) != Error::kNone) return 3;
  std::printf("site %u at %g, area %.3f\n", nearest, distance, measures.area);
  return 0;
}
