#include "tiles/stream_groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/box.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/write_shapes.h"
#include "plane/named_groups.h"
#include "rbpa/plane/collinear.h"
#include "rbpa/plane/groups.h"
#include "shared/arguments.h"
#include "shared/stats.h"
#include "stream/budget.h"
#include "stream/group_points.h"
#include "stream/input_blocks.h"
#include "stream/manifest.h"
#include "stream/pass_progress.h"
#include "stream/run_stream.h"
#include "stream/scratch.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

/// Tests whether all points, given block by block, are on one line.
class OnLine {
 public:
  void add(std::span<const Point> points) {
    if (!are_on_line_) return;
    std::vector<Point> all = first_;  // at most two distinct points of earlier blocks
    all.insert(all.end(), points.begin(), points.end());
    are_on_line_ = are_collinear(all, until_interrupted());
    for (const Point& p : points)
      if (first_.size() < 2 && (first_.empty() || p != first_.front())) first_.push_back(p);
  }
  bool are_on_line() const { return are_on_line_; }

 private:
  std::vector<Point> first_ = {};
  bool are_on_line_ = true;
};

/// Adds up polygons of all groups.
class Totals final : public PolygonSink {
 public:
  void begin(const PolygonFacts& facts) override {
    ++polygons;
    sums.add(facts.holes, facts.area, facts.perimeter);
  }
  void ring(std::span<const Point>) override {}
  void end() override {}
  void finish() override {}

  std::uint64_t polygons = 0;
  RunningTotals sums = {};
};

class GroupStream {
 public:
  GroupStream(const StreamRequest& request, Run& run)
      : request_(request),
        run_(run),
        scratch_(request),
        budget_(divide(request.memory, request.threads)),
        points_(scratch_.groups(), budget_.sort_bytes / bytes_of_waiting) {
    if (scratch_.has_run())
      bad_usage("--group-by", "another run in " + scratch_.folder(), "an empty folder, or --scratch with a new name");
    constexpr std::uint64_t most_at_once = 1U << 28U;
    most_ = std::min({request.tile_size.value_or(most_at_once), budget_.tile_points, most_at_once});
  }

  void run() {
    return_freed_memory(request_.memory, budget_.workers);
    part();
    stats_.read_seconds = run_.lap();
    compute();
    stats_.build_seconds = run_.lap();
    report();
  }

 private:
  static constexpr std::uint64_t bytes_of_waiting = 64;  // a point that waits, while all are sorted by group

  /// Returns two corners of the box of all points; none without points.
  std::vector<Point> corners() const {
    return stats_.points > 0 ? std::vector{box_.least, box_.greatest} : std::vector<Point>{};
  }
  std::string input() const {
    const std::size_t files = request_.sources.size();
    return files == 1 ? request_.sources.front().path : counted(files, "file");
  }
  std::span<const std::uint32_t> parts_of(std::size_t group) const { return named_.groups[group]; }
  std::uint64_t size_of(std::size_t group) const {
    std::uint64_t size = 0;
    for (const std::uint32_t part : parts_of(group)) size += points_.size(part);
    return size;
  }
  void read(std::size_t group, const std::function<void(std::span<const Point>)>& visit) const {
    for (const std::uint32_t part : parts_of(group)) points_.read(part, visit);
  }

  /// Stores the points of each file by their keys, and finds the names of groups. A point of a PointFile stands for all
  /// points of the file with the same keys.
  void part() {
    PassProgress progress(request_.shows_progress, "1/2 sorting by group", run_key_of(request_).bytes());
    std::vector<PointFile> files;
    std::map<std::vector<double>, std::uint32_t> numbers;  // of the points with the same keys in this file
    std::vector<std::vector<double>> fields;
    std::set<std::string> warnings;
    const std::size_t keys = request_.sources.front().where->columns();
    std::vector<double> key(keys);
    for_each_input_block(request_.sources, {}, progress, [&](const InputBlock& block) {
      fields.resize(keys);
      for (std::size_t i = 0; i < block.points.size(); ++i) {
        const Point& p = block.points[i];
        box_.add(p);
        for (std::size_t k = 0; k < keys; ++k) key[k] = block.fields[k][i];
        if (std::any_of(key.begin(), key.end(), [](double value) { return std::isnan(value); })) continue;
        const auto [place, is_new] = numbers.try_emplace(key, 0);
        if (is_new) {
          place->second = points_.add_group();
          for (std::size_t k = 0; k < keys; ++k) fields[k].push_back(key[k]);
        }
        points_.add(place->second, p);
      }
      stats_.points += block.points.size();
      if (!block.ends_file) return;
      for (const std::string& text : block.about.warnings)
        if (warnings.insert(text).second) run_.summarize(request_.sources[block.file].path + ": " + text);
      PointFile& file = files.emplace_back(block.about);
      file.points.resize(numbers.size());
      file.fields = std::exchange(fields, {});
      file.index.clear();
      numbers.clear();
    });
    points_.flush();
    named_ = groups_in({.files = request_.sources}, std::move(files));
    std::uint64_t in_groups = 0;
    for (std::size_t g = 0; g < named_.groups.size(); ++g) in_groups += size_of(g);
    for (const std::string& text : warnings_on(stats_.points - in_groups)) run_.summarize(input() + ": " + text);
  }

  void compute() {
    const bool cuts = is_cut_in_geojson(corners(), named_.file.crs, named_.file.degrees);
    std::vector<OutputFile*> files;
    for (const StreamTarget& target : request_.targets) {
      files.push_back(&run_.files().add(target.path));
      writers_.push_back(std::make_unique<GroupsWriter>(*files.back(), named_.file.crs, cuts));
    }
    attributes_ = key_attributes(named_);
    PassProgress progress(request_.shows_progress, "2/2 shapes of groups", stats_.points);
    std::uint64_t done = 0;
    for (std::size_t g = 0; g < named_.names.size(); progress.at(done, done)) {
      stop_if_interrupted();
      const std::size_t first = g;
      std::uint64_t points = 0;
      while (g < named_.names.size() && size_of(g) <= most_ - points) points += size_of(g++);
      if (g > first) {
        shape(first, g);
      } else {
        points = size_of(g);
        stream(g++);
      }
      done += points;
    }
    for (const auto& writer : writers_) writer->finish();
    for (OutputFile* file : files) file->finish();
  }

  void problem_of(std::size_t group, const std::string& what) {
    if (problems_++ == 0) first_problem_ = in_quotes(named_.names[group]) + ", " + what;
  }

  /// Writes the shapes of the groups from `first` to before `last`, which fit into memory together.
  void shape(std::size_t first, std::size_t last) {
    std::vector<Point> points;
    Groups groups;
    std::vector<std::size_t> sizes;
    for (std::size_t g = first; g < last; ++g) {
      const std::size_t before = points.size();
      read(g, [&](std::span<const Point> some) { points.insert(points.end(), some.begin(), some.end()); });
      sizes.push_back(points.size() - before);
      groups.offsets.push_back(points.size());
    }
    for (std::uint32_t i = 0; i < points.size(); ++i) groups.members.push_back(i);
    GroupShapesOptions options;
    options.threads = request_.threads;
    options.go_on = [go_on = until_interrupted()](std::size_t) { return go_on(); };
    options.filter = request_.filter;
    const GroupShapes shapes = shapes_of_groups(points, groups, {.given = {&request_.alpha, 1}}, options);
    const NamedShapes named{points,
                            std::span(named_.names).subspan(first, last - first),
                            named_.are_numbers,
                            sizes,
                            shapes,
                            named_.file.crs,
                            named_.file.degrees,
                            attributes_,
                            first};
    for (const auto& writer : writers_) write_groups(*writer, named);
    triangles_ += shapes.triangle_begin.back();
    for (const Polygon& polygon : shapes.polygons)
      totals_.begin({.area = polygon.area, .perimeter = polygon.perimeter, .holes = polygon.holes.size()});
    for (const GroupProblem& problem : shapes.problems) problem_of(first + problem.group, problem.what);
  }

  /// Writes the shape of a group that is computed through tiles.
  void stream(std::size_t group) {
    OnLine line;
    {
      ScratchFile file(scratch_.group_points(), ScratchFile::Mode::write);
      read(group, [&](std::span<const Point> some) {
        line.add(some);
        file.write({reinterpret_cast<const char*>(some.data()), some.size_bytes()});
      });
    }
    StreamRequest one = request_;
    one.sources = {{.path = scratch_.group_points(), .format = Format::raw}};
    one.scratch = scratch_.group_folder();
    one.targets = {{scratch_.group_points(), StreamFormat::geojson}};  // is not written
    one.quiet = true;
    one.shows_progress = false;
    use_polygons(one, [&](const StreamResult& result, const auto& show) {
      const PartialCounts& counts = result.counts;
      std::string problem;
      if (counts.triangles == 0)
        problem = why_no_triangle(counts.points - counts.duplicates, line.are_on_line(), request_.alpha);
      else if (result.polygons == 0)
        problem = "no part has an area >= " + text_of(request_.filter.min_part_area);
      for (const auto& writer : writers_)
        writer->write({json_name(named_.names[group], named_.are_numbers),
                       counts.points,
                       request_.alpha,
                       {.holes = result.holes, .area = result.area, .perimeter = result.perimeter},
                       result.polygons,
                       json_members(attributes_, group),
                       problem},
                      show);
      triangles_ += counts.triangles;
      show(totals_);
      if (!problem.empty()) problem_of(group, problem);
    });
  }

  void report() {
    const PolygonTotals totals = totals_.sums.totals();
    if (request_.stats) {
      stats_.threads = request_.threads;
      stats_.alpha = request_.alpha;
      stats_.alpha_rule = "given";
      stats_.groups = GroupStats{named_.names.size(), problems_, triangles_};
      stats_.polygons = totals_.polygons;
      stats_.of_polygons = totals;
      run_.add(*request_.stats, [&](OutputFile& file) { write_stats(file, stats_); });
    }
    scratch_.clear(false);
    run_.publish();
    if (problems_ > 0)
      run_.summarize(input() + ": " + counted(problems_, "group") +
                     " without a polygon: " + (problems_ == 1 ? "" : "the first is ") + first_problem_);
    const std::vector<Point> box = corners();
    if (!request_.targets.empty())
      if (const auto why = geojson_caution({box, {}, {}, named_.file.crs, named_.file.degrees}))
        say("rbpa", output_name(request_.targets.front().path) + ": " + *why);
    run_.summarize(counted(stats_.points, "point") + ", " + counted(named_.names.size(), "group") + ", " +
                   counted(totals_.polygons, "polygon") + ", area " + rounded(totals.area, 6) +
                   list_of(request_.targets));
  }

  const StreamRequest& request_;
  Run& run_;
  Scratch scratch_;
  Budget budget_;
  GroupPoints points_;
  std::uint64_t most_ = 0;  // the most points of groups that are computed in memory together
  Box box_ = {};
  NamedGroups named_ = {};  // its points stand for all points of a file with the same keys
  std::vector<Attribute> attributes_ = {};
  std::vector<std::unique_ptr<GroupsWriter>> writers_ = {};
  Totals totals_ = {};
  std::size_t triangles_ = 0, problems_ = 0;
  std::string first_problem_ = {};
  Stats stats_ = {};
};

}  // namespace

void run_stream_groups(const StreamRequest& request, Run& run) { GroupStream(request, run).run(); }

}  // namespace rbpa::app
