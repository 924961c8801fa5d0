#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/mesh/single_precision.h"
#include "io/number.h"
#include "picture/picture.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/repair/reconstruct.h"
#include "rbpa/space/repair/watertight.h"
#include "rbpa/space/surface/split_fans.h"
#include "shared/progress.h"
#include "shared/run.h"
#include "shared/verbs.h"
#include "space/surface_files.h"
#include "space/surface_report.h"
#include "space/surface_request.h"
#include "triangulation/surface_counts.h"

namespace rbpa::app {
namespace {

// Texts of the progress line, indexed by ReconstructionStep; null means that no line is shown.
constexpr std::array<const char*, 13> step_texts{"looking for outliers",
                                                 "scale space",
                                                 "estimating normals",
                                                 "choosing radii",
                                                 "rolling",
                                                 "looking at unused points",
                                                 "looking at holes",
                                                 "looking for repairs",
                                                 "looking for a radius",
                                                 nullptr,
                                                 "filling holes",
                                                 "refining fillings",
                                                 "decimating"};
static_assert(step_texts.size() == static_cast<std::size_t>(ReconstructionStep::decimating) + 1);
constexpr std::array source_names{"file", "estimate", "none"};  // indexed by NormalSource

/// Returns the reason why `file` would not be watertight, and a way to mend it: rounding makes triangles lose their
/// area, coincide or cross, or STL joins vertices at equal positions. Returns "" if the file would be watertight, and
/// for formats in double precision. Requires: the triangles are a closed surface without crossings. Throws as
/// crossing_triangles() and single_positions() do. The check is exact for the rounded coordinates,
/// which a reader of the file gets.
std::string why_file_is_open(Format format, const std::string& file, std::span<const Point3> points,
                             std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                             const SurfaceOptions& options) {
  if (!has_single_precision(format)) return "";
  const SinglePositions rounded = single_positions(format, points, triangles, shift, file);
  std::string why = why_not_kept(rounded, format, points, triangles, file);
  if (!why.empty()) return why;
  if (const std::size_t edges = non_manifold_edges(triangles); format == Format::stl && edges > 0)
    return file + ": STL joins what is at equal positions, and " + counted(edges, "edge") +
           " would have more than two triangles (.ply, .obj and .off keep them apart)";
  const auto crossing = [&](const SinglePositions& positions) {
    std::vector<Point3> places;
    for (const auto& [x, y, z] : positions.at) places.push_back({x, y, z});
    return crossing_triangles(places, triangles, most_crossing_pairs, options).size();
  };
  const std::size_t pairs = crossing(rounded);
  if (pairs == 0) return "";
  return file + ": single precision makes " + (pairs < most_crossing_pairs ? "" : "at least ") +
         counted(pairs, "pair") + " of triangles cross" +
         way_to_keep((!shift || shift->by) &&
                     crossing(single_positions(format, points, triangles, Shift(), file)) == 0);
}

class SurfaceRun : public Run {
 public:
  SurfaceRun(const SurfaceArguments& arguments, SurfaceRequest request)
      : Run(request.source.path, arguments.outputs, request.run), arguments_(arguments), request_(std::move(request)) {}

  void run();

 private:
  ReconstructionOptions options_for(SpacePoints& file) const;
  SurfaceFacts reconstructed(SpacePoints& file);
  void require_watertight(const SurfaceFacts& facts) const;
  void count(SurfaceFacts& facts, const SplitFans& fans) const;
  void write(SurfaceFacts& facts, const SplitFans& fans, SpacePoints& file);
  std::string summary(const SurfaceFacts& facts) const;

  const SurfaceArguments& arguments_;
  SurfaceRequest request_;
};

/// Returns the options with the normals and viewpoints of the file. Throws BadInput if the file lacks requested
/// normals, or has normals although --color normals requires estimated ones.
ReconstructionOptions SurfaceRun::options_for(SpacePoints& file) const {
  ReconstructionOptions how = request_.how;
  for (std::size_t i = 0; i < file.points.size() && file.fields.size() == 3; ++i)
    how.viewpoints.push_back({file.fields[0][i], file.fields[1][i], file.fields[2][i]});
  const bool has_normals = !file.normals.empty();
  // Accept an empty file, which lacks no normals.
  if (how.source == NormalSource::given && !has_normals && !file.points.empty())
    bad_input(input(), "no normals",
              "a normal for each point (--normals estimate computes them, --normals none does without)");
  if (request_.colors_normals && (how.source ? *how.source != NormalSource::estimate : has_normals))
    bad_input(input(), "normals, whose confidence is not known",
              "none, as --color normals requires (or --normals estimate)");
  how.normals = std::move(file.normals);
  how.explain = true;
  how.threads = options().threads;
  return how;
}

/// Reconstructs the surface, with a progress line for each step. Moves points and normals out of `file`.
SurfaceFacts SurfaceRun::reconstructed(SpacePoints& file) {
  ReconstructionOptions how = options_for(file);
  const bool has_viewpoint = !how.viewpoints.empty();
  const std::size_t points = file.points.size();
  std::optional<double> normals_seconds;
  std::optional<TriangleProgress> line;
  how.on_step = [&](ReconstructionStep step) {
    if (!normals_seconds && (step == ReconstructionStep::radii || step == ReconstructionStep::rolling))
      normals_seconds = lap();
    const char* doing = step_texts[static_cast<std::size_t>(step)];
    line.emplace(!options().quiet && doing != nullptr, doing == nullptr ? "" : doing, triangles_text);
  };
  how.progress = [&](const Progress& progress) { return line->watch()(progress); };
  try {
    SurfaceFacts facts{reconstruct(std::move(file.points), std::move(how))};
    facts.input_points = points;
    facts.has_viewpoint = has_viewpoint;
    facts.normals_seconds = normals_seconds.value_or(0);
    return facts;
  } catch (const InvalidInput& e) {
    throw BadInput(input() + ": " + e.what());
  }
}

/// Throws Failure if the surface, or the mesh in a file, is not watertight.
void SurfaceRun::require_watertight(const SurfaceFacts& facts) const {
  if (const std::string left = openings(facts); !left.empty()) {
    if (facts.surface.triangles.empty()) say("rbpa", why_empty(facts));
    throw Failure("--watertight: " + left + "; nothing is written" +
                  (facts.holes.empty() ? ""
                                       : " (--fill-holes all in its place fills what can be filled; --holes FILE shows "
                                         "the rest)"));
  }
  for (const Target& target : request_.targets) {
    TriangleProgress progress(!options().quiet, "looking for crossings", triangles_text);
    const std::string why =
        why_file_is_open(target.format, target.path, facts.points, facts.surface.triangles, request_.shift,
                         {.threads = options().threads, .progress = progress.watch()});
    if (!why.empty()) throw Failure("--watertight: " + why + "; nothing is written");
  }
}

/// Sets the counts and the settings of the run in `facts`.
void SurfaceRun::count(SurfaceFacts& facts, const SplitFans& fans) const {
  facts.outlier_factor = request_.how.outlier_factor;
  facts.has_repairs = arguments_.repairs;
  facts.watertight = arguments_.watertight;
  facts.manifold = arguments_.manifold || arguments_.watertight;
  facts.threads = options().threads_or_all();
  facts.normals_name = source_names[static_cast<std::size_t>(facts.source)];
  if (facts.source == NormalSource::estimate) {
    const auto end = facts.confidence.begin() + static_cast<std::ptrdiff_t>(facts.input_points);
    const auto in_doubt =
        std::count_if(facts.confidence.begin(), end, [](double confidence) { return confidence < least_confidence; });
    facts.in_doubt =
        static_cast<std::size_t>(in_doubt) - facts.outliers.points.size();  // outliers have the confidence 0
  }
  facts.counts = app::count(fans, facts.components);
  facts.non_manifold_edges = non_manifold_edges(facts.manifold ? fans.triangles : facts.surface.triangles);
}

/// Returns the positions of the points in pictures. An outlier gets the position of the first point that is no outlier,
/// so that it is not visible.
std::vector<Point3> seen_points(const SurfaceFacts& facts) {
  std::vector<Point3> seen = facts.points;
  const std::vector<std::uint32_t>& outliers = facts.outliers.points;
  std::uint32_t first = 0;
  while (first < outliers.size() && outliers[first] == first) ++first;
  for (const std::uint32_t i : outliers) seen[i] = seen[first];
  return seen;
}

/// Appends a color for each added point: the mean color of the three points around the added point. Does nothing if
/// `colors` is empty.
void add_colors(std::vector<std::array<std::uint8_t, 3>>& colors, const AddedPoints& added) {
  if (colors.empty()) return;
  for (const auto& [a, b, c] : added.between) {
    std::array<std::uint8_t, 3> mean{};
    for (std::size_t k = 0; k < 3; ++k)
      mean[k] = static_cast<std::uint8_t>((colors[a][k] + colors[b][k] + colors[c][k] + 1) / 3);
    colors.push_back(mean);
  }
}

void SurfaceRun::write(SurfaceFacts& facts, const SplitFans& fans, SpacePoints& file) {
  const ProgressLine line = writing();
  add_colors(file.colors, facts.added);
  append_between(file.kept, facts.points, facts.added.between);
  for (std::size_t next = file.all_points; !file.index.empty() && file.index.size() < facts.points.size(); ++next)
    file.index.push_back(static_cast<std::uint32_t>(next));  // input indices of the added points
  if (request_.colors_normals) file.colors = colors_of(facts.confidence);
  const std::vector<Point3> seen = seen_points(facts);
  std::vector<std::uint32_t> order;
  if (facts.source == NormalSource::none) order = by_shells(facts.components);
  const SurfaceFiles files{.facts = facts,
                           .fans = fans,
                           .order = order,
                           .seen = seen,
                           .colors = file.colors,
                           .compact = arguments_.compact || arguments_.faces.has_value(),
                           .shift = request_.shift,
                           .index = file.index,
                           .fields = file.kept};
  add(request_.targets,
      [&](OutputFile& out, const Target& target) { files.write(out, target.format, request_.width); });
  if (arguments_.holes) add(*arguments_.holes, [&](OutputFile& out) { files.write_curves(out); });
}

std::string SurfaceRun::summary(const SurfaceFacts& facts) const {
  const SurfaceCounts& counts = facts.counts;
  const std::string origin = facts.source == NormalSource::given      ? "normals of the file"
                             : facts.source == NormalSource::estimate ? "normals estimated"
                                                                      : "without normals";
  const std::string moved =
      facts.scale_space == 0 ? "" : ", moved by " + counted(facts.scale_space, "step") + " of scale space";
  const std::size_t equal = facts.surface.duplicates.size();
  return counted(facts.input_points, "point") + (equal > 0 ? " (" + std::to_string(equal) + " repeated)" : "") + ", " +
         origin + moved +
         (facts.radii.empty()       ? ", no radius"
          : facts.radii.size() == 1 ? ", radius "
                                    : ", radii ") +
         text_of_radii(facts.radii) + (request_.how.radii.empty() ? " (auto)" : "") + ": " +
         counted(counts.triangles, "triangle") + ", " + counted(counts.components, "component") + ", " +
         counted(counts.boundary_curves, "boundary curve") + genus_text(facts) + list_of(request_.targets);
}

void SurfaceRun::run() {
  SpacePoints file = read_points(request_.source);
  const double read_seconds = lap();
  SurfaceFacts facts = reconstructed(file);
  facts.read_seconds = read_seconds;
  facts.chosen_radii = request_.how.radii.empty();
  facts.filling = app::count(facts.fillings);
  if (arguments_.refine && facts.filling.filled() > 0)
    count_refined(facts.points, facts.surface.triangles, facts.filled, facts.added, facts.filling);
  facts.filling.given_up = facts.given_up;
  if (arguments_.watertight) require_watertight(facts);
  const SplitFans fans = split_fans(facts.surface, until_interrupted());
  count(facts, fans);
  facts.build_seconds = lap();

  warning_on_fields(file.kept, request_.targets, facts.surface.duplicates.size());
  for (const Target& target : request_.targets)
    if ((!file.colors.empty() || request_.colors_normals) &&
        (target.format == Format::obj || target.format == Format::off))
      warning("colors are left out of " + output_name(target.path) + " (.ply, .vtu and .glb have them)");
  std::vector<std::string> lines;
  for (const Target& target : request_.targets)
    lines.push_back(text_of_shift(target.format, facts.points, facts.surface.triangles, request_.shift, target.path));
  write(facts, fans, file);
  if (!file.index.empty()) renumber(facts, file.index);  // reports name points by their input indices
  facts.write_seconds = lap();
  if (arguments_.json) add("-", [&](OutputFile& out) { write_surface_json(out, facts); });
  add_stats([&](OutputFile& out) { write_surface_stats(out, facts); });
  publish();

  if (facts.surface.triangles.empty()) say("rbpa", why_empty(facts));
  summarize(summary(facts));
  for (const std::string& line : lines)
    if (!line.empty()) summarize(line);
  for (const std::string& line : explanations(facts)) summarize(line);
}

}  // namespace

void run_surface(const SurfaceArguments& arguments) { SurfaceRun(arguments, parse(arguments)).run(); }

}  // namespace rbpa::app
