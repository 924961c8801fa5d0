// One small mesh in every format.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace apps_test {

/// A pyramid on a square: four triangles and a square, χ = 2.
inline const std::vector<std::array<double, 3>> pyramid_positions = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
inline const std::vector<std::vector<std::uint32_t>> pyramid_faces = {
    {3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
/// The pyramid with the square as two triangles.
inline const std::vector<std::array<std::uint32_t, 3>> pyramid_triangles = {{3, 2, 1}, {3, 1, 0}, {0, 1, 4},
                                                                            {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

inline const std::string pyramid_off =
    "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
inline const std::string pyramid_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
inline const std::string pyramid_ply =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 5\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "0.5 0.5 1\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";

/// Returns the pyramid with x as float, z and y as double, indices as short, and another list after the vertices.
std::string ply_binary(std::endian order);

using Triangles = std::vector<std::array<std::uint32_t, 3>>;  // of the points of the pyramid
std::string stl_text(const Triangles& triangles);
std::string stl_binary(const Triangles& triangles);

}  // namespace apps_test
