// What: a vector for large arrays of trivially copyable elements that are written before they are read.
// Law:  elements that resize(n) or the constructor from a size adds have no value until one is written: no time is
//       spent on zeros, and threads can share the first touch of the memory. Arrays of 2 MiB or more use large pages.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/core/large_pages.h"

namespace meshops {

/// Allocator of FreshVector. Memory of 2 MiB or more is aligned to large pages.
template <typename T>
struct FreshAllocator {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  using value_type = T;

  FreshAllocator() = default;
  template <typename U>
  FreshAllocator(const FreshAllocator<U>&) {}

  /// Returns memory for `count` elements. Throws std::bad_alloc, or std::bad_array_new_length if the size of the
  /// elements in bytes is out of range.
  T* allocate(std::size_t count) {
    if (count < large_page / sizeof(T)) return std::allocator<T>().allocate(count);
    const std::size_t bytes = whole_pages(count);
    void* const memory = ::operator new(bytes, std::align_val_t(large_page));
    prefer_large_pages(memory, bytes);
    return static_cast<T*>(memory);
  }
  /// Frees memory that allocate(count) returned. Requires: `count` is the same number.
  void deallocate(T* memory, std::size_t count) {
    if (count < large_page / sizeof(T)) return std::allocator<T>().deallocate(memory, count);
    ::operator delete(memory, std::align_val_t(large_page));  // clang 14 has no delete with a size
  }

  /// Leaves the element without a value.
  template <typename U>
  void construct(U*) {}
  /// Makes the element from the arguments.
  template <typename U, typename... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const FreshAllocator&, const FreshAllocator&) { return true; }

 private:
  /// Returns the bytes for `count` elements, rounded up to whole large pages.
  static std::size_t whole_pages(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T)) throw std::bad_array_new_length();
    return (count * sizeof(T) + large_page - 1) / large_page * large_page;
  }
};

/// std::vector whose new elements have no value until one is written. Reading an element earlier is undefined behavior.
template <typename T>
using FreshVector = std::vector<T, FreshAllocator<T>>;

}  // namespace meshops
