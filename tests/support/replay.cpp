#include "support/replay.h"

namespace apollonius::test {

namespace {

std::string validated(const Diagram& diagram) {
  std::string broken;
  if (diagram.validate(broken) != Error::kNone) return "validate() failed";
  return broken.empty() ? std::string() : "validate(): " + broken;
}

std::vector<double> numbersOf(std::span<const Operation> call) {
  std::vector<double> xyr;
  for (const Operation& operation : call)
    xyr.insert(xyr.end(), {operation.circle.x, operation.circle.y, operation.circle.r});
  return xyr;
}

/// Compares the diagram with everything else that can be known about its circles.
std::string compared(const Diagram& diagram, const Circles& circles, const Checks& checks) {
  std::string broken;
  const Canonical form = canonicalForm(diagram, broken);
  if (!broken.empty()) return broken;
  for (const Build build : {Build::kOneByOne, Build::kBulk}) {
    const Canonical fresh = freshBuild(circles, build, checks.location, broken);
    const std::string title = build == Build::kBulk ? "fresh bulk build" : "fresh build";
    if (!broken.empty()) return title + ": " + broken;
    if (!(form == fresh)) return "differs from a " + title + ":\n" + difference(fresh, form);
  }
  if (circles.size() <= checks.oracleUpTo) {
    const Canonical expected = canonicalByOracle(circles);
    if (!(form == expected)) return "differs from the oracle:\n" + difference(expected, form);
  }
  return {};
}

}  // namespace

std::string Replay::apply(std::span<const Operation> call) {
  std::string wrong;
  switch (call[0].kind) {
    case Operation::Kind::kInsert:
      wrong = insert(call);
      break;
    case Operation::Kind::kRemove:
      wrong = remove(call);
      break;
    case Operation::Kind::kUpdate:
      wrong = update(call);
      break;
    case Operation::Kind::kRestore: {
      std::vector<std::uint8_t> bytes;
      if (diagram_.toBytes(bytes) != Error::kNone) return "toBytes failed";
      if (diagram_.fromBytes(bytes, Source::kTrusted) != Error::kNone) return "fromBytes failed";
      break;
    }
  }
  if (wrong.empty() && diagram_.size() != taken_.size()) return "wrong size()";
  return wrong;
}

std::string Replay::insert(std::span<const Operation> call) {
  std::vector<SiteId> ids(call.size(), kNoSite);
  const std::vector<double> xyr = numbersOf(call);
  const Error error = call.size() == 1 ? diagram_.insert(xyr[0], xyr[1], xyr[2], ids[0])
                                       : diagram_.insertMany(xyr, ids);
  if (error != Error::kNone) return "insert failed";
  for (std::size_t k = 0; k < call.size(); ++k) {
    if (!taken_.insert(ids[k]).second) return "insert gave an id that is taken";
    entries_.push_back({call[k].circle, ids[k], true});
  }
  return {};
}

std::string Replay::remove(std::span<const Operation> call) {
  const std::vector<SiteId> ids = idsOf(call);
  std::size_t removed = 0;
  bool isRemoved = false;
  const Error error =
      call.size() == 1 ? diagram_.remove(ids[0], isRemoved) : diagram_.removeMany(ids, removed);
  if (error != Error::kNone || removed + isRemoved != call.size()) return "remove failed";
  for (std::size_t k = 0; k < call.size(); ++k) {
    if (diagram_.has(ids[k])) return "a removed site is still there";
    entries_[call[k].target].lives = false;
    taken_.erase(ids[k]);
  }
  return {};
}

std::string Replay::update(std::span<const Operation> call) {
  const std::vector<SiteId> ids = idsOf(call);
  const std::vector<double> xyr = numbersOf(call);
  const Error error = call.size() == 1 ? diagram_.update(ids[0], xyr[0], xyr[1], xyr[2])
                                       : diagram_.updateMany(ids, xyr);
  if (error != Error::kNone) return "update failed";
  for (const Operation& operation : call) entries_[operation.target].circle = operation.circle;
  return {};
}

std::vector<SiteId> Replay::idsOf(std::span<const Operation> call) const {
  std::vector<SiteId> ids;
  for (const Operation& operation : call) ids.push_back(entries_.at(operation.target).id);
  return ids;
}

Circles Replay::survivors() const {
  Circles circles;
  for (const Entry& entry : entries_) {
    if (entry.lives) circles.push_back(entry.circle);
  }
  return circles;
}

std::string checkHistory(const History& history, const Checks& checks) {
  Replay replay(checks.location);
  for (std::size_t step = 0, end = 0; step < history.size(); step = end) {
    end = endOfCall(history, step);
    std::string wrong = replay.apply(std::span(history).subspan(step, end - step));
    const bool last = end == history.size();
    // To validate a restored diagram is to ask for all of its circles: the next operation is to
    // meet it without them.
    if (wrong.empty() && history[step].kind == Operation::Kind::kRestore && !last) continue;
    if (wrong.empty() && checks.validateEveryStep) wrong = validated(replay.diagram());
    if (wrong.empty() && (last || checks.compareEveryStep))
      wrong = compared(replay.diagram(), replay.survivors(), checks);
    if (!wrong.empty())
      return std::string("after operation ")
          .append(std::to_string(step))
          .append(": ")
          .append(wrong);
  }
  return {};
}

Canonical freshBuild(const Circles& circles, Build build, Location location, std::string& broken) {
  Diagram diagram(location);
  if (build == Build::kBulk) {
    const std::vector<double> xyr = flat(circles);
    std::vector<SiteId> ids(circles.size());
    if (diagram.insertMany(xyr, ids) != Error::kNone) broken = "insertMany failed";
  } else {
    for (const Circle& c : circles) {
      SiteId id = kNoSite;
      if (diagram.insert(c.x, c.y, c.r, id) != Error::kNone) broken = "insert failed";
    }
  }
  const Canonical form = canonicalForm(diagram, broken);
  if (broken.empty()) broken = validated(diagram);
  return form;
}

std::string failureOf(const History& history, const Checks& checks) {
  const std::string wrong = checkHistory(history, checks);
  if (wrong.empty()) return {};
  const History shorter = shorten(
      history, [&](const History& candidate) { return !checkHistory(candidate, checks).empty(); });
  return wrong + "\nshortened to:\n" + toText(shorter) + checkHistory(shorter, checks);
}

}  // namespace apollonius::test
