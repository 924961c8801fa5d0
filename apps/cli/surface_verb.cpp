#include "cli/surface_verb.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>
#include <utility>

#include "cli/stats.h"
#include "cli/surface_report.h"
#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_mesh.h"
#include "io/progress_line.h"
#include "picture/surface_picture.h"
#include "rbpa/auto_radii.h"
#include "rbpa/base/error.h"
#include "rbpa/estimate_normals.h"
#include "rbpa/surface_levels.h"

namespace rbpa::app {
namespace {

/// A line that counts triangles where there are any, and hears Ctrl-C.
class SurfaceProgress {
 public:
  SurfaceProgress(bool wanted, const std::string& doing) : line_("rbpa", wanted, doing) {}

  std::function<bool(const Progress&)> watch() {
    return [this](const Progress& progress) {
      triangles_ = progress.triangles;
      if (!begun_ && progress.triangles > 0) {
        begun_ = true;
        line_.say([this](double) { return short_number(static_cast<double>(triangles_.load())) + " triangles"; });
      }
      return !interrupted();
    };
  }

 private:
  std::atomic<std::size_t> triangles_ = 0;
  bool begun_ = false;
  ProgressLine line_;
};

class SurfaceRun {
 public:
  explicit SurfaceRun(const SurfaceArguments& arguments) : arguments_(arguments), request_(parse(arguments)) {}

  void run();

 private:
  bool talks() const { return !request_.run.quiet; }
  std::string name() const { return request_.path == "-" ? "standard input" : request_.path; }
  /// One step, with a line of progress; what the library refuses is bad input.
  template <typename Step>
  auto step(const std::string& doing, Step&& work);

  void read();
  void take_normals();
  void build();
  void explain();
  void write(OutputSet& outputs);
  void write_target(OutputFile& file, const Target& target);
  void say_empty();
  void summarize() const;

  const SurfaceArguments& arguments_;
  SurfaceRequest request_;
  SpacePoints file_;
  NormalSource source_ = NormalSource::none;
  std::vector<Point3> estimated_;
  Surface surface_;
  std::vector<std::array<std::uint32_t, 3>> ordered_;  ///< triangles as mesh files have them
  SurfaceFacts facts_;

  std::span<const Point3> normals() const {
    if (source_ == NormalSource::none) return {};
    return source_ == NormalSource::estimate ? estimated_ : file_.normals;
  }
};

template <typename Step>
auto SurfaceRun::step(const std::string& doing, Step&& work) {
  SurfaceProgress progress(talks(), doing);
  try {
    return work(SurfaceOptions{.threads = request_.run.threads, .progress = progress.watch()});
  } catch (const InvalidInput& e) {
    throw BadInput(name() + ": " + e.what());
  }
}

void SurfaceRun::read() {
  {
    const ProgressLine line("rbpa", talks() && !read_from_terminal(request_.path), "reading");
    file_ = read_space_points(request_.path, request_.format, request_.choice);
  }
  if (talks())
    for (const std::string& remark : file_.remarks) say("rbpa", name() + ": " + remark);
  facts_.points = file_.points.size();
}

void SurfaceRun::take_normals() {
  source_ = request_.normals.value_or(file_.normals.empty() ? NormalSource::estimate : NormalSource::file);
  // No points have no normals, and miss none.
  if (source_ == NormalSource::file && file_.normals.empty() && !file_.points.empty())
    bad_input(name(), "no normals", "some, or --normals estimate or none");
  constexpr std::array names{"file", "estimate", "none"};
  facts_.normals = names[static_cast<std::size_t>(source_)];
  if (source_ != NormalSource::estimate) return;
  estimated_ = step("estimating normals", [&](const SurfaceOptions& options) {
    return estimate_normals(file_.points, {.threads = options.threads, .progress = options.progress});
  });
}

void SurfaceRun::build() {
  facts_.radii = request_.radii;
  if (facts_.radii.empty()) {
    facts_.chosen_radii = true;
    facts_.radii =
        step("choosing radii", [&](const SurfaceOptions& options) { return auto_radii(file_.points, options); });
    // Without normals there is one radius: the one that spans the gaps everywhere.
    if (source_ == NormalSource::none && facts_.radii.size() > 1) facts_.radii = {facts_.radii.back()};
  }
  // Where no radius can be chosen nothing has triangles: any will say so.
  const std::vector<double> radii = facts_.radii.empty() ? std::vector<double>{1} : facts_.radii;
  surface_ = step("rolling", [&](const SurfaceOptions& options) {
    return source_ == NormalSource::none ? exposed_triangles(file_.points, radii.back(), options)
                                         : surface(file_.points, normals(), radii, options);
  });
  facts_.distinct = surface_.distinct;
  facts_.counts = count(surface_);
}

void SurfaceRun::explain() {
  const std::vector<double> radii = facts_.radii.empty() ? std::vector<double>{1} : facts_.radii;
  facts_.unused = step("looking at unused points", [&](const SurfaceOptions& options) {
    return unused_points(file_.points, normals(), radii, surface_, options);
  });
  if (source_ == NormalSource::none || facts_.counts.boundary_curves == 0) return;
  facts_.holes = step("looking at holes", [&](const SurfaceOptions& options) {
    return holes(file_.points, normals(), radii, surface_, options);
  });
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
  const std::span<const Point3> all_normals = normals().empty() ? file_.normals : normals();
  if (!arguments_.compact)
    return write_surface(file, target.format, {file_.points, ordered_, all_normals, file_.colors});
  std::vector<std::uint32_t> place(file_.points.size(), 0);
  for (const auto& triangle : ordered_)
    for (const std::uint32_t corner : triangle) place[corner] = 1;
  SpacePoints kept;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    place[i] = static_cast<std::uint32_t>(kept.points.size());
    kept.points.push_back(file_.points[i]);
    if (!all_normals.empty()) kept.normals.push_back(all_normals[i]);
    if (!file_.colors.empty()) kept.colors.push_back(file_.colors[i]);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles = ordered_;
  for (auto& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = place[corner];
  write_surface(file, target.format, {kept.points, triangles, kept.normals, kept.colors});
}

void SurfaceRun::write(OutputSet& outputs) {
  const ProgressLine line("rbpa", talks() && !written_to_terminal(arguments_.outputs), "writing");
  for (const Target& target : request_.targets) {
    stop_if_interrupted();
    OutputFile& file = outputs.add(target.path);
    write_target(file, target);
    file.finish();
  }
  if (!arguments_.holes) return;
  std::vector<std::array<double, 3>> positions;
  positions.reserve(file_.points.size());
  for (const Point3& p : file_.points) positions.push_back({p.x, p.y, p.z});
  std::vector<Polyline> loops;
  for (const Hole& hole : facts_.holes) {
    Polyline& loop = loops.emplace_back();
    for (const RimEdge& edge : hole.edges) loop.push_back(edge.from);
  }
  OutputFile& file = outputs.add(*arguments_.holes);
  write_polylines(file, Format::obj, positions, loops);
  file.finish();
}

void SurfaceRun::say_empty() {
  std::string why = "fewer than three distinct points";
  if (facts_.distinct >= 3) {
    const std::optional<double> radius = step("looking for a radius", [&](const SurfaceOptions& options) {
      return radius_with_triangles(file_.points, normals(), options);
    });
    why = radius ? "with --radius " + std::string(ShortestText(*radius)) + " there would be some"
                 : "and none of the radii that were tried gives one";
    if (!radius && facts_.radii.empty()) why = "all points are on a line";
  }
  say("rbpa", "there is no triangle: " + why);
}

void SurfaceRun::summarize() const {
  const SurfaceCounts& counts = facts_.counts;
  const std::string origin = source_ == NormalSource::file       ? "normals of the file"
                             : source_ == NormalSource::estimate ? "normals estimated"
                                                                 : "without normals";
  const std::size_t equal = surface_.duplicates.size();
  say("rbpa", counted(facts_.points, "point") + (equal ? " (" + std::to_string(equal) + " repeated)" : std::string()) +
                  ", " + origin +
                  (facts_.radii.empty()       ? ", no radius"
                   : facts_.radii.size() == 1 ? ", radius "
                                              : ", radii ") +
                  text_of_radii(facts_.radii) + (facts_.chosen_radii ? " (auto)" : "") + ": " +
                  counted(counts.triangles, "triangle") + ", " + counted(counts.components, "component") + ", " +
                  counted(counts.boundary_curves, "boundary curve") + ", genus " + std::to_string(counts.genus) +
                  list_of(request_.targets));
  for (const std::string& line : explanations(facts_)) say("rbpa", line);
}

void SurfaceRun::run() {
  Stopwatch watch;
  read();
  facts_.read_seconds = watch.lap();
  take_normals();
  facts_.normals_seconds = watch.lap();
  build();
  explain();
  facts_.threads = request_.run.threads ? request_.run.threads : std::max(1U, std::thread::hardware_concurrency());
  facts_.build_seconds = watch.lap();

  OutputSet outputs;
  write(outputs);
  facts_.write_seconds = watch.lap();
  const auto report = [&](const std::string& path, auto&& write_report) {
    OutputFile& file = outputs.add(path);
    write_report(file, facts_);
    file.finish();
  };
  if (arguments_.json) report("-", write_surface_json);
  if (arguments_.stats) report(*arguments_.stats, write_surface_stats);
  outputs.publish();

  if (surface_.triangles.empty()) say_empty();
  if (talks()) summarize();
}

}  // namespace

void run_surface(const SurfaceArguments& arguments) { SurfaceRun(arguments).run(); }

}  // namespace rbpa::app
