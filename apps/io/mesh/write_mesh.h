// What: polygons in space as a mesh file, surfaces, with normals and colors, and closed polylines on them.
// Law:  what read_mesh() makes of the file is the same points, to the last bit (but for STL), and the same faces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "io/mesh/single_precision.h"
#include "meshops/topology/polygon_soup.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// OFF, PLY (binary little-endian), OBJ; or STL, binary, in single precision and with a face of more corners as for_each_fan_triangle()
/// parts it. Throws BadInput, before anything is written, when a coordinate is too large for STL; Failure, when single
/// precision does not keep the mesh. Requires: one of mesh_formats; a position for every point of `soup`.
void write_mesh(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                const meshops::PolygonSoup& soup, const std::optional<Shift>& shift = std::nullopt);

/// Faces as triangles, as STL keeps them.
struct TriangulatedFaces {
  std::vector<Point3> vertices = {};
  std::vector<std::array<std::uint32_t, 3>> triangles = {};

  TriangulatedFaces(std::span<const std::array<double, 3>> positions, const meshops::PolygonSoup& soup);
};

/// Normals, colors, points and certainties: none, or one of each vertex.
struct SpaceMesh {
  std::span<const Point3> vertices;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const Point3> normals = {};
  std::span<const std::array<std::uint8_t, 3>> colors = {};
  std::span<const std::uint32_t> points = {};  ///< input indices
  std::span<const double> certainty = {};      ///< of the normals
  std::optional<Shift> shift = std::nullopt;   ///< of STL and GLB
  std::span<const std::uint32_t> index =
      {};  ///< of each vertex among the points of the input; none where that is its number
};

/// Throws Failure: single precision does not keep the triangles.
void require_kept(const OutputFile& file, Format format, const SpaceMesh& mesh);

/// OFF, OBJ; PLY (binary little-endian) with normals as double, colors as uchar, points as uint `point` and
/// certainties as double `certainty`; STL (binary, single precision; its header says a shift); VTU, GLB (below); or the
/// triangles as an .npy array of uint32 with shape (n, 3). Throws BadInput, before anything is written, when a
/// coordinate is too large for STL or GLB; Failure, when single precision does not keep the triangles. Requires: not a
/// picture format.
void write_surface(OutputFile& file, Format format, const SpaceMesh& mesh);

/// Normals as point data `Normals`, colors as `RGB`, input indices as `point`, certainties as `certainty`.
void write_vtu(OutputFile& file, const SpaceMesh& mesh);

/// One mesh, both sides of which are seen. Positions are in single precision; where that loses something, relative to a node's
/// `translation`, the shift. Colors are linear, as the format has them. Input indices are not written. Without a
/// triangle the scene is empty.
void write_glb(OutputFile& file, const SpaceMesh& mesh);

/// Points one after the other, each once; the first follows the last.
using Polyline = std::vector<std::uint32_t>;

/// OBJ: all of `positions` as vertices, each loop as one element 'l', which names its first vertex again at the end; where
/// loops have `groups`, names, in groups 'g' by these.
/// JSON: a list of {"kind": the group, if there are any, "vertices": [numbers from 0], "positions": [[x, y, z], …]}.
void write_polylines(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                     std::span<const Polyline> loops, std::span<const std::string_view> groups = {});

}  // namespace rbpa::app
