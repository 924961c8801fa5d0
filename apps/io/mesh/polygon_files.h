// What: writes points and polygons as OFF, OBJ and PLY, and rows of indices as .npy.
// Law:  the bytes depend on the mesh alone; coordinates read back to the same doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/bytes/npy.h"
#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "io/number.h"
#include "io/values_at.h"

namespace rbpa::app {

// A `Mesh` below has the counts points() and faces(); point(i), three coordinates; and face(f), a range of corners,
// each a std::uint32_t from 0.

/// Writes `before`, the coordinates of `p` as in "1.5 2 0", and a line end.
inline void write_position(OutputFile& file, std::string_view before, const std::array<double, 3>& p) {
  char* at = file.room(before.size() + 3 * (number_room + 1));
  at = std::copy(before.begin(), before.end(), at);
  for (const double coordinate : p) {
    at = put_number(at, coordinate);
    *at++ = ' ';
  }
  at[-1] = '\n';
  file.written(at);
}

inline void write_obj_vertex(OutputFile& file, const std::array<double, 3>& p) { write_position(file, "v ", p); }

/// Writes the corners as in " 4 5 6", with `first_index` added to each, and a line end.
inline void write_corners(OutputFile& file, std::span<const std::uint32_t> corners, std::uint32_t first_index) {
  constexpr std::size_t at_once = 64;
  do {
    const auto some = corners.first(std::min(at_once, corners.size()));
    corners = corners.subspan(some.size());
    char* at = file.room(at_once * (number_room + 1) + 1);
    for (const std::uint32_t corner : some) {
      *at++ = ' ';
      at = put_number(at, std::uint64_t{corner} + first_index);
    }
    if (corners.empty()) *at++ = '\n';
    file.written(at);
  } while (!corners.empty());
}

template <typename Mesh>
void write_off(OutputFile& file, const Mesh& mesh) {
  file.write_all("OFF\n", mesh.points(), " ", mesh.faces(), " 0\n");
  for (std::size_t i = 0; i < mesh.points(); ++i) write_position(file, "", mesh.point(i));
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    file.write_number(std::uint64_t{mesh.face(f).size()});
    write_corners(file, mesh.face(f), 0);
  }
}

template <typename Mesh>
void write_obj(OutputFile& file, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.points(); ++i) write_obj_vertex(file, mesh.point(i));
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    file.write("f");
    write_corners(file, mesh.face(f), 1);
  }
}

/// Writes binary little-endian PLY. A mesh may have further properties of a vertex: properties() returns their lines in
/// the header, with line ends, and write_properties(file, i) writes their values; face_properties() and
/// write_face_properties(file, f) do so for a face; comments() returns lines before the elements. The number of corners
/// of a face is a byte, which every reader supports, unless a face has more than 255 corners.
template <typename Mesh>
void write_ply(OutputFile& file, const Mesh& mesh) {
  bool long_faces = false;
  for (std::size_t f = 0; f < mesh.faces() && !long_faces; ++f)
    long_faces = mesh.face(f).size() > std::numeric_limits<std::uint8_t>::max();
  file.write("ply\nformat binary_little_endian 1.0\n");
  if constexpr (requires { mesh.comments(); }) file.write(mesh.comments());
  file.write_all("element vertex ", mesh.points(), "\nproperty double x\nproperty double y\nproperty double z\n");
  if constexpr (requires { mesh.properties(); }) file.write(mesh.properties());
  file.write_all("element face ", mesh.faces(), "\nproperty list ", long_faces ? "uint" : "uchar",
                 " int vertex_indices\n");
  if constexpr (requires { mesh.face_properties(); }) file.write(mesh.face_properties());
  file.write("end_header\n");
  for (std::size_t i = 0; i < mesh.points(); ++i) {
    file.write_binary(mesh.point(i));
    if constexpr (requires { mesh.properties(); }) mesh.write_properties(file, i);
  }
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const std::span<const std::uint32_t> corners = mesh.face(f);
    if (long_faces)
      file.write_binary(static_cast<std::uint32_t>(corners.size()));
    else
      file.write_binary(static_cast<std::uint8_t>(corners.size()));
    file.write_binary(corners);
    if constexpr (requires { mesh.face_properties(); }) mesh.write_face_properties(file, f);
  }
}

/// Writes a mesh. Requires: `format` is off, obj or ply.
template <typename Mesh>
void write_polygons(OutputFile& file, Format format, const Mesh& mesh) {
  if (format == Format::off) return write_off(file, mesh);
  if (format == Format::obj) return write_obj(file, mesh);
  if (format == Format::ply) return write_ply(file, mesh);
  throw std::logic_error("write_polygons: found a format without a writer, expected off, obj or ply");
}

/// Writes `rows` as an .npy array of uint32 with shape (n, columns). If `index` is not empty, it has the input index of
/// each vertex, which is written in place of the vertex.
template <std::size_t columns>
void write_npy_rows(OutputFile& file, std::span<const std::array<std::uint32_t, columns>> rows,
                    std::span<const std::uint32_t> index) {
  file.write(npy_header("<u4", rows.size(), ", " + std::to_string(columns)));
  constexpr std::size_t at_once = 4096;
  for (std::size_t first = 0; first < rows.size(); first += at_once) {
    const auto some = rows.subspan(first, index.empty() ? rows.size() : std::min(at_once, rows.size() - first));
    if (index.empty()) return file.write_binary(std::span(some.front().data(), columns * some.size()));
    const auto numbered = renumbered(some, index);
    file.write_binary(std::span(numbered.front().data(), columns * numbered.size()));
  }
}

}  // namespace rbpa::app
