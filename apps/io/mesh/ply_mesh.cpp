#include <algorithm>
#include <cmath>
#include <optional>

#include "io/cloud/cloud.h"
#include "io/cloud/ply.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"
#include "io/number.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

/// The elements and properties of a PLY file that make a mesh.
struct PlyMeshLayout {
  const PlyElement* vertex = nullptr;
  std::array<std::size_t, 3> coordinate{};  ///< indices of x, y, z among the properties of a vertex
  const PlyElement* face = nullptr;         ///< null if there are no faces
  std::size_t corners = 0;                  ///< index of the list of corners among the properties of a face
};

PlyMeshLayout lay_out(const PlyHeader& header, const std::string& name) {
  PlyMeshLayout layout{.vertex = &vertices_of(header, name)};
  constexpr std::string_view axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) layout.coordinate[i] = find_number(*layout.vertex, axes[i], "x, y and z", name);
  for (const PlyElement& element : header.elements) {
    if (element.name == "tristrips")
      bad_input(at_line(name, element.line), "triangle strips", "faces as lists of vertex indices");
    if (element.name != "face" || layout.face != nullptr) continue;
    const auto list = std::find_if(element.properties.begin(), element.properties.end(), [](const PlyProperty& p) {
      return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
    });
    if (list == element.properties.end())
      bad_input(at_line(name, element.line), "faces without a list of vertices",
                "a list property vertex_indices or vertex_index");
    layout.face = &element;
    layout.corners = static_cast<std::size_t>(list - element.properties.begin());
  }
  return layout;
}

/// Lists what the file has beside the mesh: "vertex colors", "1 vertex field", "2 face fields".
std::vector<std::string> unused_of(const PlyMeshLayout& layout) {
  constexpr std::string_view normal[] = {"nx", "ny", "nz"}, color[] = {"red", "green", "blue", "alpha"};
  const std::size_t normals = number_places(*layout.vertex, normal).size(),
                    colors = number_places(*layout.vertex, color).size(),
                    others = layout.vertex->properties.size() - 3 - normals - colors,
                    of_faces = layout.face == nullptr ? 0 : layout.face->properties.size() - 1;
  std::vector<std::string> unused;
  if (colors > 0) unused.emplace_back("vertex colors");
  if (normals > 0) unused.emplace_back("vertex normals");
  if (others > 0) unused.push_back(counted(others, "vertex field"));
  if (of_faces > 0) unused.push_back(counted(of_faces, "face field"));
  return unused;
}

/// Returns the corner at `at` if `type` is one of the usual integer types; a negative corner becomes a number beyond
/// all points. Returns nothing for other types.
std::optional<std::uint32_t> load_corner(Scalar type, const char* at, std::endian order) {
  if (type != Scalar::int32 && type != Scalar::uint32) return std::nullopt;
  return load<std::uint32_t>(at, order);
}

template <typename Data, typename ReadVertex, typename ReadFace>
void pass_all(Data& data, const PlyHeader& header, const PlyMeshLayout& layout, MeshFile& mesh,
              const ReadVertex& read_vertex, const ReadFace& read_face) {
  for (const PlyElement& element : header.elements) {
    data.require_room(element);
    if (&element == layout.vertex) {
      mesh.positions.reserve(element.count);
      data.pass(element, 0, element.count, read_vertex);
    } else if (&element == layout.face) {
      mesh.reserve_faces(element.count);
      data.pass(element, 0, element.count, read_face);
    } else {
      data.skip(element);
    }
  }
}

MeshFile read_binary(const PlyHeader& header, const PlyMeshLayout& layout, const std::string& name) {
  MeshFile mesh;
  PlyBinary data(header, name);
  const std::endian order = *header.binary;
  const auto read_vertex = [&](std::size_t i, const std::vector<const char*>& offsets) {
    std::array<double, 3> position{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t property = layout.coordinate[k];
      position[k] = load_exactly(layout.vertex->properties[property].type, offsets[property], order,
                                 [&] { return name + ": vertex " + std::to_string(i); });
      if (!std::isfinite(position[k]))
        bad_input(name + ": vertex " + std::to_string(i), in_quotes(text_of(position[k])), "a finite number");
    }
    mesh.positions.push_back(position);
  };
  std::vector<std::uint32_t> corners;
  const auto read_face = [&](std::size_t f, const std::vector<const char*>& offsets) {
    const PlyProperty& list = layout.face->properties[layout.corners];
    const char* at = offsets[layout.corners];
    const auto length = static_cast<std::size_t>(load_number(*list.count_type, at, order));
    at += size_of(*list.count_type);
    corners.clear();
    for (std::size_t i = 0; i < length; ++i, at += size_of(list.type)) {
      if (const auto known = load_corner(list.type, at, order); known && *known < layout.vertex->count) {
        corners.push_back(*known);
        continue;
      }
      const double corner = load_number(list.type, at, order);
      if (!(corner >= 0 && corner < static_cast<double>(layout.vertex->count) && corner == std::floor(corner)))
        bad_input(name + ": face " + std::to_string(f), in_quotes(text_of(corner)),
                  corner_expected(layout.vertex->count));
      corners.push_back(static_cast<std::uint32_t>(corner));
    }
    mesh.soup.add_face(corners);
  };
  pass_all(data, header, layout, mesh, read_vertex, read_face);
  return mesh;
}

MeshFile read_ascii(const PlyHeader& header, const PlyMeshLayout& layout, const std::string& name) {
  MeshFile mesh;
  PlyText data(header, name);
  const auto read_vertex = [&](std::size_t, std::string_view& rest) {
    std::array<double, 3> position{};
    for (std::size_t k = 0; k < layout.vertex->properties.size(); ++k) {
      const auto axis = std::find(layout.coordinate.begin(), layout.coordinate.end(), k);
      if (axis == layout.coordinate.end()) {
        data.pass_words(layout.vertex->properties[k], rest);
      } else {
        position[static_cast<std::size_t>(axis - layout.coordinate.begin())] =
            take_coordinate(rest, data.lines(), name);
      }
    }
    mesh.positions.push_back(position);
    mesh.point_lines.push_back(data.lines().number());
  };
  std::vector<std::uint32_t> corners;
  const auto read_face = [&](std::size_t, std::string_view& rest) {
    for (std::size_t k = 0; k < layout.corners; ++k) data.pass_words(layout.face->properties[k], rest);
    take_corner_list(rest, data.lines(), name, layout.vertex->count, corners);
    for (std::size_t k = layout.corners + 1; k < layout.face->properties.size(); ++k)
      data.pass_words(layout.face->properties[k], rest);
    mesh.soup.add_face(corners);
    mesh.face_lines.push_back(data.lines().number());
  };
  pass_all(data, header, layout, mesh, read_vertex, read_face);
  data.require_end();
  return mesh;
}

}  // namespace

MeshFile read_ply_mesh(std::string_view bytes, const std::string& name) {
  const PlyHeader header = read_ply_header(bytes, name);
  const PlyMeshLayout layout = lay_out(header, name);
  MeshFile mesh = header.binary ? read_binary(header, layout, name) : read_ascii(header, layout, name);
  mesh.unused = unused_of(layout);
  return mesh;
}

}  // namespace rbpa::app
