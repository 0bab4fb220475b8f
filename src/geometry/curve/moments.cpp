#include "geometry/curve/moments.h"

#include <array>
#include <limits>

#include "number/fp.h"

namespace apollonius::internal {

namespace {

// The series are used for |z| below this: 2^-2 to the 20th power, times the last coefficient
// (2^-15), is below 2^-53.
constexpr double kSeriesEnd = 0.25;
constexpr int kTerms = 20;

/// Coefficient of z^(k-1) in the sum of g, k = 1, 2, …
constexpr double areaCoefficient(int k) {
  return -1.0 / ((2.0 * k + 1) * (2.0 * k - 1) * (2.0 * k - 3));
}
/// Coefficient of z^(k-2) in the sum of m, k = 2, 3, …
constexpr double momentCoefficient(int k) {
  return -2.0 * (k - 1) / ((2.0 * k + 1) * (2.0 * k - 1) * (2.0 * k - 3) * (2.0 * k - 5));
}

template <double (*Coefficient)(int), int First>
constexpr std::array<double, kTerms> coefficients() {
  std::array<double, kTerms> c{};
  for (int k = 0; k < kTerms; ++k) c[static_cast<std::size_t>(k)] = Coefficient(First + k);
  return c;
}
constexpr auto kAreaCoefficients = coefficients<areaCoefficient, 1>();
constexpr auto kMomentCoefficients = coefficients<momentCoefficient, 2>();

double series(const std::array<double, kTerms>& c, double z) {
  // Most edges are short: a few terms do.
  const double size = absolute(z);
  int k = size < 0.001 ? 5 : size < 0.03 ? 9 : kTerms - 1;
  double sum = c[static_cast<std::size_t>(k)];
  while (k-- > 0) sum = sum * z + c[static_cast<std::size_t>(k)];
  return sum;
}

}  // namespace

// Conditions are written so that NaN ends the recursion: an invalid edge, which a trusted snapshot
// can have, gives it.

ArcFactors arcFactors(double w) {
  const double z = (w - 1) / (w + 1), next = 1 + z;
  if (!(absolute(z) > kSeriesEnd))
    return {2 * next * series(kAreaCoefficients, z), next * next * series(kMomentCoefficients, z)};
  const ArcFactors half = arcFactors(std::sqrt((1 + w) / 2));
  const double share = w / (1 + w), rest = 1 / (1 + w);
  return {share + share * rest * half.area,
          share * share / 3 + share * share * rest / 2 * (half.area + half.moment)};
}

double arcAreaFactor(double w) {
  const double z = (w - 1) / (w + 1);
  if (!(absolute(z) > kSeriesEnd)) return 2 * (1 + z) * series(kAreaCoefficients, z);
  const double share = w / (1 + w);
  return share + share / (1 + w) * arcAreaFactor(std::sqrt((1 + w) / 2));
}

double areaBeyondChord(const Conic& conic) {
  if (conic.isStraight()) return 0;
  return cross(conic.p1 - conic.p0, conic.p2 - conic.p0) / 2 * arcAreaFactor(conic.w);
}

void Moments::add(const Conic& piece, Point origin) {
  const Point a = piece.p0 - origin, b = piece.p2 - origin;
  const double triangle = cross(a, b) / 2;
  area += triangle;
  first = first + (triangle / 3) * (a + b);
  if (piece.isStraight()) return;
  const double control = cross(piece.p1 - piece.p0, piece.p2 - piece.p0) / 2;
  const ArcFactors factors = arcFactors(piece.w);
  const Point m = middle(a, b);
  area += control * factors.area;
  first =
      first + (control * factors.area) * m + (control * factors.moment) * (piece.p1 - origin - m);
}

namespace {

struct GaussNode {
  double x, weight;
};
// Gauss-Legendre, 10 points on [-1, 1] (symmetric): exact for polynomials of degree 19.
constexpr std::array<GaussNode, 5> kGauss{{{0.14887433898163122, 0.29552422471475287},
                                           {0.43339539412924719, 0.26926671930999636},
                                           {0.67940956829902441, 0.21908636251598204},
                                           {0.86506336668898451, 0.14945134915058059},
                                           {0.97390652851717172, 0.066671344308688138}}};

double gaussLength(const Conic& conic) {
  double sum = 0;
  for (const auto& [x, weight] : kGauss)
    sum += weight * (length(conic.tangent((1 - x) / 2)) + length(conic.tangent((1 + x) / 2)));
  return sum / 2;
}

double adaptiveLength(const Conic& conic, double whole, double tolerance, int depth) {
  Conic first, second;
  conic.halve(first, second);
  const double a = gaussLength(first), b = gaussLength(second);
  // If the two differ by so little, the finer one is far better (by a factor of 2^20 for each
  // halving of a smooth piece).
  if (depth == 0 || !(absolute(a + b - whole) > tolerance)) return a + b;
  return adaptiveLength(first, a, tolerance, depth - 1) +
         adaptiveLength(second, b, tolerance, depth - 1);
}

/// Length of a conic whose weight may be above 2. Such a curve changes so fast towards its ends
/// that the quadrature would miss it, so it is halved. A halving takes about the root of the
/// weight, so even 2^1000 is below 2 after eleven.
double halvedLength(const Conic& conic, double tolerance) {
  if (!(conic.w > 2 && conic.w < std::numeric_limits<double>::infinity()))
    return adaptiveLength(conic, gaussLength(conic), tolerance, 40);
  Conic first, second;
  conic.halve(first, second);
  return halvedLength(first, tolerance) + halvedLength(second, tolerance);
}

}  // namespace

double lengthOf(const Conic& conic) {
  const Point p2 = conic.p2 - conic.p0;
  if (conic.isStraight()) return length(p2);
  const Conic shifted{{0, 0},
                      conic.p1 - conic.p0,
                      conic.w,
                      p2};  // so that halving rounds relative to the piece's own size
  Conic first, second;
  shifted.halve(first, second);
  return halvedLength(shifted, powerOfTwo(-46) * (length(first.p2) + length(p2 - first.p2)));
}

}  // namespace apollonius::internal
