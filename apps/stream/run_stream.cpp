#include "stream/run_stream.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "stream/budget.h"
#include "stream/cell_counts.h"
#include "stream/input_blocks.h"
#include "stream/manifest.h"
#include "stream/pass_progress.h"
#include "stream/passes.h"
#include "stream/plan_tiles.h"
#include "stream/tile_file.h"

namespace rbpa::app {
namespace {

using Pass = Manifest::Pass;

class Run {
 public:
  Run(const StreamRequest& request, OutputSet& outputs)
      : request_(request), outputs_(outputs), run_key_(run_key_of(request)), scratch_(request) {}

  void run_polygons(const std::function<void(const StreamResult&, const ShowPolygons&)>& use) {
    prepare();
    compute();
    const ShowPolygons show = shown_polygons(request_, manifest_, *polygons_, budget_.sort_bytes, false);
    add_up(show, nullptr, result_);
    use(result_, show);
    scratch_.clear(false);
  }

  StreamResult run(const std::function<void(const StreamResult&)>& before_names) {
    prepare();
    compute();
    result_.compute_seconds = lap();
    write();
    result_.write_seconds = lap();
    before_names(result_);
    // Remove a temporary folder first: a process that is killed from now on leaves no folder. Keep the folder of
    // --scratch until all outputs have their names: the run can be resumed until then.
    if (!request_.scratch) scratch_.clear(request_.keep_tiles);
    outputs_.publish();
    if (request_.scratch) scratch_.clear(request_.keep_tiles);
    return result_;
  }

 private:
  void prepare() {
    begin();
    return_freed_memory(request_.memory, budget_.workers);
    if (manifest_.pass == Pass::count) count();
    result_.count_seconds = lap();
    if (manifest_.pass == Pass::cut) cut();
    cut_smaller(request_, budget_, scratch_, manifest_);
    return_free_pages();  // memory of the points that waited for tiles
    result_.cut_seconds = lap();
  }

  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

  void begin() {
    manifest_.run_key = run_key_;
    budget_ = divide(request_.memory, request_.threads);
    manifest_.workers = budget_.workers;
    if (!scratch_.has_run()) return save(manifest_, scratch_);
    manifest_ = load_manifest(scratch_, run_key_);
    // Use the number of workers of the run that made the tiles: it determined the size of the tiles.
    budget_ = divide(request_.memory, manifest_.workers);
    budget_.workers = std::min(budget_.workers, std::max(request_.threads, 1U));
  }

  void warning(const std::string& text, const std::string& name) {
    if (warnings_.insert(text).second && !request_.quiet) say("rbpa", name + ": " + text);
  }

  void take_crs(const InputBlock& block) {
    const std::string& name = request_.sources[block.file].path;
    if (block.file > 0) require_same_crs(block.about.crs, name, manifest_.facts.crs, request_.sources.front().path);
    manifest_.facts.crs = block.about.crs;
    manifest_.facts.degrees = manifest_.facts.degrees || block.about.degrees;
    for (const std::string& text : block.about.warnings) warning(text, name);
    const bool has_heights = block.about.heights.differ() || is_las(request_.sources[block.file].format);
    if (has_heights && request_.wants(StreamFormat::ply))
      warning("meshes of tiles have z = 0 (rbpa mesh keeps heights, of points that fit into memory)", name);
  }

  void count() {
    CellCounts counts(budget_.cells);
    PackedSample sample;
    {
      PassProgress progress(request_.shows_progress, "1/4 counting", run_key_.bytes());
      for_each_input_block(request_.sources, {}, progress, [&](const InputBlock& block) {
        counts.add(block.points);
        sample.add(block.points, block.first);
        if (block.ends_file) take_crs(block);
      });
    }
    manifest_.points = counts.points();
    manifest_.facts.least = counts.least();
    manifest_.facts.greatest = counts.greatest();
    try {
      TilePlan plan = plan_for(counts);
      manifest_.tree = std::move(plan.tree);
      require_room_for_tiles(scratch_.folder(), plan.points, sample);
    } catch (const TooDense& dense) {
      refuse_dense(dense, request_, budget_);
    }
    manifest_.pass = Pass::cut;
    save(manifest_, scratch_);
  }

  /// Returns the plan of the tiles. Small tiles are fastest unless the tiles have many points around them.
  TilePlan plan_for(const CellCounts& counts) const {
    constexpr std::uint64_t small = 1U << 17U;
    TileLimits limits{budget_.tile_points, std::min(request_.tile_size.value_or(small), budget_.tile_points),
                      reach_of(request_.alpha)};
    while (true) {
      TilePlan plan = plan_tiles(counts, limits);
      constexpr double much = 1.25;
      const bool is_lean = plan.points <= much * static_cast<double>(counts.points());
      if (is_lean || request_.tile_size || limits.owned == budget_.tile_points) return plan;
      limits.owned = std::min(4 * limits.owned, budget_.tile_points);
    }
  }

  void cut() {
    try {
      cut_tiles(request_, budget_, scratch_, manifest_);
    } catch (const Damaged&) {  // a file was damaged after the earlier run
      manifest_.files_done = manifest_.next_index = 0;
      manifest_.tiles.clear();
      cut_tiles(request_, budget_, scratch_, manifest_);
    }
    manifest_.pass = Pass::compute;
    save(manifest_, scratch_);
  }

  void compute() {
    rows_.emplace(scratch_, manifest_.points, budget_.sort_bytes / 2);
    polygons_.emplace(scratch_);
    result_.counts = compute_tiles(request_, budget_, scratch_, manifest_, *rows_, *polygons_);
    result_.tiles = manifest_.tiles.size();
  }

  void write() { write_targets(request_, manifest_, *rows_, *polygons_, budget_.sort_bytes, outputs_, result_); }

  const StreamRequest& request_;
  OutputSet& outputs_;
  RunKey run_key_;
  Scratch scratch_;
  Budget budget_ = {};
  Manifest manifest_ = {};
  std::optional<TriangleRows> rows_ = std::nullopt;
  std::optional<PolygonLog> polygons_ = std::nullopt;
  std::set<std::string> warnings_ = {};
  StreamResult result_ = {};
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

StreamResult run_stream(const StreamRequest& request, OutputSet& outputs,
                        const std::function<void(const StreamResult&)>& before_names) {
  return Run(request, outputs).run(before_names);
}

void use_polygons(const StreamRequest& request,
                  const std::function<void(const StreamResult&, const ShowPolygons&)>& use) {
  OutputSet none;
  Run(request, none).run_polygons(use);
}

}  // namespace rbpa::app
