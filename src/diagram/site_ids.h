// Public site ids: which are in use and for what, and which are free to be used again. One word a site.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "diagram/vocabulary.h"


namespace apollonius {

/// kPending: in use, but the site is in no structure at the moment; within operations of several steps only.
enum class SiteState : std::uint8_t { kFree = 0, kVisible = 1, kHidden = 2, kPending = 3 };

class SiteIds {
 public:
  [[nodiscard]] std::size_t slots() const { return words_.size(); }
  [[nodiscard]] std::size_t size() const { return words_.size() - freeCount_; }
  [[nodiscard]] std::size_t hiddenCount() const { return hiddenCount_; }
  [[nodiscard]] SiteState state(SiteId id) const {
    return id < words_.size() ? static_cast<SiteState>(words_[id] >> kShift) : SiteState::kFree;
  }

  /// Makes room for one more id and returns it; it is not in use before setState.
  [[nodiscard]] SiteId next() {
    if (freeCount_ == 0) {
      words_.push_back(kEndOfList);
      firstFree_ = static_cast<SiteId>(words_.size() - 1);
      freeCount_ = 1;
    }
    return firstFree_;
  }

  /// Takes the id that next() returned.
  void take(SiteId id, SiteState state) {
    const std::uint32_t following = words_[id] & kListMask;
    firstFree_ = following == kEndOfList ? kNoSite : following;
    --freeCount_;
    words_[id] = 0;
    setState(id, state);
  }

  /// Changes the state of an id in use.
  void setState(SiteId id, SiteState state) {
    hiddenCount_ += state == SiteState::kHidden;
    hiddenCount_ -= this->state(id) == SiteState::kHidden;
    words_[id] = static_cast<std::uint32_t>(state) << kShift;
  }

  void release(SiteId id) {
    hiddenCount_ -= state(id) == SiteState::kHidden;
    words_[id] = firstFree_ == kNoSite ? kEndOfList : firstFree_;
    firstFree_ = id;
    ++freeCount_;
  }

  void reserve(std::size_t slots) { words_.reserve(slots); }

  void clear() { *this = SiteIds{std::move(words_)}; }

  SiteIds() = default;

 private:
  // State in the upper two bits; of a free id, the next free one below.
  static constexpr unsigned kShift = 30;
  static constexpr std::uint32_t kListMask = (std::uint32_t{1} << kShift) - 1;
  static constexpr std::uint32_t kEndOfList = kListMask;
  static_assert(kMostSites < kEndOfList);

  /// Keeps the room of a used array.
  explicit SiteIds(std::vector<std::uint32_t>&& room) : words_(std::move(room)) { words_.clear(); }

  std::vector<std::uint32_t> words_;
  SiteId firstFree_ = kNoSite;
  std::size_t freeCount_ = 0;
  std::size_t hiddenCount_ = 0;
};

}  // namespace apollonius
