#include "support/mesh_files.h"

#include <algorithm>
#include <cstring>

namespace apps_test {
namespace {

template <typename T>
void append(std::string& bytes, T value, std::endian order) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (order != std::endian::native) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

}  // namespace

std::string ply_binary(std::endian order) {
  std::string bytes = "ply\nformat binary_";
  bytes += order == std::endian::little ? "little" : "big";
  bytes +=
      "_endian 1.0\nelement vertex 5\nproperty float x\nproperty double z\nproperty double y\n"
      "property list uchar ushort tags\nelement face 5\nproperty uchar red\n"
      "property list int short vertex_indices\nend_header\n";
  for (const auto& p : pyramid_positions) {
    append(bytes, static_cast<float>(p[0]), order);
    append(bytes, p[2], order);
    append(bytes, p[1], order);
    append(bytes, std::uint8_t{2}, order);
    append(bytes, std::uint16_t{7}, order);
    append(bytes, std::uint16_t{8}, order);
  }
  for (const auto& face : pyramid_faces) {
    append(bytes, std::uint8_t{255}, order);
    append(bytes, static_cast<std::int32_t>(face.size()), order);
    for (const std::uint32_t corner : face) append(bytes, static_cast<std::int16_t>(corner), order);
  }
  return bytes;
}

std::string stl_text(const Triangles& triangles) {
  std::string text = "solid pyramid on a square\n";
  for (const auto& triangle : triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::uint32_t corner : triangle) {
      text += "      vertex";
      for (const double coordinate : pyramid_positions[corner]) text.append(" ").append(std::to_string(coordinate));
      text += "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid pyramid on a square\n";
}

std::string stl_binary(const Triangles& triangles) {
  std::string bytes(80, '\0');
  append(bytes, static_cast<std::uint32_t>(triangles.size()), std::endian::little);
  for (const auto& triangle : triangles) {
    bytes.append(12, '\0');
    for (const std::uint32_t corner : triangle)
      for (const double coordinate : pyramid_positions[corner])
        append(bytes, static_cast<float>(coordinate), std::endian::little);
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace apps_test
