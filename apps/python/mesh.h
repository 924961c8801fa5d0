// What: the halfedge mesh of Python. In Python a valid handle is an int, and an invalid handle is None.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cstdint>
#include <optional>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/core/live.h"
#include "meshops/topology/polygon_soup.h"

namespace rbpa::python {

/// Connectivity without coordinates, which can mark elements of every kind as deleted.
struct MeshKernel : OpenMesh::PolyMesh_ArrayKernelT<> {
  MeshKernel() { meshops::request_status(*this); }

  /// Replaces the elements and links by those of `other`. Adds status properties to `other` first, as OpenMesh would
  /// otherwise remove those of this mesh. Requires: no element of `other` is marked as deleted.
  void take_links(OpenMesh::PolyConnectivity& other) {
    meshops::request_status(other);
    assign_connectivity(other);
  }
};

class Mesh {
 public:
  const meshops::Connectivity& seen() const { return kernel_; }
  /// Returns the connectivity, for a change. Throws ContractViolation while a Look exists, which another thread of
  /// Python, or a caller of the current function, has made.
  meshops::Connectivity& changed() {
    meshops::require(
        looking_ == 0,
        "mesh: cannot be changed while another call uses the mesh (change it when that call has returned)");
    return kernel_;
  }
  MeshKernel& kernel() { return kernel_; }

  /// A ban on changes: while a Look exists, changed() throws, so that Python's lock may be released.
  class Look {
   public:
    explicit Look(Mesh& mesh) : mesh_(mesh) { ++mesh_.looking_; }
    ~Look() { --mesh_.looking_; }
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;

   private:
    Mesh& mesh_;
  };

  std::vector<std::uint32_t> built_on;  ///< for each vertex of the first mesh, its point in the given faces

 private:
  MeshKernel kernel_;
  int looking_ = 0;
};

/// Returns the handle; nothing, which is None in Python, if the handle is invalid.
template <typename Handle>
std::optional<Handle> maybe(Handle handle) {
  return handle.is_valid() ? std::optional<Handle>(handle) : std::nullopt;
}

void bind_mesh_operators(pybind11::module_& module, pybind11::class_<Mesh>& mesh);

}  // namespace rbpa::python

namespace pybind11::detail {

template <typename Handle>
struct MeshHandleCaster {
  PYBIND11_TYPE_CASTER(Handle, const_name("int"));

  /// Converts an integer of Python or NumPy. Returns false for a bool, and for numbers that are no integers.
  bool load(handle source, bool convert) {
    if (PyBool_Check(source.ptr())) return false;
    const auto whole = reinterpret_steal<object>(PyNumber_Index(source.ptr()));
    if (!whole) PyErr_Clear();
    make_caster<int> number;
    if (!whole || !number.load(whole, convert)) return false;
    value = Handle(cast_op<int>(number));
    return true;
  }
  static handle cast(const Handle& source, return_value_policy, handle) {
    if (!source.is_valid()) return none().release();
    return int_(source.idx()).release();
  }
};
template <>
struct type_caster<OpenMesh::VertexHandle> : MeshHandleCaster<OpenMesh::VertexHandle> {};
template <>
struct type_caster<OpenMesh::HalfedgeHandle> : MeshHandleCaster<OpenMesh::HalfedgeHandle> {};
template <>
struct type_caster<OpenMesh::EdgeHandle> : MeshHandleCaster<OpenMesh::EdgeHandle> {};
template <>
struct type_caster<OpenMesh::FaceHandle> : MeshHandleCaster<OpenMesh::FaceHandle> {};

}  // namespace pybind11::detail
