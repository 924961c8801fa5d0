// What: requests large memory pages (2 MiB) for large arrays.
// Why:  the first touch of fresh memory costs as much time per small page as the work on the page; large pages are few.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/api.h"

namespace meshops {

inline constexpr std::size_t large_page = std::size_t{1} << 21;  ///< size of a large page in bytes

/// Advises the system to use large pages for the `bytes` bytes from `begin` on, and for what lies in the same large
/// pages. Call the function before the memory is touched. The advice has no effect on systems other than Linux, on
/// systems without large pages, and on fewer bytes than a large page has.
MESHOPS_API void prefer_large_pages(const void* begin, std::size_t bytes);

/// Reserves memory for `size` elements or slightly more, in large pages. With the few bytes that malloc() adds, the
/// memory is a whole number of large pages, so that Linux aligns it to large pages.
template <typename T>
void reserve_in_large_pages(std::vector<T>& elements, std::size_t size) {
  constexpr std::size_t added = 64;
  if (size < large_page / sizeof(T)) return elements.reserve(size);
  const std::size_t pages = (size * sizeof(T) + added + large_page - 1) / large_page;
  elements.reserve((pages * large_page - added) / sizeof(T));
  prefer_large_pages(elements.data(), elements.capacity() * sizeof(T));
}

}  // namespace meshops
