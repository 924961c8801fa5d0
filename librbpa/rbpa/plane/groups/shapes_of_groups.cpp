#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/choose_alpha.h"
#include "rbpa/plane/collinear.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/filtration/radii.h"
#include "rbpa/plane/groups.h"
#include "rbpa/plane/groups/chunks.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/plane/shape/polygons_of_linked.h"

namespace rbpa {
namespace {

constexpr double no_alpha = std::numeric_limits<double>::quiet_NaN();

/// The shapes of a chunk of groups, before they are appended to the shapes of earlier chunks.
struct ShapesOfChunk {
  GroupPoints gathered;
  GroupShapes made;  // `polygon_begin` and `triangle_begin` count from the beginning of the chunk
};

/// The number of finished groups. Calls GroupOptions::go_on with this number, one call at a time.
class GroupsDone {
 public:
  explicit GroupsDone(const std::function<bool(std::size_t)>& go_on) : go_on_(go_on) {}

  bool go_on() {
    if (!go_on_) return true;
    const std::lock_guard lock(mutex_);
    return go_on_(done_);
  }
  /// Sets the number of finished groups, and calls go_on(). Throws: Cancelled.
  void set(std::size_t done) {
    {
      const std::lock_guard lock(mutex_);
      done_ = done;
    }
    if (!go_on()) throw Cancelled();
  }

 private:
  const std::function<bool(std::size_t)>& go_on_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

/// The least number of points of a group for which the computation of the group may use several threads, and calls
/// go_on().
constexpr std::size_t long_enough = 16384;

class GroupShaper {
 public:
  GroupShaper(const GroupAlpha& alpha, const GroupShapesOptions& options)
      : alpha_(alpha), options_(options), done_(options.go_on) {}

  GroupsDone& done() { return done_; }

  /// Appends the shape of a group, computed by `threads` threads.
  void add(const Group& group, unsigned threads, GroupShapes& made) {
    const std::size_t before = made.polygons.size();
    const std::string problem = find(group, threads, made);
    made.polygon_begin.push_back(made.polygons.size());
    made.totals.push_back(total(std::span(made.polygons).subspan(before)));
    if (made.polygons.size() == before) made.problems.push_back({group.number, problem});
  }

 private:
  /// Appends everything except totals, problems and the new entry of polygon_begin. Returns why there is no polygon;
  /// the text is meaningless if there is a polygon.
  std::string find(const Group& group, unsigned threads, GroupShapes& made) {
    GoOn go_on;
    AlphaComplexOptions of_group{.neighbors = true, .threads = threads};
    if (options_.go_on && group.points.size() >= long_enough) {
      go_on = [this] { return done_.go_on(); };
      of_group.progress = [this](const Progress&) { return done_.go_on(); };
    }
    made.alphas.push_back(no_alpha);
    made.triangle_begin.push_back(made.triangle_begin.back());
    for (std::size_t i = 0; i < group.points.size(); ++i)
      if (const Point& p = group.points[i]; !is_finite(p))
        return "point " + std::to_string(group.members[i]) + " is (" + text(p.x) + ", " + text(p.y) +
               "), expected finite coordinates";
    double& alpha = made.alphas.back();
    AlphaComplex complex;
    if (const std::optional<double> given = given_for(group.number)) {
      if (!(*given > 0)) return "alpha is " + text(*given) + ", expected a radius above 0, or infinity";
      alpha = *given;
      complex = alpha_complex(group.points, alpha, of_group);
    } else {
      const Delaunay delaunay(group.points, of_group);
      complex = choose(delaunay, alpha, go_on);
    }
    made.triangle_begin.back() += complex.triangles.size();
    made.duplicates += complex.duplicates.size();
    const auto index = [&](std::uint32_t i) { return group.members[i]; };
    if (options_.triangles)
      for (const Triangle& t : complex.triangles) made.triangles.push_back({index(t[0]), index(t[1]), index(t[2])});
    for (Polygon& polygon : polygons_of_linked(group.points, complex, options_.filter, go_on)) {
      for (std::uint32_t& i : polygon.shell.points) i = index(i);
      for (Ring& hole : polygon.holes)
        for (std::uint32_t& i : hole.points) i = index(i);
      made.polygons.push_back(std::move(polygon));
    }
    if (!complex.triangles.empty()) return "no part has an area >= " + text(options_.filter.min_part_area);
    if (complex.distinct == 0) return "no points";
    return why_no_triangle(complex.distinct, are_collinear(group.points, go_on), alpha);
  }

  /// Returns the given radius of a group; nothing if a rule chooses the radius.
  std::optional<double> given_for(std::size_t group) const {
    if (!alpha_.given.empty()) return alpha_.given[alpha_.given.size() == 1 ? 0 : group];
    return alpha_.choice.rule == AlphaRule::given ? std::optional(alpha_.choice.radius) : std::nullopt;
  }

  /// Returns the complex at the radius that the rule chooses, and stores that radius in `alpha`. If the rule finds no
  /// radius, returns the whole triangulation and leaves `alpha` as it is.
  AlphaComplex choose(const Delaunay& delaunay, double& alpha, const GoOn& go_on) const {
    if (delaunay.triangulation().triangles.empty()) return delaunay.triangulation();
    Steps step(go_on);
    if (alpha_.choice.rule != AlphaRule::plateau) {
      const std::vector<double> radii = radii_of(delaunay, step);
      const std::optional<double> smallest = smallest_covering(delaunay, radii, covering_of(alpha_.choice), step);
      if (!smallest) return delaunay.triangulation();
      alpha = *smallest;
      return complex_at(delaunay, radii, alpha);
    }
    const Filtration all = filtration(delaunay, go_on);
    const std::vector<Plateau> found = plateaus(delaunay, all, go_on);
    if (found.empty()) return delaunay.triangulation();
    alpha = found[std::min(alpha_.choice.rank, found.size()) - 1].alpha;
    return complex_at(delaunay, all, alpha);
  }

  const GroupAlpha& alpha_;
  const GroupShapesOptions& options_;
  GroupsDone done_;
};

template <typename Value>
void append(std::vector<Value>& to, std::vector<Value>& from) {
  to.insert(to.end(), std::move_iterator(from.begin()), std::move_iterator(from.end()));
}

/// Appends the offsets after the first one, which is 0.
void append_offsets(std::vector<std::uint64_t>& to, const std::vector<std::uint64_t>& from) {
  const std::uint64_t begin = to.back();
  for (std::size_t i = 1; i < from.size(); ++i) to.push_back(begin + from[i]);
}

void append(GroupShapes& all, GroupShapes& made) {
  append(all.alphas, made.alphas);
  append(all.polygons, made.polygons);
  append_offsets(all.polygon_begin, made.polygon_begin);
  append(all.totals, made.totals);
  append_offsets(all.triangle_begin, made.triangle_begin);
  append(all.triangles, made.triangles);
  append(all.problems, made.problems);
  all.duplicates += made.duplicates;
}

void check(const GroupAlpha& alpha, std::size_t groups) {
  const std::size_t given = alpha.given.size();
  if (given > 1 && given != groups)
    throw InvalidInput("alpha: found " + std::to_string(given) + " radii for " + std::to_string(groups) +
                       " groups, expected as many, or one for all");
  if (given == 1 && !std::isnan(alpha.given[0])) check(std::span<const Point>(), alpha.given[0]);
  if (given > 0) return;
  const AlphaChoice& choice = alpha.choice;
  if (choice.rule == AlphaRule::given) check(std::span<const Point>(), choice.radius);
  if (choice.rule == AlphaRule::plateau && choice.rank == 0) require_rank(choice, 0);
  if (takes_components(choice.rule) && choice.max_components == 0)
    throw InvalidInput("alpha " + name_of(choice) + ": found 0 for max_components, expected 1 or more");
}

}  // namespace

GroupShapes shapes_of_groups(std::span<const Point> points, const Groups& groups, const GroupAlpha& alpha,
                             const GroupShapesOptions& options) {
  check(points, groups);
  check(alpha, groups.size());
  GroupShaper shaper(alpha, options);
  const std::vector<Chunk> chunks = chunks_of(groups);
  Threads threads = threads_for(groups.members.size(), options.threads);
  // All threads work together on a group with more than an equal share of all points: one thread alone would keep the
  // other threads waiting.
  const auto is_for_all = [&](const Chunk& chunk) {
    const std::size_t size = groups[chunk.first].size();
    return size >= long_enough && size > groups.members.size() / threads.count();
  };
  GroupShapes all;
  const auto shape = [&](const Chunk& chunk, ShapesOfChunk& shapes, unsigned in_a_group) {
    shapes.made = {};
    for (std::size_t g = chunk.first; g < chunk.last; ++g)
      shaper.add(shapes.gathered.of(points, groups, g), in_a_group, shapes.made);
  };
  const auto join = [&](const Chunk& chunk, ShapesOfChunk& shapes) {
    append(all, shapes.made);
    shaper.done().set(chunk.last);
  };
  for (std::size_t first = 0; first < chunks.size();) {
    if (is_for_all(chunks[first])) {
      ShapesOfChunk shapes;
      shape(chunks[first], shapes, options.threads);
      join(chunks[first++], shapes);
      continue;
    }
    std::size_t last = first + 1;
    while (last < chunks.size() && !is_for_all(chunks[last])) ++last;
    in_order<ShapesOfChunk>(
        threads, last - first, [&](std::size_t c, ShapesOfChunk& shapes) { shape(chunks[first + c], shapes, 1); },
        [&](std::size_t c, ShapesOfChunk& shapes) { join(chunks[first + c], shapes); },
        [](std::size_t, ShapesOfChunk&) {});
    first = last;
  }
  return all;
}

}  // namespace rbpa
