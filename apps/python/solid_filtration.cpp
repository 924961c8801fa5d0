#include "rbpa/space/persistence/solid_filtration.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "python/module.h"
#include "python/solid_again.h"
#include "rbpa/base/pair_choice.h"
#include "rbpa/space/balls/weighted_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/persistence/solid_plateaus.h"
#include "rbpa/space/persistence/solid_representatives.h"
#include "rbpa/space/persistence/void_tree.h"
#include "rbpa/space/solid/solid_radii.h"

namespace rbpa::python {
namespace {

/// Returns the simplices, each with the value from which on it is in the complex, and the persistence pairs.
py::dict arrays_of(SolidFiltration&& filtration, const std::vector<SolidPair>& all) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<std::vector<std::array<double, 2>>, 3> values;
  std::array<std::vector<std::array<std::uint32_t, 2>>, 3> simplices;
  for (const SolidPair& pair : all) {
    const auto dimension = static_cast<std::size_t>(pair.dimension);
    values[dimension].push_back({pair.birth, pair.death.value_or(infinity)});
    simplices[dimension].push_back({pair.born_by, pair.ended_by});
  }
  py::list persistence, pairs;
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    persistence.append(rows<double>(std::move(values[dimension])));
    pairs.append(rows<std::int32_t>(std::move(simplices[dimension])));
  }
  py::dict result;
  result["edges"] = rows<std::int32_t>(std::move(filtration.edges));
  result["edge_alpha"] = line<double>(std::move(filtration.edge_alpha));
  result["triangles"] = rows<std::int32_t>(std::move(filtration.triangles));
  result["triangle_alpha"] = line<double>(std::move(filtration.triangle_alpha));
  result["simplices"] = rows<std::int32_t>(std::move(filtration.delaunay.simplices));
  result["neighbors"] = rows<std::int32_t>(std::move(filtration.delaunay.neighbors));
  result["simplex_alpha"] = line<double>(std::move(filtration.tetrahedron_alpha));
  result["edges_of"] = rows<std::int32_t>(std::move(filtration.edges_of));
  result["triangles_of"] = rows<std::int32_t>(std::move(filtration.triangles_of));
  result["distinct"] = filtration.delaunay.distinct;
  result["_persistence"] = persistence;
  result["_pairs"] = pairs;
  return result;
}

/// Returns the result of arrays_of() for points, and the radii that the rules min and auto choose.
py::dict solid_filtration_of(const Doubles& points, unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  struct Made {
    SolidFiltration filtration;
    std::vector<SolidPair> pairs;
    double least, automatic;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Made made = watched(input.size(), progress, [&](Watch& watch) {
    Made all{.filtration = solid_filtration(input, {.threads = threads, .progress = watch.progress()}),
             .pairs = {},
             .least = infinity,
             .automatic = infinity};
    all.pairs = solid_persistence(all.filtration, watch.until_stopped(), threads);
    all.least = min_alpha(all.filtration.delaunay, all.filtration.tetrahedron_alpha, 1, watch.until_stopped());
    all.automatic =
        auto_alpha(all.filtration.delaunay, all.filtration.tetrahedron_alpha, 1, watch.until_stopped(), threads);
    return all;
  });
  py::dict result = arrays_of(std::move(made.filtration), made.pairs);
  result["min"] = made.least;
  result["auto"] = made.automatic;
  return result;
}

/// Returns the result of arrays_of() for balls, and the value of each ball.
py::dict weighted_filtration_of(const Doubles& centers, const Doubles& radii, bool roots, unsigned threads) {
  const auto input = points3_of(centers, "centers");
  SolidFiltration filtration;
  const std::vector<SolidPair> pairs = watched(input.size(), py::none(), [&](Watch& watch) {
    filtration =
        weighted_filtration(input, line_of(radii), {.roots = roots, .threads = threads, .progress = watch.progress()});
    return solid_persistence(filtration, watch.until_stopped(), threads);
  });
  std::vector<double> of_balls = std::move(filtration.point_alpha);
  py::dict result = arrays_of(std::move(filtration), pairs);
  result["ball_alpha"] = line<double>(std::move(of_balls));
  return result;
}

/// Returns the arguments of rbpa.SolidRepresentative for each pair.
py::list solid_representatives_of(const Doubles& points, int dimension, double min_persistence,
                                  std::optional<std::size_t> top, unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  struct Made {
    SolidFiltration filtration;
    std::vector<SolidPair> pairs;
    std::vector<SolidRepresentative> found;
  };
  Made made = watched(input.size(), progress, [&](Watch& watch) {
    Made all{.filtration = solid_filtration(input, {.threads = threads, .progress = watch.progress()}),
             .pairs = {},
             .found = {}};
    all.pairs = solid_persistence(all.filtration, watch.until_stopped(), threads);
    std::erase_if(all.pairs, [&](const SolidPair& pair) { return pair.dimension != dimension; });
    PairChoice choice{.min_persistence = min_persistence};
    if (top) choice.top = *top;
    all.pairs = chosen(all.pairs, choice);
    all.found = solid_representatives(input, all.filtration, all.pairs, watch.until_stopped());
    return all;
  });
  py::list list;
  for (std::size_t i = 0; i < made.pairs.size(); ++i) {
    SolidRepresentative& one = made.found[i];
    std::vector<std::array<std::uint32_t, 2>> edges;
    if (dimension < 2)
      for (const std::uint32_t edge : one.cells) edges.push_back(made.filtration.edges[edge]);
    list.append(py::make_tuple(
        dimension, made.pairs[i].birth, made.pairs[i].death.value_or(std::numeric_limits<double>::infinity()),
        rows<std::int32_t>(std::move(edges)), rows<std::int32_t>(std::move(one.faces)),
        line<std::int32_t>(std::move(one.tetrahedra)), one.length, one.area, one.volume, one.is_shortest));
  }
  return list;
}

/// Returns the arguments of rbpa.SolidPlateau for each plateau, the best first.
py::list solid_plateaus_of(const Doubles& points, const Indices& simplices, const Indices& neighbors,
                           const Doubles& radii, std::size_t distinct, unsigned threads) {
  const auto input = points3_of(points, "points");
  const std::vector<SolidPlateau> found = watched(input.size(), py::none(), [&](Watch& watch) {
    Solid delaunay = solid_again(simplices, neighbors);
    delaunay.distinct = distinct;
    return solid_plateaus(input, delaunay, line_of(radii), watch.until_stopped(), threads);
  });
  py::list list;
  for (const SolidPlateau& p : found)
    list.append(py::make_tuple(p.from, p.to, p.alpha, p.ratio, p.tetrahedra, p.components, p.covered, p.volume,
                               p.effective_parts, p.void_share, p.is_structured ? "structured" : "one piece",
                               p.is_long));
  return list;
}

/// Returns the nodes of the tree of voids, with an array for each member of a node.
py::dict void_tree_of(const Doubles& points, const Indices& simplices, const Indices& neighbors, const Doubles& radii,
                      bool full, unsigned threads) {
  const auto input = points3_of(points, "points");
  const VoidTree tree = watched(input.size(), py::none(), [&](Watch& watch) {
    return void_tree(input, solid_again(simplices, neighbors), line_of(radii),
                     full ? ComplexKind::full : ComplexKind::solid, threads, watch.until_stopped());
  });
  py::dict result;
  result["closes"] = column<double>(tree.nodes, &VoidNode::closes);
  result["filled"] = column<double>(tree.nodes, &VoidNode::filled);
  result["volume"] = column<double>(tree.nodes, &VoidNode::volume);
  result["parent"] = column<std::int32_t>(tree.nodes, &VoidNode::parent);
  result["mouth"] = column<std::int32_t>(tree.nodes, &VoidNode::mouth);
  return result;
}

}  // namespace

void bind_solid_filtration(py::module_& module) {
  using py::arg;
  module.def("solid_filtration", &solid_filtration_of, as_is("points"), arg("threads"), arg("progress"));
  module.def("weighted_filtration", &weighted_filtration_of, as_is("centers"), as_is("radii"), arg("roots"),
             arg("threads"));
  module.def("solid_plateaus", &solid_plateaus_of, as_is("points"), as_is("simplices"), as_is("neighbors"),
             as_is("radii"), arg("distinct"), arg("threads"));
  module.def("void_tree", &void_tree_of, as_is("points"), as_is("simplices"), as_is("neighbors"), as_is("radii"),
             arg("full"), arg("threads"));
  module.def("solid_representatives", &solid_representatives_of, as_is("points"), arg("dimension"),
             arg("min_persistence"), arg("top"), arg("threads"), arg("progress"));
}

}  // namespace rbpa::python
