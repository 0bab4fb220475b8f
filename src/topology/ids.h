// Typed indices of the graph's arrays. An enumeration each, so that they cannot be mixed; `index`
// turns one into an index.
#pragma once

#include <cstddef>
#include <cstdint>

namespace apollonius::internal {

enum class VertexId : std::uint32_t {};
enum class HalfedgeId : std::uint32_t {};
enum class FaceId : std::uint32_t {};

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;
inline constexpr VertexId kNoVertex{kNoIndex};
inline constexpr HalfedgeId kNoHalfedge{kNoIndex};
inline constexpr FaceId kNoFace{kNoIndex};

/// The vertex of the site at infinity.
inline constexpr VertexId kInfinity{0};

constexpr std::size_t index(VertexId v) { return static_cast<std::size_t>(v); }
constexpr std::size_t index(HalfedgeId h) { return static_cast<std::size_t>(h); }
constexpr std::size_t index(FaceId f) { return static_cast<std::size_t>(f); }

// --- Three half-edges a face, counter-clockwise: 3f, 3f+1, 3f+2

constexpr FaceId faceOf(HalfedgeId h) { return FaceId{static_cast<std::uint32_t>(h) / 3}; }
constexpr HalfedgeId halfedgeOf(FaceId f, unsigned corner) {
  return HalfedgeId{static_cast<std::uint32_t>(f) * 3 + corner};
}
constexpr HalfedgeId next(HalfedgeId h) {
  const auto i = static_cast<std::uint32_t>(h);
  return HalfedgeId{i % 3 == 2 ? i - 2 : i + 1};
}
constexpr HalfedgeId previous(HalfedgeId h) {
  const auto i = static_cast<std::uint32_t>(h);
  return HalfedgeId{i % 3 == 0 ? i + 2 : i - 1};
}

}  // namespace apollonius::internal
