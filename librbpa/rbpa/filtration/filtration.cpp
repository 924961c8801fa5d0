#include "rbpa/filtration/filtration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "meshops/core/connectivity.h"
#include "rbpa/filtration/corners.h"
#include "rbpa/filtration/disjoint_sets.h"
#include "rbpa/filtration/least_alpha.h"

namespace rbpa {
namespace {

/// What the sum of areas depends on is ordered by coordinates only: by alpha, then by area.
struct Entry {
  double alpha;
  double area;
  std::uint32_t face;
  friend bool operator<(const Entry& a, const Entry& b) {
    if (a.alpha != b.alpha) return a.alpha < b.alpha;
    if (a.area != b.area) return a.area < b.area;
    return a.face < b.face;
  }
};

/// Of corners in any order, always rounded alike.
double area(std::array<Point, 3> corners) {
  std::sort(corners.begin(), corners.end());
  const auto& [a, b, c] = corners;
  using Wide = long double;
  const Wide cross =
      (Wide(b.x) - Wide(a.x)) * (Wide(c.y) - Wide(a.y)) - (Wide(b.y) - Wide(a.y)) * (Wide(c.x) - Wide(a.x));
  return static_cast<double>(std::abs(cross) / 2);
}

/// The complex while triangles are added to it.
class Growth {
 public:
  explicit Growth(const Mesh& mesh)
      : mesh_(mesh), solids_(mesh.n_faces()), pieces_(mesh.n_vertices()), in_(mesh.n_faces()), on_(mesh.n_vertices()) {}

  void add(const Entry& entry) {
    ++now_.triangles;
    ++now_.solid_components;
    area_ += entry.area;
    in_[entry.face] = true;

    std::array<std::uint32_t, 3> corners;
    auto h = mesh_.halfedge_handle(meshops::Face(static_cast<int>(entry.face)));
    for (std::uint32_t& corner : corners) {
      corner = static_cast<std::uint32_t>(mesh_.to_vertex_handle(h).idx());
      cover(corner);
      add_edge(entry.face, mesh_.face_handle(mesh_.opposite_halfedge_handle(h)));
      h = mesh_.next_halfedge_handle(h);
    }
    now_.components -= pieces_.join(corners[0], corners[1]);
    now_.components -= pieces_.join(corners[0], corners[2]);
  }

  FiltrationStep step(double alpha) const {
    FiltrationStep step = now_;
    step.alpha = alpha;
    step.holes = step.components + edges_ - step.covered - step.triangles;  // components − χ
    step.area = static_cast<double>(area_);
    return step;
  }

 private:
  void cover(std::uint32_t vertex) {
    if (on_[vertex]) return;
    on_[vertex] = true;
    ++now_.covered;
    ++now_.components;
  }

  void add_edge(std::uint32_t face, meshops::Face beyond) {
    const auto other = static_cast<std::uint32_t>(beyond.idx());
    if (beyond.is_valid() && in_[other])
      now_.solid_components -= solids_.join(face, other);
    else
      ++edges_;
  }

  const Mesh& mesh_;
  DisjointSets solids_;  // of faces
  DisjointSets pieces_;  // of vertices
  std::vector<bool> in_, on_;
  FiltrationStep now_;
  std::size_t edges_ = 0;
  long double area_ = 0;
};

}  // namespace

Filtration filtration(const SolidAlphaComplex& delaunay, std::span<const Point> points) {
  const Corners corners(delaunay, points);
  meshops::require(delaunay.mesh.n_faces() == 0 || delaunay.isolated.empty(),
                   "filtration: the complex leaves points out, so it is not the Delaunay triangulation");
  Filtration result{.steps = {}, .triangle_alpha = {}, .distinct = delaunay.distinct};
  result.triangle_alpha.resize(delaunay.mesh.n_faces());
  std::vector<Entry> entries(delaunay.mesh.n_faces());
  for (std::uint32_t f = 0; f < entries.size(); ++f) {
    const std::array<Point, 3> triangle = corners.of_face(f);
    result.triangle_alpha[f] = least_alpha(triangle[0], triangle[1], triangle[2]);
    entries[f] = {result.triangle_alpha[f], area(triangle), f};
  }
  std::sort(entries.begin(), entries.end());

  Growth growth(delaunay.mesh);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    growth.add(entries[i]);
    const bool last_of_step = i + 1 == entries.size() || entries[i + 1].alpha != entries[i].alpha;
    if (last_of_step) result.steps.push_back(growth.step(entries[i].alpha));
  }
  return result;
}

std::optional<double> smallest_covering(const Filtration& filtration, std::optional<std::size_t> most_components) {
  const auto step = std::find_if(filtration.steps.begin(), filtration.steps.end(), [&](const FiltrationStep& s) {
    return s.covered == filtration.distinct && (!most_components || s.solid_components <= *most_components);
  });
  if (step == filtration.steps.end()) return std::nullopt;
  return step->alpha;
}

}  // namespace rbpa
