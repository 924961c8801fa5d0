// What: prints the outline of points, at a radius chosen by a rule, as GeoJSON on standard output.
#include <cstdio>
#include <optional>
#include <vector>

#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/choose_alpha.h"
#include "rbpa/plane/outline_polygons.h"

std::vector<rbpa::Polygon> outline_of(const std::vector<rbpa::Point>& points) {
  const rbpa::Delaunay delaunay(points);
  const std::optional<double> alpha = rbpa::choose_alpha(*rbpa::parse_alpha_rule("plateau"), delaunay).alpha;
  if (!alpha) return {};  // all points are on a line
  return rbpa::outline_polygons(points, rbpa::alpha_complex(points, *alpha, {.neighbors = true}));
}

void print(const std::vector<rbpa::Point>& points, const rbpa::Ring& ring) {
  std::printf("[");
  for (const std::uint32_t corner : ring.points) std::printf("[%.17g,%.17g],", points[corner].x, points[corner].y);
  std::printf("[%.17g,%.17g]]", points[ring.points[0]].x, points[ring.points[0]].y);  // closed, as GeoJSON demands
}

int main() {
  std::vector<rbpa::Point> points;
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y)
      if (x < 15 || y < 15) points.push_back({double(x), double(y)});  // an L
  std::printf(R"({"type":"MultiPolygon","coordinates":[)");
  const char* comma = "";
  for (const rbpa::Polygon& polygon : outline_of(points)) {
    std::printf("%s[", comma);
    print(points, polygon.shell);
    for (const rbpa::Ring& hole : polygon.holes) std::printf(","), print(points, hole);
    std::printf("]");
    comma = ",";
  }
  std::printf("]}\n");
}
