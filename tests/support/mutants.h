// Wrong snapshots: they have a right checksum and, here or there, other values than were saved. And
// all questions that can be asked of a diagram that is restored from one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/random.h"

namespace apollonius::test {

/// Makes one to four changes in any part of a snapshot: numbers, words of ids, twins, half-edges of
/// vertices, pairs of the forest. Most change a twin or exchange two words, so that surfaces come
/// of them. The checksum fits.
std::vector<std::uint8_t> mutant(const std::vector<std::uint8_t>& snapshot, Random& random);
/// As above, with this many changes: the counts of the snapshot's header, which may be changed, say
/// where its parts are, so that no mutant can be changed again.
std::vector<std::uint8_t> mutant(const std::vector<std::uint8_t>& snapshot, Random& random,
                                 std::uint64_t changes);

/// Says what is wrong with a diagram that fromBytes has accepted from anyone: it must be the one of
/// the sites that it holds, with their ids, by a fresh build and by brute force. Empty if nothing
/// is.
std::string whatIsWrong(const Diagram& diagram, Random& random);

/// Makes each call some times, reading and changing in turns, in an order that the seed gives, and
/// ignores the answers. After a call returns kCorruptSnapshot, all calls must. Returns whether one
/// did.
bool callEverything(Diagram& diagram, std::uint64_t seed);

}  // namespace apollonius::test
