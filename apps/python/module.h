// What: declares the functions that bind the parts of the extension module: bind_NAME() is in NAME.cpp.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "python/arrays.h"
#include "python/watched.h"

namespace rbpa::python {

using Bind = void(py::module_& module);
Bind bind_alpha_choice, bind_balls, bind_discs, bind_filtration, bind_groups, bind_heights, bind_locators, bind_mesh,
    bind_molecules, bind_nearest, bind_partial, bind_periodic_solid, bind_points, bind_polygons, bind_solid,
    bind_solid_filtration, bind_soups, bind_space_points, bind_surface, bind_surface_causes, bind_triangulation,
    bind_voronoi;

}  // namespace rbpa::python
