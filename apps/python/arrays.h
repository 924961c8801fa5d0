// What: passes NumPy arrays to the library as spans, and vectors of the library to Python as NumPy arrays, without
//       copies.
// Law:  an array for Python owns the vector that it views, alone or with other arrays; only an array that owns a vector
//       alone is writable.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa::python {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::int32_t, py::array::c_style>;
using Begins = py::array_t<std::int64_t, py::array::c_style>;
/// Returns the declaration of an argument without conversion: an array must have exactly the type of the parameter.
inline py::arg as_is(const char* name) { return py::arg(name).noconvert(); }

using Triple = std::array<std::uint32_t, 3>;

/// Throws ValueError that names the shape of `array` and the expected shape, unless `is_so`. Makes no call to Python,
/// so that threads without Python's lock may call this function.
inline void require_shape(bool is_so, const py::array& array, const std::string& name, const std::string& expected) {
  if (is_so) return;
  std::string found;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) found += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  if (array.ndim() == 1) found += ",";
  throw py::value_error(name + ": found an array of shape (" + found + "), expected " + expected);
}
inline void require_rows(const py::array& array, const std::string& name, int columns) {
  require_shape(array.ndim() == 2 && array.shape(1) == columns, array, name, "(n, " + std::to_string(columns) + ")");
}

/// Views a contiguous float64 array of shape (n, 2) as points. The array must outlive the span.
inline std::span<const Point> points_of(const Doubles& array) {
  require_rows(array, "points", 2);
  static_assert(sizeof(Point) == 2 * sizeof(double));
  return {reinterpret_cast<const Point*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

/// Views a contiguous float64 array of shape (n, 3) as points or vectors in space; messages call the array `name`. The
/// array must outlive the span.
inline std::span<const Point3> points3_of(const Doubles& array, const char* name) {
  require_rows(array, name, 3);
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  return {reinterpret_cast<const Point3*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

using MaybeDoubles = std::optional<Doubles>;
/// Views an optional array as the other points3_of() does; returns an empty span if there is no array.
inline std::span<const Point3> points3_of(const MaybeDoubles& array, const char* name) {
  return array ? points3_of(*array, name) : std::span<const Point3>();
}

inline std::span<const Triple> triples_of(const Indices& array, const char* name) {
  require_rows(array, name, 3);
  return {reinterpret_cast<const Triple*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

/// Views a contiguous float64 array as a list of numbers. The array must outlive the span.
inline std::span<const double> line_of(const Doubles& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

using Quadruple = std::array<std::uint32_t, 4>;
inline std::span<const Quadruple> quadruples_of(const Indices& array, const char* name) {
  require_rows(array, name, 4);
  return {reinterpret_cast<const Quadruple*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

/// Views arrays of shape (m, 3) as triangles and neighbors. Both arrays must outlive the view. −1, SciPy's sign for no
/// neighbor, has the bits of TriangleArrays::none.
inline TriangleArrays triangle_arrays_of(const Indices& simplices, const Indices& neighbors) {
  static_assert(static_cast<std::uint32_t>(-1) == TriangleArrays::none);
  return {triples_of(simplices, "simplices"), triples_of(neighbors, "neighbors")};
}

/// A value that arrays view. Python frees the value with the last of these arrays.
template <typename Value>
class Kept {
 public:
  explicit Kept(Value value)
      : value_(new Value(std::move(value))), owner_(value_, [](void* p) { delete static_cast<Value*>(p); }) {}

  const Value& operator*() const { return *value_; }
  const Value* operator->() const { return value_; }

  /// Returns an array that views the numbers from `first` on, with shape `shape` and `strides` in bytes. The array is
  /// read-only unless `is_alone`: no other array views the numbers.
  template <typename Number>
  py::array view(const void* first, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                 bool is_alone = false) const {
    py::array array(py::dtype::of<Number>(), std::move(shape), std::move(strides), first, owner_);
    if (!is_alone) array.attr("setflags")(py::arg("write") = false);
    return array;
  }

 private:
  Value* value_;
  py::capsule owner_;
};

/// Returns the numbers of `items` as an array of shape (n, columns), or (n,) if `columns` is 0.
template <typename Number, typename Item>
py::array_t<Number, py::array::c_style> array_of(std::vector<Item> items, std::size_t columns) {
  const Kept kept(std::move(items));
  std::vector<py::ssize_t> shape = {py::ssize_t(kept->size())}, strides = {py::ssize_t(sizeof(Item))};
  if (columns > 0) {
    shape.push_back(py::ssize_t(columns));
    strides.push_back(py::ssize_t(sizeof(Number)));
  }
  py::array array = kept.template view<Number>(kept->data(), std::move(shape), std::move(strides), true);
  return py::reinterpret_steal<py::array_t<Number, py::array::c_style>>(array.release());
}

/// Returns `items` as a two-dimensional array; each item is a row.
template <typename Number, typename Item>
auto rows(std::vector<Item> items) {
  return array_of<Number>(std::move(items), sizeof(Item) / sizeof(Number));
}

/// Returns a list of numbers as a one-dimensional array.
template <typename Number, typename Item>
auto line(std::vector<Item> items) {
  static_assert(sizeof(Number) == sizeof(Item));
  return array_of<Number>(std::move(items), 0);
}

/// Returns an array with a number or a row for each item: the value of `member`, a data member or a function, for it.
template <typename Number, typename Item, typename Member>
auto column(const std::vector<Item>& items, Member member) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Member, const Item&>>;
  static_assert(sizeof(Value) % sizeof(Number) == 0);
  std::vector<Value> values;
  values.reserve(items.size());
  for (const Item& item : items) values.push_back(std::invoke(member, item));
  return array_of<Number>(std::move(values), std::is_class_v<Value> ? sizeof(Value) / sizeof(Number) : 0);
}

/// Returns the array that column() returns for a data member, as a read-only view of `items`, without a copy.
template <typename Number, typename Item, typename Member>
py::array view_column(const Kept<std::vector<Item>>& items, Member Item::*member) {
  static_assert(sizeof(Member) % sizeof(Number) == 0);
  std::vector<py::ssize_t> shape = {py::ssize_t(items->size())}, strides = {py::ssize_t(sizeof(Item))};
  if (std::is_class_v<Member>) {
    shape.push_back(py::ssize_t(sizeof(Member) / sizeof(Number)));
    strides.push_back(py::ssize_t(sizeof(Number)));
  }
  const void* first = items->empty() ? nullptr : &(items->front().*member);
  return items.template view<Number>(first, std::move(shape), std::move(strides));
}

}  // namespace rbpa::python
