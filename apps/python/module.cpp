// What: the extension module rbpa._core: private functions and classes that work on arrays.
#include "python/module.h"

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"

namespace {

namespace py = pybind11;

/// Registers the exceptions of the library.
void bind_errors(py::module_& module) {
  const auto describe = [&](const char* name, const char* what) {
    module.attr(name).attr("__module__") = "rbpa";
    module.attr(name).attr("__doc__") = what;
  };
  py::register_exception<rbpa::InvalidInput>(module, "InvalidInput", PyExc_ValueError);
  py::register_exception<meshops::ContractViolation>(module, "ContractViolation", PyExc_ValueError);
  py::register_exception<rbpa::Cancelled>(module, "Cancelled", PyExc_RuntimeError);
  describe("InvalidInput", "Raised for invalid data or parameters, before anything is computed.");
  describe("ContractViolation", "Raised if a requirement of the function is not met, before anything is changed.");
  describe("Cancelled", "Raised if the progress function asked to stop.");
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of rbpa.";
  module.attr("version") = RBPA_VERSION;
  bind_errors(module);
  // Bind classes before functions that have them in their signatures, so that signatures show the Python types.
  using namespace rbpa::python;
  for (Bind* bind : {bind_alpha_choice,   bind_triangulation,    bind_polygons, bind_points,         bind_filtration,
                     bind_groups,         bind_locators,         bind_nearest,  bind_partial,        bind_soups,
                     bind_mesh,           bind_space_points,     bind_surface,  bind_surface_causes, bind_solid,
                     bind_periodic_solid, bind_solid_filtration, bind_balls,    bind_discs,          bind_molecules,
                     bind_heights,        bind_voronoi})
    bind(module);
}
