// What: the parts of the extension module; bind_NAME() is in NAME.cpp.
#pragma once

#include <pybind11/pybind11.h>

namespace rbpa::python {

void bind_alpha_choice(pybind11::module_& module);
void bind_triangulation(pybind11::module_& module);
void bind_polygons(pybind11::module_& module);
void bind_filtration(pybind11::module_& module);
void bind_groups(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_soups(pybind11::module_& module);
void bind_locators(pybind11::module_& module);
void bind_space_points(pybind11::module_& module);
void bind_surface(pybind11::module_& module);
void bind_surface_causes(pybind11::module_& module);
void bind_solid(pybind11::module_& module);
void bind_periodic_solid(pybind11::module_& module);
void bind_solid_filtration(pybind11::module_& module);
void bind_nearest(pybind11::module_& module);
void bind_partial(pybind11::module_& module);
void bind_points(pybind11::module_& module);

}  // namespace rbpa::python
