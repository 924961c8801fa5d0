#include "rbpa/space/solid/solid_locator.h"

#include <utility>

#include "python/arrays.h"
#include "python/module.h"
#include "python/watched.h"

namespace rbpa::python {
namespace {

/// A SolidLocator that keeps its arrays alive.
class ArraySolidLocator {
 public:
  ArraySolidLocator(Doubles points, Indices simplices, Indices neighbors)
      : points_(std::move(points)),
        simplices_(std::move(simplices)),
        neighbors_(std::move(neighbors)),
        locator_(points3_of(points_, "points"), quadruples_of(simplices_, "simplices"),
                 quadruples_of(neighbors_, "neighbors")) {}

  Indices find(const Doubles& queries) const {
    const auto input = points3_of(queries, "queries");
    return line<std::int32_t>(watched(input.size(), py::none(), [&](Watch& watch) {
      return locator_.find(input, {.go_on = watch.until_stopped()});
    }));
  }

 private:
  Doubles points_;
  Indices simplices_, neighbors_;
  SolidLocator locator_;
};

}  // namespace

void bind_solid_locator(py::module_& module) {
  py::class_<ArraySolidLocator>(module, "SolidLocator")
      .def(py::init<Doubles, Indices, Indices>(), as_is("points"), as_is("simplices"), as_is("neighbors"))
      .def("find", &ArraySolidLocator::find, as_is("queries"));
}

}  // namespace rbpa::python
