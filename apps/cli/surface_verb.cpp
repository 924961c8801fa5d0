#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/arguments.h"
#include "cli/point_arguments.h"
#include "cli/progress.h"
#include "cli/run.h"
#include "cli/surface_report.h"
#include "cli/verbs.h"
#include "io/bytes/number.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/mesh/write_mesh.h"
#include "picture/surface_picture.h"
#include "rbpa/auto_radii.h"
#include "rbpa/base/error.h"
#include "rbpa/estimate_normals.h"
#include "rbpa/surface_levels.h"

namespace rbpa::app {
namespace {

enum class NormalSource { file, estimate, none };

/// What the command line asks for.
struct SurfaceRequest {
  std::string path;
  Format format;
  CloudRequest choice;
  std::vector<double> radii;            ///< empty: auto
  std::optional<NormalSource> normals;  ///< absent: of the file if it has any, else estimated
  std::vector<Target> targets;
  int width;
  RunOptions run;
};

std::vector<double> parse_radii(const std::string& text) {
  if (text == "auto") return {};
  std::vector<double> radii;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const ParsedNumber number = parse_whole_number(part);
    if (number.fault != NumberFault::none || !(number.value > 0))
      throw WrongUsage("--radius: found " + in_quotes(part) +
                       ", expected a radius: a number above 0, several with commas between them, or auto");
    if (!radii.empty() && number.value <= radii.back())
      throw WrongUsage("--radius: found " + in_quotes(part) + " behind " + text_of(radii.back()) +
                       ", expected ascending radii");
    radii.push_back(number.value);
    begin = end + 1;
  }
  return radii;
}

std::optional<NormalSource> parse_normals(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  if (*text == "file") return NormalSource::file;
  if (*text == "estimate") return NormalSource::estimate;
  if (*text == "none") return NormalSource::none;
  throw WrongUsage("--normals: found " + in_quotes(*text) + ", expected file, estimate or none");
}

SurfaceRequest parse(const SurfaceArguments& arguments) {
  SurfaceRequest request{
      .path = arguments.points,
      .format = parse_format(Use::space, arguments.points, arguments.format, space_formats, "POINTS", Format::text),
      .choice = {},
      .radii = parse_radii(arguments.radius),
      .normals = parse_normals(arguments.normals),
      .targets = {},
      .width = parse_width(arguments.width),
      .run = parse_run(arguments.run)};
  const bool text = request.format == Format::text;
  if (arguments.columns) {
    require_format(text, "--columns", "with fixed columns", "text");
    request.choice.columns = parse_space_columns(*arguments.columns);
  }
  if (arguments.skip_invalid)
    require_format(text || request.format == Format::las, "--skip-invalid", "without lines of points", "las or text");
  request.choice.skip_invalid = arguments.skip_invalid;
  if (arguments.where) {
    const std::optional<FieldNames> names = fields_of(request.format);
    require_format(names.has_value(), "--where", "without fields beside the points", "las, pcd, ply or text");
    request.choice.where = Condition(*arguments.where, *names);
  }
  if (request.normals == NormalSource::none && request.radii.size() > 1)
    throw WrongUsage("--radius: found " + counted(request.radii.size(), "number") +
                     " with --normals none, expected one radius");
  if (arguments.holes) {
    if (find_format(Use::polylines, ending(*arguments.holes)) != Format::obj)
      throw WrongUsage("--holes: found the ending " + in_quotes(ending(*arguments.holes)) + ", expected obj");
    if (request.normals == NormalSource::none)
      throw WrongUsage("--holes: found --normals none, of which the triangles have no boundary");
  }
  std::vector<std::string> reports = given({arguments.stats, arguments.holes});
  if (arguments.json) reports.emplace_back("-");
  request.targets = parse_targets(Use::surface, arguments, arguments.points, reports);
  return request;
}

/// Vertices that no triangle uses left out.
void write_compact(OutputFile& file, Format format, const SpaceMesh& whole) {
  std::vector<std::uint32_t> place(whole.vertices.size(), 0);
  for (const auto& triangle : whole.triangles)
    for (const std::uint32_t corner : triangle) place[corner] = 1;
  SpacePoints kept;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    place[i] = static_cast<std::uint32_t>(kept.points.size());
    kept.points.push_back(whole.vertices[i]);
    if (!whole.normals.empty()) kept.normals.push_back(whole.normals[i]);
    if (!whole.colors.empty()) kept.colors.push_back(whole.colors[i]);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles(whole.triangles.begin(), whole.triangles.end());
  for (auto& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = place[corner];
  write_surface(file, format, {kept.points, triangles, kept.normals, kept.colors});
}

class SurfaceRun : public Run {
 public:
  SurfaceRun(const SurfaceArguments& arguments, SurfaceRequest request)
      : Run(request.path, arguments.outputs, request.run), arguments_(arguments), request_(std::move(request)) {}

  void run();

 private:
  /// One step, with a line of progress; what the library refuses is bad input.
  template <typename Step>
  auto step(const std::string& doing, Step&& work) const;

  void take_normals();
  void build();
  void explain();
  void write();
  void write_target(OutputFile& file, const Target& target);
  void write_holes(OutputFile& file) const;
  void say_empty() const;
  std::string summary() const;

  const SurfaceArguments& arguments_;
  SurfaceRequest request_;
  SpacePoints file_;
  NormalSource source_ = NormalSource::none;
  std::vector<Point3> estimated_;
  std::vector<double> radii_;  ///< by which the surface is made
  Surface surface_;
  std::vector<std::array<std::uint32_t, 3>> ordered_;  ///< triangles as mesh files have them
  SurfaceFacts facts_;

  std::span<const Point3> normals() const {
    if (source_ == NormalSource::none) return {};
    return source_ == NormalSource::estimate ? estimated_ : file_.normals;
  }
};

template <typename Step>
auto SurfaceRun::step(const std::string& doing, Step&& work) const {
  TriangleProgress progress(!options().quiet, doing, triangles_text);
  try {
    return work(SurfaceOptions{.threads = options().threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
}

void SurfaceRun::take_normals() {
  source_ = request_.normals.value_or(file_.normals.empty() ? NormalSource::estimate : NormalSource::file);
  // No points have no normals, and miss none.
  if (source_ == NormalSource::file && file_.normals.empty() && !file_.points.empty())
    bad_input(input(), "no normals", "some, or --normals estimate or none");
  constexpr std::array names{"file", "estimate", "none"};
  facts_.normals = names[static_cast<std::size_t>(source_)];
  if (source_ != NormalSource::estimate) return;
  estimated_ = step("estimating normals", [&](const SurfaceOptions& how) {
    return estimate_normals(file_.points, {.threads = how.threads, .progress = how.progress});
  });
}

void SurfaceRun::build() {
  facts_.radii = request_.radii;
  if (facts_.radii.empty()) {
    facts_.chosen_radii = true;
    facts_.radii = step("choosing radii", [&](const SurfaceOptions& how) { return auto_radii(file_.points, how); });
    // Without normals there is one radius: the one that spans the gaps everywhere.
    if (source_ == NormalSource::none && facts_.radii.size() > 1) facts_.radii = {facts_.radii.back()};
  }
  // Where no radius can be chosen nothing has triangles: any will say so.
  radii_ = facts_.radii.empty() ? std::vector<double>{1} : facts_.radii;
  surface_ = step("rolling", [&](const SurfaceOptions& how) {
    return source_ == NormalSource::none ? exposed_triangles(file_.points, radii_.back(), how)
                                         : surface(file_.points, normals(), radii_, how);
  });
  facts_.distinct = surface_.distinct;
  facts_.counts = count(surface_);
}

void SurfaceRun::explain() {
  facts_.unused = step("looking at unused points", [&](const SurfaceOptions& how) {
    return unused_points(file_.points, normals(), radii_, surface_, how);
  });
  if (source_ == NormalSource::none || facts_.counts.boundary_curves == 0) return;
  facts_.holes = step("looking at holes",
                      [&](const SurfaceOptions& how) { return holes(file_.points, normals(), radii_, surface_, how); });
}

void SurfaceRun::write_target(OutputFile& file, const Target& target) {
  if (target.format == Format::png) {
    std::vector<std::array<std::uint32_t, 2>> rims;
    for (const Hole& hole : facts_.holes)
      for (const RimEdge& edge : hole.edges) rims.push_back({edge.from, edge.to});
    std::vector<std::uint32_t> unused;
    for (const UnusedPoint& point : facts_.unused) unused.push_back(point.index);
    return write_surface_png(file, {file_.points, surface_.triangles, rims, unused, file_.colors}, request_.width);
  }
  // An .npy file has the canonical order whatever other files have.
  if (target.format == Format::npy)
    return write_surface(file, target.format, {file_.points, surface_.triangles, {}, {}});
  if (ordered_.empty())
    ordered_ = source_ == NormalSource::none ? by_shells(file_.points, surface_) : surface_.triangles;
  const SpaceMesh whole{file_.points, ordered_, normals().empty() ? file_.normals : normals(), file_.colors};
  arguments_.compact ? write_compact(file, target.format, whole) : write_surface(file, target.format, whole);
}

void SurfaceRun::write_holes(OutputFile& file) const {
  std::vector<std::array<double, 3>> positions;
  positions.reserve(file_.points.size());
  for (const Point3& p : file_.points) positions.push_back({p.x, p.y, p.z});
  std::vector<Polyline> loops;
  for (const Hole& hole : facts_.holes) {
    Polyline& loop = loops.emplace_back();
    for (const RimEdge& edge : hole.edges) loop.push_back(edge.from);
  }
  write_polylines(file, Format::obj, positions, loops);
}

void SurfaceRun::write() {
  const ProgressLine line = writing();
  add(request_.targets, [&](OutputFile& file, const Target& target) { write_target(file, target); });
  if (arguments_.holes) add(*arguments_.holes, [&](OutputFile& file) { write_holes(file); });
}

void SurfaceRun::say_empty() const {
  std::string why = "fewer than three distinct points";
  if (facts_.distinct >= 3) {
    const std::optional<double> radius = step("looking for a radius", [&](const SurfaceOptions& how) {
      return radius_with_triangles(file_.points, normals(), how);
    });
    why = radius ? "with --radius " + text_of(*radius) + " there would be some"
                 : "and none of the radii that were tried gives one";
    if (!radius && facts_.radii.empty()) why = "all points are on a line";
  }
  say("rbpa", "there is no triangle: " + why);
}

std::string SurfaceRun::summary() const {
  const SurfaceCounts& counts = facts_.counts;
  const std::string origin = source_ == NormalSource::file       ? "normals of the file"
                             : source_ == NormalSource::estimate ? "normals estimated"
                                                                 : "without normals";
  const std::size_t equal = surface_.duplicates.size();
  return counted(facts_.points, "point") + (equal > 0 ? " (" + std::to_string(equal) + " repeated)" : "") + ", " +
         origin +
         (facts_.radii.empty()       ? ", no radius"
          : facts_.radii.size() == 1 ? ", radius "
                                     : ", radii ") +
         text_of_radii(facts_.radii) + (facts_.chosen_radii ? " (auto)" : "") + ": " +
         counted(counts.triangles, "triangle") + ", " + counted(counts.components, "component") + ", " +
         counted(counts.boundary_curves, "boundary curve") + ", genus " + std::to_string(counts.genus) +
         list_of(request_.targets);
}

void SurfaceRun::run() {
  file_ = read([&] { return read_space_points(request_.path, request_.format, request_.choice); });
  remark(file_.remarks);
  facts_.points = file_.points.size();
  facts_.read_seconds = lap();
  take_normals();
  facts_.normals_seconds = lap();
  build();
  explain();
  facts_.threads = options().threads_or_all();
  facts_.build_seconds = lap();

  write();
  facts_.write_seconds = lap();
  if (arguments_.json) add("-", [&](OutputFile& file) { write_surface_json(file, facts_); });
  if (arguments_.stats) add(*arguments_.stats, [&](OutputFile& file) { write_surface_stats(file, facts_); });
  publish();

  if (surface_.triangles.empty()) say_empty();
  summarize(summary());
  for (const std::string& line : explanations(facts_)) summarize(line);
}

}  // namespace

void run_surface(const SurfaceArguments& arguments) { SurfaceRun(arguments, parse(arguments)).run(); }

}  // namespace rbpa::app
