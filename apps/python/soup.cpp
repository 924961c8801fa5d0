#include "python/soup.h"

#include <tuple>

#include "meshops/topology/examine.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "python/module.h"

namespace rbpa::python {

meshops::PolygonSoup soup_of(const Indices& corners, const Begins& begin, std::size_t points) {
  meshops::PolygonSoup soup;
  soup.points = points;
  const auto* first = reinterpret_cast<const std::uint32_t*>(corners.data());
  soup.corners.assign(first, first + corners.size());
  soup.begin.clear();
  for (py::ssize_t i = 0; i < begin.size(); ++i) soup.begin.push_back(static_cast<std::size_t>(begin.data()[i]));
  meshops::require_parted(soup);
  return soup;
}

namespace {

std::tuple<Indices, Begins, Indices, Begins, std::vector<meshops::RepairStep>> repaired(const Indices& corners,
                                                                                        const Begins& begin,
                                                                                        std::size_t points) {
  const meshops::PolygonSoup soup = soup_of(corners, begin, points);
  meshops::Repair made =
      watched(soup.faces(), py::none(), [&](Watch& watch) { return meshops::repair(soup, watch.until_stopped()); });
  std::vector<std::int64_t> begins(made.soup.begin.begin(), made.soup.begin.end());
  std::vector<std::int64_t> face_was(made.face_was.begin(), made.face_was.end());
  return {line<std::int32_t>(std::move(made.soup.corners)), line<std::int64_t>(std::move(begins)),
          line<std::int32_t>(std::move(made.stands_on)), line<std::int64_t>(std::move(face_was)),
          std::move(made.steps)};
}

std::vector<meshops::SoupDefect> defects(const Indices& corners, const Begins& begin, std::size_t points) {
  const meshops::PolygonSoup soup = soup_of(corners, begin, points);
  return watched(soup.faces(), py::none(),
                 [&](Watch& watch) { return meshops::find_defects(soup, watch.until_stopped()); });
}

meshops::TopologyReport report_of(const Indices& corners, const Begins& begin, std::size_t points) {
  const meshops::PolygonSoup soup = soup_of(corners, begin, points);
  return watched(soup.faces(), py::none(), [&](Watch& watch) { return meshops::report(soup, watch.until_stopped()); });
}

/// Binds the members that defects and steps of a repair have in common.
template <typename Item>
void bind_item(py::module_& module, const char* class_name, const char* what) {
  py::class_<Item>(module, class_name, what)
      .def_property_readonly("kind", [](const Item& item) { return std::string(name(item.kind)); })
      .def_readonly("points", &Item::points)
      .def_readonly("faces", &Item::faces)
      .def("__eq__", [](const Item& a, const Item& b) { return a == b; })
      .def("__repr__",
           [class_name](const Item& item) {
             return "<rbpa.meshops." + std::string(class_name) + ": " + describe(item) + ">";
           })
      .def("__str__", [](const Item& item) { return describe(item); })
      .attr("__module__") = "rbpa.meshops";
}

void bind_reports(py::module_& module) {
  using meshops::ComponentReport;
  using meshops::TopologyReport;
  const auto betti = [](const meshops::BettiNumbers& b) { return std::make_tuple(b[0], b[1], b[2]); };
  py::class_<ComponentReport>(module, "ComponentReport", "A component of faces connected through edges.")
      .def_readonly("vertices", &ComponentReport::vertices)
      .def_readonly("edges", &ComponentReport::edges)
      .def_readonly("faces", &ComponentReport::faces)
      .def_readonly("boundary_curves", &ComponentReport::boundary_curves)
      .def_readonly("orientable", &ComponentReport::orientable)
      .def_readonly("first_face", &ComponentReport::first_face)
      .def_property_readonly("euler", &ComponentReport::euler)
      .def_property_readonly("genus", &ComponentReport::genus)
      .def_property_readonly("betti", [betti](const ComponentReport& r) { return betti(r.betti()); })
      .attr("__module__") = "rbpa.meshops";
  py::class_<TopologyReport>(
      module, "Report",
      "The topology of a mesh or of any faces, in total and per component. `genus` is None if a\n"
      "component is not orientable, or cut at a non-manifold edge; `betti` are the numbers of\n"
      "components, loops and cavities, over Z/2.")
      .def_readonly("vertices", &TopologyReport::vertices)
      .def_readonly("edges", &TopologyReport::edges)
      .def_readonly("faces", &TopologyReport::faces)
      .def_readonly("components", &TopologyReport::components)
      .def_readonly("solid_components", &TopologyReport::solid_components)
      .def_readonly("boundary_curves", &TopologyReport::boundary_curves)
      .def_readonly("genus", &TopologyReport::genus)
      .def_property_readonly("betti", [betti](const TopologyReport& r) { return betti(r.betti); })
      .def_readonly("pinches", &TopologyReport::pinches)
      .def_readonly("isolated", &TopologyReport::isolated)
      .def_readonly("per_component", &TopologyReport::per_component)
      .def_property_readonly("euler", &TopologyReport::euler)
      .def("__repr__",
           [](const TopologyReport& r) {
             return "<rbpa.meshops.Report: " + std::to_string(r.vertices) + " vertices, " + std::to_string(r.edges) +
                    " edges, " + std::to_string(r.faces) + " faces, betti (" + std::to_string(r.betti[0]) + ", " +
                    std::to_string(r.betti[1]) + ", " + std::to_string(r.betti[2]) + ")>";
           })
      .attr("__module__") = "rbpa.meshops";
}

}  // namespace

void bind_soups(py::module_& module) {
  using py::arg;
  bind_item<meshops::SoupDefect>(module, "Defect",
                                 "A defect that keeps faces from being an oriented 2-manifold with boundary.");
  bind_item<meshops::RepairStep>(module, "RepairStep", "A change of faces to make a manifold of them.");
  bind_reports(module);
  module.def("repair", &repaired, arg("corners"), arg("begin"), arg("points"));
  module.def("find_defects", &defects, arg("corners"), arg("begin"), arg("points"));
  module.def("report", &report_of, arg("corners"), arg("begin"), arg("points"));
}

}  // namespace rbpa::python
