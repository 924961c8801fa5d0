// The reader of polygons in .poly files: any bytes are either polygons that cover an area and whose rings have three
// vertices or more and share none, or they are refused in a sentence of one line. The bytes are the file.
#include <cmath>
#include <string>
#include <vector>

#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/failure.h"
#include "io/polygon/read_polygons.h"

namespace {

using namespace rbpa::app;

void is_sound(const PolygonFile& file) {
  const std::vector<rbpa::Point>& points = file.vertices.points;
  for (const rbpa::Point& p : points) fuzz::require(std::isfinite(p.x) && std::isfinite(p.y), "vertices are finite");
  std::vector<bool> used(points.size(), false);
  const auto is_ring = [&](const rbpa::Ring& ring) {
    fuzz::require(ring.points.size() >= 3, "a ring has three vertices or more");
    for (const std::uint32_t v : ring.points) {
      fuzz::require(v < points.size(), "a ring has vertices of the file");
      fuzz::require(!used[v], "no vertex is in two rings, or in one twice");
      used[v] = true;
    }
  };
  for (const rbpa::Polygon& polygon : file.polygons) {
    is_ring(polygon.shell);
    for (const rbpa::Ring& hole : polygon.holes) is_ring(hole);
    fuzz::require(polygon.area >= 0 && polygon.perimeter >= 0, "measures are numbers");
  }
}

/// Checks a refusal. Where rings meet, the message names both rings instead of saying what was found.
void is_a_refusal(const std::string& message) {
  if (message.find("; expected rings that meet in single points at most") == std::string::npos)
    return fuzz::is_a_sentence(message);
  fuzz::require(message.starts_with("FILE: ") && rbpa::app::printable(message) == message,
                "a message is one line of visible characters, and names the place");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    is_sound(read_poly_polygons(bytes, "FILE"));
  } catch (const BadInput& refusal) {
    is_a_refusal(refusal.what());
  }
  return 0;
}
