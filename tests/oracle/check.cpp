#include "oracle/check.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <numeric>
#include <utility>

#include "meshops/core/validate.h"
#include "oracle/delaunay.h"
#include "rbpa/paper.h"
#include "support/shrink.h"

namespace rbpa_test {
namespace {

std::string at(std::string what, std::size_t index) { return what.append(" ").append(std::to_string(index)); }

/// Returns the faces of the mesh as input indices; a face that is not a triangle is left out.
std::vector<Triangle> faces(const rbpa::SolidAlphaComplex& complex) {
  std::vector<Triangle> triangles;
  for (const auto face : complex.mesh.faces()) {
    std::vector<std::uint32_t> corners;
    for (const auto vertex : face.vertices())
      corners.push_back(complex.input_index[static_cast<std::size_t>(vertex.idx())]);
    if (corners.size() == 3) triangles.push_back({corners[0], corners[1], corners[2]});
  }
  return canonical(std::move(triangles));
}

/// The numbers of vertices and edges of a mesh of the triangles in which each fan has a vertex of its own.
struct Size {
  std::size_t vertices = 0, edges = 0;
};

Size size_with_fans_apart(const std::vector<Triangle>& triangles) {
  struct Side {
    std::uint32_t low, high;      ///< ends, the lower index first
    std::size_t at_low, at_high;  ///< the triangle's corners there: 3 · triangle + place
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      Side side{triangles[t][i], triangles[t][j], 3 * t + i, 3 * t + j};
      if (side.low > side.high) side = {side.high, side.low, side.at_high, side.at_low};
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });

  std::vector<std::size_t> parent(3 * triangles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t corner) {
    while (parent[corner] != corner) corner = parent[corner] = parent[parent[corner]];
    return corner;
  };
  Size size{parent.size(), sides.size()};
  const auto unite = [&](std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    size.vertices -= a != b;
    parent[a] = b;
  };
  for (std::size_t s = 1; s < sides.size(); ++s) {
    const Side &a = sides[s - 1], &b = sides[s];
    if (a.low != b.low || a.high != b.high) continue;
    --size.edges;
    unite(a.at_low, b.at_low);
    unite(a.at_high, b.at_high);
  }
  return size;
}

std::string wrong_vertices(const rbpa::SolidAlphaComplex& complex, std::span<const rbpa::Point> points,
                           const std::vector<std::uint32_t>& lowest) {
  if (complex.input_index.size() != complex.mesh.n_vertices()) return "input_index does not have one entry per vertex";
  for (const auto vertex : complex.mesh.vertices()) {
    const auto v = static_cast<std::size_t>(vertex.idx());
    const std::uint32_t index = complex.input_index[v];
    if (index >= points.size()) return at("input_index out of range at vertex", v);
    if (lowest[index] != index) return at("input_index names a duplicate at vertex", v);
    const auto& position = complex.mesh.point(vertex);
    if (rbpa::Point{position[0], position[1]} != points[index] || position[2] != 0)
      return at("vertex does not stand on its input point: vertex", v);
    if (complex.mesh.is_isolated(vertex)) return at("isolated vertex in the mesh: vertex", v);
  }
  return {};
}

std::string wrong_points(const rbpa::SolidAlphaComplex& complex, const std::vector<std::uint32_t>& lowest,
                         const std::vector<Triangle>& expected) {
  std::vector<bool> covered(lowest.size(), false);
  for (const Triangle& t : expected)
    for (const std::uint32_t corner : t) covered[corner] = true;
  std::vector<std::uint32_t> isolated;
  std::vector<rbpa::Duplicate> duplicates;
  for (std::uint32_t i = 0; i < lowest.size(); ++i) {
    if (lowest[i] != i)
      duplicates.push_back({i, lowest[i]});
    else if (!covered[i])
      isolated.push_back(i);
  }
  if (complex.isolated != isolated)
    return "isolated points: expected " + std::to_string(isolated.size()) + ", got " +
           std::to_string(complex.isolated.size()) + " or others";
  if (complex.duplicates != duplicates)
    return "duplicates: expected " + std::to_string(duplicates.size()) + ", got " +
           std::to_string(complex.duplicates.size()) + " or others";
  if (complex.distinct != lowest.size() - duplicates.size()) return "wrong number of distinct points";
  return {};
}

}  // namespace

std::string wrong_with(const rbpa::SolidAlphaComplex& complex, std::span<const rbpa::Point> points,
                       const std::vector<Triangle>& expected) {
  if (const auto defects = meshops::validate(complex.mesh); !defects.empty())
    return "mesh: " + meshops::describe(defects.front());
  const std::vector<std::uint32_t> lowest = lowest_equal(points);
  if (std::string wrong = wrong_vertices(complex, points, lowest); !wrong.empty()) return wrong;
  const std::vector<Triangle> actual = faces(complex);
  if (actual.size() != complex.mesh.n_faces()) return "a face is not a triangle";
  if (std::string wrong = difference(expected, actual); !wrong.empty()) return wrong;
  if (rbpa::triangles(complex) != expected) return "triangles() is not the canonical list of the mesh's faces";
  const Size size = size_with_fans_apart(expected);
  if (complex.mesh.n_edges() != size.edges)
    return "expected " + std::to_string(size.edges) + " edges, got " + std::to_string(complex.mesh.n_edges());
  if (complex.mesh.n_vertices() != size.vertices)
    return "expected a vertex for each of " + std::to_string(size.vertices) + " fans, got " +
           std::to_string(complex.mesh.n_vertices());
  return wrong_points(complex, lowest, expected);
}

std::string wrong_with_rbpa(std::span<const rbpa::Point> points, double alpha, Rbpa compute) {
  try {
    return wrong_with(compute(points, alpha, {}), points, DelaunayOracle(points).triangles(alpha));
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

std::string report(const std::string& complaint, const Points& points, double alpha, Rbpa compute) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::minutes(1);
  const auto fails = [&](const Points& some) {
    return Clock::now() < deadline && !wrong_with_rbpa(some, alpha, compute).empty();
  };
  std::string text =
      complaint + "\n  alpha " + literal(alpha) + (compute == rbpa::paper::rbpa ? ", the paper's search" : "");
  if (!fails(points)) return text + "\n  (not seen when run alone)";
  const Points few = shrink(points, fails);
  return text + "\n  shrunk to " + std::to_string(few.size()) + " points: " + wrong_with_rbpa(few, alpha, compute) +
         "\n  " + literal(few);
}

}  // namespace rbpa_test
