#include "support/claiming_files.h"

#include <bit>

#include "support/lzf.h"
#include "support/mesh_files.h"

namespace apps_test {
namespace {

std::string pcd(const std::string& kind, std::size_t points, const std::string& data) {
  return "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + std::to_string(points) +
         "\nHEIGHT 1\nPOINTS " + std::to_string(points) + "\nDATA " + kind + "\n" + data;
}

/// A PLY of lists with lengths of 32 bits: the first is empty, the second has three values.
std::string ply_with_long_lists() {
  return "ply\nformat binary_little_endian 1.0\nelement face 2\nproperty list int int vertex_indices\n"
         "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n" +
         little(0, 4) + little(3, 4) + std::string(12, '\0') + std::string(12, '\0');
}

}  // namespace

std::string npy_of_zeros(const std::string& shape, std::size_t numbers) {
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': " + shape + "}\n";
  return std::string("\x93NUMPY\x01\x00", 8) + little(header.size(), 2) + header + std::string(4 * numbers, '\0');
}

std::string las_of(std::size_t points, const std::vector<LasRecord>& extended) {
  LasFile file{.minor = 4, .format = 6, .extended = extended};
  for (std::size_t i = 0; i < points; ++i) file.points.push_back({.x = static_cast<int>(i), .y = static_cast<int>(i)});
  return bytes_of(file);
}

std::vector<File> claiming_points() {
  return {{"p.ply", pyramid_ply},
          {"b.ply", ply_binary(std::endian::big)},
          {"l.ply", ply_with_long_lists()},
          {"p.off", pyramid_off},
          {"p.npy", npy_of_zeros("(5, 2)", 10)},
          {"t.pgm", "P2\n2 2\n255\n0 0\n0 255\n", 1},
          {"b.pgm", std::string("P5\n2 2\n65535\n") + std::string(8, '\0')},
          {"p.las", las_of(3)},
          {"e.las", las_of(3, {{"user", 1, std::string(100, 'x')}, {"user", 2, "y"}})}};
}

std::vector<File> claiming_space() {
  return {{"p.ply", pyramid_ply},
          {"b.ply", ply_binary(std::endian::little)},
          {"p.off", pyramid_off},
          {"p.npy", npy_of_zeros("(5, 3)", 15)},
          {"p.las", las_of(3)},
          {"b.pcd", pcd("binary", 3, std::string(36, '\0'))},
          {"c.pcd", pcd("binary_compressed", 3,
                        little(lzf_repeated('\0', 36).size(), 4) + little(36, 4) + lzf_repeated('\0', 36))},
          {"t.pcd", pcd("ascii", 3, "0 0 0\n1 0 0\n0 1 0\n")}};
}

std::vector<File> claiming_meshes() {
  return {{"p.ply", pyramid_ply},
          {"b.ply", ply_binary(std::endian::big)},
          {"l.ply", ply_with_long_lists()},
          {"p.off", pyramid_off},
          {"b.stl", stl_binary(pyramid_triangles)}};
}

}  // namespace apps_test
