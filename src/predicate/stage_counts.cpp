#include "predicate/stage_counts.h"

apollonius::stages::Counts& apollonius::stages::counts() {
  thread_local Counts counts;
  return counts;
}
