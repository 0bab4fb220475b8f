// BuilderOf, whose instances are in builder.cpp and spherical_builder.cpp. The work of each is made
// of the diagram, and has:
//   core                        of the diagram
//   error                       that ended the work
//   size()                      of the sites that have been added and are not done
//   reserve(), add(), advance(), progress()
//                               as the builder's, of what has been checked; throw std::bad_alloc
#pragma once

#include "api/checks.h"
#include "apollonius/builder.h"

namespace apollonius {

template <class AnyDiagram>
BuilderOf<AnyDiagram>::BuilderOf(AnyDiagram& diagram) : work_(std::make_unique<Work>(diagram)) {}
template <class AnyDiagram>
BuilderOf<AnyDiagram>::~BuilderOf() = default;
template <class AnyDiagram>
BuilderOf<AnyDiagram>::BuilderOf(BuilderOf&&) noexcept = default;

template <class AnyDiagram>
Error BuilderOf<AnyDiagram>::reserve(std::size_t count) {
  return guarded(work_->core, internal::checkRoom(count, 0), [&] { work_->reserve(count); });
}

template <class AnyDiagram>
Error BuilderOf<AnyDiagram>::add(std::span<const double> sites) {
  const Error error = internal::firstOf(internal::checkLength(sites.size() % 3 == 0),
                                        checkSites(work_->core, sites),
                                        internal::checkRoom(sites.size() / 3, work_->size()));
  return guarded(work_->core, error, [&] { work_->add(internal::TakenNumbers(sites)); });
}

template <class AnyDiagram>
Error BuilderOf<AnyDiagram>::advance(std::size_t steps, bool& isDone) {
  Error& error = work_->error;
  isDone = error == Error::kNone && work_->size() == 0;
  if (!isDone) error = guarded(work_->core, error, [&] { isDone = work_->advance(steps); });
  return error;
}

template <class AnyDiagram>
double BuilderOf<AnyDiagram>::progress() const noexcept {
  return work_->progress();
}

}  // namespace apollonius
