#include "support/whole_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "support/replay.h"

namespace apollonius::test {

WholeSet::WholeSet(const Circles& circles, Location location) : diagram_(location) {
  insert(circles);
}

std::string WholeSet::insert(const Circles& more) {
  std::vector<SiteId> ids(more.size());
  if (diagram_.insertMany(flat(more), ids) != Error::kNone) return "insertMany failed";
  circles_.insert(circles_.end(), more.begin(), more.end());
  ids_.insert(ids_.end(), ids.begin(), ids.end());
  return std::set<SiteId>(ids_.begin(), ids_.end()).size() == ids_.size()
             ? ""
             : "insertMany gave an id twice";
}

std::string WholeSet::remove(const std::vector<std::size_t>& positions) {
  std::vector<SiteId> ids;
  std::vector<bool> isRemoved(circles_.size(), false);
  for (const std::size_t k : positions) {
    ids.push_back(ids_[k]);
    isRemoved[k] = true;
  }
  std::size_t removed = 0;
  if (diagram_.removeMany(ids, removed) != Error::kNone || removed != ids.size())
    return "removeMany failed";
  std::size_t kept = 0;
  for (std::size_t k = 0; k < circles_.size(); ++k) {
    if (isRemoved[k]) continue;
    circles_[kept] = circles_[k];
    ids_[kept++] = ids_[k];
  }
  circles_.resize(kept);
  ids_.resize(kept);
  return {};
}

std::string WholeSet::restore() {
  std::vector<std::uint8_t> bytes;
  return diagram_.toBytes(bytes) == Error::kNone && diagram_.fromBytes(bytes) == Error::kNone
             ? ""
             : "toBytes or fromBytes failed";
}

std::string WholeSet::update(const std::vector<std::size_t>& positions, const Circles& next) {
  std::vector<SiteId> ids;
  Circles circles;
  for (const std::size_t k : positions) {
    ids.push_back(ids_[k]);
    circles.push_back(next[k]);
  }
  if (diagram_.updateMany(ids, flat(circles)) != Error::kNone) return "updateMany failed";
  for (const std::size_t k : positions) circles_[k] = next[k];
  return {};
}

std::string WholeSet::moveTo(const Circles& next, Way way, Random& random) {
  std::vector<std::size_t> all(circles_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  random.shuffle(all);
  std::string wrong;
  switch (way) {
    case Way::kTogether:
      return update(all, next);
    case Way::kRestored:
      wrong = restore();
      return wrong.empty() ? update(all, next) : wrong;
    case Way::kInParts: {
      const auto ends = {all.size() / 50 + 1, all.size() / 2 + 1, all.size()};
      std::size_t begin = 0;
      for (const std::size_t end : ends) {
        if (end <= begin || end > all.size()) continue;
        const auto at = [&](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
        wrong = update({at(begin), at(end)}, next);
        if (wrong.empty() && end < all.size() && diagram_.size() < 400)
          wrong = check(random);  // half-way
        if (!wrong.empty()) return wrong;
        begin = end;
      }
      return {};
    }
    case Way::kOneByOne:
      break;
  }
  for (const std::size_t k : all) {
    if (diagram_.update(ids_[k], next[k].x, next[k].y, next[k].r) != Error::kNone)
      return "update failed";
    circles_[k] = next[k];
  }
  return {};
}

std::string WholeSet::check(Random& random) const {
  std::string broken;
  if (diagram_.validate(broken) != Error::kNone) return "validate() failed";
  if (!broken.empty()) return "validate(): " + broken;
  const Canonical form = canonicalForm(diagram_, broken);
  if (!broken.empty()) return broken;
  for (std::size_t k = 0; k < circles_.size(); ++k) {
    Circle circle{};
    if (diagram_.site(ids_[k], circle) != Error::kNone) return "an id got lost";
    if (circle.x != circles_[k].x || circle.y != circles_[k].y || circle.r != circles_[k].r)
      return "a site is elsewhere";
  }
  const Canonical fresh = freshBuild(circles_, Build::kBulk, Location::kHierarchy, broken);
  if (!broken.empty()) return "fresh build: " + broken;
  if (!(form == fresh)) return "differs from a fresh build:\n" + difference(fresh, form);
  return findSamples(random);
}

/// Searches at points near sites, where all kinds of cells are.
std::string WholeSet::findSamples(Random& random) const {
  for (int k = 0; k < 20 && !circles_.empty(); ++k) {
    const Circle &a = circles_[random.below(circles_.size())],
                 &b = circles_[random.below(circles_.size())];
    const double share = random.between(-0.3, 1);
    const double x = a.x + share * (b.x - a.x), y = a.y + share * (b.y - a.y);
    double least = std::numeric_limits<double>::infinity(), size = 0;
    const auto distanceTo = [&](const Circle& c) {
      const double dx = c.x - x, dy = c.y - y;
      return std::sqrt(dx * dx + dy * dy) - c.r;
    };
    for (const Circle& c : circles_) {
      least = std::min(least, distanceTo(c));
      size = std::max({size, std::abs(c.x), std::abs(c.y), std::abs(c.r)});
    }
    SiteId id = kNoSite;
    double distance = 0;
    if (diagram_.find(x, y, id, distance) != Error::kNone) return "find failed";
    Circle found{};
    if (diagram_.site(id, found) != Error::kNone) return "find gave no site";
    if (!(distanceTo(found) <= least + 1e-12 * size))
      return "find gave a site that is not the nearest";
  }
  return {};
}

// --- Moves

namespace {

double extentOf(const Circles& circles) {
  double extent = 0;
  for (const Circle& c : circles)
    extent = std::max({extent, std::abs(c.x - circles[0].x), std::abs(c.y - circles[0].y)});
  return extent > 0 ? extent : 1;
}
/// The approximate distance of neighbours.
double spacingOf(const Circles& circles) {
  return extentOf(circles) / std::sqrt(static_cast<double>(circles.size() + 1));
}

template <class Change>
Circles changed(Circles circles, Change&& change) {
  for (Circle& c : circles) change(c);
  return circles;
}

Circles grown(const Circles& circles, double by) {
  return changed(circles, [=](Circle& c) { c.r += by; });
}

Circles jittered(const Circles& circles, Random& random, double by) {
  return changed(circles, [&](Circle& c) {
    c.x += random.between(-by, by);
    c.y += random.between(-by, by);
    if (random.oneIn(2)) c.r += random.between(-by, by) / 2;
  });
}

/// Towards the mean of three others that are drawn: the circles gather, at first in clumps.
Circles gathered(const Circles& circles, Random& random) {
  Circles next = circles;
  for (Circle& c : next) {
    for (int k = 0; k < 3; ++k) {
      const Circle& other = circles[random.below(circles.size())];
      c.x += (other.x - c.x) / 8;
      c.y += (other.y - c.y) / 8;
    }
  }
  return next;
}

/// Lloyd: each to the mean of its neighbours' centres.
Circles relaxed(const Circles& circles, Random&) {
  WholeSet set(circles);
  Circles next = circles;
  std::vector<SiteId> neighbors;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    if (set.diagram().neighbors(set.ids()[k], neighbors) != Error::kNone || neighbors.empty())
      continue;
    double x = 0, y = 0;
    for (const SiteId id : neighbors) {
      x += circles[id].x;
      y += circles[id].y;
    }
    const auto count = static_cast<double>(neighbors.size());
    next[k].x += (x / count - next[k].x) * 0.75;
    next[k].y += (y / count - next[k].y) * 0.75;
  }
  return next;
}

/// A tick of a simulation of forces: overlapping circles push each other apart along one axis, and
/// all are drawn to the middle.
Circles pushed(const Circles& circles, Random&) {
  Circles next = circles;
  double x = 0, y = 0;
  for (const Circle& c : circles) {
    x += c.x / static_cast<double>(circles.size());
    y += c.y / static_cast<double>(circles.size());
  }
  for (std::size_t k = 1; k < next.size(); ++k) {
    Circle &a = next[k - 1], &b = next[k];
    const double overlap =
        std::abs(a.r) + std::abs(b.r) - std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
    if (overlap > 0) {
      a.x -= overlap / 4;
      b.x += overlap / 4;
    }
    a.x += (x - a.x) / 16;
    a.y += (y - a.y) / 16;
  }
  return next;
}

/// Weights towards prescribed areas: with few neighbours (a small cell, mostly) a weight rises,
/// with many it falls.
Circles balanced(const Circles& circles, Random&) {
  WholeSet set(circles);
  Circles next = circles;
  const double step = spacingOf(circles) / 4;
  std::vector<SiteId> neighbors;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    if (set.diagram().neighbors(set.ids()[k], neighbors) != Error::kNone) continue;
    next[k].r += step * (6 - static_cast<double>(std::min<std::size_t>(neighbors.size(), 12)));
  }
  return next;
}

}  // namespace

const std::vector<WholeMove>& wholeMoves() {
  using C = Circles;
  static const std::vector<WholeMove> moves{
      {"grow a little", [](const C& c, Random&) { return grown(c, spacingOf(c) / 64); }},
      {"grow", [](const C& c, Random&) { return grown(c, spacingOf(c)); }},
      {"grow a lot", [](const C& c, Random&) { return grown(c, extentOf(c) / 2); }},
      {"shrink", [](const C& c, Random&) { return grown(c, -extentOf(c)); }},
      {"grow from points",
       [](const C& c, Random&) { return changed(c, [&](Circle& d) { d.r = 0; }); }},
      {"grow at random",
       [](const C& c, Random& random) {
         const double most = extentOf(c) / 2;
         return changed(c, [&](Circle& d) { d.r += random.between(0, most); });
       }},
      {"double weights",
       [](const C& c, Random&) { return changed(c, [](Circle& d) { d.r *= 2; }); }},
      {"negate weights",
       [](const C& c, Random&) { return changed(c, [](Circle& d) { d.r = -d.r; }); }},
      {"zoom in",
       [](const C& c, Random&) {
         return changed(c, [](Circle& d) { d = {2 * d.x, 2 * d.y, 2 * d.r}; });
       }},
      {"zoom out under the weights",
       [](const C& c, Random&) {
         return changed(c, [](Circle& d) { d = {d.x / 4, d.y / 4, d.r}; });
       }},
      {"shift a little",
       [](const C& c, Random&) {
         const double by = spacingOf(c) / 8;
         return changed(c, [=](Circle& d) { d.x += by; });
       }},
      {"shift afar",
       [](const C& c, Random&) {
         const double by = 3 * extentOf(c);
         return changed(c, [=](Circle& d) { d = {d.x + by, d.y - by, d.r}; });
       }},
      {"turn by a quarter",
       [](const C& c, Random&) { return changed(c, [](Circle& d) { d = {-d.y, d.x, d.r}; }); }},
      {"mirror", [](const C& c, Random&) { return changed(c, [](Circle& d) { d.x = -d.x; }); }},
      {"shuffle",
       [](const C& c, Random& random) {
         C next = c;
         random.shuffle(next);
         return next;
       }},
      {"shuffle weights",
       [](const C& c, Random& random) {
         C next = c, donors = c;
         random.shuffle(donors);
         for (std::size_t k = 0; k < c.size(); ++k) next[k].r = donors[k].r;
         return next;
       }},
      {"swap neighbours in line",
       [](const C& c, Random&) {
         C next = c;
         for (std::size_t k = 1; k < c.size(); k += 2) std::swap(next[k - 1], next[k]);
         return next;
       }},
      {"jitter a little",
       [](const C& c, Random& random) { return jittered(c, random, spacingOf(c) / 256); }},
      {"jitter", [](const C& c, Random& random) { return jittered(c, random, spacingOf(c) / 4); }},
      {"jitter a lot",
       [](const C& c, Random& random) { return jittered(c, random, extentOf(c) / 4); }},
      {"tilt the weights",
       [](const C& c, Random&) {
         return changed(c, [&](Circle& d) { d.r += (d.x - c[0].x) / 2; });
       }},
      {"tilt them more than distances",
       [](const C& c, Random&) {
         return changed(c, [&](Circle& d) { d.r += (d.x - c[0].x) * 1.5; });
       }},
      {"all to one place",
       [](const C& c, Random&) {
         return changed(c, [&](Circle& d) { d = {c[0].x, c[0].y, d.r}; });
       }},
      {"all to one circle",
       [](const C& c, Random&) { return changed(c, [&](Circle& d) { d = c[0]; }); }},
      {"all to one line",
       [](const C& c, Random&) { return changed(c, [&](Circle& d) { d = {d.x, c[0].y, d.r}; }); }},
      {"half of them grow",
       [](const C& c, Random& random) {
         const double by = 2 * spacingOf(c);
         return changed(c, [&](Circle& d) { d.r += random.oneIn(2) ? by : 0; });
       }},
      {"half of them jump",
       [](const C& c, Random& random) {
         const double by = extentOf(c) / 3;
         return changed(c, [&](Circle& d) { d.x += random.oneIn(2) ? by : 0; });
       }},
      {"one grows over all",
       [](const C& c, Random& random) {
         C next = c;
         next[random.below(c.size())].r += 8 * extentOf(c);
         return next;
       }},
      {"gather", gathered},
      {"Lloyd's step", relaxed},
      {"forces", pushed},
      {"balance", balanced},
  };
  return moves;
}

}  // namespace apollonius::test
