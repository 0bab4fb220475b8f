// Wrong snapshots: with a right checksum and, here or there, something else than what was saved;
// and everything that can be asked of the diagram that comes of one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/random.h"

namespace apollonius::test {

/// One to four changes of any part of a snapshot: numbers, words of ids, twins, half-edges of
/// vertices, pairs of the forest; of a twin or an exchange of two words mostly, so that surfaces
/// come of them. The checksum fits.
std::vector<std::uint8_t> mutant(const std::vector<std::uint8_t>& snapshot, Random& random);
/// As above, with this many changes: the counts of the snapshot's header, which may be changed, say
/// where its parts are, so that no mutant can be changed again.
std::vector<std::uint8_t> mutant(const std::vector<std::uint8_t>& snapshot, Random& random,
                                 std::uint64_t changes);

/// Says what is wrong with a diagram that fromBytes has accepted from anyone: it must be the one of
/// the sites that it holds, with their ids, by a fresh build and by brute force. Empty if nothing
/// is.
std::string whatIsWrong(const Diagram& diagram, Random& random);

/// Makes each call some times, reading and changing in turns, in an order that the seed gives;
/// answers are not looked at. After the call that says kCorruptSnapshot all must. Returns whether
/// one did.
bool callEverything(Diagram& diagram, std::uint64_t seed);

}  // namespace apollonius::test
