// What: large pages for large arrays: the first touch of fresh memory costs as much as the work on it.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"

namespace meshops {

inline constexpr std::size_t large_page = std::size_t{1} << 21;  ///< bytes, where the system has them

/// Advises the system to put large pages behind memory that has not been touched yet. A hint: without effect where the
/// system has none to give, and on memory in which none fits.
MESHOPS_API void prefer_large_pages(const void* begin, std::size_t bytes);

}  // namespace meshops
