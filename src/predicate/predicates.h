// The questions that the diagram asks, one header each. There are a question's contract and its
// stages, in the order in which they are asked; its .cpp file has the same order. Every answer is
// exact for sites in the documented range; a site covered by another is hidden and no longer asked
// about. Nothing here throws or needs memory. Formulas and proofs: docs/PREDICATES.md.
#pragma once

#include "predicate/bearing.h"
#include "predicate/covers.h"
#include "predicate/distance.h"
#include "predicate/edge_conflict.h"
#include "predicate/edge_order.h"
#include "predicate/hull_turn.h"
#include "predicate/vertex_conflict.h"
