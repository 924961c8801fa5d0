#include "stream/compute_tile.h"

#include <algorithm>
#include <array>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/interrupt.h"
#include "io/mesh/write_triangles.h"
#include "stream/scratch_file.h"

namespace rbpa::app {

PartialAndItems compute_tile(const Region& region, const IndexedPoints& points, double alpha, unsigned threads,
                             bool wants_triangles) {
  PartialOptions options{.threads = threads};
  options.progress = [](const Progress&) { return !interrupted(); };
  const RegionPoints given{points.points, points.indices};
  if (!wants_triangles) return {partial(region, given, alpha, options), {}};
  return partial_and_items(region, given, alpha, options);
}

std::string tile_mesh_path(const std::string& pattern, std::uint32_t tile) {
  std::string path = pattern;
  return path.replace(path.rfind('*'), 1, file_number(tile));
}

void write_tile_mesh(const std::string& path, const IndexedPoints& points, std::span<const TriangleRow> triangles) {
  std::vector<std::uint64_t> used;
  for (const TriangleRow& triangle : triangles) used.insert(used.end(), triangle.begin(), triangle.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto place = [](const std::vector<std::uint64_t>& sorted, std::uint64_t index) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), index) - sorted.begin());
  };
  std::vector<Point> vertices;
  for (const std::uint64_t index : used) vertices.push_back(points.points[place(points.indices, index)]);
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (const TriangleRow& triangle : triangles) {
    std::array<std::uint32_t, 3>& face = faces.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) face[k] = static_cast<std::uint32_t>(place(used, triangle[k]));
  }
  OutputSet outputs;
  OutputFile& file = outputs.add(path);
  write_triangles(file, Format::ply, {vertices, faces, {}, {}});
  file.finish();
  outputs.publish();
}

}  // namespace rbpa::app
