// What: formats the place of a defect or a repair in the file of the mesh: vertices, faces and lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

/// Vertices and faces by their numbers in the file, from 0.
struct Place {
  std::span<const std::uint32_t> vertices;
  std::span<const std::size_t> faces;
};

/// Returns "vertices 3 4, faces 0 7, lines 12 19". Lines are those of the faces, or of the vertices if there are no
/// faces; a binary file has none. A list of more than eight numbers is cut, and its length follows.
std::string for_people(const Place& place, const MeshFile& mesh);

/// Returns {"vertices": […], "faces": […]}. A text file adds "vertex_lines" and "face_lines", the line number of each
/// vertex and face, as far as the lines are known.
nlohmann::ordered_json as_json(const Place& place, const MeshFile& mesh);

}  // namespace rbpa::app
