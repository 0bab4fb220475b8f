// FlatArray: a growing array of trivially copyable elements, used like std::vector, whose interface
// it has as far as it is needed.
//
// Every std::vector<T> brings its own code to grow, with a buffer to move over from and a way out
// for each exception: for some thirty types that was a tenth of the wasm module, which every
// visitor of a page loads (bench/README.md, "Size"). Here, what does not depend on T is there once,
// in FlatBytes. Arrays that the library's users get are std::vector.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace apollonius::internal {

/// The memory of an array, in elements of a width that the caller knows.
class FlatBytes {
 public:
  FlatBytes() = default;
  FlatBytes(FlatBytes&& other) noexcept { swap(other); }
  FlatBytes& operator=(FlatBytes&& other) noexcept;
  ~FlatBytes() { ::operator delete(data); }

  void swap(FlatBytes& other) noexcept;
  /// Room for exactly this many elements, the first `size` of which stay. REQUIRES: n >= size.
  /// Throws std::bad_alloc, and then nothing has changed.
  void setRoom(std::size_t n, std::size_t width);
  /// Room for at least this many, twice as many as before if it has to be more.
  void growTo(std::size_t n, std::size_t width);

  void* data = nullptr;
  std::size_t size = 0, room = 0;
};

template <class T>
class FlatArray {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  using value_type = T;

  FlatArray() = default;
  explicit FlatArray(std::size_t n) { resize(n); }
  FlatArray(std::size_t n, const T& value) { resize(n, value); }
  FlatArray(std::initializer_list<T> values) { assign(values); }
  FlatArray(const FlatArray& other) { assign(other); }
  FlatArray(FlatArray&&) noexcept = default;
  FlatArray& operator=(const FlatArray& other) {
    if (this != &other) assign(other);
    return *this;
  }
  FlatArray& operator=(FlatArray&&) noexcept = default;

  [[nodiscard]] T* data() { return static_cast<T*>(bytes_.data); }
  [[nodiscard]] const T* data() const { return static_cast<const T*>(bytes_.data); }
  [[nodiscard]] std::size_t size() const { return bytes_.size; }
  [[nodiscard]] std::size_t capacity() const { return bytes_.room; }
  [[nodiscard]] bool empty() const { return bytes_.size == 0; }
  [[nodiscard]] T& operator[](std::size_t k) {
    assert(k < size());  // AddressSanitizer only knows of the room
    return data()[k];
  }
  [[nodiscard]] const T& operator[](std::size_t k) const {
    assert(k < size());
    return data()[k];
  }
  [[nodiscard]] T* begin() { return data(); }
  [[nodiscard]] T* end() { return data() + size(); }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size(); }
  [[nodiscard]] T& back() { return (*this)[size() - 1]; }
  [[nodiscard]] const T& back() const { return (*this)[size() - 1]; }

  void clear() { bytes_.size = 0; }
  void pop_back() {
    assert(!empty());
    --bytes_.size;
  }
  /// Sets the size after elements have been written at data(). REQUIRES: n <= capacity().
  void setSize(std::size_t n) {
    assert(n <= capacity());
    bytes_.size = n;
  }
  void swap(FlatArray& other) noexcept { bytes_.swap(other.bytes_); }

  // All below throw std::bad_alloc, and then nothing has changed.

  void reserve(std::size_t n) {
    if (n > capacity()) bytes_.setRoom(n, sizeof(T));
  }
  void push_back(const T& value) {
    const T copy = value;  // which may be in this array
    const std::size_t n = bytes_.size;
    if (n == bytes_.room) bytes_.growTo(n + 1, sizeof(T));
    new (data() + n) T(copy);
    bytes_.size = n + 1;
  }
  void resize(std::size_t n) { resize(n, T()); }
  void resize(std::size_t n, const T& value) {
    const T copy = value;
    if (n > capacity()) bytes_.growTo(n, sizeof(T));
    if (n > size()) std::uninitialized_fill(end(), data() + n, copy);
    bytes_.size = n;
  }
  void assign(std::size_t n, const T& value) {
    const T copy = value;
    reserve(n);
    clear();
    resize(n, copy);
  }
  void assign(std::span<const T> values) {  // must not be a part of this array
    reserve(values.size());
    std::uninitialized_copy(values.begin(), values.end(), data());
    bytes_.size = values.size();
  }
  void append(std::span<const T> values) {  // must not be a part of this array
    const std::size_t n = size() + values.size();
    if (n > capacity()) bytes_.growTo(n, sizeof(T));
    std::uninitialized_copy(values.begin(), values.end(), end());
    bytes_.size = n;
  }
  /// Takes element k out; those behind it move up.
  void erase(std::size_t k) {
    assert(k < size());
    std::copy(begin() + k + 1, end(), begin() + k);
    pop_back();
  }

 private:
  FlatBytes bytes_;
};

}  // namespace apollonius::internal
