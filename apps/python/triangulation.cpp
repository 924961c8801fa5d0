#include "rbpa/plane/alpha_complex.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <tuple>
#include <vector>

#include "meshops/core/contract.h"
#include "python/module.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/constrained_delaunay.h"

namespace rbpa::python {
namespace {

py::dict triangulate(const Doubles& points, double alpha, unsigned threads, const py::object& progress) {
  const auto input = points_of(points);
  AlphaComplex made = watched(input.size(), progress, [&](Watch& watch) {
    return rbpa::alpha_complex(input, alpha,
                               {.neighbors = true, .boundary = true, .threads = threads, .progress = watch.progress()});
  });
  py::dict result;
  result["simplices"] = rows<std::int32_t>(std::move(made.triangles));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["boundary"] = rows<std::int32_t>(std::move(made.boundary));
  result["isolated"] = line<std::int32_t>(std::move(made.isolated));
  result["duplicates"] = rows<std::int32_t>(std::move(made.duplicates));
  return result;
}

/// Returns the members of rbpa.ConstrainedDelaunay.
py::dict constrain(const Doubles& points, const Indices& segments, bool split_crossings, unsigned threads,
                   const py::object& progress) {
  const auto input = points_of(points);
  require_rows(segments, "segments", 2);
  std::vector<Segment> ends;
  for (py::ssize_t i = 0; i < segments.shape(0); ++i)
    ends.push_back({static_cast<std::uint32_t>(segments.at(i, 0)), static_cast<std::uint32_t>(segments.at(i, 1))});
  SegmentRegions found;
  ConstrainedDelaunay made = watched(long_work, progress, [&](Watch& watch) {
    ConstrainedDelaunay result = constrained_delaunay(
        input, ends, {.split_crossings = split_crossings, .threads = threads, .progress = watch.progress()});
    found = regions(result, watch.until_stopped());
    return result;
  });
  py::dict result;
  result["points"] = rows<double>(std::move(made.points));
  result["crossed"] = rows<std::int32_t>(std::move(made.crossed));
  result["simplices"] = rows<std::int32_t>(std::move(made.triangles));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["constrained"] = line<std::uint8_t>(std::move(made.constrained));
  result["segments"] = rows<std::int32_t>(std::move(made.edges));
  result["convex_hull"] = rows<std::int32_t>(std::move(made.boundary));
  result["duplicates"] = rows<std::int32_t>(std::move(made.duplicates));
  result["region"] = line<std::int32_t>(std::move(found.region));
  result["is_inside"] = line<std::uint8_t>(std::vector<std::uint8_t>(found.is_inside.begin(), found.is_inside.end()));
  return result;
}

/// The neighbors of each point in ascending order, one list after another, and the index at which each list begins.
struct NeighborLists {
  std::vector<std::int32_t> begin, neighbors;
};

NeighborLists neighbor_lists(std::span<const Triple> triangles, std::size_t points, const Watch& watch) {
  auto ask = [&watch, steps = 0U]() mutable {
    if (++steps % 16384 == 0 && !watch.go_on()) throw Cancelled();
  };
  NeighborLists lists{.begin = std::vector<std::int32_t>(points + 1), .neighbors = {}};
  std::vector<std::size_t> next(points + 1);
  for (const Triple& t : triangles) {
    ask();
    for (const std::uint32_t corner : t) {
      meshops::require(corner < points, "simplices: found corner ", corner, ", expected the index of a point");
      next[corner + std::size_t{1}] += 2;
    }
  }
  for (std::size_t i = 0; i < points; ++i) next[i + 1] += next[i];
  std::vector<std::int32_t> twice(next[points]);  // lists each inner edge twice, as a side of two triangles
  const std::vector<std::size_t> first = next;
  for (const Triple& t : triangles) {
    ask();
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t other : {k + 1, k + 2}) twice[next[t[k]]++] = static_cast<std::int32_t>(t[other % 3]);
  }
  lists.neighbors.reserve(twice.size() / 2 + points);
  for (std::size_t i = 0; i < points; ++i) {
    ask();
    const auto from = twice.begin() + static_cast<std::ptrdiff_t>(first[i]),
               to = twice.begin() + static_cast<std::ptrdiff_t>(first[i + 1]);
    std::sort(from, to);
    lists.neighbors.insert(lists.neighbors.end(), from, std::unique(from, to));
    lists.begin[i + 1] = static_cast<std::int32_t>(lists.neighbors.size());
  }
  return lists;
}

std::tuple<Indices, Indices> vertex_neighbors(const Indices& simplices, std::size_t points) {
  const auto triangles = triples_of(simplices, "simplices");
  NeighborLists lists =
      watched(points, py::none(), [&](const Watch& watch) { return neighbor_lists(triangles, points, watch); });
  return {line<std::int32_t>(std::move(lists.begin)), line<std::int32_t>(std::move(lists.neighbors))};
}

/// Returns a hash of the bits of all coordinates, by which a result detects changes of its points.
/// Requires: `points` is contiguous.
std::uint64_t fingerprint(const Doubles& points) {
  const auto words = static_cast<std::size_t>(points.size());
  const auto* const at = reinterpret_cast<const unsigned char*>(points.data());
  const py::gil_scoped_release unlocked;
  constexpr std::size_t lanes = 8;  // number of independent chains of products
  constexpr std::uint64_t prime = 0x100000001b3;
  std::array<std::uint64_t, lanes> hash{};
  const auto word = [&](std::size_t i) {
    std::uint64_t bits;
    std::memcpy(&bits, at + i * sizeof bits, sizeof bits);
    return bits;
  };
  std::size_t i = 0;
  for (; i + lanes <= words; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      std::uint64_t mixed = (hash[lane] ^ word(i + lane)) * prime;
      hash[lane] = mixed ^ mixed >> 32U;
    }
  for (; i < words; ++i) hash[i % lanes] = (hash[i % lanes] ^ word(i)) * prime;
  std::uint64_t all = words;
  for (const std::uint64_t one : hash) all = (all ^ one ^ one >> 29U) * prime;
  return all;
}

}  // namespace

void bind_triangulation(py::module_& module) {
  using py::arg;
  module.def("triangulate", &triangulate, as_is("points"), arg("alpha"), arg("threads"), arg("progress"));
  module.def("constrain", &constrain, as_is("points"), as_is("segments"), arg("split_crossings"), arg("threads"),
             arg("progress"));
  module.def("vertex_neighbors", &vertex_neighbors, as_is("simplices"), arg("points"));
  module.def("fingerprint", &fingerprint, as_is("points"));
}

}  // namespace rbpa::python
