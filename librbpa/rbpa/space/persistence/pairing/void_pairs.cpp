#include "rbpa/space/persistence/pairing/void_pairs.h"

#include <cstddef>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/radii/sorted_by_alpha.h"

namespace rbpa::space {
namespace {

/// Sets of tetrahedra. Each set knows its last element in the filtration. The outside is an element, too, with the
/// greatest number; it is later than all tetrahedra.
class Basins {
 public:
  explicit Basins(std::span<const double> alpha) : alpha_(alpha), sets_(alpha.size() + 1), last_(alpha.size() + 1) {
    for (std::uint32_t t = 0; t < last_.size(); ++t) last_[t] = t;
  }

  std::uint32_t outside() const { return static_cast<std::uint32_t>(alpha_.size()); }
  std::uint32_t find(std::uint32_t t) { return sets_.find(t); }
  /// Returns the last tetrahedron of a set, or none if the last element is the outside.
  std::uint32_t last(std::uint32_t set) const { return last_[set] == outside() ? Solid::none : last_[set]; }
  struct Joined {
    std::uint32_t ended, stays;  ///< the last tetrahedron of the set that ends, and of the other set
  };
  /// Joins sets a and b: the set whose last element is earlier ends. Requires: a ≠ b; both are results of find().
  Joined join(std::uint32_t a, std::uint32_t b) {
    const bool is_a_first = is_before(last_[a], last_[b]);
    const Joined joined = {last(is_a_first ? a : b), last(is_a_first ? b : a)};
    const std::uint32_t stays = last_[is_a_first ? b : a];
    last_[sets_.link(a, b)] = stays;
    return joined;
  }

 private:
  bool is_before(std::uint32_t t, std::uint32_t other) const {
    if (t == outside() || other == outside()) return other == outside();
    return alpha_[t] != alpha_[other] ? alpha_[t] < alpha_[other] : t < other;
  }

  std::span<const double> alpha_;
  meshops::DisjointSets sets_;
  std::vector<std::uint32_t> last_;
};

/// Joins each tetrahedron to what is across the last of its triangles that have the radius of the tetrahedron: another
/// tetrahedron or the outside. A tetrahedron without such a triangle is not joined.
void flow(const Solid& delaunay, std::span<const double> radii,
          std::span<const std::array<std::uint32_t, 4>> triangles_of, std::span<const double> triangle_radii,
          Steps& step, Basins& basins, std::vector<bool>& makes_one) {
  const auto& neighbors = delaunay.neighbors;
  for (std::uint32_t t = 0; t < neighbors.size(); ++t) {
    step();
    std::uint32_t last = Solid::none, across = Solid::none;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t triangle = triangles_of[t][k];
      if (triangle_radii[triangle] != radii[t] || (last != Solid::none && triangle < last)) continue;
      last = triangle;
      across = neighbors[t][k] == Solid::none ? basins.outside() : neighbors[t][k];
    }
    if (last == Solid::none) continue;
    const std::uint32_t a = basins.find(t), b = basins.find(across);
    if (a == b) continue;  // the triangle joined the two from its other side
    basins.join(a, b);
    makes_one[last] = true;
  }
}

struct Passage {
  std::uint32_t triangle, a, b;
};

}  // namespace

PersistentVoids find_voids(const Solid& delaunay, std::span<const double> radii,
                           std::span<const std::array<std::uint32_t, 4>> triangles_of,
                           std::span<const double> triangle_radii, Steps& step) {
  const auto& neighbors = delaunay.neighbors;
  PersistentVoids result;
  result.makes_one.assign(triangle_radii.size(), false);
  Basins basins(radii);
  flow(delaunay, radii, triangles_of, triangle_radii, step, basins, result.makes_one);

  std::vector<Passage> passages;
  std::vector<double> alpha;
  result.basin.resize(neighbors.size());
  for (std::uint32_t t = 0; t < neighbors.size(); ++t) {
    step();
    result.basin[t] = basins.last(basins.find(t));
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t beyond = neighbors[t][k];
      if (beyond < t) continue;
      const std::uint32_t a = basins.find(t), b = basins.find(beyond == Solid::none ? basins.outside() : beyond);
      if (a == b) continue;
      passages.push_back({triangles_of[t][k], a, b});  // ascending
      alpha.push_back(triangle_radii[passages.back().triangle]);
    }
  }
  const auto order = sorted_by_alpha(alpha, step);
  for (std::size_t i = order.size(); i-- > 0;) {
    step(4);
    const Passage& passage = passages[order[i]];
    const std::uint32_t a = basins.find(passage.a), b = basins.find(passage.b);
    if (a == b) continue;
    result.makes_one[passage.triangle] = true;
    const auto [ended, stays] = basins.join(a, b);
    result.all.push_back({passage.triangle, ended, stays});
  }
  return result;
}

}  // namespace rbpa::space
