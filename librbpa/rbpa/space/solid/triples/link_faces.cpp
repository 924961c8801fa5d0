#include "rbpa/space/solid/triples/link_faces.h"

#include <algorithm>
#include <vector>

namespace rbpa::space {
namespace {

/// A face with a known least corner: `corners` has the two others; `at` is 4 · row + the corner across.
struct Face {
  std::uint64_t corners;
  std::uint32_t at;
};

Face face(std::uint32_t p, std::uint32_t q, std::size_t row, std::uint32_t across) {
  return {std::uint64_t{std::min(p, q)} << 32U | std::max(p, q), static_cast<std::uint32_t>(4 * row + across)};
}

/// Links the rows of equal faces. Requires: `faces` has all faces of one lowest corner.
void link(std::vector<Face>& faces, meshops::FreshVector<std::array<std::uint32_t, 4>>& neighbors) {
  const auto join = [&](const Face& one, const Face& other) {
    neighbors[one.at / 4][one.at % 4] = other.at / 4;
    neighbors[other.at / 4][other.at % 4] = one.at / 4;
  };
  constexpr std::size_t few = 24;
  if (faces.size() <= few) {
    for (std::size_t i = 1; i < faces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (faces[i].corners == faces[j].corners) join(faces[i], faces[j]);
    return;
  }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.corners < b.corners; });
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].corners == faces[i - 1].corners) join(faces[i], faces[i - 1]);
}

}  // namespace

meshops::FreshVector<std::array<std::uint32_t, 4>> link_faces(std::span<const std::array<std::uint32_t, 4>> rows,
                                                              std::size_t bound, Threads& threads) {
  constexpr std::size_t at_a_time = 1u << 14;
  constexpr std::uint32_t none = 0xffffffff;
  meshops::FreshVector<std::array<std::uint32_t, 4>> neighbors(rows.size(), {none, none, none, none});
  // Sorts rows by their second corner; rows are sorted by their first corner already.
  std::vector<std::uint32_t> first(bound + 1, 0), by_second(rows.size());
  for (const auto& row : rows) ++first[row[1]];
  std::uint32_t sum = 0;
  for (std::uint32_t& count : first) {
    const std::uint32_t here = count;
    count = sum;
    sum += here;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) by_second[first[rows[i][1]]++] = static_cast<std::uint32_t>(i);
  // first[v] is now the end, in by_second, of the rows with second corner v.

  for_each_part(threads, bound, at_a_time, [&](std::size_t begin, std::size_t end) {
    std::vector<Face> faces;
    auto row = static_cast<std::size_t>(
        std::lower_bound(rows.begin(), rows.end(), begin, [](const auto& r, std::size_t v) { return r[0] < v; }) -
        rows.begin());
    for (std::size_t v = begin; v < end; ++v) {
      faces.clear();
      for (; row < rows.size() && rows[row][0] == v; ++row) {
        const auto& [a, b, c, d] = rows[row];
        faces.push_back(face(c, d, row, 1));
        faces.push_back(face(b, d, row, 2));
        faces.push_back(face(b, c, row, 3));
      }
      for (std::uint32_t i = v == 0 ? 0 : first[v - 1]; i < first[v]; ++i)
        faces.push_back(face(rows[by_second[i]][2], rows[by_second[i]][3], by_second[i], 0));
      link(faces, neighbors);
    }
  });
  return neighbors;
}

}  // namespace rbpa::space
