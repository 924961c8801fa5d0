#include "rbpa/plane/partial.h"

#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "python/flat_polygons.h"
#include "python/module.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/partial_bytes.h"

namespace rbpa::python {
namespace {

using LongIndices = py::array_t<std::uint64_t, py::array::c_style>;

using Bounds = std::tuple<double, double, double, double>;

Region region_of(const Bounds& bounds) {
  const auto [x0, y0, x1, y1] = bounds;
  return {x0, y0, x1, y1};
}

Bounds halo_of(const Bounds& bounds, double alpha) {
  const Region halo = rbpa::halo(region_of(bounds), alpha);
  return {halo.x0, halo.y0, halo.x1, halo.y1};
}

py::bytes as_bytes(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Returns a view of `bytes`, which must outlive the span.
std::span<const std::uint8_t> span_of(const py::bytes& bytes) {
  const auto text = static_cast<std::string_view>(bytes);
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

py::dict as_arrays(std::span<const CornerPolygon> polygons) {
  FlatPolygons<std::uint64_t> flat;
  std::vector<std::uint64_t> points;
  for (const CornerPolygon& polygon : polygons) {
    flat.add(polygon);
    points.push_back(polygon.points);
  }
  py::dict result = flat.as_arrays();
  result["coordinates"] = rows<double>(std::move(flat.coordinates));
  result["points"] = line<std::int64_t>(std::move(points));
  return result;
}

/// The result for some regions: the open part, which later merges change, as bytes; and the finished polygons.
struct Settled {
  std::vector<std::uint8_t> open;
  std::vector<CornerPolygon> polygons;
};

Settled settle(Partial&& partial) {
  Settled settled;
  settled.polygons = take_settled(partial);
  settled.open = to_bytes(partial);
  return settled;
}

std::tuple<py::bytes, py::dict, Begins, Begins> partial_of(const Doubles& points, const LongIndices& indices,
                                                           const Bounds& bounds, double alpha, unsigned threads) {
  const auto input = points_of(points);
  const Region region = region_of(bounds);
  const std::span<const std::uint64_t> numbers(indices.data(), static_cast<std::size_t>(indices.size()));
  struct SettledRegion {
    Settled settled;
    OwnedItems owned;
  };
  SettledRegion made = watched(input.size(), py::none(), [&](Watch& watch) {
    auto [partial, owned] = partial_and_items(region, {.points = input, .indices = numbers}, alpha,
                                              {.threads = threads, .progress = watch.progress()});
    return SettledRegion{settle(std::move(partial)), std::move(owned)};
  });
  return {as_bytes(made.settled.open), as_arrays(made.settled.polygons),
          rows<std::int64_t>(std::move(made.owned.triangles)), line<std::int64_t>(std::move(made.owned.isolated))};
}

std::tuple<py::bytes, py::dict> merge_of(const py::bytes& a, const py::bytes& b) {
  const auto first = span_of(a), second = span_of(b);
  const Settled settled = watched(first.size() + second.size(), py::none(), [&](Watch&) {
    return settle(merge(partial_from_bytes(first), partial_from_bytes(second)));
  });
  return {as_bytes(settled.open), as_arrays(settled.polygons)};
}

std::tuple<py::dict, py::dict> finish_of(const py::bytes& bytes) {
  const WholeComplex whole = rbpa::finish(partial_from_bytes(span_of(bytes)));
  const PartialCounts& counts = whole.counts;
  py::dict result;
  result["points"] = counts.points;
  result["duplicates"] = counts.duplicates;
  result["isolated"] = counts.isolated;
  result["vertices"] = counts.vertices;
  result["edges"] = counts.edges;
  result["triangles"] = counts.triangles;
  result["solid_components"] = counts.solid_components;
  result["components"] = counts.components;
  result["holes"] = counts.holes();
  result["boundary_curves"] = counts.boundary_curves;
  return {result, as_arrays(whole.polygons)};
}

}  // namespace

void bind_partial(py::module_& module) {
  using py::arg;
  module.def("halo", &halo_of, arg("region"), arg("alpha"));
  module.def("partial", &partial_of, as_is("points"), as_is("indices"), arg("region"), arg("alpha"), arg("threads"));
  module.def("merge_partials", &merge_of, arg("a"), arg("b"));
  module.def("finish_partial", &finish_of, arg("partial"));
}

}  // namespace rbpa::python
