// What a user writes who wants triangles and no mesh.
#include <cstdio>
#include <vector>

#include "rbpa/triangulate.h"

int main() {
  const std::vector<rbpa::Point> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {9, 9}};
  rbpa::TriangulationOptions options;
  options.neighbors = true;
  const rbpa::Triangulation found = rbpa::triangulate(points, 1, options);
  const bool is_right = found.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 3}, {1, 2, 3}} &&
                        found.neighbors[0][0] == 1 && found.neighbors[1][1] == 0 &&
                        found.isolated == std::vector<std::uint32_t>{4};
  std::puts(is_right ? "two triangles" : "not what is expected");
  return is_right ? 0 : 1;
}
