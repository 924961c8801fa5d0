// What: requests large memory pages (2 MiB) for large arrays.
// Why:  the first touch of fresh memory, page by page, costs as much as the work on it; large pages are few.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"

namespace meshops {

inline constexpr std::size_t large_page = std::size_t{1} << 21;  ///< size of a large page in bytes

/// Advises the system to use large pages for the whole large pages among the `bytes` bytes from `begin` on. Call it
/// before the memory is touched. It is a hint: without effect on systems other than Linux, where no large pages are
/// available, and where the range holds no whole large page.
MESHOPS_API void prefer_large_pages(const void* begin, std::size_t bytes);

}  // namespace meshops
