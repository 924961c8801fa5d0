// What: a vector for large arrays that are written before they are read.
// Law:  elements that resize() adds have no value until one is written: no time is spent on zeros, and threads can share
//       the first touch of the memory. Large ones ask for large pages.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/core/large_pages.h"

namespace meshops {

template <typename T>
struct FreshAllocator {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  using value_type = T;

  FreshAllocator() = default;
  template <typename U>
  FreshAllocator(const FreshAllocator<U>&) {}

  T* allocate(std::size_t count) {
    T* const memory = std::allocator<T>().allocate(count);
    prefer_large_pages(memory, count * sizeof(T));
    return memory;
  }
  void deallocate(T* memory, std::size_t count) { std::allocator<T>().deallocate(memory, count); }

  template <typename U>
  void construct(U*) {}
  template <typename U, typename... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const FreshAllocator&, const FreshAllocator&) { return true; }
};

template <typename T>
using FreshVector = std::vector<T, FreshAllocator<T>>;

}  // namespace meshops
