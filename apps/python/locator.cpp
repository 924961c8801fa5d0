#include <utility>

#include "python/module.h"
#include "rbpa/plane/locate.h"
#include "rbpa/space/solid/solid_locator.h"

namespace rbpa::python {
namespace {

/// A Locator, and the arrays that it views.
class ArrayLocator {
 public:
  ArrayLocator(Doubles points, Indices simplices, Indices neighbors, bool is_constrained)
      : points_(std::move(points)),
        simplices_(std::move(simplices)),
        neighbors_(std::move(neighbors)),
        locator_(make(is_constrained)) {}

  Indices find(const Doubles& queries) const {
    const auto input = points_of(queries);
    return line<std::int32_t>(watched(input.size(), py::none(), [&](Watch& watch) {
      return locator_.find(input, {.go_on = watch.until_stopped()});
    }));
  }

  /// Returns interpolated values, as an array of shape (number of queries, k). `values` has shape (n, k), with a row
  /// for each point.
  Doubles interpolate(const Doubles& values, const Doubles& queries, bool by_natural_neighbors) const {
    require_shape(values.ndim() == 2, values, "values", "(n, k)");
    const auto input = points_of(queries);
    const auto columns = static_cast<std::size_t>(values.shape(1));
    const std::span<const double> rows_of_points(values.data(), static_cast<std::size_t>(values.size()));
    std::vector<double> found = watched(input.size(), py::none(), [&](Watch& watch) {
      const auto method = by_natural_neighbors ? Interpolation::natural_neighbor : Interpolation::linear;
      return locator_.interpolate(rows_of_points, columns, input, {.method = method, .go_on = watch.until_stopped()});
    });
    return array_of<double>(std::move(found), 0);
  }

 private:
  Locator make(bool is_constrained) const {
    const auto input = points_of(points_);
    TriangleArrays triangles = triangle_arrays_of(simplices_, neighbors_);
    triangles.is_constrained = is_constrained;
    return watched(input.size(), py::none(),
                   [&](Watch& watch) { return Locator(input, triangles, {.go_on = watch.until_stopped()}); });
  }

  Doubles points_;
  Indices simplices_, neighbors_;
  Locator locator_;
};

/// A SolidLocator, and the arrays that it views.
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

void bind_locators(py::module_& module) {
  using py::arg;
  py::class_<ArrayLocator>(module, "Locator")
      .def(py::init<Doubles, Indices, Indices, bool>(), as_is("points"), as_is("simplices"), as_is("neighbors"),
           arg("is_constrained"))
      .def("find", &ArrayLocator::find, as_is("queries"))
      .def("interpolate", &ArrayLocator::interpolate, as_is("values"), as_is("queries"), arg("by_natural_neighbors"));
  py::class_<ArraySolidLocator>(module, "SolidLocator")
      .def(py::init<Doubles, Indices, Indices>(), as_is("points"), as_is("simplices"), as_is("neighbors"))
      .def("find", &ArraySolidLocator::find, as_is("queries"));
}

}  // namespace rbpa::python
