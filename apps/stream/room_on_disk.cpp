#include "stream/room_on_disk.h"

#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <numeric>

#include "io/failure.h"
#include "io/progress_line.h"
#include "stream/pack_block.h"

namespace rbpa::app {
namespace {

void require(std::uint64_t free, double needed, const std::string& where, const std::string& what) {
  if (static_cast<double>(free) >= needed) return;
  throw Failure(where + ": found " + short_number(static_cast<double>(free)) + "B free on its disk, expected " +
                short_number(needed) + "B for " + what);
}

}  // namespace

void PackedSample::add(std::span<const Point> points, std::uint64_t first) {
  if (points.empty()) return;
  // The first blocks, and from then on ever fewer.
  if (blocks_++ < 2 * taken_ && taken_ > 8) return;
  ++taken_;
  const std::span<const Point> some = points.first(std::min(points.size(), most_in_packed_block));
  std::vector<std::uint64_t> indices(some.size());
  std::iota(indices.begin(), indices.end(), first);
  PackingHint hint;
  std::string bytes;
  pack_block(some, indices, hint, bytes);
  points_ += some.size();
  bytes_ += bytes.size();
}

double PackedSample::bytes_per_point() const {
  return points_ == 0 ? 0 : static_cast<double>(bytes_) / static_cast<double>(points_);
}

void require_room_for_tiles(const Scratch& scratch, double points, const PackedSample& sample) {
  // In a tile, indices of points are farther apart, and coordinates nearer to each other: not less than this.
  require(scratch.free_bytes(), points * sample.bytes_per_point() * 0.8, scratch.folder(), "the files of tiles");
}

void require_room_for_output(const std::string& path, std::uint64_t bytes) {
  struct stat file {};
  if (path == "-" || (stat(path.c_str(), &file) == 0 && !S_ISREG(file.st_mode))) return;
  const std::string folder = path.rfind('/') == std::string::npos ? "." : path.substr(0, path.rfind('/') + 1);
  struct statvfs status {};
  if (statvfs(folder.c_str(), &status) != 0) return;
  require(std::uint64_t{status.f_bavail} * status.f_frsize, static_cast<double>(bytes), path, "the triangles");
}

}  // namespace rbpa::app
