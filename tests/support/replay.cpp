#include "support/replay.h"

namespace apollonius::test {

namespace {

std::string validated(const Diagram& diagram) {
  std::string broken;
  if (diagram.validate(broken) != Error::kNone) return "validate() failed";
  return broken.empty() ? std::string() : "validate(): " + broken;
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

std::string Replay::apply(const Operation& operation) {
  const Circle& c = operation.circle;
  switch (operation.kind) {
    case Operation::Kind::kInsert: {
      SiteId id = kNoSite;
      if (diagram_.insert(c.x, c.y, c.r, id) != Error::kNone) return "insert failed";
      for (const Entry& entry : entries_) {
        if (entry.lives && entry.id == id) return "insert gave an id that is taken";
      }
      entries_.push_back({c, id, true});
      ++size_;
      break;
    }
    case Operation::Kind::kRemove: {
      Entry& entry = entries_.at(operation.target);
      bool removed = false;
      if (diagram_.remove(entry.id, removed) != Error::kNone || !removed) return "remove failed";
      if (diagram_.has(entry.id)) return "a removed site is still there";
      entry.lives = false;
      --size_;
      break;
    }
    case Operation::Kind::kUpdate: {
      Entry& entry = entries_.at(operation.target);
      if (diagram_.update(entry.id, c.x, c.y, c.r) != Error::kNone) return "update failed";
      entry.circle = c;
      break;
    }
    case Operation::Kind::kRestore: {
      std::vector<std::uint8_t> bytes;
      if (diagram_.toBytes(bytes) != Error::kNone) return "toBytes failed";
      if (diagram_.fromBytes(bytes, Source::kTrusted) != Error::kNone) return "fromBytes failed";
      break;
    }
  }
  if (diagram_.size() != size_) return "wrong size()";
  return {};
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
  for (std::size_t step = 0; step < history.size(); ++step) {
    std::string wrong = replay.apply(history[step]);
    const bool last = step + 1 == history.size();
    // To validate a restored diagram is to ask for all of its circles: the next operation is to meet it without them.
    if (wrong.empty() && history[step].kind == Operation::Kind::kRestore && !last) continue;
    if (wrong.empty() && checks.validateEveryStep) wrong = validated(replay.diagram());
    if (wrong.empty() && (last || checks.compareEveryStep)) wrong = compared(replay.diagram(), replay.survivors(), checks);
    if (!wrong.empty()) return std::string("after operation ").append(std::to_string(step)).append(": ").append(wrong);
  }
  return {};
}

Canonical freshBuild(const Circles& circles, Build build, Location location, std::string& broken) {
  Diagram diagram(location);
  if (build == Build::kBulk) {
    std::vector<double> xyr;
    for (const Circle& c : circles) xyr.insert(xyr.end(), {c.x, c.y, c.r});
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
  const History shorter = shorten(history, [&](const History& candidate) { return !checkHistory(candidate, checks).empty(); });
  return wrong + "\nshortened to:\n" + toText(shorter) + checkHistory(shorter, checks);
}

}  // namespace apollonius::test
