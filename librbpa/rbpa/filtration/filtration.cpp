#include "rbpa/filtration/filtration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "meshops/core/connectivity.h"
#include "rbpa/filtration/corners.h"
#include "rbpa/filtration/disjoint_sets.h"
#include "rbpa/filtration/least_alpha.h"
#include "rbpa/filtration/pulse.h"

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

/// A face without the detour over its halfedges: faces come in the order of their alphas, so each is a cache miss.
struct Cell {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::array<std::uint32_t, 3> corners;     ///< vertices
  std::array<std::uint32_t, 3> neighbours;  ///< faces, or none beyond the hull
};

std::vector<Cell> cells_of(const Mesh& mesh) {
  std::vector<Cell> cells(mesh.n_faces());
  for (std::size_t f = 0; f < cells.size(); ++f) {
    auto h = mesh.halfedge_handle(meshops::Face(static_cast<int>(f)));
    for (unsigned side = 0; side < 3; ++side) {
      const auto beyond = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      cells[f].corners[side] = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      cells[f].neighbours[side] = beyond.is_valid() ? static_cast<std::uint32_t>(beyond.idx()) : Cell::none;
      h = mesh.next_halfedge_handle(h);
    }
  }
  return cells;
}

/// The complex while triangles are added to it.
class Growth {
 public:
  explicit Growth(const Mesh& mesh)
      : cells_(cells_of(mesh)),
        solids_(mesh.n_faces()),
        pieces_(mesh.n_vertices()),
        in_(mesh.n_faces()),
        on_(mesh.n_vertices()) {}

  void add(const Entry& entry) {
    const Cell& cell = cells_[entry.face];
    ++now_.triangles;
    ++now_.solid_components;
    area_ += entry.area;
    in_[entry.face] = true;
    for (const std::uint32_t neighbour : cell.neighbours) {
      if (neighbour == Cell::none || !in_[neighbour])
        ++edges_;
      else
        now_.solid_components -= solids_.join(entry.face, neighbour);
    }
    for (const std::uint32_t corner : cell.corners) {
      if (!on_[corner]) ++now_.covered, ++now_.components;
      on_[corner] = true;
      now_.components -= pieces_.join(cell.corners[0], corner);
    }
  }

  FiltrationStep step(double alpha) const {
    FiltrationStep step = now_;
    step.alpha = alpha;
    step.holes = step.components + edges_ - step.covered - step.triangles;  // components − χ
    step.area = static_cast<double>(area_);
    return step;
  }

 private:
  std::vector<Cell> cells_;
  DisjointSets solids_;        // of faces
  DisjointSets pieces_;        // of vertices
  std::vector<bool> in_, on_;  // faces, vertices
  FiltrationStep now_;
  std::size_t edges_ = 0;
  long double area_ = 0;
};

}  // namespace

Filtration filtration(const SolidAlphaComplex& delaunay, std::span<const Point> points,
                      const std::function<bool()>& go_on) {
  Pulse pulse(go_on);
  const Corners corners(delaunay, points);
  meshops::require(delaunay.mesh.n_faces() == 0 || delaunay.isolated.empty(),
                   "filtration: the complex leaves points out, so it is not the Delaunay triangulation");
  Filtration result{.steps = {}, .triangle_alpha = {}, .distinct = delaunay.distinct};
  result.triangle_alpha.resize(delaunay.mesh.n_faces());
  std::vector<Entry> entries(delaunay.mesh.n_faces());
  for (std::uint32_t f = 0; f < entries.size(); ++f) {
    pulse.beat();
    const std::array<Point, 3> triangle = corners.of_face(f);
    result.triangle_alpha[f] = least_alpha(triangle[0], triangle[1], triangle[2]);
    entries[f] = {result.triangle_alpha[f], area(triangle), f};
  }
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    pulse.beat();
    return a < b;
  });

  const auto ends_step = [&](std::size_t i) {
    return i + 1 == entries.size() || entries[i + 1].alpha != entries[i].alpha;
  };
  std::size_t steps = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) steps += ends_step(i);
  result.steps.reserve(steps);
  Growth growth(delaunay.mesh);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    pulse.beat();
    growth.add(entries[i]);
    if (ends_step(i)) result.steps.push_back(growth.step(entries[i].alpha));
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
