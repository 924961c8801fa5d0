#include "stream/passes.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_triangles.h"
#include "rbpa/base/join_in_order.h"
#include "rbpa/plane/partial.h"
#include "rbpa/plane/partial_bytes.h"
#include "stream/pass_progress.h"
#include "stream/scratch_file.h"
#include "stream/tile_file.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

/// Computes the tile whose box is `region`, by at most `threads` threads. PartialAndItems::owned, the triangles that
/// belong to this tile and no other, is empty unless `wants_triangles`.
/// Requires: `points` contains all points of the file of the tile.
/// Throws:   InvalidInput as partial() does; Cancelled.
PartialAndItems compute_tile(const Region& region, const IndexedPoints& points, double alpha, unsigned threads,
                             bool wants_triangles) {
  PartialOptions options{.threads = threads};
  options.progress = [](const Progress&) { return !interrupted(); };
  const RegionPoints given{points.points, points.indices};
  if (!wants_triangles) return {partial(region, given, alpha, options), {}};
  return partial_and_items(region, given, alpha, options);
}

/// Returns the path of the mesh of a tile, with its number for the last '*': "tiles/000012.ply" for "tiles/*.ply".
std::string tile_mesh_path(const std::string& pattern, std::uint32_t tile) {
  std::string path = pattern;
  return path.replace(path.rfind('*'), 1, file_number(tile));
}

/// Writes a PLY file of `triangles` and the points that they use, in the order of the point indices. Requires: `points`
/// contains all points that triangles use. Throws Failure, Cancelled.
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

void write_partials(const std::vector<Partial>& partials, const std::string& path) {
  ScratchFile file(path, ScratchFile::Mode::write);
  for (const Partial& partial : partials) {
    const std::vector<std::uint8_t> bytes = to_bytes(partial);
    const std::uint64_t size = bytes.size();
    file.write({reinterpret_cast<const char*>(&size), sizeof size});
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
}

std::vector<Partial> read_partials(const std::string& path, std::size_t count) {
  const std::string bytes = scratch_content(path);
  std::vector<Partial> partials;
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t size = 0;
    if (bytes.size() - at < sizeof size) throw std::runtime_error(path + " is cut off");
    std::memcpy(&size, bytes.data() + at, sizeof size);
    at += sizeof size;
    if (bytes.size() - at < size) throw std::runtime_error(path + " is cut off");
    partials.push_back(partial_from_bytes({reinterpret_cast<const std::uint8_t*>(bytes.data()) + at, size}));
    at += size;
  }
  return partials;
}

/// The progress of the computation, which is saved in files of scratch, completely or not at all: progress.json names
/// the file with the open parts only when that file is complete.
struct ComputeState {
  std::uint64_t generation = 0;
  std::size_t tiles_done = 0;  ///< number of computed tiles, in the order of the tree
  std::uint64_t points_done = 0;
  std::vector<Partial> open = {};  ///< results of parts of the tree that are not merged with others yet
  RowsState rows = {};
  LogState polygons = {};
};

void save(const ComputeState& state, const Scratch& scratch) {
  write_partials(state.open, scratch.partials(state.generation));
  const Json json = {{"generation", state.generation},
                     {"tiles_done", state.tiles_done},
                     {"points_done", state.points_done},
                     {"open", state.open.size()},
                     {"rows", state.rows.rows},
                     {"sums", state.rows.sums},
                     {"polygons", {state.polygons.polygons.bytes, state.polygons.polygons.checksum}},
                     {"holes", {state.polygons.holes.bytes, state.polygons.holes.checksum}}};
  replace_checked(scratch.progress(), json.dump());
  if (state.generation > 0) unlink(scratch.partials(state.generation - 1).c_str());
}

/// Returns the saved state, or nothing if no state was saved. Throws BadInput if a file is damaged.
std::optional<ComputeState> load_state(const Scratch& scratch) {
  const std::string text = checked_content(scratch.progress());
  if (text.empty()) return std::nullopt;
  try {
    const Json json = Json::parse(text);
    ComputeState state{.generation = json.at("generation"),
                       .tiles_done = json.at("tiles_done"),
                       .points_done = json.at("points_done")};
    state.open = read_partials(scratch.partials(state.generation), json.at("open"));
    state.rows = {json.at("rows"), json.at("sums")};
    const auto log = [&](const char* name) { return RecordState{json.at(name).at(0), json.at(name).at(1)}; };
    state.polygons = {log("polygons"), log("holes")};
    return state;
  } catch (const std::exception& error) {
    begin_anew(scratch.progress(), "no progress of rbpa stream (" + std::string(error.what()) + "), expected one",
               scratch.folder());
  }
}

/// Returns for each tile, in the order of the tree, the number of cut parts of the tree whose last tile it is.
std::vector<unsigned> parts_that_end(const TileTree& tree) {
  std::vector<unsigned> ends;
  const auto visit = [&](const auto& self, std::uint32_t at, unsigned above) -> void {
    const TileTree::Part& part = tree.parts()[at];
    if (part.kind == TileTree::Part::Kind::tile) {
      ends.push_back(above);
      return;
    }
    self(self, part.first, 0);
    self(self, part.second, above + 1);
  };
  visit(visit, 0, 0);
  return ends;
}

class Computation {
 public:
  Computation(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
              TriangleRows& rows, PolygonLog& polygons)
      : request_(request),
        budget_(budget),
        scratch_(scratch),
        manifest_(manifest),
        rows_(rows),
        polygons_(polygons),
        order_(manifest.tree.order()),
        ends_(parts_that_end(manifest.tree)),
        progress_(request.shows_progress, "3/4 computing", manifest.points) {
    if (std::optional<ComputeState> state = load_state(scratch)) {
      state_ = std::move(*state);
      require_plausible();
      rows_.resume(state_.rows);
      polygons_.resume(state_.polygons);
    } else {
      scratch.clear_rows();
    }
    begun_ = cleared_ = state_.tiles_done;
  }

  PartialCounts run() {
    const auto tile = [&](std::size_t i) { return order_[begun_ + i]; };
    // Treat a tile as small if its result takes little memory compared with computing a tile.
    const auto is_small = [&](std::size_t i) { return manifest_.tiles[tile(i)].points <= budget_.tile_points / 8; };
    join_in_order(
        budget_.workers, order_.size() - begun_, [&](std::size_t i) { return compute(tile(i)); }, is_small,
        [&](std::size_t i, PartialAndItems made) { commit(begun_ + i, std::move(made)); });
    const WholeComplex rest = finish(std::move(state_.open.front()));
    if (request_.wants_polygons()) polygons_.add(rest.polygons);
    rows_.flush();
    polygons_.flush();
    return rest.counts;
  }

 private:
  /// Throws BadInput unless the number of open parts is the one that the tree has after tiles_done tiles.
  void require_plausible() const {
    std::size_t open = 0;
    for (std::size_t i = 0; i < std::min(state_.tiles_done, ends_.size()); ++i) open = open + 1 - ends_[i];
    if (state_.tiles_done > 0 && state_.tiles_done <= ends_.size() && state_.open.size() == open) return;
    begin_anew(scratch_.progress(), "the progress of another run", scratch_.folder());
  }

  /// Returns the points of a tile. Makes the file of the tile again if it is damaged.
  IndexedPoints points_of(std::uint32_t tile) {
    try {
      return read(tile);
    } catch (const Damaged&) {
      const std::lock_guard lock(cutting_);
      cut_again(request_, budget_, scratch_, manifest_, tile);
      save(manifest_, scratch_);
      return read(tile);
    }
  }
  IndexedPoints read(std::uint32_t tile) const {
    TileReader reader(scratch_.tile(tile), manifest_.tree.box(tile), request_.alpha);
    if (reader.summary() != manifest_.tiles[tile])
      throw Damaged(scratch_.tile(tile) + ": found another tile than manifest.json lists");
    return read_tile(reader);
  }

  bool wants_triangles() const { return request_.wants(StreamFormat::npy) || request_.wants(StreamFormat::ply); }

  PartialAndItems compute(std::uint32_t tile) {
    stop_if_interrupted();
    const IndexedPoints points = points_of(tile);
    PartialAndItems made = compute_tile(manifest_.tree.box(tile), points, request_.alpha,
                                        budget_.workers > 1 ? 1 : request_.threads, wants_triangles());
    for (const StreamTarget& target : request_.targets)
      if (target.format == StreamFormat::ply)
        write_tile_mesh(tile_mesh_path(target.path, tile), points, made.owned.triangles);
    return made;
  }

  /// Merges the result of a tile into the open parts. Requires: calls in the order of the tiles, one at a time.
  void commit(std::size_t position, PartialAndItems made) {
    if (request_.wants(StreamFormat::npy)) rows_.add(made.owned.triangles);
    made.owned = {};
    state_.open.push_back(std::move(made.partial));
    for (unsigned i = 0; i < ends_[position]; ++i) {
      stop_if_interrupted();
      Partial second = std::move(state_.open.back());
      state_.open.pop_back();
      Partial& first = state_.open.back();
      first = merge(std::move(first), std::move(second));
      keep_finished(first);
    }
    if (ends_[position] == 0) keep_finished(state_.open.back());
    state_.points_done += manifest_.tiles[order_[position]].owned;
    progress_.at(state_.points_done, state_.points_done);
    if (is_time_to_save(position)) save_progress(position + 1);
    state_.tiles_done = position + 1;
  }

  /// Moves finished polygons and holes from `partial` to files, or drops them if no polygons are requested. Memory then
  /// does not grow with the number of polygons.
  void keep_finished(Partial& partial) {
    const Finished finished = take_finished(partial);
    if (!request_.wants_polygons()) return;
    polygons_.add(finished.polygons);
    polygons_.add(finished.holes);
  }

  /// Returns whether to save the progress now. Saves are so rare that they take about a twentieth of the time. Returns
  /// false without --scratch and after the last tile.
  bool is_time_to_save(std::size_t position) const {
    if (!request_.scratch || position + 1 == order_.size()) return false;
    constexpr int part = 20;
    return Clock::now() - saved_ > std::max<Clock::duration>(part * time_of_save_, std::chrono::milliseconds(50));
  }
  void save_progress(std::size_t done) {
    const Clock::time_point start = Clock::now();
    ComputeState now{.generation = state_.generation + 1, .tiles_done = done, .points_done = state_.points_done};
    now.open.swap(state_.open);
    now.rows = rows_.flush();
    now.polygons = polygons_.flush();
    save(now, scratch_);
    state_.generation = now.generation;
    state_.open.swap(now.open);
    for (; !request_.keep_tiles && cleared_ < done; ++cleared_) unlink(scratch_.tile(order_[cleared_]).c_str());
    saved_ = Clock::now();
    time_of_save_ = saved_ - start;
  }

  const StreamRequest& request_;
  const Budget& budget_;
  const Scratch& scratch_;
  Manifest& manifest_;
  TriangleRows& rows_;
  PolygonLog& polygons_;
  std::vector<std::uint32_t> order_;
  std::vector<unsigned> ends_;
  std::size_t begun_ = 0, cleared_ = 0;
  Clock::time_point saved_ = Clock::now();
  Clock::duration time_of_save_{0};
  ComputeState state_ = {};
  std::mutex cutting_;
  PassProgress progress_;
};

}  // namespace

PartialCounts compute_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch,
                            Manifest& manifest, TriangleRows& rows, PolygonLog& polygons) {
  return Computation(request, budget, scratch, manifest, rows, polygons).run();
}

}  // namespace rbpa::app
