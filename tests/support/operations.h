// Histories of a diagram: its insertions, removals and updates, in a form that can be generated,
// replayed, shortened, printed, and kept as a text file (tests/data/regressions/*.sites):
//
//   # a comment: what broke
//   insert x y r       adds a circle; the k-th insert of the history (from 0) is called k from here
//                      on
//   remove k           removes the circle called k
//   update k x y r     moves and resizes it
//   restore            the diagram becomes what its snapshot gives
//   and …              with insert, remove or update: in the same call as the line before, which is
//                      of the same kind: insertMany, removeMany, updateMany
//
// Numbers are decimal or C hex floats; printed ones are hex floats, so that no digit gets lost.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/generators.h"

namespace apollonius::test {

struct Operation {
  enum class Kind { kInsert, kRemove, kUpdate, kRestore };
  Kind kind;
  std::size_t target;     ///< kRemove and kUpdate: which insert made the circle
  Circle circle;          ///< kInsert and kUpdate
  bool isJoined = false;  ///< in one call with the operation before
};

using History = std::vector<Operation>;

History insertAll(const Circles& circles);

/// Index of the first operation behind the call that holds operation `first`.
std::size_t endOfCall(const History& history, std::size_t first);

/// `steps` operations over circles drawn from `pool` (with repetition): about half inserts, a
/// quarter removals and a quarter updates, with a restoration now and then, in phases of growth and
/// decline so that diagrams of few and of many sites both occur.
History randomHistory(Random& random, const Circles& pool, std::size_t steps);

/// The circles that a history leaves, in order of their names.
Circles survivors(const History& history);

std::string toText(const History& history);

/// Reads what toText wrote, or a file written by hand; `error` becomes empty, or says which line is
/// wrong.
History fromText(const std::string& text, std::string& error);

/// Leaves out operations as long as `fails` stays true, and returns what remains: a case that a
/// person can look at. `fails(history)` must be true.
History shorten(History history, const std::function<bool(const History&)>& fails);

}  // namespace apollonius::test
