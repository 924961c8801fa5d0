#include "rbpa/space/solid/rows/solid_rows.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "rbpa/base/error.h"

namespace rbpa::space {
namespace {

/// An even permutation of four numbers, with two bits for each place.
using Permutation = std::uint8_t;

/// Returns a table: entry 4 i + j is the even permutation that puts the two least of four numbers first, when the least
/// is at place i and the second least at place j ≠ i.
constexpr std::array<Permutation, 16> even_permutations() {
  std::array<Permutation, 16> all{};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = 0; j < 4; ++j) {
      if (i == j) continue;
      unsigned k = 0;
      while (k == i || k == j) ++k;
      unsigned l = 6 - i - j - k;
      const auto inversions = [&] { return (i > j) + (i > k) + (i > l) + (j > k) + (j > l) + (k > l); };
      if (inversions() % 2 != 0) std::swap(k, l);
      all[4 * i + j] = static_cast<Permutation>(i | j << 2U | k << 4U | l << 6U);
    }
  return all;
}

/// Returns the permutation of a row. Without branches on the places of the two least numbers, which would be
/// mispredicted.
Permutation permutation_of(const Row& row) {
  static constexpr auto all = even_permutations();
  // Each number together with its place.
  const auto placed = [&](std::size_t i) { return std::uint64_t{row[i]} << 2U | i; };
  const std::uint64_t a = placed(0), b = placed(1), c = placed(2), d = placed(3);
  const std::uint64_t low = std::min(a, b), high = std::max(a, b), other_low = std::min(c, d),
                      other_high = std::max(c, d);
  const std::uint64_t least = std::min(low, other_low);
  const std::uint64_t next = std::min(std::max(low, other_low), std::min(high, other_high));
  return all[4 * (least & 3U) + (next & 3U)];
}

Row permuted(const Row& row, Permutation p) {
  return {row[p & 3U], row[p >> 2U & 3U], row[p >> 4U & 3U], row[p >> 6U]};
}

}  // namespace

void check_number_of(std::size_t tetrahedra) {
  constexpr std::size_t most = std::size_t{1} << 30U;
  if (tetrahedra > most)
    throw InvalidInput("more than " + std::to_string(most) +
                       " tetrahedra at a time, expected so few that 32 bits number their faces");
}

void fill_in(SolidRows rows, std::span<const std::uint32_t> index, std::size_t bound, bool neighbors, Threads& threads,
             const Checkpoint& checkpoint, Solid& solid) {
  if (checkpoint) checkpoint();
  const std::size_t count = rows.corners.size();
  meshops::FreshVector<Permutation> permutation(count);
  constexpr std::size_t at_a_time = 1u << 14;
  for_each_part(threads, count, at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto& [a, b, c, d] = rows.corners[i];
      const Row corners = {index[a], index[b], index[c], index[d]};
      permutation[i] = permutation_of(corners);
      rows.corners[i] = permuted(corners, permutation[i]);
    }
  });
  if (checkpoint) checkpoint();
  const auto place = sort_rows(rows.corners, bound, threads, solid.simplices);
  if (!neighbors) return;
  if (checkpoint) checkpoint();
  // The first touch of fresh memory costs as much as this step, so the neighbors reuse the memory of the rows.
  rows.corners.swap(solid.neighbors);
  if (solid.neighbors.capacity() / 5 * 4 > count) solid.neighbors.shrink_to_fit();
  // Rows are visited in their order, because the neighbors of consecutive rows are near each other in memory.
  for_each_part(threads, count, at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (i + 16 < count) __builtin_prefetch(&solid.neighbors[place[i + 16]], 1);
      Row row = permuted(rows.neighbors[i], permutation[i]);
      for (std::uint32_t& neighbor : row) neighbor = neighbor == Solid::none ? neighbor : place[neighbor];
      solid.neighbors[place[i]] = row;
    }
  });
}

}  // namespace rbpa::space
