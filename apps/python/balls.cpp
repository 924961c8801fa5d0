#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "python/module.h"
#include "rbpa/space/balls/ball_interfaces.h"
#include "rbpa/space/balls/ball_voids.h"
#include "rbpa/space/balls/measure_ball_frames.h"
#include "rbpa/space/balls/periodic_voids.h"
#include "rbpa/space/balls/pore_sizes.h"
#include "rbpa/space/balls/regular_triangulation.h"

namespace rbpa::python {
namespace {

/// Returns the entries of `member` of all frames, one frame after another.
template <typename Item>
std::vector<Item> joined(const std::vector<PeriodicBallMeasures>& frames, std::vector<Item> BallMeasures::*member) {
  std::vector<Item> all;
  for (const PeriodicBallMeasures& frame : frames)
    all.insert(all.end(), (frame.*member).begin(), (frame.*member).end());
  return all;
}

/// Returns the cell of a frame: `cells` has shape (frames, 3, 3), (1, 3, 3) for all frames, or (0, 3, 3).
std::optional<RepeatingCell> cell_of(const Doubles& cells, std::size_t frame) {
  if (cells.shape(0) == 0) return std::nullopt;
  const auto* edges = reinterpret_cast<const std::array<Point3, 3>*>(cells.data());
  return RepeatingCell{edges[cells.shape(0) == 1 ? 0 : frame]};
}

/// Returns the number of points to pass to watched(): balls in a cell take long even if they are few.
std::size_t work_of(std::size_t balls, const Doubles& cells) { return cells.shape(0) > 0 ? long_work : balls; }

/// Measures the balls of each frame: `centers` has shape (frames, n, 3), and `radii` has shape (frames, n), or (1, n)
/// for all frames; `cells` are those of cell_of(). Arrays of the result that have a row for each ball contain one frame
/// after another.
py::dict measured(const Doubles& centers, const Doubles& radii, const Doubles& cells, double probe, bool contacts,
                  bool derivatives, unsigned threads, const py::object& progress) {
  require_shape(centers.ndim() == 3 && centers.shape(2) == 3, centers, "centers", "(frames, n, 3)");
  require_shape(radii.ndim() == 2 && radii.shape(1) == centers.shape(1) &&
                    (radii.shape(0) == 1 || radii.shape(0) == centers.shape(0)),
                radii, "radii", "(frames, n) or (1, n)");
  require_shape(cells.ndim() == 3 && cells.shape(1) == 3 && cells.shape(2) == 3 &&
                    (cells.shape(0) <= 1 || cells.shape(0) == centers.shape(0)),
                cells, "cells", "(frames, 3, 3), (1, 3, 3) or (0, 3, 3)");
  const auto count = static_cast<std::size_t>(centers.shape(1));
  const std::span<const Point3> all(reinterpret_cast<const Point3*>(centers.data()),
                                    static_cast<std::size_t>(centers.size()) / 3);
  const std::span<const double> all_radii = line_of(radii);
  std::vector<BallFrame> frames;
  for (std::size_t f = 0; f < static_cast<std::size_t>(centers.shape(0)); ++f)
    frames.push_back({all.subspan(f * count, count), all_radii.subspan(radii.shape(0) == 1 ? 0 : f * count, count),
                      cell_of(cells, f)});
  std::vector<PeriodicBallMeasures> made = watched(work_of(all.size(), cells), progress, [&](Watch& watch) {
    return measure_ball_frames(frames, {.probe = probe,
                                        .contacts = contacts,
                                        .derivatives = derivatives,
                                        .threads = threads,
                                        .progress = watch.progress()});
  });
  py::dict result;
  result["volume"] = column<double>(made, &BallMeasures::volume);
  result["area"] = column<double>(made, &BallMeasures::area);
  result["volumes"] = line<double>(joined(made, &BallMeasures::volumes));
  result["areas"] = line<double>(joined(made, &BallMeasures::areas));
  result["arcs"] = line<std::int32_t>(joined(made, &BallMeasures::arcs));
  result["volume_gradient"] = rows<double>(joined(made, &BallMeasures::volume_gradient));
  result["area_gradient"] = rows<double>(joined(made, &BallMeasures::area_gradient));
  py::list hidden, all_contacts;
  for (PeriodicBallMeasures& frame : made) {
    hidden.append(line<std::int32_t>(std::move(frame.hidden)));
    all_contacts.append(py::make_tuple(
        column<std::int32_t>(frame.contacts, &BallContact::balls), column<double>(frame.contacts, &BallContact::area),
        column<double>(frame.contacts, &BallContact::arc), column<double>(frame.contacts, &BallContact::distance),
        rows<std::int32_t>(std::move(frame.contact_offsets))));
  }
  result["hidden"] = std::move(hidden);
  result["contacts"] = std::move(all_contacts);
  return result;
}

Indices tetrahedra_of(const Doubles& centers, const Doubles& radii) {
  const auto input = points3_of(centers, "centers");
  return rows<std::int32_t>(watched(input.size(), py::none(), [&](Watch& watch) {
    return regular_triangulation(input, line_of(radii), {.progress = watch.progress()}).simplices;
  }));
}

py::tuple tuple_of(const Point3& p) { return py::make_tuple(p.x, p.y, p.z); }

/// Returns the arguments of rbpa.BallMouth.
py::tuple tuple_of(BallMouth&& mouth) {
  return py::make_tuple(rows<std::int32_t>(std::move(mouth.triangles)), line<std::int32_t>(std::move(mouth.balls)),
                        mouth.area, mouth.perimeter, mouth.power, tuple_of(mouth.center), mouth.radius);
}

/// Returns the arguments of rbpa.BallVoid for each void or pocket; mouths are a list of tuples.
py::list voids_of(std::vector<BallVoid>&& voids, const RegularTriangulation& regular) {
  py::list list;
  for (BallVoid& of : voids) {
    std::vector<std::array<std::uint32_t, 4>> simplices;
    for (const std::uint32_t t : of.tetrahedra) simplices.push_back(regular.simplices[t]);
    py::list mouths;
    for (BallMouth& mouth : of.mouths) mouths.append(tuple_of(std::move(mouth)));
    list.append(py::make_tuple(
        of.volume, of.area, of.volume_of_tetrahedra, of.dimension, rows<std::int32_t>(std::move(simplices)),
        column<std::int32_t>(of.balls, &LiningBall::ball), column<double>(of.balls, &LiningBall::area),
        tuple_of(of.center), of.radius, of.power, std::move(mouths)));
  }
  return list;
}

/// Returns two lists: the voids, and the pockets if `pockets`. `cells` has at most one cell.
py::list ball_voids_of(const Doubles& centers, const Doubles& radii, const Doubles& cells, bool pockets,
                       unsigned threads) {
  const auto input = points3_of(centers, "centers");
  RegularTriangulation regular;
  BallVoids made = watched(work_of(input.size(), cells), py::none(), [&](Watch& watch) {
    if (const auto cell = cell_of(cells, 0))
      return periodic_ball_voids(input, line_of(radii), *cell, {.threads = threads, .progress = watch.progress()});
    regular = regular_triangulation(input, line_of(radii), {.threads = threads, .progress = watch.progress()});
    return ball_voids(input, line_of(radii), regular,
                      {.pockets = pockets, .threads = threads, .progress = watch.progress()});
  });
  py::list both;
  both.append(voids_of(std::move(made.voids), regular));
  both.append(voids_of(std::move(made.pockets), regular));
  return both;
}

/// Returns the arguments of rbpa.PoreSizes; `cells` has one cell.
std::tuple<double, double, double, std::tuple<double, double, double>> pore_sizes_of(const Doubles& centers,
                                                                                     const Doubles& radii,
                                                                                     const Doubles& cells,
                                                                                     unsigned threads) {
  const auto input = points3_of(centers, "centers");
  const PoreSizes made = watched(work_of(input.size(), cells), py::none(), [&](Watch& watch) {
    return pore_sizes(input, line_of(radii), *cell_of(cells, 0), {.threads = threads, .progress = watch.progress()});
  });
  return {made.included, made.passing, made.on_the_way, {made.along[0], made.along[1], made.along[2]}};
}

/// Returns the members of rbpa.BallInterfaces, with numbers of groups in place of labels. `cells` is that of cell_of().
py::dict ball_interfaces_of(const Doubles& centers, const Doubles& radii, const Doubles& cells, const Indices& groups,
                            unsigned threads) {
  const auto input = points3_of(centers, "centers");
  const std::vector<std::uint32_t> numbers(groups.data(), groups.data() + groups.size());
  BallInterfaces made = watched(work_of(input.size(), cells), py::none(), [&](Watch& watch) {
    return ball_interfaces({input, line_of(radii), cell_of(cells, 0)}, numbers,
                           {.threads = threads, .progress = watch.progress()});
  });
  py::dict result;
  result["groups"] = column<std::int32_t>(made.all, &BallInterface::groups);
  result["areas"] = column<double>(made.all, &BallInterface::areas);
  result["contact_areas"] = column<double>(made.all, &BallInterface::contact_area);
  result["areas_alone"] = line<double>(std::move(made.areas_alone));
  return result;
}

}  // namespace

void bind_balls(py::module_& module) {
  using py::arg;
  module.def("measure_balls", &measured, as_is("centers"), as_is("radii"), as_is("cells"), arg("probe"),
             arg("contacts"), arg("derivatives"), arg("threads"), arg("progress"));
  module.def("regular_triangulation", &tetrahedra_of, as_is("centers"), as_is("radii"));
  module.def("ball_voids", &ball_voids_of, as_is("centers"), as_is("radii"), as_is("cells"), arg("pockets"),
             arg("threads"));
  module.def("pore_sizes", &pore_sizes_of, as_is("centers"), as_is("radii"), as_is("cells"), arg("threads"));
  module.def("ball_interfaces", &ball_interfaces_of, as_is("centers"), as_is("radii"), as_is("cells"), as_is("groups"),
             arg("threads"));
}

}  // namespace rbpa::python
