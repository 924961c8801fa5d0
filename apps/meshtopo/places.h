// What: the place of vertices and faces in the mesh's file, for reports.
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

/// Returns "vertices 3 4, faces 0 7, lines 12 19": the lines of the faces, or of the vertices if there are no faces; no
/// lines for a binary file. Long lists are cut off, and their length follows.
std::string for_people(const Place& place, const MeshFile& mesh);

/// Returns {"vertices": […], "faces": […]}, for a text file also "vertex_lines" and "face_lines", one for each.
nlohmann::ordered_json as_json(const Place& place, const MeshFile& mesh);

}  // namespace rbpa::app
