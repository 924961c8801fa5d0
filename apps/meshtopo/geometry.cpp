#include "meshtopo/geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/interrupt.h"
#include "io/mesh/equal_positions.h"
#include "io/sort.h"
#include "rbpa/collinear.h"

namespace rbpa::app {
namespace {

using Face = std::span<const std::uint32_t>;
using Positions = std::vector<Position>;

/// The planes of two coordinates on which a face is looked at.
constexpr std::pair<std::size_t, std::size_t> planes[] = {{0, 1}, {1, 2}, {2, 0}};

/// Whether three points span an area on one of the planes for certain. The error of the determinant is below
/// (3 + 16ε)ε times the sum of its two products (Shewchuk 1997, section 4.4), ε = 2⁻⁵³, unless products underflow, which
/// changes it by less than 2⁻¹⁰⁷³. Where they overflow no comparison holds.
bool surely_span_area(const Position& a, const Position& b, const Position& c) {
  constexpr double error = 4e-16, least = 1e-300;
  return std::any_of(std::begin(planes), std::end(planes), [&](const auto& plane) {
    const auto& [x, y] = plane;
    const double one = (a[x] - c[x]) * (b[y] - c[y]), other = (a[y] - c[y]) * (b[x] - c[x]);
    const double area = std::abs(one - other);
    return area > least && area > error * (std::abs(one) + std::abs(other)) && std::isfinite(area);
  });
}

/// Points lie on one line in space when they do so on all three planes.
bool is_on_a_line(Face face, const Positions& positions) {
  for (std::size_t i = 2; i < face.size(); ++i)
    if (surely_span_area(positions[face[0]], positions[face[1]], positions[face[i]])) return false;
  return std::all_of(std::begin(planes), std::end(planes), [&](const auto& plane) {
    std::vector<Point> points;
    for (const std::uint32_t corner : face)
      points.push_back({positions[corner][plane.first], positions[corner][plane.second]});
    return are_collinear(points);
  });
}

bool names_each_once(Face face, std::vector<std::uint32_t>& scratch) {
  if (face.size() == 3) return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) == scratch.end();
}

void find_zero_areas(const MeshFile& mesh, std::vector<GeometricDefect>& defects) {
  std::vector<std::uint32_t> scratch;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const Face face = mesh.soup.face(f);
    if (face.size() >= 3 && names_each_once(face, scratch) && is_on_a_line(face, mesh.positions))
      defects.push_back({GeometryKind::zero_area_face, {face.begin(), face.end()}, {f}});
  }
}

void find_coincident(const MeshFile& mesh, std::vector<GeometricDefect>& defects) {
  EqualPositions places(mesh.positions.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> repeated;  // the first at a place, and a later one
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (const std::uint32_t first = places.first_at(mesh.positions, i); first != i) repeated.emplace_back(first, i);
  }
  sort(repeated);
  for (std::size_t k = 0; k < repeated.size(); ++k) {
    if (k % 16384 == 0) stop_if_interrupted();
    const auto& [first, later] = repeated[k];
    if (k == 0 || repeated[k - 1].first != first) defects.push_back({GeometryKind::coincident_vertices, {first}, {}});
    defects.back().points.push_back(later);
  }
}

}  // namespace

std::string_view name(GeometryKind kind) {
  return kind == GeometryKind::zero_area_face ? "zero-area face" : "coincident vertices";
}

std::vector<GeometricDefect> find_geometric_defects(const MeshFile& mesh) {
  std::vector<GeometricDefect> defects;
  find_zero_areas(mesh, defects);
  find_coincident(mesh, defects);
  return defects;
}

}  // namespace rbpa::app
