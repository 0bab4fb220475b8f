#include "support/operations.h"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace apollonius::test {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool hasTarget(Operation::Kind kind) {
  return kind == Operation::Kind::kRemove || kind == Operation::Kind::kUpdate;
}
bool hasCircle(Operation::Kind kind) {
  return kind == Operation::Kind::kInsert || kind == Operation::Kind::kUpdate;
}

std::string hexFloat(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%a", value);
  return buffer;
}

/// The history without operations [first, first + count): operations on circles that are no longer
/// inserted go too, and names close up. The remaining operations of a call stay one call.
History without(const History& history, std::size_t first, std::size_t count) {
  std::vector<std::size_t> newName;
  std::size_t inserted = 0;
  History result;
  bool isCallOpen = false;  // has something of the call that operation k belongs to been kept?
  for (std::size_t k = 0; k < history.size(); ++k) {
    const bool leftOut = k >= first && k < first + count;
    Operation operation = history[k];
    isCallOpen = isCallOpen && operation.isJoined;
    operation.isJoined = isCallOpen;
    if (operation.kind == Operation::Kind::kInsert) {
      newName.push_back(leftOut ? kNone : inserted++);
      if (leftOut) continue;
    } else if (operation.kind == Operation::Kind::kRestore) {
      if (leftOut) continue;
    } else {
      if (leftOut || newName[operation.target] == kNone) continue;
      operation.target = newName[operation.target];
    }
    result.push_back(operation);
    isCallOpen = true;
  }
  return result;
}

}  // namespace

std::size_t endOfCall(const History& history, std::size_t first) {
  std::size_t end = first + 1;
  while (end < history.size() && history[end].isJoined) ++end;
  return end;
}

History insertAll(const Circles& circles) {
  History history;
  for (const Circle& circle : circles) history.push_back({Operation::Kind::kInsert, 0, circle});
  return history;
}

History randomHistory(Random& random, const Circles& pool, std::size_t steps) {
  History history;
  std::vector<std::size_t> live;
  std::size_t inserted = 0;
  bool growing = true;
  const auto draw = [&] { return pool[random.below(pool.size())]; };
  for (std::size_t k = 0; k < steps; ++k) {
    if (random.oneIn(16)) growing = !growing;
    if (k % 11 == 10) history.push_back({Operation::Kind::kRestore, 0, {}});
    const int dice = random.below(8);
    if (live.empty() || dice < (growing ? 5 : 2)) {
      history.push_back({Operation::Kind::kInsert, 0, draw()});
      live.push_back(inserted++);
      continue;
    }
    const std::size_t chosen = random.below(live.size());
    if (dice < 6) {
      history.push_back({Operation::Kind::kRemove, live[chosen], {}});
      live[chosen] = live.back();
      live.pop_back();
    } else {
      history.push_back({Operation::Kind::kUpdate, live[chosen], draw()});
    }
  }
  return history;
}

Circles survivors(const History& history) {
  std::vector<std::optional<Circle>> circles;
  for (const Operation& operation : history) {
    switch (operation.kind) {
      case Operation::Kind::kInsert:
        circles.push_back(operation.circle);
        break;
      case Operation::Kind::kRemove:
        circles[operation.target].reset();
        break;
      case Operation::Kind::kUpdate:
        circles[operation.target] = operation.circle;
        break;
      case Operation::Kind::kRestore:
        break;
    }
  }
  Circles result;
  for (const std::optional<Circle>& circle : circles) {
    if (circle) result.push_back(*circle);
  }
  return result;
}

std::string toText(const History& history) {
  std::string text;
  for (const Operation& operation : history) {
    const Circle& c = operation.circle;
    if (operation.isJoined) text += "and ";
    switch (operation.kind) {
      case Operation::Kind::kInsert:
        text += "insert";
        break;
      case Operation::Kind::kRemove:
        text += "remove ";
        break;
      case Operation::Kind::kUpdate:
        text += "update ";
        break;
      case Operation::Kind::kRestore:
        text += "restore";
        break;
    }
    if (hasTarget(operation.kind)) text += std::to_string(operation.target);
    if (hasCircle(operation.kind)) {
      for (const double value : {c.x, c.y, c.r}) text.append(" ").append(hexFloat(value));
    }
    text += '\n';
  }
  return text;
}

History fromText(const std::string& text, std::string& error) {
  error.clear();
  History history;
  std::vector<bool> lives;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const auto fail = [&](const char* what) {
      error = std::string("line ")
                  .append(std::to_string(number))
                  .append(": ")
                  .append(what)
                  .append(": ")
                  .append(line);
    };
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word[0] == '#') continue;
    Operation operation{Operation::Kind::kInsert, 0, {}};
    operation.isJoined = word == "and";
    if (operation.isJoined && !(words >> word)) word.clear();
    if (word == "remove" || word == "update") {
      operation.kind = word == "remove" ? Operation::Kind::kRemove : Operation::Kind::kUpdate;
    } else if (word == "restore") {
      operation.kind = Operation::Kind::kRestore;
    } else if (word != "insert") {
      fail("not an operation");
      return {};
    }
    const bool canJoin = !history.empty() && history.back().kind == operation.kind &&
                         operation.kind != Operation::Kind::kRestore;
    if (operation.isJoined && !canJoin) {
      fail("not of the kind of the line before");
      return {};
    }
    if (hasTarget(operation.kind)) {
      if (!(words >> operation.target) || operation.target >= lives.size() ||
          !lives[operation.target]) {
        fail("no such circle");
        return {};
      }
    }
    if (hasCircle(operation.kind)) {
      for (double* value : {&operation.circle.x, &operation.circle.y, &operation.circle.r}) {
        words >> word;
        char* end = nullptr;
        *value = std::strtod(word.c_str(), &end);  // istream does not read hex floats
        if (!words || *end != '\0') {
          fail("not three numbers");
          return {};
        }
      }
    }
    if (words >> word && word[0] != '#') {
      fail("too many words");
      return {};
    }
    if (operation.kind == Operation::Kind::kInsert) lives.push_back(true);
    if (operation.kind == Operation::Kind::kRemove) lives[operation.target] = false;
    history.push_back(operation);
  }
  return history;
}

History shorten(History history, const std::function<bool(const History&)>& fails) {
  for (std::size_t count = history.size() / 2 + 1; count > 0;) {
    bool shortened = false;
    for (std::size_t first = 0; first < history.size();) {
      History candidate = without(history, first, count);
      if (fails(candidate)) {
        history = std::move(candidate);
        shortened = true;
      } else {
        first += count;
      }
    }
    if (!shortened || count > 1) count /= 2;
  }
  return history;
}

}  // namespace apollonius::test
