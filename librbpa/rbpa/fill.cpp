#include "rbpa/fill.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "meshops/core/live.h"
#include "meshops/front/engine.h"
#include "meshops/topology/build_mesh.h"
#include "rbpa/base/error.h"
#include "rbpa/base/mesh.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/point_text.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill/front/improve.h"
#include "rbpa/fill/front/link_filling.h"
#include "rbpa/fill/front/lo_front.h"
#include "rbpa/fill/front/outline.h"
#include "rbpa/fill/front/size_estimate.h"
#include "rbpa/fill/front/size_field.h"
#include "rbpa/fill/front/triangulate_outline.h"
#include "rbpa/fill/rings/polygon_rings.h"
#include "rbpa/plane/mesh/monitor.h"
#include "rbpa/plane/shape/measure.h"

namespace rbpa {
namespace {

void check_positive(const std::string& what, double value) {
  if (!(value > 0) || std::isinf(value))
    throw InvalidInput(what + ": found " + text(value) + ", expected a finite number above 0");
}

void check_sizes(const FillOptions& options) {
  if (std::isinf(options.size) && options.size > 0) {
    if (options.grade || !options.sizes.empty())
      throw InvalidInput("size: found inf, at which no point is added, together with " +
                         std::string(options.grade ? "a grade" : "sizes at points") + ", expected one of them");
    return;
  }
  check_positive("size", options.size);
  if (options.grade) check_positive("grade", *options.grade);
  for (std::size_t i = 0; i < options.sizes.size(); ++i) {
    const std::string which = "size " + std::to_string(i) + " of sizes at points";
    check_positive(which, options.sizes[i].size);
    if (!is_finite(options.sizes[i].at))
      throw InvalidInput(which + ": found it at " + place_of(options.sizes[i].at) + ", expected finite coordinates");
  }
}

/// Maximum number of triangles of a mesh.
constexpr double max_triangles = 500e6;

/// Estimates the number of triangles and reports it to `said.estimated`. Throws: InvalidInput when there are too many.
void check_number(const Outline& outline, const SizeField& field, const FillOptions& said, const GoOn& go_on) {
  const double triangles = estimate_triangles(parts_of(outline), field, said.keep_boundary, go_on);
  if (!(triangles <= max_triangles)) {
    const std::string others = said.grade || !said.sizes.empty() ? " and the other size options" : "";
    throw InvalidInput("size: found " + text(said.size) + others + ", at which about " + text(std::round(triangles)) +
                       " triangles would be made, expected larger sizes: at most " + text(max_triangles) +
                       " triangles");
  }
  if (said.estimated) said.estimated(triangles);
}

/// A temporary scale for coordinates whose squared lengths would overflow or underflow. The factor is a power of two,
/// so scaling changes only exponents.
class Scale {
 public:
  /// Scales the outline. Throws: InvalidInput when scaling back would not restore a coordinate; Cancelled.
  Scale(Outline& outline, Steps& step) {
    double largest = 0;
    for (const Point& p : outline.places) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    constexpr int comfortable = 300;
    exponent_ = std::abs(std::ilogb(largest)) > comfortable ? std::ilogb(largest) : 0;
    for (Point& p : outline.places) {
      step();
      const Point scaled{in(p.x), in(p.y)};
      if (out(scaled) != p)
        throw InvalidInput("coordinates: found " + place_of(p) + " together with a coordinate of " + text(largest) +
                           ", expected coordinates closer in magnitude");
      p = scaled;
    }
  }

  double in(double value) const { return std::scalbn(value, -exponent_); }
  Point out(const Point& p) const { return {std::scalbn(p.x, exponent_), std::scalbn(p.y, exponent_)}; }
  FillOptions in(FillOptions options, std::vector<SizeAt>& sizes) const {
    constexpr double huge = 0x1p400;  // larger sizes have the same effect
    for (SizeAt& size : sizes) size = {{in(size.at.x), in(size.at.y)}, std::min(in(size.size), huge)};
    options.size = std::min(in(options.size), huge);
    options.sizes = sizes;
    return options;
  }

 private:
  int exponent_;
};

SizeField field_of(const Outline& outline, const FillOptions& options) {
  std::vector<SizeAt> sources(options.sizes.begin(), options.sizes.end());
  if (options.grade)
    for (const OutlineRing& ring : outline.rings)
      for (std::size_t i = 0; i < ring.sites.size(); ++i) {
        const Point& a = outline.places[ring.sites[i]];
        const Point& b = outline.places[ring.sites[(i + 1) % ring.sites.size()]];
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double length = std::sqrt(dx * dx + dy * dy);
        if (length > 0) sources.push_back({{a.x + dx / 2, a.y + dy / 2}, length});
      }
  return {options.size, options.grade.value_or(FillOptions::default_grade), std::move(sources)};
}

/// Returns cones over the rings: each boundary edge has a triangle to the tip of its ring on its outer side. The whole
/// boundary is thus a front, and the engine attaches nothing to its outer side.
meshops::PolygonSoup cones_over(const Outline& outline, Steps& step) {
  meshops::PolygonSoup soup{.points = outline.places.size() + outline.rings.size(), .corners = {}};
  for (std::size_t r = 0; r < outline.rings.size(); ++r) {
    const std::vector<Site>& ring = outline.rings[r].sites;
    const auto tip = static_cast<Site>(outline.places.size() + r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      step();
      soup.add_face(Triangle{ring[(i + 1) % ring.size()], ring[i], tip});
    }
  }
  return soup;
}

/// Triangles on places; the places of the outline come first.
struct Pieces {
  std::vector<Point> places = {};
  std::vector<Triangle> triangles = {};
  std::size_t retreats = 0, passed = 0;
};

class ProgressVisitor : public Monitor {
 public:
  ProgressVisitor(LoFront& policy, const OnProgress& progress, std::size_t points)
      : Monitor(progress, points), policy_(policy) {}
  void attached(const Front& front, Halfedge h, const meshops::InsertedTriangle& triangle) {
    policy_.attached(front, triangle);
    Monitor::attached(front, h, triangle);
  }
  void detached(const Front&, const meshops::DetachedTriangle& triangle) { policy_.detached(triangle); }

 private:
  LoFront& policy_;
};

Pieces advance_from(const Outline& outline, const SizeField& field, const FillOptions& options, const GoOn& go_on) {
  Mesh mesh;
  meshops::request_status(mesh);
  Steps step(go_on);
  const std::vector<std::uint32_t> site_of_vertex = meshops::build_mesh(mesh, cones_over(outline, step), go_on);
  const std::size_t outside = mesh.n_faces();
  std::vector<std::vector<Site>> rings;
  for (const OutlineRing& ring : outline.rings) rings.push_back(ring.sites);
  std::vector<Point> places = outline.places;
  places.resize(places.size() + outline.rings.size());

  stop_if_cancelled(go_on);
  Front front(mesh, site_of_vertex);
  stop_if_cancelled(go_on);
  LoFront policy(std::move(places), rings, field, go_on);
  meshops::advance(front, policy, ProgressVisitor(policy, options.progress, outline.places.size()));
  Pieces pieces{.places = policy.places(), .triangles = {}, .retreats = policy.retreats(), .passed = policy.passed()};
  for (std::size_t i = 0; i < mesh.n_halfedges(); ++i) {
    step();
    meshops::require(!front.is_boundary(Halfedge(static_cast<int>(i))), "fill: the front has not closed");
  }
  meshops::for_each_face(mesh, [&](meshops::Face f) {
    step();
    if (static_cast<std::size_t>(f.idx()) < outside) return;
    const Halfedge h = mesh.halfedge_handle(f), next = mesh.next_halfedge_handle(h);
    pieces.triangles.push_back({front.from_site(h), front.to_site(h), front.to_site(next)});
  });
  return pieces;
}

/// Removes places that no triangle uses, except those of the outline.
void drop_unused(Pieces& pieces, std::size_t outline) {
  constexpr std::uint32_t unused = TriangleArrays::none;
  std::vector<std::uint32_t> number(pieces.places.size(), unused);
  for (std::size_t i = 0; i < outline; ++i) number[i] = static_cast<std::uint32_t>(i);
  for (const Triangle& triangle : pieces.triangles)
    for (const std::uint32_t s : triangle) number[s] = s;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == unused) continue;
    pieces.places[kept] = pieces.places[i];
    number[i] = static_cast<std::uint32_t>(kept++);
  }
  pieces.places.resize(kept);
  for (Triangle& triangle : pieces.triangles)
    for (std::uint32_t& s : triangle) s = number[s];
}

meshops::PolygonSoup soup_of(std::span<const Triangle> triangles, std::size_t points, Steps& step) {
  meshops::PolygonSoup soup{.points = points, .corners = {}};
  for (const Triangle& triangle : triangles) {
    step();
    soup.add_face(triangle);
  }
  return soup;
}

/// Moves each vertex v to places[point[v]].
void place(Mesh& mesh, std::span<const Point> places, std::span<const std::uint32_t> point) {
  for (std::size_t v = 0; v < point.size(); ++v)
    mesh.set_point(meshops::Vertex(static_cast<int>(v)), {places[point[v]].x, places[point[v]].y, 0});
}

/// Improves the triangles: moves places and flips edges.
void make_better(Pieces& pieces, std::size_t outline, const SizeField& field, const FillOptions& options,
                 const GoOn& go_on) {
  Mesh mesh;
  meshops::request_status(mesh);
  Steps step(go_on);
  const std::vector<std::uint32_t> site =
      meshops::build_mesh(mesh, soup_of(pieces.triangles, pieces.places.size(), step), go_on);
  place(mesh, pieces.places, site);
  const Checkpoint checkpoint = checkpoint_of(options.progress, outline, pieces.triangles.size());
  improve(mesh, outline, field, [&] {
    if (checkpoint) checkpoint();
  });
  pieces.triangles.clear();
  for (std::size_t i = outline; i < pieces.places.size(); ++i) {
    const auto& p = mesh.point(meshops::Vertex(static_cast<int>(i)));
    pieces.places[i] = {p[0], p[1]};
  }
  meshops::for_each_face(mesh, [&](meshops::Face f) {
    step();
    const Halfedge h = mesh.halfedge_handle(f), next = mesh.next_halfedge_handle(h);
    const auto number = [&](meshops::Vertex v) { return site[static_cast<std::size_t>(v.idx())]; };
    pieces.triangles.push_back(
        {number(mesh.from_vertex_handle(h)), number(mesh.to_vertex_handle(h)), number(mesh.to_vertex_handle(next))});
  });
  drop_unused(pieces, outline);
}

/// Returns the triangles of `outline`, on places that begin with those of `outline`. Adds no point if `field` is null.
Pieces pieces_of(const Outline& outline, const SizeField* field, const FillOptions& options, const GoOn& go_on) {
  if (field == nullptr) return {.places = outline.places, .triangles = triangulate(outline, go_on)};
  Pieces pieces = advance_from(outline, *field, options, go_on);
  drop_unused(pieces, outline.places.size());
  make_better(pieces, outline.places.size(), *field, options, go_on);
  return pieces;
}

/// Appends the triangles of `pieces`, which fill the part, to `triangles`, and their new points to `filling`. number[s]
/// is the point of site s of the whole outline.
void add(const OutlinePart& part, const Pieces& pieces, std::span<const std::uint32_t> number, const Scale& scale,
         std::vector<std::pair<Triangle, std::size_t>>& triangles, Filling& filling) {
  std::vector<std::uint32_t> point;
  for (const Site s : part.site) point.push_back(number[s]);
  for (std::size_t i = part.site.size(); i < pieces.places.size(); ++i) {
    point.push_back(static_cast<std::uint32_t>(filling.points.size()));
    filling.points.push_back(scale.out(pieces.places[i]));
  }
  for (const Triangle& triangle : pieces.triangles) {
    Triangle named{point[triangle[0]], point[triangle[1]], point[triangle[2]]};
    std::rotate(named.begin(), std::min_element(named.begin(), named.end()), named.end());
    triangles.emplace_back(named, part.group);
  }
  filling.retreats += pieces.retreats;
  filling.passed += pieces.passed;
}

std::vector<Polygon> polygons_of(const Outline& outline, const PolygonRings& rings,
                                 std::span<const std::uint32_t> number, std::span<const Polygon> input,
                                 std::span<const Point> points) {
  std::vector<Polygon> polygons(input.size());
  for (std::size_t p = 0; p < input.size(); ++p) polygons[p].holes.resize(input[p].holes.size());
  for (const OutlineRing& ring : outline.rings) {
    const auto [polygon, hole] = rings.roles[ring.input];
    Ring& cut = hole ? polygons[polygon].holes[*hole] : polygons[polygon].shell;
    for (const Site s : ring.sites) cut.points.push_back(number[s]);
  }
  for (Polygon& polygon : polygons)
    if (!polygon.shell.points.empty()) measure(polygon, points);
  return polygons;
}

}  // namespace

Filling fill(std::span<const Point> points, std::span<const Polygon> polygons, const FillOptions& said) {
  check_sizes(said);
  const Checkpoint checkpoint = checkpoint_of(said.progress, points.size());
  const GoOn go_on = [&] {
    if (checkpoint) checkpoint();
    return true;
  };
  Steps step(go_on);
  const PolygonRings rings = valid_polygons(points, polygons, said.groups, go_on);
  Filling filling;
  filling.points.assign(points.begin(), points.end());
  filling.boundary_points = points.size();
  if (rings.input.empty()) {
    filling.polygons.assign(polygons.begin(), polygons.end());
    link(filling, step);
    return filling;
  }
  Outline outline = outline_of(points, rings.noded.rings, rings.places, rings.groups);
  const Scale scale(outline, step);
  std::vector<SizeAt> sizes(said.sizes.begin(), said.sizes.end());
  FillOptions options = scale.in(said, sizes);
  std::optional<SizeField> field;
  if (!std::isinf(said.size)) {
    field.emplace(field_of(outline, options));
    check_number(outline, *field, said, go_on);
    if (!options.keep_boundary) cut(outline, *field, go_on);
  }
  std::vector<std::uint32_t> number = outline.input;
  for (std::size_t i = outline.input.size(); i < outline.places.size(); ++i) {
    number.push_back(static_cast<std::uint32_t>(filling.points.size()));
    filling.points.push_back(scale.out(outline.places[i]));
  }
  filling.boundary_points = filling.points.size();

  std::vector<std::pair<Triangle, std::size_t>> triangles;
  if (said.progress)
    options.progress = [&](const Progress& progress) {
      return said.progress({triangles.size() + progress.triangles, progress.points});
    };
  for (const OutlinePart& part : parts_of(outline))
    add(part, pieces_of(part.outline, field ? &*field : nullptr, options, go_on), number, scale, triangles, filling);
  sort(triangles, step, std::less<>());
  for (const auto& [triangle, group] : triangles) {
    step();
    filling.triangles.push_back(triangle);
    filling.groups.push_back(group);
  }
  link(filling, step);
  filling.polygons = polygons_of(outline, rings, number, polygons, filling.points);
  return filling;
}

}  // namespace rbpa
