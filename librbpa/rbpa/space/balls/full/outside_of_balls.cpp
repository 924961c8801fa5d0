#include "rbpa/space/balls/full/outside_of_balls.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/balls/full/common_of_balls.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {
namespace {

/// The shares of a tetrahedron in balls and their intersections, in units of alpha.
class Share {
 public:
  Share(const Triangulated& space, std::uint32_t t, double alpha) {
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t l = 0; l < 4; ++l)
        edges_[k][l] = 1 / alpha * from<double>(space.position(t, k), space.position(t, l));
  }

  double volume() const { return std::abs(dot(edges_[0][1], cross(edges_[0][2], edges_[0][3]))) / 6; }
  /// Returns the volume of the intersection of balls in the tetrahedron: of one at a corner, of two at an edge, of
  /// three on this side of a face.
  double of_ball(std::size_t k) const {
    const auto to = [&](std::size_t step) { return unit(edges_[k][(k + step) % 4]); };
    return solid_angle(to(1), to(2), to(3)) * one_ball.volume;
  }
  double of_two(const EdgeAt& at) const {
    const auto [k, l] = others(at);
    const auto& from = edges_[at.from];
    return dihedral_angle(unit(from[at.to]), unit(from[k]), unit(from[l])) * two_balls(norm(from[at.to])).volume;
  }
  double of_three(std::size_t across) const {
    const auto& [a, b, c] = outer_faces[across];
    return three_balls(edges_[a][b], edges_[a][c]).volume / 2;
  }

 private:
  std::array<std::array<Vector, 4>, 4> edges_{};
};

}  // namespace

std::vector<double> outside_of_balls(const Triangulated& space, std::span<const std::uint32_t> void_of,
                                     std::size_t voids, double alpha, Threads& threads, const GoOn& go_on) {
  const auto count = static_cast<std::uint32_t>(space.simplices.size());
  const auto is_wall = [&](std::uint32_t t, std::size_t k) { return space.neighbors[t][k] == Solid::none; };
  std::vector<std::uint8_t> has_edge(6 * std::size_t{count}, 0);  // for edges 01 02 03 12 13 23 of each
  const auto slot = [](std::uint32_t t, std::size_t i, std::size_t j) {
    return 6 * std::size_t{t} + (std::min(i, j) == 0 ? 0 : 1) + i + j - 1;
  };
  // All tetrahedra around an edge that is in no wall are in the same void.
  const auto is_in_complex = [&](std::span<const EdgeAt> ring) {
    const auto is_at_wall = [&](const EdgeAt& at) {
      const auto [k, l] = others(at);
      return is_wall(at.tetrahedron, k) || is_wall(at.tetrahedron, l);
    };
    return std::any_of(ring.begin(), ring.end(), is_at_wall) || is_edge_alone(space, ring, alpha);
  };
  for_each_edge(
      space, PointStars(space), threads,
      [&](std::uint32_t, std::uint32_t, std::span<const EdgeAt> ring) {
        if (is_in_complex(ring))
          for (const EdgeAt& at : ring) has_edge[slot(at.tetrahedron, at.from, at.to)] = 1;
        return false;
      },
      [](std::uint32_t, std::uint32_t) {}, go_on);

  std::vector<std::uint32_t> by_void(count);
  std::iota(by_void.begin(), by_void.end(), std::uint32_t{0});
  std::stable_sort(by_void.begin(), by_void.end(),
                   [&](std::uint32_t t, std::uint32_t other) { return void_of[t] < void_of[other]; });
  Steps step(go_on);
  std::vector<double> volumes(voids, 0);
  for (std::size_t at = 0; at < by_void.size();) {
    const std::uint32_t of = void_of[by_void[at]];
    ExactSum sum;
    for (; at < by_void.size() && void_of[by_void[at]] == of; ++at) {
      const std::uint32_t t = by_void[at];
      step();
      const Share share(space, t, alpha);
      sum.add(share.volume());
      for (std::uint8_t k = 0; k < 4; ++k) {
        sum.add(-share.of_ball(k));
        if (is_wall(t, k)) sum.add(-share.of_three(k));
        for (std::uint8_t l = k + 1; l < 4; ++l)
          if (has_edge[slot(t, k, l)] != 0) sum.add(share.of_two({t, k, l}));
      }
    }
    volumes[of] = std::max(sum.rounded(), 0.0) * alpha * alpha * alpha;
  }
  return volumes;
}

}  // namespace rbpa::space
