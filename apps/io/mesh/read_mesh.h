// What: a mesh from a file of any format we read: where its points are, and the cycles of its faces.
// Law:  points and faces keep the order of the file; the reader checks that the file is well formed, and judges no mesh.
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
  /// Where each point and face stands in a text, from 1; empty when the file is binary.
  std::vector<std::size_t> point_lines;
  std::vector<std::size_t> face_lines;
  std::vector<std::string> remarks = {};  ///< what is left out

  /// Room for faces as the file announces them, most of them triangles.
  void reserve_faces(std::size_t count) {
    soup.begin.reserve(count + 1);
    soup.corners.reserve(3 * count);
  }
};

struct MeshSource {
  std::string path;  ///< "-" is standard input
  Format format;
};

/// Every coordinate is finite and every corner a point. Throws BadInput naming the file, the line or the element, what
/// was found and what was expected; Failure; Cancelled.
MeshFile read_mesh(const MeshSource& source);

/// The same of the content of a file, which messages call `name`.
MeshFile mesh_in(std::string_view bytes, const std::string& name, Format format);

/// OFF with any of the prefixes ST, C, N; one vertex a line, x y z first, and one face a line, whose colors are passed
/// over; or, of fewer lines, the numbers of vertices and faces as one sequence of words, and nothing else. Throws
/// BadInput naming the line; when the file is too short for what it announces, before memory is allocated.
MeshFile read_off_mesh(std::string_view text, const std::string& name);

/// The number properties x, y, z of the element "vertex" and the list vertex_indices or vertex_index of the element
/// "face", of any number types and in either order; without faces, points alone. Everything else is passed over, but
/// has to be there, so that a cut file is noticed. Triangle strips are not read. Throws BadInput naming the line, or
/// the element of a binary file (counted from 0); when the file is too short for what the header announces, before
/// memory is allocated.
MeshFile read_ply_mesh(std::string_view bytes, const std::string& name);

/// The lines "v x y z …" and "f …"; of a corner v, v/vt, v//vn or v/vt/vn counts v, from 1, or from −1 back from the
/// last vertex before the line. A line that ends in '\' goes on in the next. Everything else is passed over. Throws
/// BadInput naming the line.
MeshFile read_obj_mesh(std::string_view text, const std::string& name);

/// Points are numbered by their first corner in the file. Binary when the size is that of the number of facets at byte
/// 80, or when it does not begin with "solid", or when there are zero bytes in it and no facet in the next line;
/// coordinates are then floats, else the doubles nearest to the text. Normals, colors and names are passed over, and
/// so is, with a remark, what follows the last facet, or each facet as its attributes. Throws BadInput naming the line,
/// or the facet of a binary file (counted from 0).
MeshFile read_stl_mesh(std::string_view bytes, const std::string& name);

/// Returns the mesh that read_stl_mesh() makes of a file of these triangles.
MeshFile as_stl_mesh(const SinglePositions& positions, std::span<const std::array<std::uint32_t, 3>> triangles);

/// A Claim: the facets of a binary file. ASCII claims nothing.
double claimed_stl_size(std::string_view first, const std::string& name);

}  // namespace rbpa::app
