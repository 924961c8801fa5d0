// What: a hook that sets chosen properties of the new vertex of a split, or of the survivor of a collapse, to a mean.
// Law:  the mean is that of both ends in split_edge() and collapse(), and of the three corners in split_face();
//       split_vertex() copies the value of the old vertex.
#pragma once

#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/stellar/split_hooks.h"

namespace meshops {

namespace detail {

template <typename T>
concept MeanNumber = std::floating_point<T> ||(std::integral<T> && !std::same_as<T, bool>);

/// Vector type of OpenMesh, whose size() is the number of coordinates.
template <typename T>
concept MeanVector = requires(T v, const T c) {
  requires MeanNumber<typename T::value_type>;
  { T::size() } -> std::convertible_to<std::size_t>;
  v[0] = c[0];
};

template <MeanNumber T>
T mean(std::span<const T> values) {
  const std::size_t n = values.size();
  if constexpr (std::floating_point<T>) {
    // Divides before it adds, because the sum may overflow.
    T sum = 0;
    for (const T value : values) sum += n == 2 ? value * T(0.5) : value * (T(1) / T(n));
    return sum;
  } else {
    static_assert(std::numeric_limits<T>::digits <= 32,
                  "the sum of large integers may not be exact: interpolate doubles");
    double sum = 0;
    for (const T value : values) sum += static_cast<double>(value);
    return static_cast<T>(std::llround(sum / static_cast<double>(n)));
  }
}

template <MeanVector T>
T mean(std::span<const T> values) {
  T result = values[0];
  typename T::value_type at[3];
  for (std::size_t i = 0; i < static_cast<std::size_t>(T::size()); ++i) {
    for (std::size_t k = 0; k < values.size(); ++k) at[k] = values[k][i];
    result[i] = mean(std::span<const typename T::value_type>(at, values.size()));
  }
  return result;
}

template <typename Value>
OpenMesh::VPropHandleT<Value> handle_of(OpenMesh::VPropHandleT<Value> handle) {
  return handle;
}
template <typename Manager>
OpenMesh::VPropHandleT<typename Manager::Value> handle_of(const Manager& manager) requires requires {
  { manager.getRawProperty() } -> std::convertible_to<OpenMesh::VPropHandleT<typename Manager::Value>>;
}
{ return manager.getRawProperty(); }

/// Vertex property, given by its handle or by its property manager.
template <typename P>
concept VertexProperty = requires(const P& property) {
  detail::handle_of(property);
};

template <VertexProperty P>
using ValueOf = typename decltype(detail::handle_of(std::declval<const P&>()))::Value;

/// Returns whether the mesh has a vertex property with this number and type.
template <typename Mesh, typename Value>
bool has_property(Mesh& mesh, OpenMesh::VPropHandleT<Value> property) {
  const auto count = std::distance(mesh.vprops_begin(), mesh.vprops_end());
  return property.idx() >= 0 && property.idx() < count &&
         dynamic_cast<const OpenMesh::PropertyT<Value>*>(*(mesh.vprops_begin() + property.idx())) != nullptr;
}

}  // namespace detail

/// Type with a mean: a number other than bool, or a vector of OpenMesh with numbers as coordinates. Integers of more
/// than 32 bits do not compile.
template <typename T>
concept HasMean = detail::MeanNumber<T> || detail::MeanVector<T>;

/// Split hook for calls such as split_edge(mesh, h, Interpolate(weight, mesh.vertex_texcoords2D_pph(),
/// mesh.vertex_colors_pph())). In a split, the hook first does what CarryOver does; in a collapse, it first places the
/// survivor of a mesh with points (PlaceVertex). Then the hook sets each named vertex property of the new or surviving
/// vertex to the mean. A property is named by an OpenMesh::VPropHandleT or by a vertex PropertyManager.
/// The mean of integers is rounded to the nearest integer, halves away from 0. Vectors are not normalized: compute
/// normals anew. Vertex properties that are not named get default values in split_edge() and split_face(), as without
/// the hook; the survivor of a collapse keeps their values. Every mean is that of the values before the operator: a
/// property may be named twice, and the points may be named.
/// Requires: the properties belong to the mesh. Checked: the mesh has vertex properties of their numbers and types.
/// Throws:   ContractViolation in the call of the operator; the mesh is then unchanged.
template <HasMean... Values>
class Interpolate {
 public:
  template <detail::VertexProperty... Properties>
  requires(sizeof...(Properties) > 0) explicit Interpolate(const Properties&... properties)
      : properties_(detail::handle_of(properties)...) {}

  template <typename Mesh, std::derived_from<SplitEffect> Effect>
  requires std::derived_from<Mesh, Connectivity>
  void operator()(Mesh& mesh, const Effect& effect) const {
    require_properties(mesh);
    CarryOver()(mesh, effect);
    if constexpr (std::same_as<Effect, SplitEdgeEffect>) {
      const Vertex ends[] = {mesh.from_vertex_handle(effect.line), mesh.to_vertex_handle(effect.halfedge)};
      set(mesh, effect.added.vertex, means(mesh, ends));
    } else if constexpr (std::same_as<Effect, SplitFaceEffect>) {
      const Halfedge vw = effect.halfedge;
      const Halfedge vc = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(vw));
      const Halfedge vd = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(vc));
      const Vertex corners[] = {mesh.to_vertex_handle(vw), mesh.to_vertex_handle(vc), mesh.to_vertex_handle(vd)};
      set(mesh, effect.added.vertex, means(mesh, corners));
    }
  }

  template <typename Mesh>
  requires std::derived_from<Mesh, Connectivity>
  void operator()(Mesh& mesh, const WeldEffect& effect) const {
    require_properties(mesh);
    // The means are computed first, because PlaceVertex and set() overwrite values of the survivor.
    const Vertex ends[] = {effect.survivor, effect.removed.vertex};
    const auto found = means(mesh, ends);
    if constexpr (HasPoints<Mesh>) PlaceVertex()(mesh, effect);
    set(mesh, effect.survivor, found);
  }

 private:
  template <typename Mesh>
  void require_properties(Mesh& mesh) const {
    const auto check = [&](auto property) {
      require(detail::has_property(mesh, property), "Interpolate: the mesh has no vertex property ", property.idx(),
              " of the type of this handle (name properties of the mesh that is changed)");
    };
    std::apply([&](const auto&... property) { (check(property), ...); }, properties_);
  }
  template <typename Mesh>
  std::tuple<Values...> means(const Mesh& mesh, std::span<const Vertex> of) const {
    const auto mean = [&]<typename T>(OpenMesh::VPropHandleT<T> property) {
      const T values[] = {mesh.property(property, of[0]), mesh.property(property, of[1]),
                          mesh.property(property, of.back())};
      return detail::mean(std::span<const T>(values, of.size()));
    };
    return std::apply([&](const auto&... property) { return std::tuple<Values...>(mean(property)...); }, properties_);
  }
  template <typename Mesh>
  void set(Mesh& mesh, Vertex v, const std::tuple<Values...>& values) const {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      ((mesh.property(std::get<i>(properties_), v) = std::get<i>(values)), ...);
    }
    (std::index_sequence_for<Values...>());
  }

  std::tuple<OpenMesh::VPropHandleT<Values>...> properties_;
};

template <detail::VertexProperty... Properties>
requires(sizeof...(Properties) > 0) explicit Interpolate(const Properties&...)
    ->Interpolate<detail::ValueOf<Properties>...>;

}  // namespace meshops
