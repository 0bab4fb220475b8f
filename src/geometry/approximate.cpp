#include "geometry/approximate.h"

#include "number/fp.h"

namespace apollonius {

namespace {

// Halving a piece of weight w gives two of weight √((1+w)/2): w is 1 up to rounding after 600 halvings at worst (w near 2^1023)
// and the sagitta falls to a quarter or less with each. Points that coincide in doubles end it sooner.
constexpr int kMostHalvings = 640;

bool isSplittable(const Conic& conic, Point m) { return !(m == conic.p0 || m == conic.p2); }

/// Bound on the distance between a conic and the cubic with the same ends and end tangents that meets it at the middle of the
/// arc, in units of the distance from the chord's middle to p1. As a function of z = (w-1)/(w+1) the distance is of order z² (the
/// sixth order in the length of a piece) with a factor that grows from 0.0187 (z = 0) to 0.0725 (z = 1), and less for z < 0.
/// Found by evaluation; tests/geometry/approximate_test.cpp holds it against the curves.
double cubicError(double w) {
  const double z = (w - 1) / (w + 1);
  return z * z * (0.02 + (z > 0 ? 0.054 * z : 0));
}

void draw(const Conic& conic, double tolerance, Path& path, int depth) {
  if (conic.isStraight() || conic.sagitta() <= tolerance) {
    path.line(conic.p2.x, conic.p2.y);
    return;
  }
  const Point p0 = conic.p0, p1 = conic.p1, p2 = conic.p2;
  Conic first, second;
  conic.halve(first, second);
  if (cubicError(conic.w) * length(p1 - middle(p0, p2)) <= tolerance || depth == 0 || !isSplittable(conic, first.p2)) {
    const double share = 4 * conic.w / (3 * (1 + conic.w));  // puts the cubic's middle where the conic's is
    const Point a = p0 + share * (p1 - p0), b = p2 + share * (p1 - p2);
    path.curve(a.x, a.y, b.x, b.y, p2.x, p2.y);
    return;
  }
  draw(first, tolerance, path, depth - 1);
  draw(second, tolerance, path, depth - 1);
}

void flatten(const Conic& conic, double tolerance, std::vector<double>& points, int depth) {
  if (!conic.isStraight() && depth > 0 && !(conic.sagitta() <= tolerance)) {
    Conic first, second;
    conic.halve(first, second);
    if (isSplittable(conic, first.p2)) {
      flatten(first, tolerance, points, depth - 1);
      flatten(second, tolerance, points, depth - 1);
      return;
    }
  }
  points.push_back(conic.p2.x);
  points.push_back(conic.p2.y);
}

}  // namespace

void drawConic(const Conic& conic, double tolerance, Path& path) { draw(conic, tolerance, path, kMostHalvings); }

void flattenConic(const Conic& conic, double tolerance, std::vector<double>& points) {
  flatten(conic, tolerance, points, kMostHalvings);
}

}  // namespace apollonius
