// What:   a progressive mesh: goes to any number of triangles between a decimated mesh and the full one, in both
//         directions, and is written and read as bytes.
// Law:    the state is a function of the number of triangles, not of the way there. Whatever the way, the full mesh has
//         every record and every position of the given one, bit by bit. A mesh that is written and read has the same
//         triangles between the same positions at each number of triangles, in the order of the given mesh.
// Cost:   about a microsecond for each collapse or split. Memory of 88 bytes for each collapse, beside the mesh; in
//         bytes that are written 45, or 69 if vertices move, where arrays of the triangles and positions have 48.
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
  /// Decimates the mesh, and keeps the way back.
  /// Requires: a sound mesh of triangles, without elements marked deleted; a finite place for each vertex.
  /// Throws:   as decimate(); ContractViolation when an element is marked deleted.
  ProgressiveMesh(meshops::Connectivity mesh, std::vector<Point3> places, const DecimationOptions& options,
                  const QuadricOptions& quadrics = {});

  /// Reads a mesh that write() has written; it is then the full mesh.
  /// Throws: InvalidInput that names what is wrong: the bytes are not of a progressive mesh or of another version, they
  ///         are too few or too many, a number is out of range or occurs twice, a coordinate is not finite, or a split
  ///         would break the mesh. Memory is in proportion to the bytes that are given.
  static ProgressiveMesh read(std::span<const std::byte> bytes);
  /// Writes the coarse mesh and then the splits that lead to the full one, all numbers with the least byte first.
  /// Requires: no two edges of the mesh join the same vertices; fewer than 2^29 triangles. Throws ContractViolation.
  /// Cost:     that of go_to() on a copy.
  std::vector<std::byte> write() const;

  std::size_t least() const { return least_; }  ///< number of triangles of the coarse mesh
  std::size_t most() const { return most_; }    ///< number of triangles of the full mesh
  std::size_t faces() const { return faces_; }  ///< number of triangles now
  /// Collapses edges, or undoes collapses, until the mesh is the one of the most triangles, but at most `faces`; the
  /// coarse mesh if all have more.
  void go_to(std::size_t faces);

  /// The mesh and the place of each vertex, as far as they are not marked deleted. Of a mesh that was read, other
  /// numbers than in the given one.
  const meshops::Connectivity& mesh() const { return mesh_; }
  const std::vector<Point3>& places() const { return places_; }
  /// Returns the triangles in the order of the given mesh, as its numbers of vertices, each from its first side on.
  std::vector<Triangle> triangles() const;
  /// Returns the position of each vertex of the given mesh, by its number; some former one for a vertex that no
  /// triangle has now.
  std::vector<Point3> positions() const;

 private:
  struct Step {
    meshops::WeldEffect effect;  // of a step that was read and never done, only the halfedge
    Point3 other;                // place of the survivor on the other side of this step
  };
  ProgressiveMesh() = default;

  meshops::Connectivity mesh_;
  std::vector<Point3> places_;
  std::vector<Step> steps_;  // the collapses; the first done_ of them are done
  bool moves_ = false;       // whether a survivor moves
  std::size_t done_ = 0, least_ = 0, most_ = 0, faces_ = 0;
  std::vector<std::uint32_t> vertex_number_, face_number_;  // in the given mesh
};

}  // namespace rbpa
