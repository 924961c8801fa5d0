// What: by which method a complex is made: the options about it, and the run.
// Law:  the complex is the same set of triangles by every method.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/run.h"
#include "rbpa/delaunay.h"
#include "rbpa/hrbpa.h"
#include "rbpa/triangulate.h"

namespace rbpa::app {

/// What the command line says, as text.
struct MethodArguments {
  std::string method = "rbpa";
  std::string search = "near";
  std::optional<std::string> leaf_capacity;
};

struct Method {
  bool by_paper = false;  ///< the method as published, or in tiles
  /// Hierarchical, with at most so many points in a leaf; absent: with one radius.
  std::optional<std::size_t> leaf_capacity = std::nullopt;

  std::string name() const { return leaf_capacity ? "hrbpa" : "rbpa"; }
};

/// Throws WrongUsage naming the value: one that is none, or one that is about another method.
Method parse_method(const MethodArguments& arguments);

/// What is wanted beside the triangles, each more than the one before.
enum class Links { none, boundary, neighbors };

/// What a method makes.
struct Built {
  Triangulation complex;
  std::vector<std::uint16_t> level;  ///< of each triangle, the number of its level; empty where the method has none
  std::optional<Hierarchy> mesh = std::nullopt;
};

/// The complex in arrays; with its mesh, made level by level, where that is wanted. With a progress line unless quiet. Throws
/// Cancelled after a signal. Requires: a full complex of rbpa alone, without its mesh and not by the paper.
Built build(const std::vector<Point>& points, double alpha, const Method& method, Complex kind, Links links,
            const RunOptions& run, bool with_mesh = false);

/// The Delaunay triangulation, of which radii are chosen, likewise.
Delaunay build_delaunay(const std::vector<Point>& points, const RunOptions& run);

}  // namespace rbpa::app
