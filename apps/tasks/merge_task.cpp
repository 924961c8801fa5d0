#include "tasks/merge_task.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

#include "io/bytes/npy.h"
#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "stream/budget.h"
#include "stream/passes.h"
#include "stream/scratch.h"

namespace rbpa::app {
namespace {

/// Throws BadInput naming the file.
void require_same_run(const PartialFile& file, const std::string& path, const RunFacts& run, const std::string& first) {
  if (file.run.alpha != run.alpha)
    bad_input(path, "a partial for alpha " + text_of(file.run.alpha), text_of(run.alpha) + " as " + first + " has");
  if (file.run.id != run.id)
    bad_input(path, "a partial of run " + shown(file.run.id), "one of run " + shown(run.id) + " as " + first + " is");
}

/// Partials two by two: neighbours first, and never more at a time than a logarithm of their number.
class Merger {
 public:
  void add(Partial partial) {
    parts_.push_back(std::move(partial));
    for (std::size_t done = ++count_; done % 2 == 0; done /= 2) join();
  }
  Partial all() {
    while (parts_.size() > 1) join();
    return parts_.empty() ? Partial() : std::move(parts_.front());
  }

 private:
  void join() {
    stop_if_interrupted();
    Partial second = std::move(parts_.back());
    parts_.pop_back();
    parts_.back() = merge(std::move(parts_.back()), std::move(second));
  }

  std::vector<Partial> parts_ = {};
  std::size_t count_ = 0;
};

template <typename Index>
void add_rows(std::string_view bytes, std::uint64_t points, const std::string& path, TriangleRows& rows) {
  std::vector<TriangleRow> some;
  for (std::size_t at = 0; at + 3 * sizeof(Index) <= bytes.size(); at += 3 * sizeof(Index)) {
    Index row[3];
    std::memcpy(row, bytes.data() + at, sizeof row);
    if (row[0] >= points)
      bad_input(path, "an index of " + std::to_string(row[0]), "one of " + counted(points, "point"));
    some.push_back({row[0], row[1], row[2]});
  }
  rows.add(some);
}

void add_triangles(const SideFile& file, std::uint64_t points, TriangleRows& rows) {
  const std::size_t row_bytes = rows.are_short() ? 12 : 24;
  const std::string header = npy_header(rows.are_short() ? "<u4" : "<u8", file.items, ", 3");
  if (file.bytes != header.size() + file.items * row_bytes)
    bad_input(file.path, std::to_string(file.bytes) + " bytes", counted(file.items, "triangle") + " as .npy");
  std::size_t skip = header.size();
  std::string left;  // of a row whose rest comes with the next piece
  for_each_piece(file, [&](std::string_view piece) {
    const std::size_t skipped = std::min(skip, piece.size());
    skip -= skipped;
    left += piece.substr(skipped);
    const std::size_t whole = left.size() - left.size() % row_bytes;
    const std::string_view bytes = std::string_view(left).substr(0, whole);
    rows.are_short() ? add_rows<std::uint32_t>(bytes, points, file.path, rows)
                     : add_rows<std::uint64_t>(bytes, points, file.path, rows);
    left.erase(0, whole);
  });
}

void require_all_tiles(const PartialFile& whole) {
  const std::uint64_t missing = whole.run.tiles - std::min(whole.tiles.size(), whole.run.tiles);
  if (missing == 0) return;
  const std::string others = missing == 1 ? "" : " nor " + std::to_string(missing - 1) + " more";
  throw BadInput("found no tile " + std::to_string(whole.tiles.first_missing()) + others +
                 " in the partials, expected all " + std::to_string(whole.run.tiles) + " of the run");
}

void require_triangles(const PartialFile& whole, std::uint64_t triangles) {
  std::uint64_t found = 0;
  for (const SideFile& file : whole.files)
    if (file.kind == SideFile::Kind::triangles) found += file.items;
  if (found != triangles)
    throw BadInput("found files with " + std::to_string(found) + " of " + counted(triangles, "triangle") +
                   ", expected all for .npy: rbpa tile writes those of a tile with a second -o, for a .npy");
}

}  // namespace

PartialFile merge_files(const std::vector<std::string>& paths) {
  PartialFile merged;
  Merger merger;
  std::vector<std::pair<TileSet, std::size_t>> before;
  std::string now;
  try {
    for (const std::string& path : paths) {
      stop_if_interrupted();
      now = path;
      PartialFile file = read_partial(path);
      if (before.empty()) merged.run = file.run;
      require_same_run(file, path, merged.run, paths.front());
      if (common(merged.tiles, file.tiles))
        for (const auto& [tiles, which] : before)
          if (const std::optional<std::uint32_t> twice = common(tiles, file.tiles))
            bad_input(path, "tile " + std::to_string(*twice) + ", which " + paths[which] + " has too",
                      "partials of different tiles");
      merged.tiles = merged.tiles + file.tiles;
      merged.files.insert(merged.files.end(), std::make_move_iterator(file.files.begin()),
                          std::make_move_iterator(file.files.end()));
      merger.add(std::move(file.partial));
      before.emplace_back(std::move(file.tiles), before.size());
    }
    now = "partials";
    merged.partial = merger.all();
  } catch (const InvalidInput& error) {
    throw BadInput(now + ": found partials that do not belong together (" + error.what() +
                   "), expected those of one run");
  }
  return merged;
}

StreamResult finish_run(const StreamRequest& request, PartialFile whole, OutputSet& outputs,
                        const std::function<void(const StreamResult&)>& before_names) {
  StreamResult result;
  require_all_tiles(whole);
  WholeComplex rest;
  try {
    rest = finish(std::move(whole.partial));
  } catch (const InvalidInput& error) {
    throw BadInput(std::string("partials: ") + error.what());
  }
  result.counts = rest.counts;
  result.tiles = whole.run.tiles;
  const std::uint64_t points = whole.run.points;
  if (rest.counts.points != points)
    throw BadInput("found " + counted(rest.counts.points, "point") + " in the partials, expected the " +
                   std::to_string(points) + " of the run: the file of a tile is another run's");
  if (request.wants(StreamFormat::npy)) require_triangles(whole, rest.counts.triangles);

  Scratch scratch(request);
  const Budget budget = divide(request.memory, 1);
  TriangleRows rows(scratch, points, budget.sort_bytes / 2);
  PolygonLog polygons(scratch);
  for (const SideFile& file : whole.files) {
    if (file.kind == SideFile::Kind::triangles) {
      if (request.wants(StreamFormat::npy)) add_triangles(file, points, rows);
    } else if (request.wants_polygons()) {
      for_each_piece(file, [&](std::string_view bytes) {
        file.kind == SideFile::Kind::polygons ? polygons.add_polygon_records(bytes) : polygons.add_hole_records(bytes);
      });
    }
  }
  if (request.wants_polygons()) polygons.add(rest.polygons);
  rows.flush();
  polygons.flush();
  write_targets(request, whole.run.of_points, rows, polygons, budget.sort_bytes, outputs, result);
  before_names(result);
  scratch.clear(false);  // before: a kill in between leaves nothing
  outputs.publish();
  return result;
}

}  // namespace rbpa::app
