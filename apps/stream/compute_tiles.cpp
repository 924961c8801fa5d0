#include "stream/compute_tiles.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "stream/compute_state.h"
#include "stream/compute_tile.h"
#include "stream/cut_tiles.h"
#include "stream/pass_progress.h"
#include "stream/tile_file.h"
#include "stream/tile_mesh.h"

namespace rbpa::app {
namespace {

using Clock = std::chrono::steady_clock;

/// How many parts of the tree are done with each tile, in their order, that was the last of them.
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
    begun_ = cleared_ = next_ = state_.tiles_done;
  }

  Computed run() {
    {
      std::vector<std::jthread> others;
      const std::size_t workers = std::min<std::size_t>(budget_.workers, order_.size() - begun_);
      for (std::size_t i = 1; i < workers; ++i) others.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    const WholeComplex rest = finish(std::move(state_.open.front()));
    if (request_.wants_polygons()) polygons_.add(rest.polygons);
    rows_.flush();
    polygons_.flush();
    return {rest.counts};
  }

 private:
  void work() {
    try {
      while (const std::optional<std::size_t> position = take()) {
        PartialAndItems made = compute(order_[*position]);
        if (!hand_in(*position, std::move(made))) return;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      turned_.notify_all();
    }
  }

  /// The open part agrees with the tree of tiles.
  void require_plausible() const {
    std::size_t open = 0;
    for (std::size_t i = 0; i < std::min(state_.tiles_done, ends_.size()); ++i) open = open + 1 - ends_[i];
    if (state_.tiles_done > 0 && state_.tiles_done <= ends_.size() && state_.open.size() == open) return;
    bad_input(scratch_.progress(), "the progress of another run",
              "that of this one; remove " + scratch_.folder() + " and begin anew");
  }

  std::optional<std::size_t> take() {
    const std::lock_guard lock(mutex_);
    if (failure_ || next_ == order_.size()) return std::nullopt;
    return next_++;
  }

  /// The thread that has the next tile commits it and those that follow; others go on with further tiles meanwhile.
  /// Returns false when a run has failed.
  bool hand_in(std::size_t position, PartialAndItems made) {
    // The result of a small tile is small against the memory in which a tile is computed.
    const bool is_small = manifest_.tiles[order_[position]].points <= budget_.tile_points / 8;
    std::unique_lock lock(mutex_);
    turned_.wait(lock, [&] {
      return failure_ || state_.tiles_done == position || (is_small && ready_.size() < budget_.workers);
    });
    if (failure_) return false;
    ready_.emplace(position, std::move(made));
    if (is_committing_) return true;
    is_committing_ = true;
    while (!failure_ && !ready_.empty() && ready_.begin()->first == state_.tiles_done) {
      auto next = ready_.extract(ready_.begin());
      lock.unlock();
      commit(next.key(), std::move(next.mapped()));
      lock.lock();
      ++state_.tiles_done;
      turned_.notify_all();
    }
    is_committing_ = false;
    return !failure_;
  }

  /// The points of the file of a tile, which is made again when it is damaged.
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
    if (reader.summary() != manifest_.tiles[tile]) throw Damaged(scratch_.tile(tile) + ": found another tile");
    return read_tile(reader);
  }

  bool wants_triangles() const { return request_.wants(StreamFormat::npy) || request_.wants(StreamFormat::ply); }

  PartialAndItems compute(std::uint32_t tile) {
    stop_if_interrupted();
    const IndexedPoints points = points_of(tile);
    const TileWork work{request_.alpha, budget_.workers > 1 ? 1 : request_.threads, wants_triangles()};
    PartialAndItems made = compute_tile(manifest_.tree.box(tile), points, work);
    for (const StreamTarget& target : request_.targets)
      if (target.format == StreamFormat::ply)
        write_tile_mesh(tile_mesh_path(target.path, tile), points, made.owned.triangles);
    return made;
  }

  /// In the order of tiles, one at a time.
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
  }

  /// Finished polygons are written to files, or dropped where none are requested: otherwise memory would only grow.
  void keep_finished(Partial& partial) {
    const Finished finished = take_finished(partial);
    if (!request_.wants_polygons()) return;
    polygons_.add(finished.polygons);
    polygons_.add(finished.holes);
  }

  /// So rarely that it costs a small part of the time.
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
  ComputeState state_ = {};  // of who commits; tiles_done of the mutex as well
  std::mutex cutting_, mutex_;
  std::condition_variable turned_;
  // Of the mutex:
  std::size_t next_ = 0;
  std::map<std::size_t, PartialAndItems> ready_ = {};  // computed, by position
  bool is_committing_ = false;
  std::exception_ptr failure_ = nullptr;
  PassProgress progress_;
};

}  // namespace

Computed compute_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
                       TriangleRows& rows, PolygonLog& polygons) {
  return Computation(request, budget, scratch, manifest, rows, polygons).run();
}

}  // namespace rbpa::app
