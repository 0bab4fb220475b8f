#include "base/flat_array.h"

#include <cstdint>
#include <cstring>

namespace apollonius::internal {

void FlatBytes::swap(FlatBytes& other) noexcept {
  std::swap(data, other.data);
  std::swap(size, other.size);
  std::swap(room, other.room);
}

FlatBytes& FlatBytes::operator=(FlatBytes&& other) noexcept {
  FlatBytes old(std::move(*this));
  swap(other);
  return *this;
}

void FlatBytes::setRoom(std::size_t n, std::size_t width) {
  if (n > PTRDIFF_MAX / width) throw std::bad_alloc();
  void* const memory = ::operator new(n * width);
  if (size > 0) std::memcpy(memory, data, size * width);
  ::operator delete(data);
  data = memory;
  room = n;
}

void FlatBytes::growTo(std::size_t n, std::size_t width) {
  if (n > room) setRoom(std::max(n, 2 * room), width);
}

}  // namespace apollonius::internal
