#include "oracle/cgal_tetrahedra.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "oracle/rational_vector.h"

namespace rbpa_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

constexpr std::uint32_t none = 0xffffffff;

/// Decides in rational numbers. The center solves c · u = u²/2 for each edge u at a.
bool is_within(const std::array<rbpa::Point3, 4>& p, double alpha) {
  const Vector3<Rational> u = rational_from(p[0], p[1]), v = rational_from(p[0], p[2]), w = rational_from(p[0], p[3]);
  const Rational volume = dot(cross(u, v), w);
  const Vector3<Rational> sum = dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v);
  const Rational radius = rational(alpha);
  return dot(sum, sum) <= 4 * volume * volume * radius * radius;
}

/// Decides in doubles if the values are far apart. Returns: whether they are.
bool is_clear(const std::array<rbpa::Point3, 4>& p, double alpha, bool& within) {
  using V = Vector3<long double>;
  const auto edge = [&](std::size_t k) {
    return V{(long double)p[k].x - p[0].x, (long double)p[k].y - p[0].y, (long double)p[k].z - p[0].z};
  };
  const V u = edge(1), v = edge(2), w = edge(3), uv = cross(u, v);
  const long double volume = dot(uv, w), uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const V sum = uu * cross(v, w) + vv * cross(w, u) + ww * uv;
  const long double squares = dot(sum, sum);
  const long double sizes = std::sqrt(uu * vv * ww), right = 4 * volume * volume * alpha * alpha;
  // A crude bound: the volume and center of a sliver have errors of some 2^-60 of the products of its edges.
  const long double size = std::sqrt(uu) + std::sqrt(vv) + std::sqrt(ww);
  const long double slack = 0x1p-50L * sizes * sizes * (size * size + (long double)alpha * alpha);
  if (!std::isfinite(slack) || !(slack > 0x1p-9000L)) return false;
  within = squares < right;
  return std::abs(squares - right) > slack;
}

}  // namespace

void make_canonical(Tetrahedron& corners, Tetrahedron& beside) {
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return corners[i] < corners[j]; });
  int inversions = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
  if (inversions % 2 != 0) std::swap(order[2], order[3]);
  const Tetrahedron c = corners, b = beside;
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = c[order[k]];
    beside[k] = b[order[k]];
  }
}

DelaunayByCgal::DelaunayByCgal(std::span<const rbpa::Point3> points) : points_(points.begin(), points.end()) {
  std::map<std::array<double, 3>, std::uint32_t> lowest;
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> named;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto& p = points[i];
    if (lowest.emplace(std::array<double, 3>{p.x + 0.0, p.y + 0.0, p.z + 0.0}, i).second)
      named.emplace_back(Kernel::Point_3(p.x, p.y, p.z), i);
  }
  Delaunay delaunay(named.begin(), named.end());
  if (delaunay.dimension() < 3) return;
  std::uint32_t cells = 0;
  for (auto c = delaunay.all_cells_begin(); c != delaunay.all_cells_end(); ++c)
    c->info() = delaunay.is_infinite(c) ? none : cells++;
  for (auto c = delaunay.finite_cells_begin(); c != delaunay.finite_cells_end(); ++c) {
    Tetrahedron corners{}, beside{};
    for (int k = 0; k < 4; ++k) {
      corners[static_cast<std::size_t>(k)] = c->vertex(k)->info();
      beside[static_cast<std::size_t>(k)] = c->neighbor(k)->info();
    }
    make_canonical(corners, beside);
    cells_.push_back(corners);
    neighbors_.push_back(beside);
  }
}

TetrahedraByCgal DelaunayByCgal::within(double alpha) const {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    const auto& t = cells_[c];
    const std::array<rbpa::Point3, 4> corners = {points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]};
    bool within = true;
    if (!std::isinf(alpha) && !is_clear(corners, alpha, within)) within = is_within(corners, alpha);
    if (within) kept.push_back(c);
  }
  std::sort(kept.begin(), kept.end(), [&](std::uint32_t c, std::uint32_t d) { return cells_[c] < cells_[d]; });
  std::vector<std::uint32_t> number(cells_.size(), none);
  for (std::uint32_t i = 0; i < kept.size(); ++i) number[kept[i]] = i;
  TetrahedraByCgal result;
  for (const std::uint32_t c : kept) {
    result.simplices.push_back(cells_[c]);
    Tetrahedron beside = neighbors_[c];
    for (std::uint32_t& other : beside)
      if (other != none) other = number[other];
    result.neighbors.push_back(beside);
  }
  return result;
}

}  // namespace rbpa_test
