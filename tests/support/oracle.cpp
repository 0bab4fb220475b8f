#include "support/oracle.h"

#include <algorithm>
#include <stdexcept>

#include "support/oracle_numbers.h"

namespace apollonius::test {

namespace {

struct ExactSite {
  Integer x, y, r;
};

/// Same order as oracleSmaller.
bool smaller(const ExactSite& a, const ExactSite& b) {
  if (a.r != b.r) return a.r < b.r;
  if (a.x != b.x) return a.x < b.x;
  return a.y < b.y;
}

/// A Voronoi circle of three finite sites, seen from the first of them: centre and distance from
/// that site's centre are (x + x1*sqrt(d)) / n and so on, with n > 0 left out because only signs
/// are asked for.
struct TouchingCircle {
  Integer x, x1, y, y1, rho, rho1;
  Integer n;
  Integer d;
};

/// Sign of l*x + m*y + k*rho + c at the circle, all numbers multiplied by n.
int signAt(const TouchingCircle& circle, const Integer& l, const Integer& m, const Integer& k,
           const Integer& c) {
  return signOf(Integer(l * circle.x + m * circle.y + k * circle.rho + c * circle.n),
                Integer(l * circle.x1 + m * circle.y1 + k * circle.rho1), circle.d);
}

/// Both solutions of |c| = rho, |c - b_j| = rho + r_j, |c - b_k| = rho + r_k, squared (so rho etc.
/// can come out negative); j and k are relative to the first site. Returns how many of them are
/// finite: the others lie at infinity, exactly.
int touchingCircles(const ExactSite& j, const ExactSite& k, TouchingCircle (&solutions)[2]) {
  // Differences of the squared equations are linear: 2*(c . b_t + rho*r_t) = p_t.
  const Integer pj = j.x * j.x + j.y * j.y - j.r * j.r;
  const Integer pk = k.x * k.x + k.y * k.y - k.r * k.r;
  const Integer det = j.x * k.y - j.y * k.x;
  if (signOf(det) != 0) {
    // 2*det * c = a + b*rho, and |c|^2 = rho^2 is the quadratic q2*rho^2 + 2*h*rho + |a|^2 = 0.
    const Integer ax = pj * k.y - pk * j.y;
    const Integer ay = pk * j.x - pj * k.x;
    const Integer bx = -2 * (j.r * k.y - k.r * j.y);
    const Integer by = -2 * (k.r * j.x - j.r * k.x);
    const Integer q2 = bx * bx + by * by - 4 * det * det;
    const Integer h = ax * bx + ay * by;
    const Integer q0 = ax * ax + ay * ay;
    const Integer d = h * h - q2 * q0;
    const Integer denominator = 2 * det * (signOf(q2) == 0 ? Integer(2 * h) : q2);
    const int flip = signOf(denominator);
    if (signOf(q2) == 0) {
      if (flip == 0) return 0;
      // rho = -q0 / (2h); the other solution went to infinity.
      solutions[0] = {flip * (2 * h * ax - bx * q0),
                      0,
                      flip * (2 * h * ay - by * q0),
                      0,
                      -2 * flip * det * q0,
                      0,
                      flip * denominator,
                      d};
      return 1;
    }
    for (int root = 0; root < 2; ++root) {
      const int unit = (root == 0 ? 1 : -1) * flip;
      solutions[root] = {
          flip * (ax * q2 - bx * h), unit * bx,      flip * (ay * q2 - by * h), unit * by,
          -2 * flip * det * h,       2 * unit * det, flip * denominator,        d};
    }
    return 2;
  }
  // The centres are collinear: c = (u*e + w*e') / E with e along the line, e' its left normal, E =
  // |e|^2. The linear equations give u and rho, and w = +-sqrt(rho^2 * E - u^2).
  const bool concentric = signOf(j.x) == 0 && signOf(j.y) == 0;
  const Integer ex = concentric ? k.x : j.x;
  const Integer ey = concentric ? k.y : j.y;
  const Integer E = ex * ex + ey * ey;
  const Integer tj = j.x * ex + j.y * ey;
  const Integer tk = k.x * ex + k.y * ey;
  // 2*(u*t/E + rho*r) = p for both: u = E*(pj*rk - pk*rj) / (2*m), rho = (tj*pk - tk*pj) / (2*m), m
  // = tj*rk - tk*rj.
  const Integer m = tj * k.r - tk * j.r;
  if (signOf(m) == 0) return 0;
  const int flip = signOf(m);
  const Integer u = flip * E * (pj * k.r - pk * j.r);
  const Integer rho = flip * (tj * pk - tk * pj);
  const Integer n = 2 * flip * m;
  const Integer d = rho * rho * E - u * u;
  for (int root = 0; root < 2; ++root) {
    const int unit = root == 0 ? 1 : -1;  // everything times E, the denominator too
    solutions[root] = {u * ex, -unit * ey, u * ey, unit * ex, rho * E, 0, n * E, d};
  }
  return 2;
}

enum class Verdict { kNoCircle, kFree, kInConflict, kUndetermined };

Verdict worse(int sign) {
  return sign > 0 ? Verdict::kInConflict : sign < 0 ? Verdict::kFree : Verdict::kUndetermined;
}

ExactSite relativeTo(const ExactSite& origin, const ExactSite& site) {
  return {site.x - origin.x, site.y - origin.y, site.r - origin.r};
}

/// The circle that touches the sites in the order (first, j, k): kFree with `result` set, or
/// kNoCircle; kUndetermined only where a site covers another.
Verdict findCircle(const ExactSite& j, const ExactSite& k, TouchingCircle& result) {
  TouchingCircle circles[2];
  const int finite = touchingCircles(j, k, circles);
  bool found = false;
  for (int solution = 0; solution < finite; ++solution) {
    const TouchingCircle& circle = circles[solution];
    if (signOf(circle.d) < 0) continue;
    if (signOf(circle.d) == 0) return Verdict::kUndetermined;
    const int si = signAt(circle, 0, 0, 1, 0);
    const int sj = signAt(circle, 0, 0, 1, j.r);
    const int sk = signAt(circle, 0, 0, 1, k.r);
    if (si < 0 || sj < 0 || sk < 0) continue;
    if (si == 0 || sj == 0 || sk == 0) return Verdict::kUndetermined;
    // Orientation of the contact directions (b_t - c) / rho_t: the determinant of the rows (b_t -
    // c, rho_t).
    const int turn =
        signAt(circle, k.y * j.r - j.y * k.r, j.x * k.r - k.x * j.r, j.x * k.y - j.y * k.x, 0);
    if (turn < 0) continue;
    if (turn == 0) return Verdict::kUndetermined;
    if (found) throw std::logic_error("oracle: two Voronoi circles of one orientation");
    found = true;
    result = circle;
  }
  return found ? Verdict::kFree : Verdict::kNoCircle;
}

/// Is the circle of a face, seen from its first site, free of a site?
Verdict judgeCircle(const TouchingCircle& circle, const ExactSite& first, const ExactSite& q) {
  // |c - b_q| < rho + r_q: never if the right side is negative; else the squares.
  const ExactSite t = relativeTo(first, q);
  if (signAt(circle, 0, 0, 1, t.r) < 0) return Verdict::kFree;
  return worse(signAt(circle, 2 * t.x, 2 * t.y, 2 * t.r, -(t.x * t.x + t.y * t.y - t.r * t.r)));
}

/// Face (i, j, k) of finite sites. `q` may be null: only existence is asked, kFree or kNoCircle. A
/// circle whose clearance is not less than the horizon does not count; without a horizon, only a
/// line does not.
Verdict judgeFinite(const ExactSite& i, const ExactSite& j, const ExactSite& k, const ExactSite* q,
                    const Integer* horizon) {
  TouchingCircle circle;
  const Verdict existence = findCircle(relativeTo(i, j), relativeTo(i, k), circle);
  if (existence != Verdict::kFree) return existence;
  if (horizon != nullptr && signAt(circle, 0, 0, 1, -(*horizon + i.r)) >= 0)
    return Verdict::kNoCircle;
  return q == nullptr ? Verdict::kFree : judgeCircle(circle, i, *q);
}

/// Face (a, b, infinity): the circle that touches both and whose clearance is the horizon, to the
/// left of the way from a to b.
Verdict judgeHorizon(const ExactSite& a, const ExactSite& bAbsolute, const ExactSite& q,
                     const Integer& horizon) {
  const ExactSite b = relativeTo(a, bAbsolute);
  const Integer rho = horizon + a.r, square = b.x * b.x + b.y * b.y;
  // |c| = rho and |c - b| = rho + r_b: 2 (c . b) = |b|^2 - r_b^2 - 2 rho r_b, and the rest of c is
  // along b's left normal.
  const Integer along = square - b.r * b.r - 2 * rho * b.r;
  const TouchingCircle circle{
      along * b.x,      -b.y, along * b.y, b.x,
      2 * square * rho, 0,    2 * square,  4 * rho * rho * square - along * along};
  return judgeCircle(circle, a, q);
}

/// Judges in the limit: the half-plane {n . x >= n . b_a + r_a} that touches both, with unit normal
/// n to the left of the way from contact point a to contact point b.
Verdict judgeHalfPlane(const ExactSite& a, const ExactSite& bAbsolute, const ExactSite& q) {
  const ExactSite b = relativeTo(a, bAbsolute);
  const ExactSite t = relativeTo(a, q);
  // n = (-r*b + sqrt(p)*b') / |b|^2 with b' the left normal of b; q sticks out if n . t + r_t > 0.
  const Integer square = b.x * b.x + b.y * b.y;
  return worse(signOf(Integer(t.r * square - b.r * (b.x * t.x + b.y * t.y)),
                      Integer(b.x * t.y - b.y * t.x), Integer(square - b.r * b.r)));
}

/// Along the half-plane of judgeHalfPlane: does q, which touches it too, touch it between a and b?
bool touchesBetween(const ExactSite& a, const ExactSite& bAbsolute, const ExactSite& q) {
  const ExactSite b = relativeTo(a, bAbsolute);
  const Integer p = b.x * b.x + b.y * b.y - b.r * b.r;
  // Positions along the tangent (n_y, -n_x), which leads from a to b; n as in judgeHalfPlane, times
  // |b|^2.
  const auto signOfPosition = [&](const Integer& x, const Integer& y) {
    return signOf(Integer(b.r * (b.x * y - b.y * x)), Integer(b.x * x + b.y * y), p);
  };
  const ExactSite t = relativeTo(a, q);
  return signOfPosition(t.x, t.y) > 0 && signOfPosition(b.x - t.x, b.y - t.y) > 0;
}

class Oracle {
 public:
  Oracle(const Circles& circles, Perturb perturb) : perturb_(perturb) {
    int unit = lowestBit(0);
    for (const Circle& c : circles) unit = std::min(unit, lowestBit({c.x, c.y, c.r}));
    unsigned bits = 1;
    for (const Circle& c : circles) {
      sites_.push_back({scaled(c.x, unit), scaled(c.y, unit), scaled(c.r, unit)});
      for (const Integer* value : {&sites_.back().x, &sites_.back().y, &sites_.back().r}) {
        if (signOf(*value) != 0) bits = std::max(bits, static_cast<unsigned>(msb(abs(*value))) + 1);
      }
    }
    // Generous: nonzero results of numbers of b bits are a few times b bits away from zero, and
    // circles are at most a few times b bits large. A tiny weight must not be seen from the
    // horizon.
    const unsigned horizonBits = 60 + 12 * bits;
    horizon_ = Integer(1) << horizonBits;
    step_ = perturb == Perturb::kEverything ? 2 * horizonBits : 40 + 8 * bits;
    rank_.resize(sites_.size());
    for (std::size_t k = 0; k < sites_.size(); ++k) {
      for (const ExactSite& other : sites_) rank_[k] += smaller(sites_[k], other);
    }
  }

  bool hidden(std::size_t k) const {
    for (std::size_t other = 0; other < sites_.size(); ++other) {
      if (other == k || !covers(sites_[other], sites_[k])) continue;
      const bool identical = covers(sites_[k], sites_[other]);
      if (!identical || other < k) return true;
    }
    return false;
  }

  static bool covers(const ExactSite& outer, const ExactSite& inner) {
    const ExactSite t = relativeTo(outer, inner);
    return signOf(t.r) <= 0 && signOf(Integer(t.x * t.x + t.y * t.y - t.r * t.r)) <= 0;
  }

  /// Face (i, j, k) counter-clockwise, i finite; q: a site, or `kNoQuery` to ask for existence
  /// only.
  static constexpr int kNoQuery = -2;
  Verdict judge(int i, int j, int k, int q) const {
    if (j == kInfinity) return judge(k, i, j, q);
    std::vector<int> involved{i, j};
    if (k != kInfinity) involved.push_back(k);
    if (q >= 0) involved.push_back(q);
    std::sort(involved.begin(), involved.end(), [&](int a, int b) { return rank_[a] < rank_[b]; });
    if (k == kInfinity && q < 0) return Verdict::kFree;
    if (k == kInfinity && perturb_ == Perturb::kWhereNeeded) {
      const Verdict verdict = judgeHalfPlane(sites_[i], sites_[j], sites_[q]);
      if (verdict != Verdict::kUndetermined) return verdict;
    }
    const std::size_t last = involved.size();
    for (std::size_t level = perturb_ == Perturb::kEverything ? last : 0; level <= last; ++level) {
      const ExactSite a = perturbed(i, involved, level);
      const ExactSite b = perturbed(j, involved, level);
      ExactSite query;
      if (q >= 0) query = perturbed(q, involved, level);
      const Integer horizon = horizon_ << step_ * static_cast<unsigned>(level);
      const Verdict verdict =
          k == kInfinity
              ? judgeHorizon(a, b, query, horizon)
              : judgeFinite(a, b, perturbed(k, involved, level), q >= 0 ? &query : nullptr,
                            perturb_ == Perturb::kEverything ? &horizon : nullptr);
      if (verdict != Verdict::kUndetermined) return verdict;
    }
    throw std::logic_error("oracle: zero in spite of the perturbation");
  }

  /// Unperturbed: do the cells of i and j share an edge that runs to infinity, i on its left?
  bool isUnboundedEdge(int i, int j, const std::vector<int>& among) const {
    return std::none_of(among.begin(), among.end(), [&](int q) {
      if (q == i || q == j) return false;
      const Verdict verdict = judgeHalfPlane(sites_[i], sites_[j], sites_[q]);
      return verdict == Verdict::kInConflict ||
             (verdict == Verdict::kUndetermined && touchesBetween(sites_[i], sites_[j], sites_[q]));
    });
  }

 private:
  /// Site k in finer units, the `level` largest of the involved ones enlarged.
  ExactSite perturbed(int k, const std::vector<int>& involved, std::size_t level) const {
    ExactSite site = sites_[k];
    if (level == 0) return site;
    const unsigned levels = static_cast<unsigned>(level);
    for (Integer* value : {&site.x, &site.y, &site.r}) *value <<= step_ * levels;
    for (unsigned order = 0; order < levels; ++order) {
      if (involved[order] == k) site.r += Integer(1) << step_ * (levels - 1 - order);
    }
    return site;
  }

  std::vector<ExactSite> sites_;
  std::vector<int>
      rank_;  ///< 0 for the largest; identical sites share a rank, but only one of them is visible
  unsigned step_ = 0;
  Integer horizon_;  ///< where infinity begins, in units of sites_
  Perturb perturb_;
};

}  // namespace

OracleDiagram oracleDiagram(const Circles& circles, Perturb perturb) {
  const Oracle oracle(circles, perturb);
  OracleDiagram diagram;
  std::vector<int> visible;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    diagram.visible.push_back(!oracle.hidden(k));
    if (diagram.visible.back()) visible.push_back(static_cast<int>(k));
  }
  const auto isVertex = [&](int i, int j, int k) {
    if (oracle.judge(i, j, k, Oracle::kNoQuery) == Verdict::kNoCircle) return false;
    return std::none_of(visible.begin(), visible.end(), [&](int q) {
      return q != i && q != j && q != k && oracle.judge(i, j, k, q) == Verdict::kInConflict;
    });
  };
  for (const int i :
       visible) {  // the smallest of a finite triple; j, k in both orders are its two orientations
    for (const int j : visible) {
      if (j == i) continue;
      if (isVertex(i, j, kInfinity)) diagram.triples.push_back({kInfinity, i, j});
      if (j < i) continue;
      for (const int k : visible) {
        if (k > i && k != j && isVertex(i, j, k)) diagram.triples.push_back({i, j, k});
      }
    }
  }
  std::sort(diagram.triples.begin(), diagram.triples.end());
  for (const int i : visible) {
    for (const int j : visible) {
      if (i != j && oracle.isUnboundedEdge(i, j, visible)) diagram.unboundedEdges.push_back({i, j});
    }
  }
  return diagram;
}

int oracleCompareDistance(double x, double y, const Circle& a, const Circle& b) {
  const int unit = lowestBit({x, y, a.x, a.y, a.r, b.x, b.y, b.r});
  const Integer px = scaled(x, unit);
  const Integer py = scaled(y, unit);
  const auto square = [&](const Circle& c) {
    const Integer dx = scaled(c.x, unit) - px;
    const Integer dy = scaled(c.y, unit) - py;
    return Integer(dx * dx + dy * dy);
  };
  return signOfRootDifference(square(a), square(b), Integer(scaled(a.r, unit) - scaled(b.r, unit)));
}

int oracleNearest(const Circles& circles, double x, double y) {
  int nearest = -1;
  for (int k = 0; k < static_cast<int>(circles.size()); ++k) {
    if (nearest < 0) {
      nearest = k;
      continue;
    }
    const int sign = oracleCompareDistance(x, y, circles[k], circles[nearest]);
    if (sign < 0 || (sign == 0 && oracleSmaller(circles[nearest], circles[k]))) nearest = k;
  }
  return nearest;
}

bool oracleCovers(const Circle& outer, const Circle& inner) {
  const int unit = lowestBit({outer.x, outer.y, outer.r, inner.x, inner.y, inner.r});
  const auto exact = [&](const Circle& c) {
    return ExactSite{scaled(c.x, unit), scaled(c.y, unit), scaled(c.r, unit)};
  };
  return Oracle::covers(exact(outer), exact(inner));
}

bool oracleSmaller(const Circle& a, const Circle& b) {
  if (a.r != b.r) return a.r < b.r;
  if (a.x != b.x) return a.x < b.x;
  return a.y < b.y;
}

bool oracleCircleIsWithin(const Circle& i, const Circle& j, const Circle& k, const Circle& estimate,
                          double error) {
  const int unit = lowestBit(
      {i.x, i.y, i.r, j.x, j.y, j.r, k.x, k.y, k.r, estimate.x, estimate.y, estimate.r, error});
  const auto exact = [&](const Circle& c) {
    return ExactSite{scaled(c.x, unit), scaled(c.y, unit), scaled(c.r, unit)};
  };
  const ExactSite reference = exact(i);
  TouchingCircle circle;
  const Verdict existence =
      findCircle(relativeTo(reference, exact(j)), relativeTo(reference, exact(k)), circle);
  if (existence != Verdict::kFree) return false;
  // The estimate's clearance s is rho - r_i.
  const ExactSite e{scaled(estimate.x, unit) - reference.x, scaled(estimate.y, unit) - reference.y,
                    scaled(estimate.r, unit) + reference.r};
  const Integer bound = scaled(error, unit);
  const auto within = [&](int l, int m, int n, const Integer& value) {
    return signAt(circle, l, m, n, -value - bound) <= 0 &&
           signAt(circle, l, m, n, -value + bound) >= 0;
  };
  return within(1, 0, 0, e.x) && within(0, 1, 0, e.y) && within(0, 0, 1, e.r);
}

CircleAnswer oracleCircle(const Circles& circles, int i, int j, int k, int q) {
  const Oracle oracle(circles, Perturb::kWhereNeeded);
  if (oracle.judge(i, j, k, Oracle::kNoQuery) == Verdict::kNoCircle) return CircleAnswer::kNoCircle;
  if (q == kInfinity) return CircleAnswer::kFree;
  return oracle.judge(i, j, k, q) == Verdict::kInConflict ? CircleAnswer::kInConflict
                                                          : CircleAnswer::kFree;
}

}  // namespace apollonius::test
