#include "bench/native/operations.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <span>

#include "bench/native/stage_counts.h"

namespace apollonius::bench {

namespace {

void check(Error error) {
  if (error == Error::kNone) return;
  std::cerr << "operation failed with error " << static_cast<int>(error) << "\n";
  std::exit(1);
}

/// Bytes that malloc has given out.
std::size_t allocated() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Velocities: the fractional parts of multiples of an irrational number, the same in
/// bench/js/ours.mjs.
double fraction(double k, double irrational) { return k * irrational - std::floor(k * irrational); }

double meanSpacing(const std::vector<double>& sites) {
  double low[2] = {sites[0], sites[1]};
  double high[2] = {sites[0], sites[1]};
  for (std::size_t k = 0; k < sites.size(); k += 3) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], sites[k + axis]);
      high[axis] = std::max(high[axis], sites[k + axis]);
    }
  }
  return std::sqrt((high[0] - low[0]) * (high[1] - low[1]) /
                   (static_cast<double>(sites.size()) / 3));
}

}  // namespace

const std::map<std::string, Operations::Operation>& Operations::operations() {
  static const std::map<std::string, Operation> all{
      {"build", &Operations::build},
      {"insert", &Operations::insert},
      {"insertByWalk", &Operations::insertByWalk},
      {"find", &Operations::find},
      {"findNear", &Operations::find},
      {"findMany", &Operations::findMany},
      {"remove", &Operations::remove},
      {"removeMany", &Operations::removeMany},
      {"update", &Operations::update},
      {"updateMany", &Operations::updateMany},
      {"toBytes", &Operations::toBytes},
      {"fromBytes", &Operations::fromBytes},
      {"kNearest", &Operations::kNearest},
      {"removeNearest", &Operations::removeNearest},
  };
  return all;
}

Answer Operations::answer(const Request& request) {
  const auto found = operations().find(request.operation);
  Answer answer;
  if (found == operations().end()) {
    answer.error = "unknown operation " + request.operation;
    return answer;
  }
  load(request.set);
  if (sites_.empty()) {
    answer.error = "no sites in " + request.set;
    return answer;
  }
  answer = (this->*found->second)(request);
  answer.visible = diagram_.visibleSize();
  return answer;
}

void Operations::load(const std::string& set) {
  if (set == set_) return;
  set_ = set;
  sites_ = contender::readDoubles(set + ".sites");
  diagram_ = Diagram();
  isWhole_ = false;
}

void Operations::buildDiagram() {
  ids_.resize(size());
  check(diagram_.insertMany(sites_, ids_));
}

void Operations::ensureDiagram() {
  if (isWhole_) return;
  diagram_ = Diagram();
  buildDiagram();
  isWhole_ = true;
}

std::vector<double> Operations::queries(const Request& request) const {
  const bool isNear = request.operation.ends_with("Near");
  std::vector<double> points = contender::readDoubles(set_ + (isNear ? ".near" : ".box"));
  if (request.count > 0) points.resize(std::min(points.size(), 2 * request.count));
  return points;
}

// --- Construction

Answer Operations::build(const Request& request) {
  std::size_t before = 0;
  const auto prepare = [&] {
    diagram_ = Diagram();
    before = allocated();
  };
  stages::reset();
  Answer answer = sampled(request, size(), prepare, [&](std::size_t&) { buildDiagram(); });
  isWhole_ = true;
  const double bytes = static_cast<double>(allocated() - before) / static_cast<double>(size());
  answer.extra = ",\"bytesPerSite\":" + std::to_string(bytes) +
                 stages::perItem(answer.samples.size() * size());
  return answer;
}

Answer Operations::insertOneByOne(const Request& request, Location location) {
  const std::size_t count = request.count > 0 ? std::min(request.count, size()) : size();
  const auto prepare = [&] {
    diagram_ = Diagram(location);
    isWhole_ = false;
  };
  stages::reset();
  Answer answer = sampled(request, count, prepare, [&](std::size_t& items) {
    forEachUntil(request.limit, items, [&](std::size_t k) {
      SiteId id;
      check(diagram_.insert(sites_[3 * k], sites_[3 * k + 1], sites_[3 * k + 2], id));
    });
  });
  answer.extra = stages::perItem(answer.samples.size() * count);
  return answer;
}

Answer Operations::insert(const Request& request) {
  return insertOneByOne(request, Location::kHierarchy);
}
Answer Operations::insertByWalk(const Request& request) {
  return insertOneByOne(request, Location::kWalk);
}

// --- Snapshots

Answer Operations::toBytes(const Request& request) {
  ensureDiagram();
  std::vector<std::uint8_t> bytes;
  Answer answer = sampled(
      request, size(), [&] { bytes = {}; }, [&](std::size_t&) { check(diagram_.toBytes(bytes)); });
  answer.sink = static_cast<double>(bytes.size());
  return answer;
}

Answer Operations::fromBytes(const Request& request) {
  ensureDiagram();
  std::vector<std::uint8_t> bytes;
  check(diagram_.toBytes(bytes));
  stages::reset();
  const auto restore = [&](std::size_t&) { check(diagram_.fromBytes(bytes, Source::kTrusted)); };
  Answer answer = sampled(request, size(), [&] { diagram_ = Diagram(); }, restore);
  answer.sink = static_cast<double>(bytes.size());
  answer.extra = stages::perItem(answer.samples.size() * size());
  return answer;
}

// --- Queries

Answer Operations::find(const Request& request) {
  ensureDiagram();
  const std::vector<double> points = queries(request);
  double sum = 0;
  stages::reset();
  Answer answer = sampled(
      request, points.size() / 2, [&] { sum = 0; },
      [&](std::size_t& items) {
        forEachUntil(request.limit, items, [&](std::size_t k) {
          SiteId id;
          double distance;
          check(diagram_.find(points[2 * k], points[2 * k + 1], id, distance));
          sum += id;
        });
      });
  answer.sink = sum;
  answer.extra = stages::perItem(answer.samples.size() * points.size() / 2);
  return answer;
}

Answer Operations::findMany(const Request& request) {
  ensureDiagram();
  const std::vector<double> points = queries(request);
  std::vector<SiteId> found(points.size() / 2);
  stages::reset();
  Answer answer = sampled(
      request, found.size(), [] {},
      [&](std::size_t&) { check(diagram_.findMany(points, found, {})); });
  for (const SiteId id : found) answer.sink += id;
  answer.extra = stages::perItem(answer.samples.size() * found.size());
  return answer;
}

/// Ten.
Answer Operations::kNearest(const Request& request) {
  ensureDiagram();
  const std::vector<double> points = queries(request);
  std::vector<SiteId> found;
  double sum = 0;
  Answer answer = sampled(
      request, points.size() / 2, [&] { sum = 0; },
      [&](std::size_t& items) {
        forEachUntil(request.limit, items, [&](std::size_t k) {
          check(diagram_.kNearest(points[2 * k], points[2 * k + 1], 10, found));
          sum += found.back();
        });
      });
  answer.sink = sum;
  return answer;
}

// --- Changes: on the sites at the end of the set

// The visible ones: CGAL cannot remove the others.
std::vector<SiteId> Operations::visibleAtEnd(std::size_t count) const {
  std::vector<SiteId> visible;
  for (std::size_t k = 0; k < count; ++k) {
    const SiteId id = ids_[ids_.size() - 1 - k];
    bool isHidden;
    check(diagram_.isHidden(id, isHidden));
    if (!isHidden) visible.push_back(id);
  }
  return visible;
}

Answer Operations::removed(const Request& request, bool atOnce) {
  ensureDiagram();
  const std::vector<SiteId> ids =
      visibleAtEnd(request.count > 0 ? std::min(request.count, size()) : size());
  std::size_t sum = 0;
  const auto prepare = [&] {
    ensureDiagram();
    stages::reset();
    sum = 0;
  };
  Answer answer = sampled(request, ids.size(), prepare, [&](std::size_t& items) {
    isWhole_ = false;
    if (atOnce) return check(diagram_.removeMany(ids, sum));
    forEachUntil(request.limit, items, [&](std::size_t k) {
      bool isRemoved;
      check(diagram_.remove(ids[k], isRemoved));
      sum += isRemoved;
    });
  });
  answer.sink = static_cast<double>(sum);
  answer.extra = stages::perItem(ids.size());
  return answer;
}

/// The site nearest to each of `count` places: of sites that hide each other, the visible one.
Answer Operations::removeNearest(const Request& request) {
  const std::vector<double> points = queries(request);
  std::size_t sum = 0;
  const auto prepare = [&] {
    ensureDiagram();
    sum = 0;
  };
  Answer answer =
      sampled(request, std::min(points.size() / 2, size() - 1), prepare, [&](std::size_t& items) {
        isWhole_ = false;
        forEachUntil(request.limit, items, [&](std::size_t k) {
          SiteId id;
          double distance;
          bool isRemoved;
          check(diagram_.find(points[2 * k], points[2 * k + 1], id, distance));
          check(diagram_.remove(id, isRemoved));
          sum += isRemoved;
        });
      });
  answer.sink = static_cast<double>(sum);
  return answer;
}

Answer Operations::remove(const Request& request) { return removed(request, false); }
Answer Operations::removeMany(const Request& request) { return removed(request, true); }

// The last `count` sites move at constant velocities of up to `step` mean spacings a frame; each
// frame is one sample.
Answer Operations::moved(const Request& request, bool atOnce) {
  ensureDiagram();
  isWhole_ = false;
  const std::size_t count = request.count > 0 ? std::min(request.count, size()) : size();
  const std::span<const SiteId> ids = std::span(ids_).last(count);
  std::vector<double> moving(sites_.end() - static_cast<std::ptrdiff_t>(3 * count), sites_.end());
  const double step = request.step * meanSpacing(sites_);
  const auto nextFrame = [&] {
    for (std::size_t k = 0; k < count; ++k) {
      moving[3 * k] += step * (2 * fraction(static_cast<double>(k), 0.6180339887498949) - 1);
      moving[3 * k + 1] += step * (2 * fraction(static_cast<double>(k), 0.4142135623730951) - 1);
    }
  };
  stages::reset();
  Answer answer = sampled(request, count, nextFrame, [&](std::size_t& items) {
    if (atOnce) return check(diagram_.updateMany(ids, moving));
    forEachUntil(request.limit, items, [&](std::size_t k) {
      check(diagram_.update(ids[k], moving[3 * k], moving[3 * k + 1], moving[3 * k + 2]));
    });
  });
  answer.extra = stages::perItem(answer.samples.size() * count);
  return answer;
}

Answer Operations::update(const Request& request) { return moved(request, false); }
Answer Operations::updateMany(const Request& request) { return moved(request, true); }

}  // namespace apollonius::bench
