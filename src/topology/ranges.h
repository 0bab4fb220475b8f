// Ranges of the graph, for range-based loops: the half-edges around a vertex, all faces, all edges.
// A range is valid until the graph changes.
#pragma once

#include <cstdint>
#include <iterator>

#include "topology/ids.h"

namespace apollonius::internal {

/// The half-edges that start at one vertex, counter-clockwise: G is the graph.
template <class G>
class Star {
 public:
  /// `begin` is the first one, or kNoHalfedge for none.
  Star(const G& graph, HalfedgeId begin) : graph_(&graph), begin_(begin) {}

  class Iterator {
   public:
    Iterator(const G& graph, HalfedgeId begin) : graph_(&graph), begin_(begin), h_(begin) {}
    HalfedgeId operator*() const { return h_; }
    Iterator& operator++() {
      h_ = graph_->rotateCcw(h_);
      if (h_ == begin_) h_ = kNoHalfedge;
      return *this;
    }
    bool operator==(std::default_sentinel_t) const { return h_ == kNoHalfedge; }

   private:
    const G* graph_;
    HalfedgeId begin_;
    HalfedgeId h_;
  };

  [[nodiscard]] Iterator begin() const { return {*graph_, begin_}; }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }

 private:
  const G* graph_;
  HalfedgeId begin_;
};

/// The ids 0, 1, 2, … below a limit for which a predicate says so: faces without the free ones,
/// edges as one of their half-edges.
template <class Id, class Predicate>
class Filtered {
 public:
  Filtered(std::uint32_t limit, Predicate isOne) : limit_(limit), isOne_(isOne) {}

  class Iterator {
   public:
    Iterator(std::uint32_t limit, Predicate isOne) : limit_(limit), isOne_(isOne) { skip(); }
    Id operator*() const { return Id{i_}; }
    Iterator& operator++() {
      ++i_;
      skip();
      return *this;
    }
    bool operator==(std::default_sentinel_t) const { return i_ >= limit_; }

   private:
    void skip() {
      while (i_ < limit_ && !isOne_(Id{i_})) ++i_;
    }
    std::uint32_t i_ = 0;
    std::uint32_t limit_;
    Predicate isOne_;
  };

  [[nodiscard]] Iterator begin() const { return {limit_, isOne_}; }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }

 private:
  std::uint32_t limit_;
  Predicate isOne_;
};

}  // namespace apollonius::internal
