#include "space/solid/solid_model.h"

#include <algorithm>
#include <set>
#include <utility>

namespace rbpa_test {

using rbpa::Solid;

Solid part_of(const Solid& solid, std::size_t points, const std::vector<bool>& kept) {
  Solid part;
  std::vector<std::uint32_t> number(solid.simplices.size(), Solid::none);
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (!kept[t]) continue;
    number[t] = static_cast<std::uint32_t>(part.simplices.size());
    part.simplices.push_back(solid.simplices[t]);
    part.neighbors.push_back(solid.neighbors[t]);
  }
  for (auto& neighbors : part.neighbors)
    for (std::uint32_t& other : neighbors)
      if (other != Solid::none) other = number[other];
  part.duplicates = solid.duplicates;
  part.distinct = solid.distinct;
  std::vector<bool> used(points, false);
  for (const Tetrahedron& t : part.simplices)
    for (const std::uint32_t i : t) used[i] = true;
  for (const rbpa::Duplicate& d : part.duplicates) used[d.index] = true;
  for (std::uint32_t i = 0; i < points; ++i)
    if (!used[i]) part.isolated.push_back(i);
  return part;
}

Solid random_part(const Solid& solid, std::size_t points, double probability, Random& random) {
  std::vector<bool> kept;
  for (std::size_t t = 0; t < solid.simplices.size(); ++t) kept.push_back(random.chance(probability));
  return part_of(solid, points, kept);
}

Face sorted(Face face) {
  std::sort(face.begin(), face.end());
  return face;
}

std::map<Face, std::vector<std::uint32_t>> tetrahedra_of_faces(const Solid& solid) {
  std::map<Face, std::vector<std::uint32_t>> faces;
  for (std::uint32_t t = 0; t < solid.simplices.size(); ++t) {
    const auto& [a, b, c, d] = solid.simplices[t];
    for (const Face& face : {Face{a, b, c}, Face{a, b, d}, Face{a, c, d}, Face{b, c, d}})
      faces[sorted(face)].push_back(t);
  }
  return faces;
}

Betti betti_by_ranks(const Solid& solid) {
  // All faces of all dimensions, as sorted corners.
  using Simplex = std::vector<std::uint32_t>;
  std::array<std::map<Simplex, std::size_t>, 4> simplices;
  for (const Tetrahedron& t : solid.simplices)
    for (unsigned subset = 1; subset < 16; ++subset) {
      Simplex s;
      for (unsigned i = 0; i < 4; ++i)
        if ((subset >> i & 1u) != 0) s.push_back(t[i]);
      std::sort(s.begin(), s.end());
      simplices[s.size() - 1].try_emplace(s, simplices[s.size() - 1].size());
    }
  std::array<std::size_t, 5> rank{};
  for (std::size_t dimension = 1; dimension < 4; ++dimension) {
    std::map<std::size_t, std::set<std::size_t>> reduced;  // by the greatest row
    for (const auto& [simplex, number] : simplices[dimension]) {
      std::set<std::size_t> column;
      for (std::size_t i = 0; i <= dimension; ++i) {
        Simplex face = simplex;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
        column.insert(simplices[dimension - 1].at(face));
      }
      while (!column.empty()) {
        const auto [at, is_new] = reduced.try_emplace(*column.rbegin(), column);
        if (is_new) break;
        for (const std::size_t row : at->second)
          if (!column.erase(row)) column.insert(row);
      }
    }
    rank[dimension] = reduced.size();
  }
  Betti result{simplices[0].size(), simplices[1].size(), simplices[2].size(), {}};
  for (std::size_t dimension = 0; dimension < 3; ++dimension)
    result.numbers[dimension] = simplices[dimension].size() - rank[dimension] - rank[dimension + 1];
  return result;
}

std::vector<std::vector<std::uint32_t>> pieces(const Solid& solid, std::size_t shared) {
  std::vector<std::vector<std::uint32_t>> all;
  std::map<std::uint32_t, std::vector<std::uint32_t>> at;
  for (std::uint32_t t = 0; t < solid.simplices.size(); ++t)
    for (const std::uint32_t i : solid.simplices[t]) at[i].push_back(t);
  std::vector<bool> seen(solid.simplices.size(), false);
  for (std::uint32_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    std::vector<std::uint32_t> piece = {first};
    for (std::size_t next = 0; next < piece.size(); ++next) {
      std::map<std::uint32_t, std::size_t> common;
      for (const std::uint32_t i : solid.simplices[piece[next]])
        for (const std::uint32_t t : at[i]) ++common[t];
      for (const auto& [t, count] : common)
        if (count >= shared && !seen[t]) {
          seen[t] = true;
          piece.push_back(t);
        }
    }
    std::sort(piece.begin(), piece.end());
    all.push_back(piece);
  }
  return all;
}

Rational six_volumes(const Points3& points, const Tetrahedron& t) {
  std::array<std::array<Rational, 3>, 3> m;
  const rbpa::Point3& a = points[t[0]];
  for (std::size_t i = 0; i < 3; ++i) {
    const rbpa::Point3& p = points[t[i + 1]];
    m[i] = {rational(p.x) - rational(a.x), rational(p.y) - rational(a.y), rational(p.z) - rational(a.z)};
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) + m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Rational volume(const Points3& points, const Solid& solid) {
  Rational sum = 0;
  for (const Tetrahedron& t : solid.simplices) sum += six_volumes(points, t);
  return sum / 6;
}

bool is_near(double computed, const Rational& exact) {
  const Rational error = abs(Rational(rational(computed) - exact));
  return error * rational(0x1p52) <= abs(exact);
}

std::vector<ModelVoid> voids_by_triangulation(const Points3& points, const Solid& delaunay, const Solid& part) {
  const std::set<Tetrahedron> solid(part.simplices.begin(), part.simplices.end());
  const auto& all = delaunay.simplices;
  std::vector<bool> seen(all.size(), false);
  std::vector<ModelVoid> voids;
  for (std::uint32_t first = 0; first < all.size(); ++first) {
    if (seen[first] || solid.count(all[first]) != 0) continue;
    seen[first] = true;
    std::vector<std::uint32_t> piece = {first};
    bool is_bounded = true;
    ModelVoid found;
    for (std::size_t at = 0; at < piece.size(); ++at) {
      const std::uint32_t t = piece[at];
      found.six_volumes += six_volumes(points, all[t]);
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t other = delaunay.neighbors[t][k];
        if (other == Solid::none) {
          is_bounded = false;
        } else if (solid.count(all[other]) != 0) {
          found.faces.push_back(sorted({all[t][(k + 1) % 4], all[t][(k + 2) % 4], all[t][(k + 3) % 4]}));
        } else if (!seen[other]) {
          seen[other] = true;
          piece.push_back(other);
        }
      }
    }
    std::sort(found.faces.begin(), found.faces.end());
    if (is_bounded) voids.push_back(std::move(found));
  }
  return voids;
}

}  // namespace rbpa_test
