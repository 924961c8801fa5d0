// What:   keeps a progressive mesh, which goes to any number of triangles between a decimated mesh and the full one, in
//         both directions, and is written and read as bytes.
// Law:    the state is a function of the number of triangles, not of earlier states. The full mesh always has every
//         record and every position of the given mesh, bit by bit. A mesh that is written and read has the same
//         triangles between the same positions at each number of triangles, in the order of the given mesh.
// Cost:   about a microsecond for each collapse or split. Memory: 88 bytes for each collapse, in addition to the mesh.
//         Written bytes: 45 for each collapse, or 69 if vertices move; arrays of the triangles and positions have 48.
// Source: Hoppe, Progressive meshes (1996).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/connectivity.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/simplify/decimate_mesh.h"

namespace rbpa {

class RBPA_API ProgressiveMesh {
 public:
  /// Decimates the mesh, and records the collapses so that they can be undone.
  /// Requires: a sound mesh of triangles, without elements marked deleted; a finite place for each vertex.
  /// Throws:   what decimate() throws; ContractViolation when an element is marked deleted.
  ProgressiveMesh(meshops::Connectivity mesh, std::vector<Point3> places, const DecimationOptions& options,
                  const QuadricOptions& quadrics = {});

  /// Reads a mesh that write() wrote. The result is at its full number of triangles.
  /// Throws: InvalidInput that names what is wrong: the bytes are not of a progressive mesh or of another version, they
  ///         are too few or too many, a number is out of range or occurs twice, a coordinate is not finite, or a split
  ///         would break the mesh. Memory is in proportion to the number of bytes.
  static ProgressiveMesh read(std::span<const std::byte> bytes);
  /// Writes the coarse mesh and then the splits that lead to the full one, all numbers with the least byte first.
  /// Requires: no two edges of the mesh join the same vertices; fewer than 2^29 triangles. Throws: ContractViolation.
  /// Cost:     that of go_to() on a copy.
  std::vector<std::byte> write() const;

  std::size_t least() const { return counts_.left; }  ///< number of triangles of the coarse mesh
  std::size_t most() const { return counts_.given; }  ///< number of triangles of the full mesh
  std::size_t faces() const { return faces_; }        ///< number of triangles now
  /// The report of the decimation. A mesh that was read has only the numbers of triangles and collapses.
  const Decimation& decimation() const { return counts_; }
  /// Collapses edges, or undoes collapses, until the mesh has as many triangles as possible, but at most `faces`. If
  /// every state has more, the mesh becomes the coarse mesh.
  void go_to(std::size_t faces);

  /// The mesh and the place of each vertex; elements that are marked deleted have no meaning. A mesh that was read has
  /// other numbers of vertices and faces than the given one.
  const meshops::Connectivity& mesh() const { return mesh_; }
  const std::vector<Point3>& places() const { return places_; }
  /// Returns the triangles in the order of the given mesh, with its numbers of vertices, each from its first side on.
  std::vector<Triangle> triangles() const;
  /// Returns the position of each vertex of the given mesh, by its number. For a vertex that no triangle has at
  /// present, it is some former position.
  std::vector<Point3> positions() const;

 private:
  struct Step {
    meshops::WeldEffect effect;  // if the step was read and never done, only the halfedge is set
    Point3 other;                // place of the survivor on the other side of this step
  };
  ProgressiveMesh() = default;

  meshops::Connectivity mesh_;
  std::vector<Point3> places_;
  std::vector<Step> steps_;  // the collapses; the first done_ of them are done
  bool moves_ = false;       // whether any collapse moves its survivor
  std::size_t done_ = 0, faces_ = 0;
  Decimation counts_;
  std::vector<std::uint32_t> vertex_number_, face_number_;  // numbers in the given mesh
};

}  // namespace rbpa
