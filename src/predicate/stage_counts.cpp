#include "predicate/stage_counts.h"

apollonius::internal::stages::Counts& apollonius::internal::stages::counts() {
  thread_local Counts counts;
  return counts;
}
