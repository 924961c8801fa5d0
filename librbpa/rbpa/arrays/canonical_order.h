// What: brings triangles into canonical order: lexicographic.
// Law:  a permutation; the same for every number of threads.
// Cost: linear, in two passes that stay in a cache each: first into buckets of many smallest corners, then each bucket by
//       itself. As much memory again as the triangles take.
#pragma once

#include <cstddef>
#include <cstdint>

#include "meshops/core/fresh_vector.h"
#include "rbpa/arrays/triangle_list.h"
#include "rbpa/parallel/threads.h"

namespace rbpa {

/// Sorts triangles with the smallest corner first, all corners being less than `bound`.
/// With `rank`, tells of each triangle where it went.
void sort_canonically(meshops::FreshVector<TriangleList::Triple>& triangles, std::size_t bound, Threads& threads,
                      meshops::FreshVector<std::uint32_t>* rank = nullptr);

}  // namespace rbpa
