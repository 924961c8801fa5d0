#include <span>
#include <vector>

#include "python/module.h"
#include "rbpa/space/balls/measure_ball_frames.h"
#include "rbpa/space/balls/regular_triangulation.h"

namespace rbpa::python {
namespace {

/// Returns the member of all frames, one frame after another.
template <typename Item>
std::vector<Item> joined(const std::vector<BallMeasures>& frames, std::vector<Item> BallMeasures::*member) {
  std::vector<Item> all;
  for (const BallMeasures& frame : frames) all.insert(all.end(), (frame.*member).begin(), (frame.*member).end());
  return all;
}

/// Measures the balls of each frame: `centers` has shape (frames, n, 3), `radii` (frames, n), or (1, n) for all. Arrays
/// of the result with a row for each ball have those of one frame after another.
py::dict measured(const Doubles& centers, const Doubles& radii, double probe, bool contacts, bool derivatives,
                  unsigned threads, const py::object& progress) {
  require_shape(centers.ndim() == 3 && centers.shape(2) == 3, centers, "centers", "(frames, n, 3)");
  require_shape(radii.ndim() == 2 && radii.shape(1) == centers.shape(1) &&
                    (radii.shape(0) == 1 || radii.shape(0) == centers.shape(0)),
                radii, "radii", "(frames, n) or (1, n)");
  const auto count = static_cast<std::size_t>(centers.shape(1));
  const std::span<const Point3> all(reinterpret_cast<const Point3*>(centers.data()),
                                    static_cast<std::size_t>(centers.size()) / 3);
  const std::span<const double> all_radii = line_of(radii);
  std::vector<BallFrame> frames;
  for (std::size_t f = 0; f < static_cast<std::size_t>(centers.shape(0)); ++f)
    frames.push_back({all.subspan(f * count, count), all_radii.subspan(radii.shape(0) == 1 ? 0 : f * count, count)});
  std::vector<BallMeasures> made = watched(all.size(), progress, [&](Watch& watch) {
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
  result["volume_gradient"] = rows<double>(joined(made, &BallMeasures::volume_gradient));
  result["area_gradient"] = rows<double>(joined(made, &BallMeasures::area_gradient));
  py::list hidden, all_contacts;
  for (BallMeasures& frame : made) {
    hidden.append(line<std::int32_t>(std::move(frame.hidden)));
    all_contacts.append(py::make_tuple(
        column<std::int32_t>(frame.contacts, &BallContact::balls), column<double>(frame.contacts, &BallContact::area),
        column<double>(frame.contacts, &BallContact::arc), column<double>(frame.contacts, &BallContact::distance)));
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

}  // namespace

void bind_balls(py::module_& module) {
  using py::arg;
  module.def("measure_balls", &measured, as_is("centers"), as_is("radii"), arg("probe"), arg("contacts"),
             arg("derivatives"), arg("threads"), arg("progress"));
  module.def("regular_triangulation", &tetrahedra_of, as_is("centers"), as_is("radii"));
}

}  // namespace rbpa::python
