#include "space/periodic_solid.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_mesh.h"
#include "io/number.h"
#include "picture/picture.h"
#include "picture/surface_picture.h"
#include "rbpa/base/error.h"
#include "rbpa/space/persistence/choose_solid_alpha.h"
#include "rbpa/space/solid/periodic_solid.h"
#include "rbpa/space/solid/solid_radii.h"
#include "shared/progress.h"
#include "space/solid_report.h"

namespace rbpa::app {
namespace {

class PeriodicRun : public Run {
 public:
  PeriodicRun(const SolidArguments& arguments, const SolidRequest& request)
      : Run(request.source.path, arguments.outputs, request.run), arguments_(arguments), request_(request) {}

  void run();

 private:
  /// Returns whether any output needs the topology.
  bool is_counted() const { return !options().quiet || arguments_.json || arguments_.run.stats || request_.voids; }
  std::string name_of_points() const;
  void settle_box();
  void build();
  void select_within();
  void write();
  void write_picture(OutputFile& file) const;

  const SolidArguments& arguments_;
  SolidRequest request_;
  SpacePoints file_;
  PeriodicSolid solid_;
  std::vector<Triangle> boundary_;
  PeriodicFacts facts_;
};

/// Returns "atoms" for a molecule, otherwise "points".
std::string PeriodicRun::name_of_points() const {
  return has(request_.source.format, &CloudFormat::is_molecule) ? "atoms" : "points";
}

/// Sets request_.box to the cell of the file for --box auto. Otherwise prints a warning, unless quiet, if the cell of
/// the file differs from --box or cannot be used. Throws BadInput for --box auto if the file has no usable cell.
void PeriodicRun::settle_box() {
  const std::optional<Point3>& sides = file_.cell.sides;
  const std::string& fault = file_.cell.fault;
  const Point3 given = *request_.box;
  if (given == Point3()) {
    if (!sides)
      throw BadInput(input() + ": found " + (fault.empty() ? "no cell" : fault) +
                     ", expected CRYST1 or _cell with right angles for --box auto (--box LX,LY,LZ gives the sides)");
    request_.box = sides;
    if (const std::string text = warning_of_symmetry(file_.cell); !text.empty()) warning(text);
  } else if (sides && *sides != given) {
    warning("--box is not the cell of the file, which is " + text_of(sides->x) + " x " + text_of(sides->y) + " x " +
            text_of(sides->z) + " (--box auto uses that)");
  } else if (!fault.empty()) {
    warning("the file has " + fault + ": the sides of --box are used");
  }
}

void PeriodicRun::build() {
  const AlphaChoice& alpha = request_.alpha;
  // Compute all tetrahedra for rules and counts: voids consist of tetrahedra with a radius above alpha.
  const bool needs_all = is_counted() || alpha.rule != AlphaRule::given;
  TriangleProgress progress(!options().quiet, "tetrahedra", text_of_progress);
  try {
    solid_ =
        periodic_solid(file_.points, *request_.box, needs_all ? std::numeric_limits<double>::infinity() : alpha.radius,
                       {.threads = options().threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what() +
                   (needs_all && std::isfinite(alpha.radius)
                        ? "; voids and counts at --alpha " + rounded(alpha.radius, 6) +
                              " need all tetrahedra (--quiet writes those within --alpha without them)"
                        : ""));
  }
  facts_.points = file_.points.size();
  facts_.distinct = solid_.distinct;
  facts_.box = solid_.box;
  facts_.alpha = alpha.radius;
  facts_.walls = request_.walls;
  facts_.threads = options().threads_or_all();
  facts_.build_seconds = lap();
  if (needs_all) select_within();
  facts_.isolated = solid_.isolated.size();
}

/// Chooses alpha if there is a rule, counts the topology if an output needs it, and keeps the tetrahedra with a radius
/// of at most alpha.
void PeriodicRun::select_within() {
  const ProgressLine line = options().line("voids");
  const std::vector<double> radii =
      circumradii(solid_.positions, solid_.simplices, options().threads, until_interrupted());
  stop_if_interrupted();
  facts_.alpha_rule = name_of(request_.alpha);
  if (request_.alpha.rule != AlphaRule::given) {
    facts_.alpha = choose_solid_alpha(request_.alpha, file_.points, without_offsets(solid_), radii, until_interrupted(),
                                      options().threads)
                       .alpha;
    stop_if_interrupted();
  }
  if (is_counted())
    facts_.topology =
        periodic_topology(solid_, radii, facts_.alpha, facts_.walls, options().threads, until_interrupted());
  solid_ = within(solid_, radii, facts_.alpha);
  stop_if_interrupted();
  facts_.count_seconds = lap();
}

void PeriodicRun::write_picture(OutputFile& file) const {
  const std::vector<bool> none;
  write_surface_png(file,
                    {.points = solid_.positions,
                     .triangles = boundary_,
                     .rims = {},
                     .holes = {},
                     .islands = {},
                     .unused = {},
                     .colors = {},
                     .filled = none},
                    request_.width);
}

void PeriodicRun::write() {
  const ProgressLine line = writing();
  add(request_.targets, [&](OutputFile& file, const Target& target) {
    if (is_picture(target.format))
      write_picture(file);
    else if (target.format == Format::npy)
      write_solid(
          file, target.format,
          {.vertices = solid_.positions, .tetrahedra = without_offsets(solid_).simplices, .index = file_.index});
    else
      write_solid(file, target.format, {.vertices = solid_.positions, .tetrahedra = solid_.simplices});
  });
  if (request_.boundary)
    add(request_.boundary->path, [&](OutputFile& file) {
      write_surface(file, request_.boundary->format,
                    {.vertices = solid_.positions, .triangles = boundary_, .shift = request_.shift});
    });
  if (request_.voids)
    add(request_.voids->path,
        [&](OutputFile& file) { write_periodic_voids(file, request_.voids->format, PointNames(file_), facts_); });
}

void PeriodicRun::run() {
  file_ = read_points(request_.source);
  if (file_.points.empty())
    throw BadInput(input() + ": found 0 " + name_of_points() +
                   ", expected at least one for --box (see --where and --waters)");
  settle_box();
  const Point3& box = *request_.box;
  warning(warnings_of_range(file_.points, {{{box.x, 0, 0}, {0, box.y, 0}, {0, 0, box.z}}}, name_of_points()));
  facts_.read_seconds = lap();
  build();
  boundary_ = periodic_boundary(solid_);
  write();
  facts_.write_seconds = lap();
  if (arguments_.json) add("-", [&](OutputFile& file) { write_periodic_json(file, facts_, PointNames(file_)); });
  add_stats([&](OutputFile& file) { write_periodic_stats(file, facts_); });
  publish();

  const bool has_void = facts_.topology && !facts_.topology->voids.empty() && facts_.walls == ComplexKind::full;
  if (solid_.simplices.empty() && !has_void)
    say("rbpa", "there is no tetrahedron: none has circumradius <= " + text_of(facts_.alpha) +
                    " (a larger --alpha may have some)");
  std::vector<std::string> files;
  for (const Target& target : request_.targets) files.push_back(target.path);
  for (const auto& target : {request_.boundary, request_.voids})
    if (target) files.push_back(target->path);
  if (facts_.topology)
    summarize(text_of_points(facts_.points, solid_.duplicates.size()) + ", " + text_of(request_.alpha, facts_.alpha) +
              ": " + text_of_periodic(facts_) + list_of(files));
}

}  // namespace

void run_periodic_solid(const SolidArguments& arguments, const SolidRequest& request) {
  PeriodicRun(arguments, request).run();
}

}  // namespace rbpa::app
