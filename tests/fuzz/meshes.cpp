// Readers of meshes: any bytes are either a mesh whose corners are points, or refused in a sentence of one line.
// format_of_input.h says how an input names its format.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/format_of_input.h"
#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/failure.h"
#include "io/mesh/read_mesh.h"

namespace {

using namespace rbpa::app;

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
  const auto file = fuzz::divided({reinterpret_cast<const char*>(data), size});
  const std::optional<Format> format = file ? find_format(Use::mesh, file->ending) : std::nullopt;
  if (!format) return 0;
  try {
    const MeshFile mesh = mesh_in(file->bytes, "FILE", *format);
    is_sound(mesh);
  } catch (const BadInput& refusal) {
    fuzz::require(std::string(refusal.what()).starts_with("FILE"), "a message names the place");
    fuzz::is_a_sentence(refusal.what());
  }
  return 0;
}
