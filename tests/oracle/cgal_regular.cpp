#include "oracle/cgal_regular.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace rbpa_test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;  // so that weights are exact squares
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel,
                                                               CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Regular = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

constexpr std::uint32_t none = 0xffffffff;

Tetrahedron sorted(Tetrahedron row) {
  std::sort(row.begin(), row.end());
  return row;
}

}  // namespace

RegularByCgal regular_by_cgal(const Balls& balls) {
  std::map<std::array<double, 4>, std::uint32_t> lowest;
  std::vector<std::pair<Regular::Weighted_point, std::uint32_t>> named;
  for (std::uint32_t i = 0; i < balls.radii.size(); ++i) {
    const auto& p = balls.centers[i];
    if (!lowest.emplace(std::array<double, 4>{p.x + 0.0, p.y + 0.0, p.z + 0.0, balls.radii[i] + 0.0}, i).second)
      continue;
    const Kernel::FT radius(balls.radii[i]);
    named.emplace_back(Regular::Weighted_point(Kernel::Point_3(p.x, p.y, p.z), radius * radius), i);
  }
  Regular regular;
  regular.insert(named.begin(), named.end());
  RegularByCgal result;
  std::vector<bool> is_visible(balls.radii.size(), false);
  for (auto v = regular.finite_vertices_begin(); v != regular.finite_vertices_end(); ++v) is_visible[v->info()] = true;
  for (const auto& [ball, i] : named)
    if (!is_visible[i]) result.hidden.push_back(i);
  switch (regular.dimension()) {
    case 0:
      result.flat.push_back({regular.finite_vertices_begin()->info(), none, none, none});
      break;
    case 1:
      for (auto e = regular.finite_edges_begin(); e != regular.finite_edges_end(); ++e)
        result.flat.push_back(
            sorted({e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info(), none, none}));
      break;
    case 2:
      for (auto f = regular.finite_facets_begin(); f != regular.finite_facets_end(); ++f)
        result.flat.push_back(
            sorted({f->first->vertex(0)->info(), f->first->vertex(1)->info(), f->first->vertex(2)->info(), none}));
      break;
    default:
      break;
  }
  std::sort(result.flat.begin(), result.flat.end());
  if (regular.dimension() < 3) return result;
  std::uint32_t cells = 0;
  for (auto c = regular.all_cells_begin(); c != regular.all_cells_end(); ++c)
    c->info() = regular.is_infinite(c) ? none : cells++;
  std::vector<Tetrahedron> corners(cells), beside(cells);
  for (auto c = regular.finite_cells_begin(); c != regular.finite_cells_end(); ++c) {
    Tetrahedron &mine = corners[c->info()], &others = beside[c->info()];
    for (int k = 0; k < 4; ++k) {
      mine[static_cast<std::size_t>(k)] = c->vertex(k)->info();
      others[static_cast<std::size_t>(k)] = c->neighbor(k)->info();
    }
    make_canonical(mine, others);
  }
  std::vector<std::uint32_t> order(cells), number(cells);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t c, std::uint32_t d) { return corners[c] < corners[d]; });
  for (std::uint32_t i = 0; i < cells; ++i) number[order[i]] = i;
  for (const std::uint32_t c : order) {
    result.simplices.push_back(corners[c]);
    for (std::uint32_t& other : beside[c])
      if (other != none) other = number[other];
    result.neighbors.push_back(beside[c]);
  }
  return result;
}

}  // namespace rbpa_test
