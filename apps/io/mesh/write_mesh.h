// What: writes meshes in space: polygons; surfaces with normals and colors; closed polylines on them; tetrahedra.
// Law:  the bytes depend on the mesh alone. In formats of double precision, coordinates read back to the same doubles;
//       read_mesh() reads the same points and faces from OFF, PLY and OBJ.
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
#include "io/point_columns.h"
#include "meshops/topology/polygon_soup.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// Writes OFF, PLY (binary little-endian), OBJ or STL. STL is binary, in single precision, and has the triangles of
/// for_each_fan_triangle() in place of larger faces. Throws, before anything is written, BadInput if a coordinate is
/// too large for STL, and Failure if single precision does not keep the mesh. Requires: a format of Use::mesh; a
/// position for every point of `soup`.
void write_mesh(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                const meshops::PolygonSoup& soup, const std::optional<Shift>& shift = std::nullopt);

/// Faces as the triangles of for_each_fan_triangle(), which STL stores.
struct TriangulatedFaces {
  std::vector<Point3> vertices = {};
  std::vector<std::array<std::uint32_t, 3>> triangles = {};

  TriangulatedFaces(std::span<const std::array<double, 3>> positions, const meshops::PolygonSoup& soup);
};

/// A mesh in space. Normals, colors, points and confidence are empty, or have a value for each vertex.
struct SpaceMesh {
  std::span<const Point3> vertices;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const Point3> normals = {};
  std::span<const std::array<std::uint8_t, 3>> colors = {};
  std::span<const std::uint32_t> points = {};  ///< input index of the point of each vertex, to be written
  std::span<const double> confidence = {};     ///< confidence in the normals
  std::optional<Shift> shift = std::nullopt;   ///< shift of positions in STL and GLB
  std::span<const std::uint32_t> index = {};   ///< input index of each vertex; empty if vertex i has index i
  VertexFields fields = {};                    ///< written to PLY and VTU
};

/// Returns the positions as STL or GLB stores them. Throws Failure if triangles would lose their area or vertices
/// coincide (why_not_kept()), and as single_positions().
SinglePositions kept_positions(const OutputFile& file, Format format, const SpaceMesh& mesh);

/// Writes OFF, OBJ; PLY (binary little-endian) with normals as double, colors as uchar, points as uint `point` and
/// confidences as double `confidence`, and fields (ply_fields.h); STL (binary, single precision, a shift in its
/// header); VTU, GLB (below); or the triangles as an .npy array of uint32 with shape (n, 3), of input indices if
/// mesh.index is not empty. Throws, before anything is written, BadInput if a coordinate is too large for STL or GLB,
/// and Failure if single precision does not keep the triangles. Requires: not a picture format.
void write_surface(OutputFile& file, Format format, const SpaceMesh& mesh);

/// Writes VTU with normals as point data `Normals`, colors as `RGB`, input indices as `point`, confidences as
/// `confidence`, and the fields.
void write_vtu(OutputFile& file, const SpaceMesh& mesh);

/// Writes GLB: one double-sided mesh. Positions are in single precision, less the shift, which, unless it is 0, is the
/// `translation` of a node. Throws as kept_positions(), and BadInput from 2^32 bytes on. Colors are linear, as the
/// format demands. Input indices are not written. Without triangles the scene is empty.
void write_glb(OutputFile& file, const SpaceMesh& mesh);

/// A closed polyline: its vertices in order; the first follows the last and is not repeated.
using Polyline = std::vector<std::uint32_t>;

/// Writes closed polylines. OBJ: all of `positions` as vertices; each loop as one element 'l', which repeats its first
/// vertex at the end; groups 'g' if `groups` has the name of the group of each loop.
/// JSON: a list of {"kind": the group, if there are any, "vertices": [numbers from 0], "positions": [[x, y, z], …]}.
void write_polylines(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                     std::span<const Polyline> loops, std::span<const std::string_view> groups = {});

/// Tetrahedra. The vertices are all points, in input order.
struct SolidMesh {
  std::span<const Point3> vertices;
  std::span<const std::array<std::uint32_t, 4>> tetrahedra;
  std::span<const std::uint32_t> index = {};  ///< input index of each vertex; empty if vertex i has index i
  VertexFields fields = {};                   ///< written to VTU
};

/// Writes VTU with appended raw data; Medit's .mesh or Gmsh's .msh, version 2.2, both text with vertices numbered from
/// 1; or the tetrahedra as an .npy array of uint32 with shape (n, 4), of input indices if mesh.index is not empty.
/// Requires: a format of Use::solid that is not a picture.
void write_solid(OutputFile& file, Format format, const SolidMesh& mesh);

}  // namespace rbpa::app
