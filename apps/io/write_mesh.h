// What: polygons in space as a mesh file.
// Law:  what read_mesh() makes of the file is the same points, to the last bit, and the same faces.
#pragma once

#include <array>
#include <span>

#include "io/formats.h"
#include "io/output_file.h"
#include "meshops/topology/polygon_soup.h"

namespace rbpa::app {

/// The formats, for messages and help: those that hold doubles and shared points, so not STL.
constexpr std::string_view written_mesh_formats = "off, ply, obj";
constexpr bool can_write_mesh(MeshFormat format) { return format != MeshFormat::stl; }

/// OFF, PLY (binary little-endian) or OBJ. Requires: can_write_mesh(format); a position for every point of `soup`.
void write_mesh(OutputFile& file, MeshFormat format, std::span<const std::array<double, 3>> positions,
                const meshops::PolygonSoup& soup);

}  // namespace rbpa::app
