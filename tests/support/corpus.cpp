#include "support/corpus.h"

#include <cmath>

namespace apollonius::test {

namespace {

NamedGenerator hiddenShare(const char* name, Hidden hidden) {
  return {name,
          [hidden](Random& random, std::size_t n) { return randomCircles(random, n, hidden); }};
}

NamedGenerator grid(const char* name, int maxCoordinate, int maxRadius) {
  return {name, [=](Random& random, std::size_t n) {
            return tinyGrid(random, n, maxCoordinate, maxRadius);
          }};
}

NamedGenerator line(const char* name, Line direction, bool equalSpacing, int maxRadius) {
  return {name, [=](Random& random, std::size_t n) {
            return collinear(random, n, direction, equalSpacing, maxRadius);
          }};
}

NamedGenerator squareLattice(const char* name, double spacing, double r) {
  return {name, [=](Random& random, std::size_t n) {
            const int columns = static_cast<int>(std::sqrt(static_cast<double>(n))) + 1;
            const int rows = static_cast<int>(n) / columns + 1;
            return lattice(random, columns, rows, spacing, r);
          }};
}

NamedGenerator extremes(const char* name, Range range) {
  return {name, [range](Random& random, std::size_t n) { return rangeEnds(random, n, range); },
          range != Range::kMixed};
}

}  // namespace

const std::vector<NamedGenerator>& corpus() {
  static const std::vector<NamedGenerator> generators{
      hiddenShare("Points", Hidden::kNone),
      hiddenShare("Hidden5Percent", Hidden::k5Percent),
      hiddenShare("Hidden20Percent", Hidden::k20Percent),
      hiddenShare("Hidden50Percent", Hidden::k50Percent),
      hiddenShare("Hidden95Percent", Hidden::k95Percent),
      {"PowerLaw", powerLaw},
      {"GiantDisk", giantDisk},
      {"Outlier", [](Random& random, std::size_t n) { return outlier(random, n, 1e5); }},
      {"Towns", towns},
      {"EveryScale", everyScale},
      grid("Grid1Radius1", 1, 1),
      grid("Grid2Radius2", 2, 2),
      grid("Grid3Radius0", 3, 0),
      grid("Grid4Radius1", 4, 1),
      grid("Grid6Radius3", 6, 3),
      grid("Grid20Radius10", 20, 10),
      squareLattice("IntegerLattice", 1, 0.5),
      squareLattice("DecimalLattice", 0.1, 0.05),
      {"EqualRadii", equalRadii},
      {"TangentOutside", tangentOutside},
      {"TangentInside", tangentInside},
      {"TangentInLayers", tangentInLayers},
      {"Concentric", concentric},
      line("HorizontalLineEqualSpacing", Line::kHorizontal, true, 0),
      line("VerticalLineEqualSpacing", Line::kVertical, true, 1),
      line("DiagonalLine", Line::kDiagonal, false, 0),
      line("RandomSlopeLine", Line::kRandomSlope, false, 4),
      line("RandomSlopeLineEqualSpacing", Line::kRandomSlope, true, 2),
      {"CocircularPoints", cocircularPoints},
      {"CommonTangent", [](Random& random, std::size_t n) { return commonTangent(random, n, 20); }},
      {"GiantDiskExact", giantDiskExact},
      extremes("Huge", Range::kHuge),
      extremes("Tiny", Range::kTiny),
      extremes("MixedMagnitudes", Range::kMixed),
      {"OneUlpApart", oneUlpApart},
      {"NestedClusters",
       [](Random& random, std::size_t n) { return nestedClusters(random, n, false); }},
      {"NestedClustersFarApart",
       [](Random& random, std::size_t n) { return nestedClusters(random, n, true); }, false},
      {"TangentLine", [](Random& random, std::size_t n) { return tangentLines(random, n, 1, 4); }},
      {"TangentLines", [](Random& random, std::size_t n) { return tangentLines(random, n, 2, 3); }},
      {"ParallelLines",
       [](Random& random, std::size_t n) { return tangentLines(random, n, 2, 0); }},
  };
  return generators;
}

}  // namespace apollonius::test
