// What: the extension module rbpa._core: private functions of arrays.
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
  rbpa::python::bind_alpha_choice(module);  // before functions of a choice, so that signatures show the Python type
  rbpa::python::bind_triangulation(module);
  rbpa::python::bind_polygons(module);
  rbpa::python::bind_points(module);
  rbpa::python::bind_filtration(module);
  rbpa::python::bind_groups(module);
  rbpa::python::bind_locators(module);
  rbpa::python::bind_nearest(module);
  rbpa::python::bind_partial(module);
  rbpa::python::bind_soups(module);  // before functions that return soups, so that signatures show the Python types
  rbpa::python::bind_mesh(module);
  rbpa::python::bind_space_points(module);
  rbpa::python::bind_surface(module);
  rbpa::python::bind_surface_causes(module);
  rbpa::python::bind_solid(module);
  rbpa::python::bind_periodic_solid(module);
  rbpa::python::bind_solid_filtration(module);
}
