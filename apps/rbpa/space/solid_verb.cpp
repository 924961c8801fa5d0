#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/vertices_of_points.h"
#include "io/mesh/write_mesh.h"
#include "io/number.h"
#include "picture/picture.h"
#include "picture/surface_picture.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/measure_solid.h"
#include "rbpa/space/surface/split_fans.h"
#include "shared/progress.h"
#include "shared/run.h"
#include "space/periodic_solid.h"
#include "space/solid_report.h"
#include "space/solid_request.h"
#include "space/void_files.h"

namespace rbpa::app {
namespace {

class SolidRun : public Run {
 public:
  SolidRun(const SolidArguments& arguments, SolidRequest request)
      : Run(request.source.path, arguments.outputs, request.run), arguments_(arguments), request_(std::move(request)) {}

  void run();

 private:
  /// Returns whether any output needs the counts.
  bool is_counted() const { return !options().quiet || arguments_.json || arguments_.run.stats || arguments_.voids; }
  bool has_lives() const { return arguments_.void_radii || request_.pockets; }
  SolidFacts measured();
  void find_lives(const SolidFacts& facts);
  void write(const SolidFacts& facts);
  void write_boundary(OutputFile& file, Format format, const Surface& surface) const;
  void write_picture(OutputFile& file, const SolidFacts& facts) const;

  const SolidArguments& arguments_;
  SolidRequest request_;
  SpacePoints file_ = {};
  std::optional<std::vector<VoidLife>> lives_ = {};  // lives of the voids, in the order of the voids
  std::vector<Pocket> pockets_ = {};
};

/// Returns the items with a volume above `above`, at most the first `top` of them. Requires: `items` are in descending
/// order of volume.
template <typename Item>
std::span<const Item> largest(const std::vector<Item>& items, double above, std::size_t top) {
  const auto last = std::find_if(items.begin(), items.end(), [&](const Item& item) { return !(item.volume > above); });
  return {items.data(), std::min(static_cast<std::size_t>(last - items.begin()), top)};
}

/// Computes everything that the outputs need, with a progress line for each step.
SolidFacts SolidRun::measured() {
  constexpr std::array doing{"tetrahedra", "alpha", "boundary",
                             "voids"};  // indexed by SolidStep; "voids" includes the balls
  const bool is_full = request_.walls == ComplexKind::full;
  const auto is_drawn = [](const Target& target) { return is_picture(target.format); };
  std::optional<TriangleProgress> line;
  std::optional<double> build_seconds, choose_seconds;
  SolidStep now = SolidStep::tetrahedra;
  const auto take_times = [&](SolidStep step) {
    if (!build_seconds && step != SolidStep::tetrahedra)
      build_seconds = lap();
    else if (now == SolidStep::choosing)
      choose_seconds = lap();
    now = step;
  };
  try {
    SolidFacts facts{measure_solid(
        file_.points,
        {.alpha = request_.alpha,
         .boundary = request_.boundary || std::any_of(request_.targets.begin(), request_.targets.end(), is_drawn),
         .counts = is_counted(),
         .full = is_full && is_counted(),
         .balls = arguments_.balls && is_counted(),
         .components = arguments_.json,
         .triangulation = has_lives() || is_full,
         .threads = options().threads,
         .progress = [&](const Progress& progress) { return line->watch()(progress); },
         .on_step =
             [&](SolidStep step) {
               take_times(step);
               if (step != SolidStep::balls)
                 line.emplace(!options().quiet, doing.at(static_cast<std::size_t>(step)), text_of_progress);
             }})};
    take_times(SolidStep::balls);
    facts.build_seconds = build_seconds.value_or(0);
    facts.choose_seconds = choose_seconds;
    return facts;
  } catch (const InvalidInput& e) {
    if (now == SolidStep::choosing)
      throw WrongUsage("--" + std::string(e.what()) + " (rbpa alpha POINTS --dimension 3 lists them)");
    if (now == SolidStep::balls) throw;
    throw BadInput(input() + ": " + e.what());
  }
}

void SolidRun::find_lives(const SolidFacts& facts) {
  const ProgressLine line = options().line("radii of voids");
  const VoidLives all(file_.points, facts.triangulation, facts.radii, request_.walls, options().threads);
  if (arguments_.void_radii)
    lives_ = all.of(facts.alpha, facts.around_voids(), largest(facts.voids, request_.voids_above, request_.top));
  if (request_.pockets) pockets_ = all.pockets(facts.alpha);
}

/// Writes the boundary. In formats that number vertices, each fan of triangles has its own, so that the mesh is a
/// manifold; npy numbers points, and STL nothing.
void SolidRun::write_boundary(OutputFile& file, Format format, const Surface& surface) const {
  if (format == Format::npy || format == Format::stl)
    return write_surface(
        file, format,
        {.vertices = file_.points, .triangles = surface.triangles, .shift = request_.shift, .index = file_.index});
  const SplitFans fans = split_fans(indexable_surface(surface, until_interrupted()), until_interrupted());
  const VerticesOfPoints vertices({.vertices = file_.points,
                                   .triangles = {},
                                   .colors = file_.colors,
                                   .shift = request_.shift,
                                   .index = file_.index,
                                   .fields = {file_.kept, {}}},
                                  fans.triangles, fans.point, true);
  write_surface(file, format, vertices.mesh());
}

void SolidRun::write_picture(OutputFile& file, const SolidFacts& facts) const {
  const std::vector<bool> none;
  write_surface_png(file,
                    {.points = file_.points,
                     .triangles = facts.boundary.surface.triangles,
                     .rims = {},
                     .holes = {},
                     .islands = {},
                     .unused = facts.solid.isolated,
                     .colors = file_.colors,
                     .filled = none},
                    request_.width);
}

void SolidRun::write(const SolidFacts& facts) {
  const ProgressLine line = writing();
  add(request_.targets, [&](OutputFile& file, const Target& target) {
    if (is_picture(target.format))
      write_picture(file, facts);
    else
      write_solid(file, target.format,
                  {.vertices = file_.points,
                   .tetrahedra = facts.solid.simplices,
                   .index = file_.index,
                   .fields = {file_.kept, {}}});
  });
  if (request_.boundary)
    add(request_.boundary->path,
        [&](OutputFile& file) { write_boundary(file, request_.boundary->format, facts.boundary.surface); });
  if (request_.voids)
    add(request_.voids->path, [&](OutputFile& file) {
      write_voids(file, request_.voids->format, PointNames(file_), facts.around_voids(),
                  largest(facts.voids, request_.voids_above, request_.top), request_.walls, lives_);
    });
  if (request_.pockets)
    add(request_.pockets->path, [&](OutputFile& file) {
      write_pockets(file, request_.pockets->format, PointNames(file_),
                    largest(pockets_, request_.voids_above, request_.top));
    });
}

/// Returns "there is no tetrahedron: " and the reason.
std::string why_empty(const SolidFacts& facts) {
  std::string why = "none has circumradius <= " + text_of(facts.alpha) + " (a larger --alpha may have some)";
  if (facts.distinct < 4)
    why = "fewer than four distinct points";
  else if (std::isinf(facts.alpha) || (facts.triangulation.distinct > 0 && facts.triangulation.simplices.empty()))
    why = "all points are in a plane";
  return "there is no tetrahedron: " + why;
}

void SolidRun::run() {
  file_ = read_points(request_.source);
  const double read_seconds = lap();
  SolidFacts facts = measured();
  facts.read_seconds = read_seconds;
  facts.points = file_.points.size();
  facts.distinct = facts.solid.distinct;
  facts.isolated = facts.solid.isolated.size();
  facts.walls = request_.walls;
  facts.alpha_rule = name_of(request_.alpha);
  facts.threads = options().threads_or_all();
  if (!facts.plateaus.empty() && !facts.plateaus.front().is_long)
    summarize("--alpha " + name_of(request_.alpha) +
              ": no range of alpha stands out, and the longest one may be chance");
  if (has_lives()) find_lives(facts);
  facts.count_seconds = lap();
  std::vector<Target> meshes = request_.targets;
  if (request_.boundary) meshes.push_back(*request_.boundary);
  warning_on_fields(file_.kept, meshes, facts.solid.duplicates.size());
  write(facts);
  facts.write_seconds = lap();
  if (arguments_.json) add("-", [&](OutputFile& file) { write_solid_json(file, facts, PointNames(file_)); });
  add_stats([&](OutputFile& file) { write_solid_stats(file, facts); });
  publish();

  if (facts.solid.simplices.empty() && !(facts.full && facts.full->voids > 0)) say("rbpa", why_empty(facts));
  std::vector<std::string> files;
  for (const Target& target : request_.targets) files.push_back(target.path);
  for (const auto& target : {request_.boundary, request_.voids, request_.pockets})
    if (target) files.push_back(target->path);
  summarize(text_of_points(facts.points, facts.solid.duplicates.size()) + ", " + text_of(request_.alpha, facts.alpha) +
            ": " + text_of_solid(facts) + list_of(files));
  if (const std::string line = text_of_shift(request_.boundary ? request_.boundary->format : Format::npy, file_.points,
                                             facts.boundary.surface.triangles, request_.shift,
                                             request_.boundary ? request_.boundary->path : "");
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
