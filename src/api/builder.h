// BuilderOf, whose instances are in builder.cpp and spherical_builder.cpp. The Work of each is
// constructed from the diagram, and has:
//   core()                      the diagram's core
//   error                       the error that ended the work
//   reading                     the snapshot that is read, if there is one
//   size()                      number of sites that have been added and are not done
//   reserve(), add(), read(), advance(), progress(), become()
//                               the builder's calls, with checked arguments; throw std::bad_alloc
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "api/checks.h"
#include "apollonius/builder.h"

namespace apollonius {

namespace internal {

/// Reads a snapshot into a new diagram, which will replace the builder's.
template <class Core, class Restoring>
class Reading {
 public:
  template <class... Source>
  Reading(std::unique_ptr<Core> empty, std::vector<std::uint8_t> bytes, Source... source)
      : core_(std::move(empty)), bytes_(std::move(bytes)), restoring_(*core_, bytes_, source...) {}
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  /// Goes on; kCorruptSnapshot if the bytes are none.
  Error advance(std::size_t steps, bool& isDone) {
    const auto state = restoring_.advance(steps);
    isDone = state == Restoring::State::kDone;
    return state == Restoring::State::kCorrupt ? Error::kCorruptSnapshot : Error::kNone;
  }
  [[nodiscard]] double progress() const { return isTaken() ? 1 : restoring_.progress(); }
  /// Hands over the diagram. REQUIRES: all has been read.
  std::unique_ptr<Core> take() { return std::move(core_); }
  [[nodiscard]] bool isTaken() const { return core_ == nullptr; }

 private:
  std::unique_ptr<Core> core_;
  std::vector<std::uint8_t> bytes_;
  Restoring restoring_;
};

}  // namespace internal

template <class AnyDiagram>
BuilderOf<AnyDiagram>::BuilderOf(AnyDiagram& diagram) : work_(std::make_unique<Work>(diagram)) {}
template <class AnyDiagram>
BuilderOf<AnyDiagram>::~BuilderOf() = default;
template <class AnyDiagram>
BuilderOf<AnyDiagram>::BuilderOf(BuilderOf&&) noexcept = default;

template <class AnyDiagram>
Error BuilderOf<AnyDiagram>::reserve(std::size_t count) {
  return guarded(work_->core(), internal::checkRoom(count, 0), [&] { work_->reserve(count); });
}

template <class AnyDiagram>
Error BuilderOf<AnyDiagram>::add(std::span<const double> sites) {
  const Error error = internal::firstOf(internal::checkLength(sites.size() % 3 == 0),
                                        checkSites(work_->core(), sites),
                                        internal::checkRoom(sites.size() / 3, work_->size()));
  return guarded(work_->core(), error, [&] { work_->add(internal::TakenNumbers(sites)); });
}

template <class AnyDiagram>
Error BuilderOf<AnyDiagram>::read(std::vector<std::uint8_t> bytes, Source source) {
  return guarded(work_->core(), Error::kNone, [&] { work_->read(std::move(bytes), source); });
}

template <class AnyDiagram>
Error BuilderOf<AnyDiagram>::advance(std::size_t steps, bool& isDone) {
  Work& work = *work_;
  isDone = work.error == Error::kNone && work.size() == 0 &&
           (work.reading == nullptr || work.reading->isTaken());
  if (isDone) return Error::kNone;
  Error found = Error::kNone;
  const Error failed = guarded(work.core(), work.error, [&] {
    if (work.reading == nullptr) {
      isDone = work.advance(steps);
      return;
    }
    found = work.reading->advance(steps, isDone);
    if (isDone) work.become(work.reading->take());
  });
  work.error = internal::firstOf(failed, found);
  return work.error;
}

template <class AnyDiagram>
double BuilderOf<AnyDiagram>::progress() const noexcept {
  return work_->reading != nullptr ? work_->reading->progress() : work_->progress();
}

}  // namespace apollonius
