// libFuzzer target: bytes are read as a sequence of operations on the public API: single ones,
// batches, moves of all circles at once, and sets of hundreds to thousands that a generator draws,
// so that the hierarchy has its levels. validate() runs after each call, and the end is compared
// with fresh builds and, for few sites, with the oracle. A failure prints the history as
// tests/data/regressions wants it. How to run: README.md beside this file.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "support/bytes.h"
#include "support/corpus.h"
#include "support/replay.h"
#include "support/whole_set.h"

namespace apollonius::test {
namespace {

constexpr std::size_t kMostCalls = 48;
constexpr std::size_t kMostSites = 1500;

// Codes that would be some more of many single inserts.
constexpr std::uint8_t kRestoreCode = 0xFD, kSetCode = 0xF9, kMoveAllCode = 0xF5,
                       kRemoveManyCode = 0xF1, kInsertManyCode = 0xED, kMoveSomeCode = 0xE9;

bool isLegal(const Circle& circle) {
  return isInRange(circle.x) && isInRange(circle.y) && isInRange(circle.r);
}

/// An illegal circle must be refused; the history goes on with legal ones only.
void expectRefusal(const Circle& circle) {
  Diagram diagram;
  SiteId id = kNoSite;
  if (diagram.insert(circle.x, circle.y, circle.r, id) == Error::kNone || diagram.size() != 0) {
    std::fprintf(stderr, "an illegal circle was accepted: %a %a %a\n", circle.x, circle.y,
                 circle.r);
    std::abort();
  }
}

/// Makes a history of bytes.
class Decoder {
 public:
  Decoder(Bytes& bytes, Numbers numbers) : bytes_(bytes), numbers_(numbers) {}

  History decode() {
    for (std::size_t call = 0; !bytes_.empty() && call < kMostCalls; ++call) step(bytes_.next());
    return history_;
  }

 private:
  void step(std::uint8_t code) {
    const std::size_t chosen = live_.empty() ? 0 : (code >> 2) % live_.size();
    switch (code) {
      case kRestoreCode:
        add(Operation::Kind::kRestore, 0, {}, false);
        return;
      case kSetCode:
        insertSet();
        return;
      case kMoveAllCode:
        moveAll();
        return;
      case kRemoveManyCode:
        removeMany();
        return;
      case kInsertManyCode:
        someMore(Operation::Kind::kInsert);
        return;
      case kMoveSomeCode:
        someMore(Operation::Kind::kUpdate);
        return;
      default:
        break;
    }
    if ((code & 3) == 3 && !live_.empty()) {
      remove(chosen, false);
      return;
    }
    Circle circle{};
    if (!read(circle)) return;
    if ((code & 3) == 2 && !live_.empty()) {
      update(live_[chosen], circle, false);
    } else {
      insert(circle, false);
    }
  }

  void add(Operation::Kind kind, std::size_t target, const Circle& circle, bool isJoined) {
    history_.push_back({kind, target, circle, isJoined});
  }
  void insert(const Circle& circle, bool isJoined) {
    add(Operation::Kind::kInsert, 0, circle, isJoined);
    live_.push_back(circles_.size());
    circles_.push_back(circle);
  }
  void update(std::size_t target, const Circle& circle, bool isJoined) {
    add(Operation::Kind::kUpdate, target, circle, isJoined);
    circles_[target] = circle;
  }
  void remove(std::size_t at, bool isJoined) {
    add(Operation::Kind::kRemove, live_[at], {}, isJoined);
    live_[at] = live_.back();
    live_.pop_back();
  }

  /// A circle that is legal, as the diagram takes its numbers; one that is not must be refused.
  bool read(Circle& circle) {
    circle.x = taken(number(bytes_, numbers_));
    circle.y = taken(number(bytes_, numbers_));
    circle.r = taken(number(bytes_, numbers_));
    if (isLegal(circle)) return true;
    expectRefusal(circle);
    return false;
  }

  /// Inserts or updates up to 16 circles in one call.
  void someMore(Operation::Kind kind) {
    bool isJoined = false;
    for (int left = bytes_.next() % 16; left >= 0 && !bytes_.empty(); --left) {
      const std::size_t chosen = live_.empty() ? 0 : bytes_.next() % live_.size();
      Circle circle{};
      if (!read(circle) || (kind == Operation::Kind::kUpdate && live_.empty())) continue;
      if (kind == Operation::Kind::kInsert) {
        insert(circle, isJoined);
      } else {
        update(live_[chosen], circle, isJoined);
      }
      isJoined = true;
    }
  }

  /// Inserts a set of a generator, mostly a few dozen, seldom as many as make a level, or two.
  void insertSet() {
    const NamedGenerator& generator = corpus()[bytes_.next() % corpus().size()];
    const std::uint8_t size = bytes_.next();
    Random random(bytes_.next());
    const std::size_t n = size < 200 ? size % 50 + 1u : size < 250 ? 200u : 1200u;
    if (!generator.large && n > 20) return;
    bool isJoined = false;
    for (const Circle& circle : generator.make(random, n)) {
      if (live_.size() >= kMostSites || !isLegal(circle)) break;
      insert(circle, isJoined);
      isJoined = true;
    }
  }

  /// All, or all but some, in one call or (small sets) one by one.
  void moveAll() {
    const WholeMove& move = wholeMoves()[bytes_.next() % wholeMoves().size()];
    const std::uint8_t how = bytes_.next();
    Random random(bytes_.next());
    if (live_.size() < 2) return;
    Circles now;
    for (const std::size_t target : live_) now.push_back(circles_[target]);
    const Circles next = move.make(now, random);
    const bool isOneByOne = (how & 1) != 0 && live_.size() <= 50;
    const unsigned share = how >> 1 & 7;  // eighths stay
    bool isJoined = false;
    for (std::size_t k = 0; k < next.size(); ++k) {
      if (!isLegal(next[k]) || random.below(8u) < share) continue;
      update(live_[k], next[k], isJoined);
      isJoined = !isOneByOne;
    }
  }

  void removeMany() {
    const std::size_t left = live_.size() * bytes_.next() / 256;
    Random random(bytes_.next());
    for (bool isJoined = false; live_.size() > left; isJoined = true)
      remove(random.below(live_.size()), isJoined);
  }

  Bytes& bytes_;
  Numbers numbers_;
  History history_;
  std::vector<std::size_t> live_;  // names of circles
  Circles circles_;                // by name
};

void run(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const std::uint8_t mode = bytes.next();
  const auto numbers = static_cast<Numbers>(mode & 3);
  Checks checks;
  checks.location = (mode & 4) != 0 ? Location::kWalk : Location::kHierarchy;
  checks.oracleUpTo = numbers == Numbers::kRawDoubles ? 4 : 6;
  const History history = Decoder(bytes, numbers).decode();
#ifdef APOLLONIUS_FUZZ_PRINT
  std::fprintf(stderr, "---\n%s", toText(history).c_str());
#endif
  const std::string wrong = checkHistory(history, checks);
  if (wrong.empty()) return;
  std::fprintf(stderr, "%s\n%s", wrong.c_str(), failureOf(history, checks).c_str());
  std::abort();
}

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::run({data, size});
  return 0;
}
