#include "rbpa/space/simplify/remesh.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include "meshops/core/blocker.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/topology/build_mesh.h"
#include "rbpa/base/error.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "rbpa/space/simplify/moving/vertex_ranks.h"
#include "rbpa/space/simplify/remeshing/mesh_curves.h"
#include "rbpa/space/simplify/remeshing/remesh_run.h"
#include "rbpa/space/simplify/remeshing/wanted_lengths.h"

namespace rbpa {
namespace {

using meshops::Connectivity;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The triangles of a mesh with canonical numbers: vertices ascend by vertex_ranks(), triangles by their corners. Each
/// triangle begins with its least corner.
struct CanonicalSoup {
  CanonicalSoup(const Connectivity& mesh, const std::vector<Point3>& of) {
    std::vector<std::uint32_t> rank = space::vertex_ranks(mesh, of);
    for (const meshops::Vertex v : meshops::live_vertices(mesh)) order.push_back(static_cast<std::uint32_t>(v.idx()));
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return rank[a] < rank[b]; });
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      rank[order[i]] = i;
      places.push_back(of[order[i]]);
    }
    Triangles triangles = space::corners_of(mesh);
    for (auto& corners : triangles) {
      for (std::uint32_t& corner : corners) corner = rank[corner];
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    }
    std::sort(triangles.begin(), triangles.end());
    soup.points = places.size();
    for (const auto& corners : triangles) soup.add_face(corners);
  }
  meshops::PolygonSoup soup;
  std::vector<std::uint32_t> order;  // for each vertex its index in the mesh
  std::vector<Point3> places;
};

/// Replaces all elements of a mesh by those of a soup.
void replace(Connectivity& mesh, const meshops::PolygonSoup& soup) {
  meshops::request_status(mesh);
  for (const auto v : mesh.all_vertices()) mesh.status(v).set_deleted(true);
  for (const auto e : mesh.all_edges()) mesh.status(e).set_deleted(true);
  for (const auto f : mesh.all_faces()) mesh.status(f).set_deleted(true);
  mesh.garbage_collection();
  meshops::build_mesh(mesh, soup);
}

[[noreturn]] void refuse(const std::string& what, double number, const std::string& expected) {
  std::ostringstream text;
  text << "remesh: found " << what << " " << number << ", expected " << expected;
  throw InvalidInput(text.str());
}

std::string text_of(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

constexpr double unit_area = std::numbers::sqrt3 / 4;  // of an equilateral triangle

/// The area of a triangle, and half the length of its edges.
struct Size {
  Size(const std::vector<Point3>& places, const std::array<std::uint32_t, 3>& corners) {
    const Point3 &p = places[corners[0]], &q = places[corners[1]], &r = places[corners[2]];
    const auto normal = space::cross(space::from<double>(p, q), space::from<double>(p, r));
    area = std::sqrt(space::dot(normal, normal)) / 2;
    edges = (space::distance(p, q) + space::distance(q, r) + space::distance(r, p)) / 2;
  }
  double area, edges;
};

void require_size(const std::string& what, double size) {
  if (!(size >= 1e-60 && size <= 1e60)) refuse(what, size, "a number from 1e-60 to 1e60");
}

/// Returns the number of triangles with sides of the length that cover the area, and, for thin triangles, two for each
/// length along the edges.
double expected_faces(double area, double edges, double length) {
  return area / (unit_area * length * length) + 2 * edges / length;
}

/// Throws InvalidInput unless the options are valid for the mesh.
void require_options(const std::vector<Point3>& places, const Triangles& triangles, const RemeshOptions& options) {
  const double length = options.length;
  require_size("the length", length);
  if (options.error) require_size("the error", *options.error);
  if (!(options.sharp_angle >= 0 && options.sharp_angle <= 180))
    refuse("the sharp angle", options.sharp_angle, "degrees from 0 to 180");
  for (const Point3& p : places)
    for (const double coordinate : {p.x, p.y, p.z})
      if (const double limit = options.single_precision ? 1e38 : 1e60; std::abs(coordinate) > limit)
        refuse("the coordinate", coordinate, "none beyond " + text_of(limit) + " (scale the mesh)");
  if (triangles.empty()) return;
  space::Box box;
  double area = 0, edges = 0;
  for (const auto& corners : triangles) {
    for (const std::uint32_t corner : corners) box.include(places[corner]);
    const Size size(places, corners);
    area += size.area;
    edges += size.edges;
  }
  if (const double diagonal = space::distance(box.low, box.high); length > diagonal)
    refuse("the length", length, "at most " + text_of(diagonal) + ", the diagonal of the mesh's box");
  const auto limit = static_cast<double>(options.most_faces);
  if (expected_faces(area, edges, length) > limit) {
    // The least length x solves limit · x² = area / unit_area + 2 · edges · x.
    const double allowed = (edges + std::sqrt(edges * edges + limit * (area / unit_area))) / limit;
    refuse("the length", length,
           "at least " + text_of(allowed * 1.00001) + ", which makes at most " + std::to_string(options.most_faces) +
               " triangles of this mesh");
  }
}

/// Throws InvalidInput if edges of the wanted lengths would need too many triangles.
void require_few_faces(const std::vector<Point3>& places, const Triangles& triangles, const std::vector<double>& wanted,
                       const RemeshOptions& options) {
  double faces = 0;
  for (const auto& corners : triangles) {
    const Size size(places, corners);
    for (const std::uint32_t corner : corners)
      faces += expected_faces(size.area, size.edges, options.length * wanted[corner]) / 3;
  }
  if (faces > static_cast<double>(options.most_faces))
    refuse("lengths for a number of triangles of about", std::round(faces),
           "at most " + std::to_string(options.most_faces) + " (a greater error, or greater lengths)");
}

}  // namespace

Remeshing remesh(Connectivity& mesh, std::vector<Point3>& places, const RemeshOptions& options) {
  space::require_places("remesh", mesh, places);
  for (const meshops::Face f : meshops::live_faces(mesh))
    if (mesh.valence(f) != 3)
      meshops::detail::enforce("remesh", std::optional(meshops::Blocker(meshops::BlockerKind::not_triangle, f)));
  if (!options.lengths.empty() && options.lengths.size() != places.size())
    refuse("a number of lengths of", static_cast<double>(options.lengths.size()),
           "one for each of " + std::to_string(places.size()) + " vertices");
  OpenMesh::PolyConnectivity changed;
  std::vector<Point3> moved;
  std::vector<double> lengths;
  const CanonicalSoup given(mesh, places);
  for (const std::uint32_t point : meshops::build_mesh(changed, given.soup, options.go_on)) {
    moved.push_back(given.places[point]);
    if (options.lengths.empty()) continue;
    lengths.push_back(options.lengths[given.order[point]]);
    require_size("the length", lengths.back());
  }
  meshops::request_status(changed);
  const Triangles triangles = space::corners_of(changed);
  require_options(moved, triangles, options);
  space::MeshCurves curves(changed, moved, options);
  std::vector<double> wanted = space::wanted_lengths(changed, moved, curves, lengths, options);
  if (!wanted.empty()) require_few_faces(moved, triangles, wanted, options);
  const std::vector<Point3> before = moved;
  const space::SurfaceDistance beginning(before, triangles, options.go_on);
  Remeshing counts{.given = triangles.size()};
  space::RemeshRun(changed, moved, std::move(curves), std::move(wanted), beginning, options, counts)();
  if (options.measured) {
    const Triangles last = space::corners_of(changed);
    counts.distance = space::distance_of(last, moved, beginning, options.go_on);
    const bool is_within =
        options.error && std::all_of(last.begin(), last.end(), [&](const auto& corners) {
          return beginning.is_within({moved[corners[0]], moved[corners[1]], moved[corners[2]]}, *options.error);
        });
    if (is_within) counts.distance = std::min(*counts.distance, *options.error);
    const space::SurfaceDistance end(moved, last, options.go_on);
    counts.distance_back = space::distance_of(triangles, before, end, options.go_on);
  }
  CanonicalSoup made(changed, moved);
  counts.left = made.soup.faces();
  replace(mesh, made.soup);
  places = std::move(made.places);
  return counts;
}

}  // namespace rbpa
