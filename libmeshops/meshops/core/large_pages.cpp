#include "meshops/core/large_pages.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace meshops {

void prefer_large_pages([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::uintptr_t page = large_page;
  if (bytes < page) return;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = address / page * page, last = (address + bytes + page - 1) / page * page;
  // A refusal of the system is no error: the memory is only slower.
  static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
  // malloc() may have touched the first page, as it writes before the array. MADV_COLLAPSE, of Linux 6.1, makes one
  // large page of touched and untouched small pages.
  constexpr int collapse = 25;
  static_cast<void>(madvise(reinterpret_cast<void*>(first), page, collapse));
#endif
}

}  // namespace meshops
