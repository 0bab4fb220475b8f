// Asks every stage of every predicate, cached circles included, and compares what those say that
// claim to know with the exact stage. Used on samples by predicates_fuzz and in numbers by
// predicate_scale.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "number/sign.h"
#include "predicate/circle_fan.h"
#include "predicate/predicates.h"
#include "support/close_calls.h"

namespace apollonius::test {

using namespace internal;

class StageChecks {
 public:
  StageChecks();

  /// All questions that can be asked of these arguments: some sixty.
  void ask(const CloseCall& call);

  /// The number of comparisons with the exact stage, and of those in which it answered zero.
  [[nodiscard]] std::uint64_t calls() const { return sum(&Tally::asked); }
  [[nodiscard]] std::uint64_t zeros() const { return sum(&Tally::zeros); }
  /// The number of calls that only the exact stage could settle.
  [[nodiscard]] std::uint64_t leftToExact() const { return sum(&Tally::left); }
  [[nodiscard]] std::uint64_t disagreements() const { return disagreements_; }
  /// The first few of them, with their arguments.
  [[nodiscard]] const std::string& report() const { return report_; }
  /// Adds what another one has counted.
  void add(const StageChecks& other);
  /// A line for each stage: the share of questions that it settles when the stages before cannot,
  /// and that it could.
  [[nodiscard]] std::string table() const;

 private:
  enum Question : std::size_t {
    kCovers,
    kDistance,
    kCircle,
    kVertex,
    kPoints,
    kRule,
    kEdge,
    kRay,
    kOrder,
    kHull,
    kShadow,
    kUp,
    kCount
  };
  struct Stage {
    const char* name;
    std::uint64_t settles = 0, knows = 0;
  };
  struct Tally {
    const char* name;
    std::vector<Stage> stages;
    std::uint64_t asked = 0, zeros = 0, left = 0;
  };
  struct Face {
    std::array<Corner, 3> corners;
    VoronoiCircle circle;
  };

  [[nodiscard]] std::uint64_t sum(std::uint64_t Tally::* count) const;
  void compare(Question question, Sign exact, std::initializer_list<MaybeSign> stages);
  void expect(bool holds, const char* what);
  void disagree(const char* question, const char* stage);

  bool covers(const Site& a, const Site& b);
  void askDistances();
  void askFaces();
  void askFace(Corner i, Corner j, Corner k);
  bool exists(Corner i, Corner j, Corner k);
  bool isInConflict(const Face& face, const Site& q);
  void askRays(const Face& face);
  void askEdges();
  void askEdge(const EdgeCorners& edge, const Site& q);
  void askHull();
  [[nodiscard]] const Face* faceOf(Corner i, Corner j, Corner k) const;

  std::vector<Tally> tallies_;
  std::uint64_t disagreements_ = 0;
  std::string report_;
  const CloseCall* call_ = nullptr;
  std::vector<const Site*> visible_;
  std::vector<Face> faces_;  // those with a circle, of the sites in hand
};

}  // namespace apollonius::test
