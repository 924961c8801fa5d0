// What: parses the options about the method that makes a complex, and runs the method.
// Law:  every method makes the same set of triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/hrbpa.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/delaunay.h"
#include "shared/run.h"

namespace rbpa::app {

/// The options about the method, as text.
struct MethodArguments {
  std::string method = "rbpa";
  std::string search = "near";
  std::optional<std::string> leaf_capacity;
};

struct Method {
  bool by_paper = false;  ///< true: the method as published; false: the method in tiles
  /// The most points in a leaf of the hierarchical method; nullopt for the method with one radius.
  std::optional<std::size_t> leaf_capacity = std::nullopt;

  std::string name() const { return leaf_capacity ? "hrbpa" : "rbpa"; }
};

/// Parses the options. Throws WrongUsage that names an unknown value, or an option of another method.
Method parse_method(const MethodArguments& arguments);

/// The links that build() computes in addition to the triangles: none, AlphaComplex::boundary, or
/// AlphaComplex::neighbors, from which the boundary follows.
enum class Links { none, boundary, neighbors };

/// The result of build().
struct Built {
  AlphaComplex complex;
  std::vector<std::uint16_t> level;  ///< number of the level of each triangle; empty for a method without levels
  std::optional<Hierarchy> mesh = std::nullopt;
};

/// Makes the complex of `points` at `alpha` as arrays. With `with_mesh` the method makes a mesh, level by level, and
/// the result contains it. Shows a progress line unless quiet. Throws Cancelled after a signal. Requires: if `kind` is
/// full, `method` is in tiles and has no levels, and `with_mesh` is false.
Built build(const std::vector<Point>& points, double alpha, const Method& method, ComplexKind kind, Links links,
            const RunOptions& run, bool with_mesh = false);

/// Makes the Delaunay triangulation, from which radii are chosen. Shows a progress line unless quiet. Throws Cancelled
/// after a signal.
Delaunay build_delaunay(const std::vector<Point>& points, const RunOptions& run);

}  // namespace rbpa::app
