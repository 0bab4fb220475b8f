// A heap that refuses: operator new of a whole test program, to be included by one of its files.
// Two ways to fail: the k-th allocation only, as if others had freed memory in between; and a
// budget of bytes, as on a heap that is full (what an operation itself frees, it may use again).
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <optional>

namespace {

constexpr std::size_t kHeader = alignof(std::max_align_t);  // holds the size of the block behind it

struct Heap {
  std::size_t live = 0;   // bytes
  std::size_t count = 0;  // allocations since the last arming
  std::size_t failures = 0;
  std::size_t wanted = 0;  // bytes that would have been live if the first failure had not been one
  std::optional<std::size_t> failAt;  // the allocation that fails, counted from 0
  std::optional<std::size_t> limit;   // bytes

  bool refuses(std::size_t size) {
    const bool refused = (failAt && count == *failAt) || (limit && live + size > *limit);
    ++count;
    if (refused && failures++ == 0) wanted = live + size;
    return refused;
  }
  void disarm() {
    failAt.reset();
    limit.reset();
  }
  void arm() {
    count = failures = wanted = 0;
    disarm();
  }
};

Heap heap;

}  // namespace

// All forms except the aligned ones, which are not used here: sanitizers have their own array and
// nothrow forms. Not inlined, or g++ takes malloc and free for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (heap.refuses(size)) return nullptr;
  void* block = std::malloc(kHeader + size);
  if (block == nullptr) return nullptr;
  *static_cast<std::size_t*>(block) = size;
  heap.live += size;
  return static_cast<std::byte*>(block) + kHeader;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory == nullptr) return;
  void* block = static_cast<std::byte*>(memory) - kHeader;
  heap.live -= *static_cast<std::size_t*>(block);
  std::free(block);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return operator new(size, std::nothrow);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { operator delete(memory); }
void operator delete[](void* memory) noexcept { operator delete(memory); }
void operator delete[](void* memory, std::size_t) noexcept { operator delete(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { operator delete(memory); }
