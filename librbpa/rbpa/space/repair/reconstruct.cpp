#include "rbpa/space/repair/reconstruct.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/repair/watertight.h"
#include "rbpa/space/surface/auto_radii.h"
#include "rbpa/space/surface/outer_shells.h"
#include "rbpa/space/surface/scale_space.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_levels.h"

namespace rbpa {
namespace {

using Step = ReconstructionStep;
using Numbers = std::vector<std::uint32_t>;

/// The points over which the ball rolls, with their normals.
struct RolledPoints {
  std::vector<Point3> points, normals;
  std::vector<Point3> unmoved = {};  // places in the result; empty if equal to `points`
  std::vector<double> confidence = {};

  std::span<const Point3> places() const { return unmoved.empty() ? points : unmoved; }

  /// Appends the added points. The attributes of each added point are means of those of the three points around it.
  void add(const AddedPoints& added) {
    for (std::vector<Point3>* all : {&points, &unmoved})
      if (!all->empty()) all->insert(all->end(), added.points.begin(), added.points.end());
    if (!normals.empty()) {
      const std::vector<Point3> further = normals_between(normals, added.between);
      normals.insert(normals.end(), further.begin(), further.end());
    }
    if (confidence.empty()) return;
    for (const auto& [a, b, c] : added.between)
      confidence.push_back(confidence[a] / 3 + confidence[b] / 3 + confidence[c] / 3);
  }
};

/// The whole input cloud, from which points are left out.
struct WholeInput {
  std::vector<Point3> points, normals;
  Numbers number = {};  // for each point that is not left out, its index in the input

  /// Copies the cloud, then removes the points `left_out` from it, with their normals and viewpoints.
  /// Requires: ascending indices.
  WholeInput(RolledPoints& cloud, std::vector<Point3>& viewpoints, std::span<const std::uint32_t> left_out)
      : points(cloud.points), normals(cloud.normals) {
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (next < left_out.size() && left_out[next] == i)
        ++next;
      else
        number.push_back(i);
    for (std::vector<Point3>* values : {&cloud.points, &cloud.normals, &viewpoints}) {
      if (values->size() != points.size()) continue;  // none, or one viewpoint for all
      for (std::size_t i = 0; i < number.size(); ++i) (*values)[i] = (*values)[number[i]];
      values->resize(number.size());
    }
    normals.resize(points.size());
  }

  /// Returns `input` with `values` at the points that are not left out, and then the values of added points. Returns
  /// nothing if `values` is empty.
  template <typename Value>
  std::vector<Value> with(std::span<const Value> values, std::vector<Value> input) const {
    if (values.empty()) return {};
    for (std::size_t i = 0; i < number.size(); ++i) input[number[i]] = values[i];
    input.insert(input.end(), values.begin() + static_cast<std::ptrdiff_t>(number.size()), values.end());
    return input;
  }

  /// Replaces the numbers and values of the cloud in `made` by those of the whole input.
  void take_back(Reconstruction& made) && {
    const std::size_t input = points.size();
    made.normals = with<Point3>(made.normals, std::move(normals));
    made.confidence = with<double>(made.confidence, std::vector<double>(input));
    made.points = with<Point3>(made.points, std::move(points));
    for (std::size_t i = input; i < made.points.size(); ++i) number.push_back(static_cast<std::uint32_t>(i));
    renumber(made, number);
  }
};

/// Returns `curves`. Edges that `known` has, too, get their causes from it.
std::vector<Hole> with_causes(std::vector<Hole> curves, std::span<const Hole> known) {
  const auto key = [](const RimEdge& edge) { return std::make_pair(edge.triangle, edge.from); };
  std::map<std::pair<std::uint32_t, std::uint32_t>, RimEdge> edges;
  for (const Hole& curve : known)
    for (const RimEdge& edge : curve.edges) edges.emplace(key(edge), edge);
  for (Hole& curve : curves)
    for (RimEdge& edge : curve.edges)
      if (const auto found = edges.find(key(edge)); found != edges.end()) edge = found->second;
  return curves;
}

/// The suggested repairs by curve. A curve is identified by its first edge and its number of edges.
class RepairsOfCurves {
 public:
  RepairsOfCurves() = default;
  RepairsOfCurves(std::span<const Hole> curves, std::span<const SuggestedRepair> repairs) {
    for (std::size_t i = 0; i < curves.size(); ++i) repairs_.emplace(key_of(curves[i]), repairs[i]);
  }

  /// Returns the repair of each curve of kind `hole`, a default one if the curve has changed. Other kinds have none.
  std::vector<std::optional<SuggestedRepair>> of(std::span<const Hole> curves, std::span<const CurveKind> kinds) const {
    std::vector<std::optional<SuggestedRepair>> result(curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (kinds[i] != CurveKind::hole) continue;
      const auto found = repairs_.find(key_of(curves[i]));
      result[i] = found != repairs_.end() ? found->second : SuggestedRepair{};
    }
    return result;
  }

 private:
  using Key = std::array<std::size_t, 3>;
  static Key key_of(const Hole& curve) {
    return {curve.edges.front().from, curve.edges.front().to, curve.edges.size()};
  }

  std::map<Key, SuggestedRepair> repairs_ = {};
};

class Reconstructing {
 public:
  Reconstructing(std::vector<Point3> points, ReconstructionOptions options)
      : options_(std::move(options)),
        run_{.threads = options_.threads, .progress = options_.progress},
        cloud_{.points = std::move(points), .normals = std::move(options_.normals)} {
    made_.source = options_.source.value_or(cloud_.normals.empty() ? NormalSource::estimate : NormalSource::given);
    check();
  }

  Reconstruction run() {
    leave_out();
    move();
    take_normals();
    roll();
    const bool explains = options_.explain || options_.repairs, closes = options_.watertight;
    if (explains) explain();
    if (options_.manifold || options_.filled || closes) {
      made_.surface = indexable_surface(made_.surface, counting());
      find_curves(cloud_.points);
    } else if (!explains && !options_.components.keeps_all()) {
      find_curves(cloud_.points);
    } else {
      made_.kinds = curve_kinds(cloud_.points, made_.components, made_.holes);
    }
    const std::vector<bool> kept = chosen_components();
    if (closes) {
      close(kept);
    } else {
      drop(kept);
      if (options_.filled) fill();
      if (!cloud_.unmoved.empty() && !made_.components.all.empty())
        made_.components = surface_components(cloud_.places(), made_.surface, counting());
    }
    if (options_.repairs) made_.repairs = repairs_.of(made_.holes, made_.kinds);
    if (options_.decimation) decimate();
    return finished();
  }

 private:
  template <typename Options>
  Options begin(Step step, Options options) const {
    if (options_.on_step) options_.on_step(step);
    options.threads = run_.threads;
    options.progress = run_.progress;
    return options;
  }
  SurfaceOptions begin(Step step) const { return begin(step, SurfaceOptions()); }
  /// Begins a step of other work, and returns the callback that may cancel it.
  GoOn counting() const {
    if (options_.on_step) options_.on_step(Step::counting);
    return go_on_of(run_.progress, cloud_.points.size(), made_.surface.triangles.size());
  }

  void check() const {
    const std::size_t points = cloud_.points.size(), normals = cloud_.normals.size();
    if (normals != points && (normals > 0 || made_.source == NormalSource::given))
      throw InvalidInput(std::to_string(normals) + " normals, expected one for each of " + std::to_string(points) +
                         " points");
    const bool has_normals = made_.source != NormalSource::none;
    if (!has_normals && options_.radii.size() > 1)
      throw InvalidInput(std::to_string(options_.radii.size()) + " radii without normals, expected one");
    if (has_normals && options_.components.shell != ShellChoice::all)
      throw InvalidInput("a choice of shells for a surface with normals, expected all shells, or NormalSource::none");
  }

  std::span<const Point3> normals() const {
    return made_.source == NormalSource::none ? std::span<const Point3>() : cloud_.normals;
  }

  void leave_out() {
    if (!options_.outlier_factor) return;
    outliers_ = outliers(cloud_.points, begin(Step::outliers, OutlierOptions{.factor = *options_.outlier_factor}));
    if (!outliers_.points.empty()) whole_.emplace(cloud_, options_.viewpoints, outliers_.points);
  }

  void move() {
    if (!options_.scale_space) return;
    ScaleSpace moved =
        scale_space(cloud_.points, begin(Step::scale_space, ScaleSpaceOptions{.steps = *options_.scale_space}));
    made_.scale_space = moved.steps;
    cloud_.points.swap(moved.points);
    if (!options_.moved) cloud_.unmoved = std::move(moved.points);
  }

  void take_normals() {
    if (made_.source == NormalSource::none) return;
    if (made_.source == NormalSource::estimate) {
      EstimatedNormals estimated = estimate_normals_and_confidence(
          cloud_.points,
          begin(Step::normals, NormalOptions{.neighbors = options_.neighbors, .viewpoints = options_.viewpoints}));
      cloud_.normals = std::move(estimated.normals);
      cloud_.confidence = std::move(estimated.confidence);
    } else if (!options_.viewpoints.empty()) {
      turn_toward(cloud_.points, options_.viewpoints, cloud_.normals);
    }
    if (!options_.flip) return;
    for (Point3& n : cloud_.normals) n = {0.0 - n.x, 0.0 - n.y, 0.0 - n.z};
  }

  /// Chooses the radii unless they are given, and rolls the ball of each: surface(), or exposed_triangles() without
  /// normals.
  void roll() {
    const bool has_normals = made_.source != NormalSource::none;
    std::vector<double>& radii = made_.radii;
    radii = options_.radii;
    if (radii.empty()) {
      radii = auto_radii(cloud_.points, begin(Step::radii));
      for (double& radius : radii) radius = std::min(radius, options_.max_radius);
      radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
      // The largest radius spans the gaps everywhere.
      if (!has_normals && radii.size() > 1) radii = {radii.back()};
    }
    // auto_radii() is empty for points on one line and for fewer than three points, but a ball needs some radius.
    radii_ = radii.empty() ? std::vector<double>{1} : radii;
    made_.surface = has_normals ? surface(cloud_.points, normals(), radii_, begin(Step::rolling))
                                : exposed_triangles(cloud_.points, radii_.back(), begin(Step::rolling));
    made_.distinct = made_.surface.distinct;
  }

  /// Finds the unused points, the components, and the boundary curves with their causes.
  void explain() {
    made_.unused = unused_points(cloud_.points, normals(), radii_, made_.surface, begin(Step::unused));
    made_.components = surface_components(cloud_.points, made_.surface, counting());
    if (made_.surface.triangles.empty() && made_.distinct >= 3)
      made_.larger_ball = radius_with_triangles(cloud_.points, normals(), begin(Step::larger_ball));
    const auto is_closed = [](const SurfaceComponent& component) { return component.is_closed(); };
    if (std::all_of(made_.components.all.begin(), made_.components.all.end(), is_closed)) return;
    made_.holes = holes(cloud_.points, normals(), radii_, made_.surface, begin(Step::holes));
    if (!options_.repairs) return;
    const std::vector<Hole> wanted =
        chosen_curves(made_.holes, curve_kinds(cloud_.points, made_.components, made_.holes));
    repairs_ = RepairsOfCurves(
        wanted, suggested_repairs(cloud_.points, normals(), radii_, made_.surface, wanted, begin(Step::repairs)));
  }

  /// Finds the components, and the boundary curves with their kinds and the known causes.
  void find_curves(std::span<const Point3> places) {
    const GoOn go_on = counting();
    made_.components = surface_components(places, made_.surface, go_on);
    made_.holes = with_causes(surface_curves(places, made_.surface, go_on), made_.holes);
    made_.kinds = curve_kinds(places, made_.components, made_.holes);
  }

  std::vector<bool> chosen_components() const {
    std::vector<bool> outer;
    if (options_.components.shell != ShellChoice::all)
      outer = outer_shells(cloud_.points, radii_.back(), made_.surface, made_.components, counting());
    return choose_components(made_.components, outer, options_.components);
  }

  void drop(const std::vector<bool>& kept) {
    if (std::find(kept.begin(), kept.end(), false) == kept.end()) return;
    const GoOn go_on = counting();
    made_.dropped = dropped_components(cloud_.points, kept, made_.surface, made_.components, go_on);
    Numbers number;  // new number of each kept triangle; for a dropped one, of the next kept one
    std::uint32_t next = 0;
    for (const std::uint32_t c : made_.components.number) {
      number.push_back(next);
      next += kept[c];
    }
    std::vector<Hole> holes;
    std::vector<CurveKind> kinds;
    for (std::size_t i = 0; i < made_.holes.size(); ++i) {
      Hole& hole = made_.holes[i];
      if (!kept[made_.components.number[hole.edges.front().triangle]]) continue;
      for (RimEdge& edge : hole.edges) edge.triangle = number[edge.triangle];
      holes.push_back(std::move(hole));
      kinds.push_back(made_.kinds[i]);
    }
    made_.holes = std::move(holes);
    made_.kinds = std::move(kinds);
    made_.surface = keep_components(made_.surface, made_.components, kept);
    made_.components = surface_components(cloud_.points, made_.surface, go_on);
  }

  void fill() {
    const std::vector<Hole> chosen = chosen_curves(made_.holes, made_.kinds, *options_.filled);
    if (chosen.empty()) return;
    FilledSurface filled = fill_holes(cloud_.points, made_.surface, chosen, begin(Step::filling));
    const bool is_refined = options_.refine && filled.has_filled();
    AddedPoints added;
    if (is_refined) added = refine_filling(cloud_.places(), filled, begin(Step::refining));
    take(filled, std::move(added));
    Numbers number;  // for each old triangle, its new number
    for (std::uint32_t t = 0; t < made_.filled.size(); ++t)
      if (!made_.filled[t]) number.push_back(t);
    for (Hole& curve : made_.holes)
      for (RimEdge& edge : curve.edges) edge.triangle = number[edge.triangle];
    find_curves(is_refined ? cloud_.places() : cloud_.points);
  }

  void close(const std::vector<bool>& kept) {
    WatertightSurface closed = make_watertight(
        cloud_.points, made_.surface,
        {.components = &made_.components, .kept = kept, .places = cloud_.places(), .refine = options_.refine},
        begin(Step::filling));
    const GoOn go_on = counting();
    made_.dropped = dropped_components(cloud_.points, closed.components, made_.surface, made_.components, go_on);
    made_.given_up = closed.given_up;
    if (options_.explain || options_.repairs) add_given_up(closed.surface, closed.components);
    made_.crossing = std::move(closed.crossing);
    take(closed, std::move(closed.added));
    made_.components = surface_components(cloud_.places(), made_.surface, go_on);
    made_.holes = std::move(closed.open);
    made_.kinds = curve_kinds(cloud_.places(), made_.components, made_.holes);
    if (made_.is_watertight()) made_.inside = nesting_depths(cloud_.places(), made_.surface, made_.components, go_on);
  }

  /// Adds the points to the unused ones that have triangles in the kept components and none in the closed surface.
  void add_given_up(const Surface& closed, const std::vector<bool>& kept) {
    std::vector<bool> is_lost(cloud_.points.size(), false);
    const auto set = [&](const auto& triangle, bool lost) {
      for (const std::uint32_t corner : triangle)
        if (corner < is_lost.size()) is_lost[corner] = lost;  // other corners are added points
    };
    for (std::size_t t = 0; t < made_.surface.triangles.size(); ++t)
      if (kept[made_.components.number[t]]) set(made_.surface.triangles[t], true);
    for (const auto& triangle : closed.triangles) set(triangle, false);
    for (std::uint32_t i = 0; i < is_lost.size(); ++i)
      if (is_lost[i]) made_.unused.push_back({i, UnusedCause::given_up});
    std::sort(made_.unused.begin(), made_.unused.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  }

  void decimate() {
    begin(Step::decimating);
    DecimationOptions options = *options_.decimation;
    options.measured = true;
    options.no_crossings = options.no_crossings || options_.watertight;
    options.go_on = go_on_of(run_.progress, cloud_.points.size(), made_.surface.triangles.size());
    DecimatedSurface left = rbpa::decimate(cloud_.places(), made_.surface, options);
    made_.decimated = std::move(left.counts);
    if (!made_.filled.empty()) {
      std::vector<bool> filled;
      for (const std::uint32_t t : left.given) filled.push_back(made_.filled[t]);
      made_.filled = std::move(filled);
    }
    made_.surface = std::move(left);
    if (!made_.components.all.empty())
      made_.components = surface_components(cloud_.places(), made_.surface, counting());
    if (options_.watertight && made_.is_watertight())
      made_.inside = nesting_depths(cloud_.places(), made_.surface, made_.components, counting());
  }

  /// Takes the surface out of `filled`, and the points that refining added.
  void take(FilledSurface& filled, AddedPoints added) {
    made_.surface = std::move(filled.surface);
    made_.filled = std::move(filled.is_new);
    made_.fillings = std::move(filled.holes);
    cloud_.add(added);
    made_.added = std::move(added);
  }

  Reconstruction finished() {
    made_.points = std::move(cloud_.unmoved.empty() ? cloud_.points : cloud_.unmoved);
    made_.normals = std::move(cloud_.normals);
    made_.confidence = std::move(cloud_.confidence);
    if (whole_) std::move(*whole_).take_back(made_);
    made_.outliers = std::move(outliers_);
    return std::move(made_);
  }

  ReconstructionOptions options_;
  SurfaceOptions run_;
  RolledPoints cloud_;
  std::optional<WholeInput> whole_ = {};  // the whole input; only if points are left out
  Outliers outliers_ = {};
  std::vector<double> radii_ = {};  // radii of the balls that make the surface
  RepairsOfCurves repairs_ = {};
  Reconstruction made_ = {};
};

}  // namespace

Reconstruction reconstruct(std::vector<Point3> points, ReconstructionOptions options) {
  return Reconstructing(std::move(points), std::move(options)).run();
}

void renumber(Reconstruction& made, std::span<const std::uint32_t> number) {
  const auto all = [&](auto& corners) {
    for (std::uint32_t& corner : corners) corner = number[corner];
  };
  for (auto& triangle : made.surface.triangles) all(triangle);
  for (auto& corners : made.added.between) all(corners);
  for (Duplicate& duplicate : made.surface.duplicates)
    duplicate = {number[duplicate.index], number[duplicate.stands_for]};
  for (UnusedPoint& point : made.unused) point.index = number[point.index];
  for (auto& repair : made.repairs)
    if (repair) all(repair->points);
  for (Hole& hole : made.holes)
    for (RimEdge& edge : hole.edges) {
      edge.from = number[edge.from];
      edge.to = number[edge.to];
      if (edge.next != decltype(edge.next){}) all(edge.next);  // otherwise `next` is not set
    }
  all(made.outliers.points);
}

}  // namespace rbpa
