// What: requests large memory pages (2 MiB) for large arrays.
// Why:  the first touch of fresh memory, page by page, costs as much as the work on it; large pages are few.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"

namespace meshops {

inline constexpr std::size_t large_page = std::size_t{1} << 21;  ///< in bytes, on systems that have large pages

/// Advises the system to use large pages for the `bytes` bytes from `begin` on, which have not been touched yet. A hint
/// only: it has no effect where the system has no large pages to give, or where the range holds no whole one.
MESHOPS_API void prefer_large_pages(const void* begin, std::size_t bytes);

}  // namespace meshops
