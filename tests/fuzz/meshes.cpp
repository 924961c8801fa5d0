// Readers of meshes: any bytes are either a mesh whose corners are points, or refused in a sentence of one line.
// The first byte is the format; the rest is the file.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"

namespace {

using namespace rbpa::app;

/// Returns the formats of meshes, in the order of the table.
std::vector<Format> all_formats() {
  std::vector<Format> formats;
  for (const FormatRow& row : format_table)
    if (row.is_for(Use::mesh)) formats.push_back(row.format);
  return formats;
}

void is_sound(const MeshFile& mesh) {
  const auto& soup = mesh.soup;
  fuzz::require(soup.points == mesh.positions.size(), "a position for each point");
  fuzz::require(soup.begin.front() == 0 && soup.begin.back() == soup.corners.size(), "faces have all corners");
  fuzz::require(std::is_sorted(soup.begin.begin(), soup.begin.end()), "faces are one after the other");
  fuzz::require(
      std::all_of(soup.corners.begin(), soup.corners.end(), [&](auto corner) { return corner < soup.points; }),
      "corners are points");
  for (const auto& position : mesh.positions)
    fuzz::require(std::all_of(position.begin(), position.end(), [](double x) { return std::isfinite(x); }),
                  "positions are finite");
  const auto is_of_text = [](const auto& lines, std::size_t count) { return lines.empty() || lines.size() == count; };
  fuzz::require(is_of_text(mesh.point_lines, soup.points) && is_of_text(mesh.face_lines, soup.faces()),
                "each has a line, or none has");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::vector<Format> formats = all_formats();
  const Format format = formats[data[0] % formats.size()];
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    const MeshFile mesh = mesh_in(bytes, "FILE", format);
    is_sound(mesh);
  } catch (const BadInput& refusal) {
    fuzz::require(std::string(refusal.what()).starts_with("FILE"), "a message names the place");
    fuzz::is_a_sentence(refusal.what());
  }
  return 0;
}
