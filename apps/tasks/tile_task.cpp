#include "tasks/tile_task.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "io/bytes/npy.h"
#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "stream/compute_tile.h"
#include "stream/triangle_rows.h"
#include "tasks/partial_file.h"

namespace rbpa::app {
namespace {

namespace fs = std::filesystem;

/// 12 of "DIR/tiles/000012.tile".
std::uint32_t number_of(const fs::path& tile) {
  const std::string name = tile.stem().string();
  const bool is_number = !name.empty() && name.size() < 10 &&
                         std::all_of(name.begin(), name.end(), [](char c) { return '0' <= c && c <= '9'; });
  if (tile.extension() != ".tile" || !is_number)
    bad_input(tile.string(), "a name that is no tile's", "the file of a tile, such as DIR/tiles/000012.tile");
  return static_cast<std::uint32_t>(std::stoul(name));
}

/// "DIR/run.json" of "DIR/tiles/000012.tile".
std::string facts_path(const fs::path& tile) {
  return (fs::absolute(tile).lexically_normal().parent_path().parent_path() / "run.json").string();
}

template <typename Index>
void write_rows(SideOutput& file, std::span<const TriangleRow> triangles) {
  std::vector<std::array<Index, 3>> rows;
  constexpr std::size_t some = 1U << 14U;
  for (std::size_t first = 0; first < triangles.size(); first += some) {
    rows.clear();
    for (const TriangleRow& row : triangles.subspan(first, std::min(some, triangles.size() - first)))
      rows.push_back({static_cast<Index>(row[0]), static_cast<Index>(row[1]), static_cast<Index>(row[2])});
    file.write({reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(rows[0])});
  }
}

SideFile write_triangles(OutputSet& outputs, const std::string& path, std::span<const TriangleRow> triangles,
                         std::uint64_t points) {
  SideOutput file(outputs, SideFile::Kind::triangles, path);
  const bool is_short = have_short_indices(points);
  file.write(npy_header(is_short ? "<u4" : "<u8", triangles.size(), ", 3"));
  is_short ? write_rows<std::uint32_t>(file, triangles) : write_rows<std::uint64_t>(file, triangles);
  return file.finish(triangles.size());
}

}  // namespace

TileDone run_tile(const TileRequest& request, OutputSet& outputs) {
  auto start = std::chrono::steady_clock::now();
  const auto lap = [&] {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start, now)).count();
  };
  try {
    const RunFacts run = load_run_facts(facts_path(request.tile));
    const std::uint32_t number = number_of(request.tile);
    TileReader reader(request.tile);
    const auto text = [](double value) { return std::string(std::string_view(ShortestText(value))); };
    if (number >= run.tiles) bad_input(request.tile, "tile " + std::to_string(number), counted(run.tiles, "tile"));
    if (reader.alpha() != run.alpha)
      bad_input(request.tile, "a tile cut for alpha " + text(reader.alpha()), text(run.alpha) + " as its run has");
    const IndexedPoints points = read_tile(reader);
    TileDone done{.number = number, .alpha = run.alpha, .around = reader.summary().points - reader.summary().owned};
    done.read_seconds = lap();

    PartialAndItems made =
        compute_tile(reader.box(), points, run.alpha, request.threads, request.mesh || request.triangles);
    done.counts = made.partial.counts();
    PartialFile partial{.run = run, .tiles = TileSet(number), .partial = std::move(made.partial)};
    done.compute_seconds = lap();

    if (request.mesh) write_tile_mesh(*request.mesh, points, made.owned.triangles);
    if (request.triangles)
      partial.files.push_back(write_triangles(outputs, *request.triangles, made.owned.triangles, run.points));
    if (request.partial) add_partial(outputs, *request.partial, std::move(partial));
    return done;
  } catch (const Damaged& damaged) {
    throw BadInput(std::string(damaged.what()) + "; rbpa stream --tasks with --resume makes it again");
  }
}

}  // namespace rbpa::app
