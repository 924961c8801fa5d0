// What: points and polygons in the words of the mesh formats, for the files that write them.
// Law:  the bytes depend on the mesh alone; coordinates read back to the same doubles.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "io/output_file.h"

namespace rbpa::app {

// A `Mesh` below has points() and faces(), how many; point(i), three coordinates; face(f), a range of corners, each
// std::uint32_t from 0.

inline void write_position(OutputFile& file, const std::array<double, 3>& p) {
  file.write_number(p[0]);
  file.write(" ");
  file.write_number(p[1]);
  file.write(" ");
  file.write_number(p[2]);
  file.write("\n");
}

inline void write_obj_vertex(OutputFile& file, const std::array<double, 3>& p) {
  file.write("v ");
  write_position(file, p);
}

/// " 4 5 6" and the end of the line.
inline void write_corners(OutputFile& file, std::span<const std::uint32_t> corners, std::uint32_t first_index) {
  for (const std::uint32_t corner : corners) {
    file.write(" ");
    file.write_number(std::uint64_t{corner} + first_index);
  }
  file.write("\n");
}

template <typename Mesh>
void write_off(OutputFile& file, const Mesh& mesh) {
  file.write("OFF\n");
  file.write_number(std::uint64_t{mesh.points()});
  file.write(" ");
  file.write_number(std::uint64_t{mesh.faces()});
  file.write(" 0\n");
  for (std::size_t i = 0; i < mesh.points(); ++i) write_position(file, mesh.point(i));
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

/// Binary little-endian. The length of a face is a byte, which every reader knows, unless one is too long for that.
template <typename Mesh>
void write_ply(OutputFile& file, const Mesh& mesh) {
  bool long_faces = false;
  for (std::size_t f = 0; f < mesh.faces() && !long_faces; ++f)
    long_faces = mesh.face(f).size() > std::numeric_limits<std::uint8_t>::max();
  file.write("ply\nformat binary_little_endian 1.0\nelement vertex ");
  file.write_number(std::uint64_t{mesh.points()});
  file.write("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  file.write_number(std::uint64_t{mesh.faces()});
  file.write(long_faces ? "\nproperty list uint int vertex_indices\nend_header\n"
                        : "\nproperty list uchar int vertex_indices\nend_header\n");
  for (std::size_t i = 0; i < mesh.points(); ++i)
    for (const double coordinate : mesh.point(i)) file.write_binary(coordinate);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const std::span<const std::uint32_t> corners = mesh.face(f);
    const char length = static_cast<char>(static_cast<std::uint8_t>(corners.size()));
    if (long_faces) {
      file.write_binary(static_cast<std::uint32_t>(corners.size()));
    } else {
      file.write({&length, 1});
    }
    for (const std::uint32_t corner : corners) file.write_binary(corner);
  }
}

}  // namespace rbpa::app
