#include "oracle/cgal_dangling.h"

#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>

namespace rbpa_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using IsExact = CGAL::Tag_true;
using VertexBase =
    CGAL::Alpha_shape_vertex_base_3<Kernel, CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>,
                                    IsExact>;
using CellBase = CGAL::Alpha_shape_cell_base_3<Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>, IsExact>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using AlphaShape = CGAL::Alpha_shape_3<Delaunay, IsExact>;

}  // namespace

struct AlphaShapeByCgal::Shape {
  explicit Shape(Delaunay& delaunay) : shape(delaunay, 0, AlphaShape::GENERAL) {}
  AlphaShape shape;
};

AlphaShapeByCgal::AlphaShapeByCgal(std::span<const rbpa::Point3> points) {
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> named;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    named.emplace_back(Kernel::Point_3(points[i].x, points[i].y, points[i].z), i);
  Delaunay delaunay(named.begin(), named.end());
  shape_ = std::make_unique<Shape>(delaunay);
}

AlphaShapeByCgal::~AlphaShapeByCgal() = default;

DanglingByCgal AlphaShapeByCgal::dangling(double alpha) {
  AlphaShape& shape = shape_->shape;
  shape.set_alpha(alpha * alpha);
  DanglingByCgal result;
  for (auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f) {
    if (shape.classify(*f) != AlphaShape::SINGULAR) continue;
    std::array<std::uint32_t, 3> t{};
    for (int k = 0, i = 0; k < 4; ++k)
      if (k != f->second) t[static_cast<std::size_t>(i++)] = f->first->vertex(k)->info();
    std::sort(t.begin(), t.end());
    result.triangles.push_back(t);
  }
  for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e) {
    if (shape.classify(*e) != AlphaShape::SINGULAR) continue;
    const std::uint32_t a = e->first->vertex(e->second)->info(), b = e->first->vertex(e->third)->info();
    result.edges.push_back({std::min(a, b), std::max(a, b)});
  }
  for (auto v = shape.finite_vertices_begin(); v != shape.finite_vertices_end(); ++v)
    if (shape.classify(v) == AlphaShape::SINGULAR) result.points.push_back(v->info());
  std::sort(result.triangles.begin(), result.triangles.end());
  std::sort(result.edges.begin(), result.edges.end());
  std::sort(result.points.begin(), result.points.end());
  return result;
}

}  // namespace rbpa_test
