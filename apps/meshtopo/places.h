// What: formats the place of vertices and faces in the file of the mesh, for reports.
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

/// Returns "vertices 3 4, faces 0 7, lines 12 19": lines are those of the faces, or of the vertices if there are no
/// faces; none for a binary file. Of a long list only the beginning and the length are shown.
std::string for_people(const Place& place, const MeshFile& mesh);

/// Returns {"vertices": […], "faces": […]}, for a text file also "vertex_lines" and "face_lines", the number of the
/// line of each.
nlohmann::ordered_json as_json(const Place& place, const MeshFile& mesh);

}  // namespace rbpa::app
