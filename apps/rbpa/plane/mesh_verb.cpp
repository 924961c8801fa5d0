#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_triangles.h"
#include "picture/picture.h"
#include "plane/level_report.h"
#include "plane/segments.h"
#include "plane/shape_outputs.h"
#include "plane/triangle_outputs.h"
#include "rbpa/plane/link_triangles.h"
#include "shared/arguments.h"
#include "shared/complex_run.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

bool is_array(Format format) {
  return format == Format::npy || format == Format::npy_edges || format == Format::npy_points;
}

/// Parses --complex. Throws WrongUsage for the full complex with --method hrbpa or --search paper.
ComplexKind parse_complex(const MeshArguments& arguments, const Method& method) {
  if (!parse_is_full(arguments.complex)) return ComplexKind::solid;
  if (method.leaf_capacity) throw WrongUsage("--complex full requires --method rbpa");
  if (method.by_paper) throw WrongUsage("--complex full requires --search near");
  return ComplexKind::full;
}

/// Throws WrongUsage for options that cannot be combined with --segments.
void check_segments(const MeshArguments& arguments, const ComplexRequest& request, ComplexKind kind) {
  refuse_given({{request.method.leaf_capacity.has_value(), "--method hrbpa"},
                {request.method.by_paper, "--search paper"},
                {kind == ComplexKind::full, "--complex full"},
                {arguments.fields.value_or("none") != "none", "--fields"}},
               "cannot be combined with --segments");
  if (request.alpha.rule != AlphaRule::given || !std::isinf(request.alpha.radius))
    throw WrongUsage("--segments requires --alpha inf");
}

/// Returns the triangles as a complex: with `inside`, only those in regions that are inside.
AlphaComplex complex_of(const ConstrainedDelaunay& made, bool inside) {
  AlphaComplex complex;
  complex.triangles = made.triangles;
  complex.neighbors = made.neighbors;
  complex.duplicates = made.duplicates;
  complex.distinct = made.points.size() - made.duplicates.size();
  if (inside) {
    const SegmentRegions found = regions(made, until_interrupted());
    complex.triangles.clear();
    for (std::size_t t = 0; t < made.triangles.size(); ++t)
      if (found.is_inside[found.region[t]]) complex.triangles.push_back(made.triangles[t]);
    complex.neighbors = link_triangles(complex.triangles, made.points.size(), until_interrupted());
  }
  std::vector<bool> is_used(made.points.size(), false);
  for (const Triangle& triangle : complex.triangles)
    for (const std::uint32_t corner : triangle) is_used[corner] = true;
  for (const Duplicate& duplicate : made.duplicates) is_used[duplicate.index] = true;
  for (std::uint32_t i = 0; i < is_used.size(); ++i)
    if (!is_used[i]) complex.isolated.push_back(i);
  return complex;
}

std::string counts_text(const AlphaComplex& made, ComplexKind kind) {
  std::string text = counted(made.triangles.size(), "triangle");
  if (kind == ComplexKind::solid) return text + ", " + std::to_string(made.isolated.size()) + " isolated";
  text += ", " + counted(made.edges.size(), "edge") + " in no triangle";
  return text + ", " + counted(made.points.size(), "point") + " in neither";
}

void write_targets(ComplexRun& run, const std::vector<Target>& targets, const Built& built, ComplexKind kind,
                   bool compacted) {
  const ProgressLine line = run.writing();
  const AlphaComplex& made = built.complex;
  const TriangleMesh whole{.vertices = run.points(),
                           .triangles = made.triangles,
                           .edges = made.edges,
                           .points = made.points,
                           .levels = built.level,
                           .z = run.file.z,
                           .index = run.file.index,
                           .fields = {run.file.kept, {}}};
  std::optional<CompactMesh> compact;
  std::optional<Drawing> drawing;
  for (const Target& target : targets) {
    stop_if_interrupted();
    if (is_picture(target.format)) {
      if (!drawing) drawing = drawing_of(run.points(), made, kind);
      add_picture(run, target, *drawing, run.request.width, run.file.crs);
    } else if (compacted && !is_array(target.format)) {
      if (!compact) compact.emplace(whole);
      add_triangles(run, target, compact->mesh(), run.file);
    } else {
      // Write input indices to .npy even with --compact: the file has no vertices.
      add_triangles(run, target, whole, run.file);
    }
  }
}

}  // namespace

void run_mesh(const MeshArguments& arguments) {
  if (arguments.has_groups()) return run_group_meshes(arguments);
  ComplexRequest request = parse_request(arguments);
  const ComplexKind kind = parse_complex(arguments, request.method);
  std::optional<Format> levels;
  if (arguments.levels) levels = parse_levels(*arguments.levels, request.method);
  const std::vector<Target> targets =
      parse_targets(Use::triangles, arguments, arguments.points, {arguments.levels}, kind);
  const bool any_picture = any_of(targets, is_picture);
  const std::optional<SegmentSource> segments = parse_segments(arguments, request.source, targets, arguments);
  if (segments) check_segments(arguments, request, kind);

  request.source.heights = any_has_vertices(targets);
  if (!segments) request.source.keeps = parse_fields_of(arguments.fields, targets);
  ComplexRun run(request, arguments);
  const Links links = any_picture ? Links::neighbors : arguments.run.stats ? Links::boundary : Links::none;
  std::string more;
  Built built;
  if (segments) {
    run.complete_heights(run.file.z);
    const ConstrainedDelaunay constrained = triangulate_with_segments(run, *segments, run.file);
    built.complex = complex_of(constrained, arguments.inside);
    more = text_of_segments(constrained);
    run.stats.points = run.points().size();
  } else {
    built = build(run.points(), run.alpha, request.method, kind, links, run.options(), levels.has_value());
    run.take_lowest_heights(built.complex.duplicates, run.file.z);
    run.complete_heights(run.file.z);
  }
  const AlphaComplex& made = built.complex;
  run.stats.build_seconds = run.lap();

  run.warning_on_fields(run.file.kept, targets, made.duplicates.size());
  write_targets(run, targets, built, kind, arguments.compact);
  if (levels)
    run.add(*arguments.levels, [&](OutputFile& file) { write_levels(file, *levels, *built.mesh, request.method); });
  run.stats.write_seconds = run.lap();
  if (arguments.run.stats) {
    run.stats.distinct = made.distinct;
    run.stats.isolated = kind == ComplexKind::full ? made.points.size() : made.isolated.size();
    if (kind == ComplexKind::full) run.stats.dangling_edges = made.edges.size();
    run.stats.counts = count(run.points(), made, kind, until_interrupted());
    run.stats.count_seconds = run.lap();
  }
  run.finish();
  caution(targets, run.points(), run.file);

  if (made.triangles.empty()) {
    const std::string what = kind == ComplexKind::full ? "there is no triangle: " : "the complex is empty: ";
    say("rbpa", what + (arguments.inside ? "no closed line encloses a triangle" : run.why_empty(made.distinct)));
  }
  run.summarize(made.duplicates.size(), counts_text(made, kind) + more, run.list_of(targets));
}

}  // namespace rbpa::app
