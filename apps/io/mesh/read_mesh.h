// What: reads a mesh from a file of any supported format: the positions of its points, and its faces as cycles of
//       points.
// Law:  points and faces are in the order of the file. The file must be well formed; the mesh need not be a manifold.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/mesh/single_precision.h"
#include "meshops/topology/polygon_soup.h"

namespace rbpa::app {

struct MeshFile {
  std::vector<std::array<double, 3>> positions;
  meshops::PolygonSoup soup;
  /// The numbers of the lines of points and faces in a text file, from 1; empty if the file is binary.
  std::vector<std::size_t> point_lines;
  std::vector<std::size_t> face_lines;
  std::vector<std::string> warnings = {};  ///< warnings about data that are left out
  std::vector<std::string> unused = {};    ///< what the file has beside positions and faces: "vertex colors"

  /// Reserves memory for `count` faces, of which most are triangles.
  void reserve_faces(std::size_t count) {
    soup.begin.reserve(count + 1);
    soup.corners.reserve(3 * count);
  }
};

struct MeshSource {
  std::string path;  ///< "-" is standard input
  Format format;
};

/// Reads a mesh: every coordinate is finite and every corner is a point. Throws BadInput that names the file, the line
/// or the element, what was found and what was expected; Failure; Cancelled.
MeshFile read_mesh(const MeshSource& source);

/// Reads a mesh from the content of a file; messages call the file `name`. Throws as read_mesh().
MeshFile mesh_in(std::string_view bytes, const std::string& name, Format format);

/// Reads OFF with any of the prefixes ST, C, N: one vertex per line, x y z first, and one face per line, whose color is
/// ignored; or, if there are fewer lines, the numbers of vertices and faces as one sequence of words, and nothing else.
/// Throws BadInput that names the line, before memory is allocated if the file is too short for its counts; Cancelled.
MeshFile read_off_mesh(std::string_view text, const std::string& name);

/// Reads PLY: the number properties x, y, z of the element "vertex" and the list vertex_indices or vertex_index of the
/// element "face", of any number types and in either order; without faces, points alone. Ignores everything else, but
/// checks that it is complete, so that a truncated file is refused. Does not read triangle strips. Throws BadInput that
/// names the line, or the element of a binary file (counted from 0), before memory is allocated if the file is too
/// short for the counts in its header; Cancelled.
MeshFile read_ply_mesh(std::string_view bytes, const std::string& name);

/// Reads the lines "v x y z …" and "f …" of OBJ. Of a corner v, v/vt, v//vn or v/vt/vn only v is used: a number from 1
/// on, or a negative one, where −1 is the last vertex before the line. A line that ends in '\' continues in the next.
/// Ignores everything else. Throws BadInput that names the line; Cancelled.
MeshFile read_obj_mesh(std::string_view text, const std::string& name);

/// Reads STL. Corners at equal positions are one point; points are in the order of their first corners. The file is
/// binary if its size fits the number of facets at byte 80, or if it does not begin with "solid", or if it has zero
/// bytes and its second line begins with neither "facet" nor "endsolid". Coordinates are floats in a binary file, and
/// the nearest doubles in a text. Ignores normals, colors and names, and, with a warning, attributes of facets and data
/// after the last facet. Throws BadInput that names the line, or the facet of a binary file (counted from 0);
/// Cancelled.
MeshFile read_stl_mesh(std::string_view bytes, const std::string& name);

/// Returns the mesh that read_stl_mesh() would read from a binary file of `triangles` at `positions`.
MeshFile as_stl_mesh(const SinglePositions& positions, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace rbpa::app
