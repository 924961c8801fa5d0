#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/number.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/vertices_of_points.h"
#include "io/mesh/write_mesh.h"
#include "io/mesh/write_solid.h"
#include "picture/picture.h"
#include "picture/surface_picture.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/persistence/choose_solid_alpha.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_radii.h"
#include "rbpa/space/surface/split_fans.h"
#include "shared/progress.h"
#include "shared/run.h"
#include "space/periodic_solid.h"
#include "space/solid_report.h"
#include "space/solid_request.h"
#include "space/void_files.h"
#include "space/void_lives.h"

namespace rbpa::app {
namespace {

class SolidRun : public Run {
 public:
  SolidRun(const SolidArguments& arguments, SolidRequest request)
      : Run(request.source.path, arguments.outputs, request.run), arguments_(arguments), request_(std::move(request)) {}

  void run();

 private:
  /// Returns whether counts are needed for any output.
  bool is_counted() const { return !options().quiet || arguments_.json || arguments_.stats || arguments_.voids; }
  bool has_lives() const { return arguments_.void_radii || request_.pockets; }
  /// Returns whether voids are those of the full complex.
  bool is_full() const { return request_.walls == ComplexKind::full; }
  /// Returns the surface that has the triangles of facts_.voids.
  const Surface& around_voids() const { return is_full() ? void_boundary_ : boundary_.surface; }
  bool has_boundary() const;
  void build();
  void select_within();
  void choose_alpha();
  void find_boundary();
  void count();
  void count_full_complex();
  void find_lives();
  void write();
  void write_boundary(OutputFile& file, Format format) const;
  void write_picture(OutputFile& file) const;
  void say_empty() const;

  const SolidArguments& arguments_;
  SolidRequest request_;
  SpacePoints file_;
  Solid solid_;
  SolidBoundary boundary_;
  Surface void_boundary_;  // boundary of the voids of the full complex
  Solid triangulation_;    // of all points; radii_ has the radii of its tetrahedra; both only if needed
  std::vector<double> radii_;
  SolidFacts facts_;
  std::optional<std::vector<VoidLife>> lives_;  // of the voids to write
  std::vector<Pocket> pockets_;
};

/// Returns the items of a volume above `above`, at most `top` of them. Requires: the largest are first.
template <typename Item>
std::span<const Item> largest(const std::vector<Item>& items, double above, std::size_t top) {
  const auto last = std::find_if(items.begin(), items.end(), [&](const Item& item) { return !(item.volume > above); });
  return {items.data(), std::min(static_cast<std::size_t>(last - items.begin()), top)};
}

bool SolidRun::has_boundary() const {
  const auto is_drawn = [](const Target& target) { return is_picture(target.format); };
  return is_counted() || request_.boundary || std::any_of(request_.targets.begin(), request_.targets.end(), is_drawn);
}

void SolidRun::build() {
  const AlphaChoice& alpha = request_.alpha;
  const bool is_given = alpha.rule == AlphaRule::given, needs_all = !is_given || is_full() || has_lives();
  TriangleProgress progress(!options().quiet, "tetrahedra", text_of_progress);
  try {
    solid_ =
        solid(file_.points, needs_all ? std::numeric_limits<double>::infinity() : alpha.radius,
              {.neighbors = has_boundary() || needs_all, .threads = options().threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
  facts_.points = file_.points.size();
  facts_.distinct = solid_.distinct;
  facts_.alpha = alpha.radius;
  facts_.walls = request_.walls;
  facts_.alpha_rule = name_of(alpha);
  facts_.threads = options().threads_or_all();
  facts_.build_seconds = lap();
  if (needs_all) select_within();
  facts_.isolated = solid_.isolated.size();
}

/// Chooses alpha, and selects the tetrahedra of the triangulation up to it.
void SolidRun::select_within() {
  const ProgressLine line = options().line("alpha");
  radii_ = circumradii(file_.points, solid_.simplices, options().threads, until_interrupted());
  stop_if_interrupted();
  triangulation_ = std::move(solid_);
  choose_alpha();
  solid_ = within(triangulation_, radii_, facts_.alpha);
  stop_if_interrupted();
  facts_.choose_seconds = lap();
}

/// Finds facts_.alpha: given, or chosen by the rule among all tetrahedra.
void SolidRun::choose_alpha() {
  ChosenSolidAlpha chosen;
  try {
    chosen = choose_solid_alpha(request_.alpha, file_.points, triangulation_, radii_, until_interrupted());
  } catch (const InvalidInput& e) {
    throw WrongUsage("--" + std::string(e.what()) + " (rbpa alpha POINTS --dimension 3 lists them)");
  }
  facts_.alpha = chosen.alpha;
  if (!chosen.plateaus.empty() && !chosen.plateaus.front().is_long)
    summarize("--alpha " + name_of(request_.alpha) +
              ": no range of alpha stands out, and the longest one may be chance");
}

void SolidRun::find_boundary() {
  const ProgressLine line = options().line("boundary");
  boundary_ = solid_boundary(solid_);
  stop_if_interrupted();
}

void SolidRun::count() {
  const ProgressLine line = options().line("voids");
  facts_.measures = measure(file_.points, boundary_.surface);
  Voids all = voids(file_.points, solid_, boundary_);
  facts_.counts = all.counts;
  facts_.voids = std::move(all.all);
  if (is_full()) count_full_complex();
  if (arguments_.balls && std::isfinite(facts_.alpha))
    facts_.balls = union_of_balls(file_.points, facts_.alpha, {.threads = options().threads});
  if (arguments_.json) facts_.components = solid_components(file_.points, solid_, boundary_).all;
  stop_if_interrupted();
}

void SolidRun::count_full_complex() {
  stop_if_interrupted();
  try {
    facts_.full =
        count_full(file_.points, triangulation_, radii_, facts_.alpha, options().threads, until_interrupted());
    FullVoids found = full_voids(
        file_.points,
        void_space(file_.points, triangulation_, radii_, facts_.alpha, options().threads, until_interrupted()),
        facts_.alpha, options().threads, until_interrupted());
    facts_.voids = std::move(found.all);
    void_boundary_ = std::move(found.boundary);
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
}

void SolidRun::find_lives() {
  const ProgressLine line = options().line("radii of voids");
  const VoidLives all(file_.points, triangulation_, radii_, request_.walls, options().threads);
  if (arguments_.void_radii)
    lives_ = all.of(facts_.alpha, around_voids(), largest(facts_.voids, request_.voids_above, request_.top));
  if (request_.pockets) pockets_ = all.pockets(facts_.alpha);
}

/// Writes the boundary. Each fan of triangles gets a vertex of its own, so that the file is a manifold.
void SolidRun::write_boundary(OutputFile& file, Format format) const {
  const Surface& surface = boundary_.surface;
  if (format == Format::npy)
    return write_surface(file, format,
                         {.vertices = file_.points, .triangles = surface.triangles, .index = file_.index});
  const SplitFans fans = split_fans(indexable_surface(surface, until_interrupted()), until_interrupted());
  const VerticesOfPoints vertices({.vertices = file_.points,
                                   .triangles = {},
                                   .colors = file_.colors,
                                   .shift = request_.shift,
                                   .index = file_.index},
                                  fans.triangles, fans.point, true);
  write_surface(file, format, vertices.mesh());
}

void SolidRun::write_picture(OutputFile& file) const {
  const std::vector<bool> none;
  write_surface_png(file,
                    {.points = file_.points,
                     .triangles = boundary_.surface.triangles,
                     .rims = {},
                     .holes = {},
                     .islands = {},
                     .unused = solid_.isolated,
                     .colors = file_.colors,
                     .filled = none},
                    request_.width);
}

void SolidRun::write() {
  const ProgressLine line = writing();
  add(request_.targets, [&](OutputFile& file, const Target& target) {
    if (is_picture(target.format))
      write_picture(file);
    else
      write_solid(file, target.format,
                  {.vertices = file_.points, .tetrahedra = solid_.simplices, .index = file_.index});
  });
  if (request_.boundary)
    add(request_.boundary->path, [&](OutputFile& file) { write_boundary(file, request_.boundary->format); });
  if (request_.voids)
    add(request_.voids->path, [&](OutputFile& file) {
      write_voids(file, request_.voids->format, PointNames(file_), around_voids(),
                  largest(facts_.voids, request_.voids_above, request_.top), request_.walls, lives_);
    });
  if (request_.pockets)
    add(request_.pockets->path, [&](OutputFile& file) {
      write_pockets(file, request_.pockets->format, PointNames(file_),
                    largest(pockets_, request_.voids_above, request_.top));
    });
}

void SolidRun::say_empty() const {
  std::string why = "no four points have such a small circumradius";
  if (solid_.distinct < 4)
    why = "fewer than four distinct points";
  else if (std::isinf(facts_.alpha) || (triangulation_.distinct > 0 && triangulation_.simplices.empty()))
    why = "all points are in a plane";
  say("rbpa", "there is no tetrahedron: " + why);
}

void SolidRun::run() {
  const SpacePointSource& source = request_.source;
  file_ = read([&] { return read_space_points(source.path, source.format, source.choice); });
  warning(file_.warnings);
  facts_.read_seconds = lap();
  build();
  if (has_boundary()) find_boundary();
  if (is_counted()) count();
  if (has_lives()) find_lives();
  facts_.count_seconds = lap();
  write();
  facts_.write_seconds = lap();
  if (arguments_.json) add("-", [&](OutputFile& file) { write_solid_json(file, facts_, PointNames(file_)); });
  if (arguments_.stats) add(*arguments_.stats, [&](OutputFile& file) { write_solid_stats(file, facts_); });
  publish();

  if (solid_.simplices.empty() && !(facts_.full && facts_.full->voids > 0)) say_empty();
  std::vector<std::string> files;
  for (const Target& target : request_.targets) files.push_back(target.path);
  for (const auto& target : {request_.boundary, request_.voids, request_.pockets})
    if (target) files.push_back(target->path);
  summarize(text_of_points(facts_.points, solid_.duplicates.size()) + ", " + text_of(request_.alpha, facts_.alpha) +
            ": " + text_of_solid(facts_) + list_of(files));
  if (const std::string line =
          text_of_shift(request_.boundary ? request_.boundary->format : Format::npy, file_.points,
                        boundary_.surface.triangles, request_.shift, request_.boundary ? request_.boundary->path : "");
      !line.empty())
    summarize(line);
}

}  // namespace

void run_solid(const SolidArguments& arguments) {
  SolidRequest request = parse(arguments);
  if (request.box)
    run_periodic_solid(arguments, request);
  else
    SolidRun(arguments, std::move(request)).run();
}

}  // namespace rbpa::app
