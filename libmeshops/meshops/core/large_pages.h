// What: requests large memory pages (2 MiB) for large arrays.
// Why:  the first touch of fresh memory costs as much time per small page as the work on the page; large pages are few.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"

namespace meshops {

inline constexpr std::size_t large_page = std::size_t{1} << 21;  ///< size of a large page in bytes

/// Advises the system to use large pages for the whole large pages within the `bytes` bytes from `begin` on. Call the
/// function before the memory is touched. The advice has no effect on systems other than Linux, on systems without
/// large pages, and on a range without a whole large page.
MESHOPS_API void prefer_large_pages(const void* begin, std::size_t bytes);

}  // namespace meshops
