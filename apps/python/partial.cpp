#include "rbpa/partial.h"

#include <pybind11/pybind11.h>

#include <cstring>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "python/arrays.h"
#include "python/module.h"
#include "python/watched.h"
#include "rbpa/base/error.h"
#include "rbpa/partial_bytes.h"

namespace rbpa::python {
namespace {

using LongIndices = py::array_t<std::uint64_t, py::array::c_style>;

Region region_of(const py::tuple& bounds) {
  if (bounds.size() != 4) throw py::value_error("region: expected (x0, y0, x1, y1)");
  return {bounds[0].cast<double>(), bounds[1].cast<double>(), bounds[2].cast<double>(), bounds[3].cast<double>()};
}

py::tuple halo_of(const py::tuple& bounds, double alpha) {
  const Region halo = rbpa::halo(region_of(bounds), alpha);
  return py::make_tuple(halo.x0, halo.y0, halo.x1, halo.y1);
}

py::bytes as_bytes(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The bytes must outlive the span.
std::span<const std::uint8_t> span_of(const py::bytes& bytes) {
  const auto text = static_cast<std::string_view>(bytes);
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// All rings one after the other, the shell of each polygon before its holes; where rings begin, and which ring is the
/// first of each polygon; and the ends.
struct FlatPolygons {
  std::vector<std::uint64_t> indices;
  std::vector<Point> coordinates;
  std::vector<std::int64_t> ring_begin = {0}, polygon_begin = {0};
  std::vector<double> areas, perimeters;
  std::vector<std::uint64_t> points;

  void add(const CornerRing& ring) {
    for (const Corner& corner : ring) {
      indices.push_back(corner.index);
      coordinates.push_back(corner.at);
    }
    ring_begin.push_back(static_cast<std::int64_t>(indices.size()));
  }
  void add(const CornerPolygon& polygon) {
    add(polygon.shell);
    for (const CornerRing& hole : polygon.holes) add(hole);
    polygon_begin.push_back(static_cast<std::int64_t>(ring_begin.size()) - 1);
    areas.push_back(polygon.area);
    perimeters.push_back(polygon.perimeter);
    points.push_back(polygon.points);
  }
};

py::dict as_arrays(std::span<const CornerPolygon> polygons) {
  FlatPolygons flat;
  for (const CornerPolygon& polygon : polygons) flat.add(polygon);
  py::dict result;
  result["indices"] = line<std::int64_t>(std::move(flat.indices));
  result["coordinates"] = rows<double>(std::move(flat.coordinates));
  result["ring_begin"] = line<std::int64_t>(std::move(flat.ring_begin));
  result["polygon_begin"] = line<std::int64_t>(std::move(flat.polygon_begin));
  result["areas"] = line<double>(std::move(flat.areas));
  result["perimeters"] = line<double>(std::move(flat.perimeters));
  result["points"] = line<std::int64_t>(std::move(flat.points));
  return result;
}

/// What there is of some regions: the bytes of what is open, and the polygons that are finished.
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

py::tuple as_tuple(const Settled& settled) {
  return py::make_tuple(as_bytes(settled.open), as_arrays(settled.polygons));
}

py::tuple partial_of(const Doubles& points, const LongIndices& indices, const py::tuple& bounds, double alpha,
                     unsigned threads) {
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
  const py::tuple settled = as_tuple(made.settled);
  return py::make_tuple(settled[0], settled[1], rows<std::int64_t>(std::move(made.owned.triangles)),
                        line<std::int64_t>(std::move(made.owned.isolated)));
}

py::tuple merge_of(const py::bytes& a, const py::bytes& b) {
  const auto first = span_of(a), second = span_of(b);
  const Settled settled = watched(first.size() + second.size(), py::none(), [&](Watch&) {
    return settle(merge(partial_from_bytes(first), partial_from_bytes(second)));
  });
  return as_tuple(settled);
}

py::tuple finish_of(const py::bytes& bytes) {
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
  return py::make_tuple(result, as_arrays(whole.polygons));
}

}  // namespace

void bind_partial(py::module_& module) {
  using py::arg;
  module.def("halo", &halo_of, arg("region"), arg("alpha"));
  module.def("partial", &partial_of, arg("points").noconvert(), arg("indices").noconvert(), arg("region"), arg("alpha"),
             arg("threads"));
  module.def("merge_partials", &merge_of, arg("a"), arg("b"));
  module.def("finish_partial", &finish_of, arg("partial"));
}

}  // namespace rbpa::python
