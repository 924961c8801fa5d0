// What: a mesh from a file of any format we read: where its points are, and the cycles of its faces.
// Law:  points and faces keep the order of the file; nothing is judged but whether the file says what it means.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "meshops/topology/polygon_soup.h"

namespace rbpa::app {

struct MeshFile {
  std::vector<std::array<double, 3>> positions;
  meshops::PolygonSoup soup;
  /// Where each point and face stands in a text, from 1; empty when the file is binary.
  std::vector<std::size_t> point_lines;
  std::vector<std::size_t> face_lines;

  /// Room for faces as the file announces them, most of them triangles.
  void reserve_faces(std::size_t count) {
    soup.begin.reserve(count + 1);
    soup.corners.reserve(3 * count);
  }
};

struct MeshSource {
  std::string path;  ///< "-" is standard input
  MeshFormat format;
};

/// Every coordinate is finite and every corner a point. Throws BadInput naming the file, the line or the element, what
/// was found and what was expected; Failure; Cancelled.
MeshFile read_mesh(const MeshSource& source);

/// The same of the content of a file, which messages call `name`.
MeshFile mesh_in(std::string_view bytes, const std::string& name, MeshFormat format);

}  // namespace rbpa::app
