// What: where in its file something of a mesh is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

/// Vertices and faces as the file numbers them, from 0.
struct Place {
  std::span<const std::uint32_t> vertices;
  std::span<const std::size_t> faces;
};

/// "vertices 3 4, faces 0 7, lines 12 19": the lines of the faces, or else of the vertices; none in a binary file. Of
/// many numbers the first few and how many there are.
std::string for_people(const Place& place, const MeshFile& mesh);

/// {"vertices": […], "faces": […]}, and in a text "vertex_lines" and "face_lines", one for each.
nlohmann::ordered_json as_json(const Place& place, const MeshFile& mesh);

}  // namespace rbpa::app
