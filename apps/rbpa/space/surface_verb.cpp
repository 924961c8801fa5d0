#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/number.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/values_at.h"
#include "picture/picture.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/watertight.h"
#include "rbpa/space/surface/auto_radii.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/estimate_normals.h"
#include "rbpa/space/surface/outer_shells.h"
#include "rbpa/space/surface/outliers.h"
#include "rbpa/space/surface/scale_space.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/surface_levels.h"
#include "shared/progress.h"
#include "shared/run.h"
#include "shared/verbs.h"
#include "space/added_points.h"
#include "space/drop_components.h"
#include "space/left_out_points.h"
#include "space/surface_files.h"
#include "space/surface_repairs.h"
#include "space/surface_report.h"
#include "space/surface_request.h"
#include "triangulation/watertight_file.h"

namespace rbpa::app {
namespace {

class SurfaceRun : public Run {
 public:
  SurfaceRun(const SurfaceArguments& arguments, SurfaceRequest request)
      : Run(request.source.path, arguments.outputs, request.run), arguments_(arguments), request_(std::move(request)) {}

  void run();

 private:
  /// Calls `work` with a progress line, and turns InvalidInput into BadInput.
  template <typename Step>
  auto step(const std::string& doing, Step&& work) const;

  void drop_outliers();
  void move_points();
  void take_normals();
  void build();
  void explain();
  void find_repairs();
  void choose_components();
  std::vector<bool> kept_by_choice() const;
  void fill();
  void take(FilledSurface& filled, const AddedPoints& added);
  void close(const std::vector<bool>& kept);
  std::vector<std::string> shifts() const;
  void write();
  SurfaceFiles files() const;
  void say_empty() const;
  std::string summary() const;

  const SurfaceArguments& arguments_;
  SurfaceRequest request_;
  std::vector<std::uint32_t> index_ = {};  ///< of the points in the input; empty if all are read
  std::size_t all_points_ = 0;             ///< number of points of the input
  SpacePoints file_;                       ///< without outliers; points are moved with --scale-space
  LeftOutPoints outliers_;
  std::vector<Point3> as_they_came_;  ///< the original points if they are moved, else empty
  NormalSource source_ = NormalSource::none;
  EstimatedNormals estimated_;
  std::vector<double> radii_;  ///< of the balls that make the surface
  SurfaceRepairs repairs_;
  Surface surface_;
  SurfaceComponents components_;  ///< of the surface; also those that are dropped later
  SplitFans fans_;
  std::vector<std::uint32_t> order_;  ///< of triangles in mesh files; empty: that of the surface
  std::vector<bool> filled_;          ///< for each triangle whether it fills a hole; empty: none does
  SurfaceFacts facts_;

  /// Return the points and normals that files have.
  std::span<const Point3> points() const {
    return as_they_came_.empty() || arguments_.moved ? file_.points : as_they_came_;
  }
  std::span<const Point3> normals() const {
    if (source_ == NormalSource::none) return {};
    return source_ == NormalSource::estimate ? estimated_.normals : file_.normals;
  }
};

/// Returns the curves with the causes that `known` has for their edges.
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

/// Returns the ascending radii with those above `most` replaced by it, without repetitions.
std::vector<double> at_most(std::vector<double> radii, std::optional<double> most) {
  for (double& radius : radii) radius = std::min(radius, most.value_or(radius));
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  return radii;
}

template <typename Step>
auto SurfaceRun::step(const std::string& doing, Step&& work) const {
  TriangleProgress progress(!options().quiet, doing, triangles_text);
  try {
    return work(SurfaceOptions{.threads = options().threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
}

void SurfaceRun::drop_outliers() {
  if (!request_.outlier_factor) return;
  facts_.outlier_factor = request_.outlier_factor;
  facts_.outliers = step("looking for outliers", [&](const SurfaceOptions& how) {
    return outliers(file_.points,
                    {.factor = *request_.outlier_factor, .threads = how.threads, .progress = how.progress});
  });
  if (!facts_.outliers.points.empty()) outliers_ = LeftOutPoints(file_, facts_.outliers.points);
}

void SurfaceRun::move_points() {
  if (!request_.scale_space) return;
  ScaleSpace moved = step("scale space", [&](const SurfaceOptions& how) {
    return scale_space(file_.points,
                       {.steps = *request_.scale_space, .threads = how.threads, .progress = how.progress});
  });
  facts_.scale_space = moved.steps;
  as_they_came_ = std::exchange(file_.points, std::move(moved.points));
}

void SurfaceRun::take_normals() {
  for (std::size_t i = 0; i < file_.points.size() && file_.fields.size() == 3; ++i)
    request_.viewpoints.push_back({file_.fields[0][i], file_.fields[1][i], file_.fields[2][i]});
  facts_.has_viewpoint = !request_.viewpoints.empty();
  source_ = request_.normals.value_or(file_.normals.empty() ? NormalSource::estimate : NormalSource::file);
  // Without points, normals are not missing.
  if (source_ == NormalSource::file && file_.normals.empty() && !file_.points.empty())
    bad_input(input(), "no normals", "some, or --normals estimate or none");
  constexpr std::array names{"file", "estimate", "none"};
  facts_.normals = names[static_cast<std::size_t>(source_)];
  if (source_ == NormalSource::estimate) {
    estimated_ = step("estimating normals", [&](const SurfaceOptions& how) {
      return estimate_normals_and_confidence(file_.points, {.neighbors = request_.neighbors,
                                                            .viewpoints = request_.viewpoints,
                                                            .threads = how.threads,
                                                            .progress = how.progress});
    });
    facts_.in_doubt =
        static_cast<std::size_t>(std::count_if(estimated_.confidence.begin(), estimated_.confidence.end(),
                                               [](double confidence) { return confidence < least_confidence; }));
  } else if (request_.colors_normals) {
    bad_input(input(), "normals, whose confidence is not known", "none, or --normals estimate for --color normals");
  } else if (source_ == NormalSource::file && !request_.viewpoints.empty()) {
    turn_toward(file_.points, request_.viewpoints, file_.normals);
  }
  if (!arguments_.flip) return;
  for (Point3& n : source_ == NormalSource::estimate ? estimated_.normals : file_.normals)
    n = {0.0 - n.x, 0.0 - n.y, 0.0 - n.z};
}

void SurfaceRun::build() {
  facts_.radii = request_.radii;
  if (facts_.radii.empty()) {
    facts_.chosen_radii = true;
    facts_.radii = step("choosing radii", [&](const SurfaceOptions& how) { return auto_radii(file_.points, how); });
    facts_.radii = at_most(facts_.radii, request_.most_radius);
    // Without normals one radius is used: the largest, which spans the gaps everywhere.
    if (source_ == NormalSource::none && facts_.radii.size() > 1) facts_.radii = {facts_.radii.back()};
  }
  // If no radius can be chosen, there is no triangle at any radius: 1 stands for all.
  radii_ = facts_.radii.empty() ? std::vector<double>{1} : facts_.radii;
  surface_ = step("rolling", [&](const SurfaceOptions& how) {
    return source_ == NormalSource::none ? exposed_triangles(file_.points, radii_.back(), how)
                                         : surface(file_.points, normals(), radii_, how);
  });
  facts_.distinct = surface_.distinct;
}

void SurfaceRun::explain() {
  facts_.unused = step("looking at unused points", [&](const SurfaceOptions& how) {
    return unused_points(file_.points, normals(), radii_, surface_, how);
  });
  components_ = surface_components(file_.points, surface_, until_interrupted());
  const auto is_closed = [](const SurfaceComponent& component) { return component.is_closed(); };
  if (std::all_of(components_.all.begin(), components_.all.end(), is_closed)) return;
  facts_.holes = step("looking at holes",
                      [&](const SurfaceOptions& how) { return holes(file_.points, normals(), radii_, surface_, how); });
  if (arguments_.repairs) find_repairs();
}

void SurfaceRun::find_repairs() {
  const std::vector<Hole> wanted = chosen_curves(facts_.holes, curve_kinds(file_.points, components_, facts_.holes));
  const auto found = step("looking for repairs", [&](const SurfaceOptions& how) {
    return suggested_repairs(file_.points, normals(), radii_, surface_, wanted, how);
  });
  repairs_ = SurfaceRepairs(wanted, found);
}

void SurfaceRun::choose_components() {
  facts_.manifold = arguments_.manifold || arguments_.watertight;
  if (facts_.manifold || request_.filled) {
    surface_ = indexable_surface(surface_, until_interrupted());
    components_ = surface_components(file_.points, surface_, until_interrupted());
    facts_.holes = with_causes(surface_curves(file_.points, surface_, until_interrupted()), facts_.holes);
  }
  facts_.kinds = curve_kinds(file_.points, components_, facts_.holes);
  const std::vector<bool> kept = kept_by_choice();
  if (arguments_.watertight) {
    close(kept);
  } else {
    if (std::count(kept.begin(), kept.end(), false) > 0)
      drop_components(file_.points, kept, surface_, components_, facts_);
    if (request_.filled) fill();
    if (!as_they_came_.empty()) components_ = surface_components(points(), surface_, until_interrupted());
  }
  facts_.watertight = arguments_.watertight;
  fans_ = split_fans(surface_, until_interrupted());
  facts_.counts = count(fans_, components_);
  facts_.non_manifold_edges = non_manifold_edges(facts_.manifold ? fans_.triangles : surface_.triangles);
  if (source_ == NormalSource::none) order_ = by_shells(components_);
  facts_.components = std::move(components_.all);
  facts_.has_repairs = arguments_.repairs;
  if (facts_.has_repairs) facts_.repairs = repairs_.of(facts_.holes, facts_.kinds);
}

/// Returns for each component whether the options keep it.
std::vector<bool> SurfaceRun::kept_by_choice() const {
  if (request_.components.keeps_all()) return std::vector<bool>(components_.all.size(), true);
  std::vector<bool> outer;
  if (request_.components.shell != ShellChoice::all)
    outer = outer_shells(file_.points, radii_.back(), surface_, components_, until_interrupted());
  return kept_components(components_, outer, request_.components);
}

void SurfaceRun::fill() {
  const std::vector<Hole> chosen = chosen_curves(facts_.holes, facts_.kinds, *request_.filled);
  if (chosen.empty()) return;
  FilledSurface filled =
      step("filling holes", [&](const SurfaceOptions& how) { return fill_holes(file_.points, surface_, chosen, how); });
  const bool is_refined = arguments_.refine && filled.has_filled();
  AddedPoints added;
  if (is_refined)
    added = step("refining fillings", [&](const SurfaceOptions& how) { return refine_filling(points(), filled, how); });
  take(filled, added);
  std::vector<std::uint32_t> number;  // of each triangle that was there before
  for (std::uint32_t t = 0; t < filled_.size(); ++t)
    if (!filled_[t]) number.push_back(t);
  for (Hole& curve : facts_.holes)
    for (RimEdge& edge : curve.edges) edge.triangle = number[edge.triangle];
  const std::span<const Point3> places = is_refined ? points() : file_.points;
  components_ = surface_components(places, surface_, until_interrupted());
  facts_.holes = with_causes(surface_curves(places, surface_, until_interrupted()), facts_.holes);
  facts_.kinds = curve_kinds(places, components_, facts_.holes);
}

/// Takes the surface out of `filled`, and the points that --refine added.
void SurfaceRun::take(FilledSurface& filled, const AddedPoints& added) {
  facts_.filling = count(filled.holes);
  add_points(added, file_, estimated_, outliers_);
  if (!as_they_came_.empty()) as_they_came_.insert(as_they_came_.end(), added.points.begin(), added.points.end());
  if (arguments_.refine && filled.has_filled()) count_refined(points(), filled, added, facts_.filling);
  surface_ = std::move(filled.surface);
  filled_ = std::move(filled.is_new);
}

/// Makes the kept components watertight. Throws Failure if that is not possible, or a file would not be.
void SurfaceRun::close(const std::vector<bool>& kept) {
  WatertightSurface closed = step("filling holes", [&](const SurfaceOptions& how) {
    return make_watertight(file_.points, surface_, {.kept = kept, .places = points(), .refine = arguments_.refine},
                           how);
  });
  facts_.dropped = dropped_components(file_.points, closed.components, surface_, components_);
  take(closed, closed.added);
  facts_.filling.given_up = closed.given_up;
  components_ = surface_components(points(), surface_, until_interrupted());
  facts_.holes = std::move(closed.open);
  facts_.kinds.clear();
  const std::string left = openings(facts_, points(), surface_, closed.crossing);
  if (!left.empty()) {
    if (surface_.triangles.empty()) say_empty();
    throw Failure("not watertight: " + left + "; nothing is written");
  }
  for (const Target& target : request_.targets) {
    const std::string why = step("looking for crossings", [&](const SurfaceOptions& how) {
      return why_file_is_open(target.format, target.path, points(), surface_.triangles, request_.shift, how);
    });
    if (!why.empty()) throw Failure("not watertight: " + why + "; nothing is written");
  }
  facts_.inside = nesting_depths(points(), surface_, components_, until_interrupted());
}

std::vector<std::string> SurfaceRun::shifts() const {
  std::vector<std::string> lines;
  for (const Target& target : request_.targets)
    lines.push_back(text_of_shift(target.format, points(), surface_.triangles, request_.shift, target.path));
  return lines;
}

SurfaceFiles SurfaceRun::files() const {
  return {.points = points(),
          .normals = normals().empty() ? file_.normals : normals(),
          .colors = file_.colors,
          .confidence = estimated_.confidence,
          .surface = surface_,
          .fans = fans_,
          .order = order_,
          .facts = facts_,
          .filled = filled_,
          .compact = arguments_.compact,
          .shift = request_.shift};
}

void SurfaceRun::write() {
  const ProgressLine line = writing();
  SurfaceFiles all = files(), pictures = all;
  std::vector<Point3> whole, seen, whole_normals;
  std::vector<double> whole_confidence;
  std::vector<std::array<std::uint8_t, 3>> colors;
  if (outliers_.is_any()) {
    whole = outliers_.all_points(all.points);
    seen = outliers_.seen_points(all.points);
    whole_normals = outliers_.all_normals(all.normals);
    all.points = whole;
    pictures.points = seen;
    all.normals = pictures.normals = whole_normals;
    all.colors = pictures.colors = outliers_.all_colors();
    all.confidence = whole_confidence = outliers_.all_confidence(all.confidence);
    outliers_.renumber(surface_);
    outliers_.renumber(fans_);
    outliers_.renumber(facts_);
  }
  for (std::size_t next = all_points_; !index_.empty() && index_.size() < all.points.size(); ++next)
    index_.push_back(static_cast<std::uint32_t>(next));  // numbers of the added points
  all.index = index_;
  if (request_.colors_normals) all.colors = pictures.colors = colors = colors_of(all.confidence);
  add(request_.targets, [&](OutputFile& file, const Target& target) {
    (is_picture(target.format) ? pictures : all).write(file, target.format, request_.width);
  });
  if (arguments_.holes) add(*arguments_.holes, [&](OutputFile& file) { all.write_curves(file); });
  if (index_.empty()) return;
  renumber(facts_, index_);
  facts_.outliers.points = renumbered(facts_.outliers.points, index_);
}

void SurfaceRun::say_empty() const {
  std::string why = "fewer than three distinct points";
  if (facts_.dropped.components > 0) {
    why = counted(facts_.dropped.components, "component") + " dropped, and none kept";
  } else if (facts_.distinct >= 3) {
    const std::optional<double> radius = step("looking for a radius", [&](const SurfaceOptions& how) {
      return radius_with_triangles(file_.points, normals(), how);
    });
    why = radius ? "with --radius " + text_of(*radius) + " there would be some" : "none of the tried radii gives one";
    if (!radius && facts_.radii.empty()) why = "all points are on a line";
  }
  say("rbpa", "there is no triangle: " + why);
}

std::string SurfaceRun::summary() const {
  const SurfaceCounts& counts = facts_.counts;
  const std::string origin = source_ == NormalSource::file       ? "normals of the file"
                             : source_ == NormalSource::estimate ? "normals estimated"
                                                                 : "without normals";
  const std::string moved =
      facts_.scale_space == 0 ? "" : ", moved by " + counted(facts_.scale_space, "step") + " of scale space";
  const std::size_t equal = surface_.duplicates.size();
  return counted(facts_.points, "point") + (equal > 0 ? " (" + std::to_string(equal) + " repeated)" : "") + ", " +
         origin + moved +
         (facts_.radii.empty()       ? ", no radius"
          : facts_.radii.size() == 1 ? ", radius "
                                     : ", radii ") +
         text_of_radii(facts_.radii) + (facts_.chosen_radii ? " (auto)" : "") + ": " +
         counted(counts.triangles, "triangle") + ", " + counted(counts.components, "component") + ", " +
         counted(counts.boundary_curves, "boundary curve") + genus_text(facts_) + list_of(request_.targets);
}

void SurfaceRun::run() {
  const SpacePointSource& source = request_.source;
  file_ = read([&] { return read_space_points(source.path, source.format, source.choice); });
  warning(file_.warnings);
  facts_.points = file_.points.size();
  index_ = file_.index;
  all_points_ = file_.all_points;
  facts_.read_seconds = lap();
  drop_outliers();
  move_points();
  take_normals();
  facts_.normals_seconds = lap();
  build();
  explain();
  choose_components();
  facts_.threads = options().threads_or_all();
  facts_.build_seconds = lap();

  const std::vector<std::string> shifted = shifts();
  write();
  facts_.write_seconds = lap();
  if (arguments_.json) add("-", [&](OutputFile& file) { write_surface_json(file, facts_); });
  if (arguments_.stats) add(*arguments_.stats, [&](OutputFile& file) { write_surface_stats(file, facts_); });
  publish();

  if (surface_.triangles.empty()) say_empty();
  summarize(summary());
  for (const std::string& line : shifted)
    if (!line.empty()) summarize(line);
  for (const std::string& line : explanations(facts_)) summarize(line);
}

}  // namespace

void run_surface(const SurfaceArguments& arguments) { SurfaceRun(arguments, parse(arguments)).run(); }

}  // namespace rbpa::app
