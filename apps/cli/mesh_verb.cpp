#include "cli/mesh_verb.h"

#include <utility>

#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/levels.h"
#include "cli/progress.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/write_triangles.h"
#include "picture/png.h"
#include "picture/svg.h"
#include "rbpa/hrbpa.h"
#include "rbpa/rbpa.h"
#include "triangulation/counts.h"

namespace rbpa::app {
namespace {

bool is_picture(Format format) { return format == Format::svg || format == Format::png; }

bool is_array(Format format) {
  return format == Format::npy || format == Format::npy_edges || format == Format::npy_points;
}

/// Edges and points in no triangle come with the arrays, and by no other method.
Complex parse_complex(const MeshArguments& arguments, const Method& method) {
  if (!parse_is_full(arguments.complex)) return Complex::solid;
  const std::string why = ", which finds edges and points in no triangle";
  if (method.leaf_capacity) throw WrongUsage("--complex full: found --method hrbpa, expected rbpa" + why);
  if (method.makes_mesh()) throw WrongUsage("--complex full: found --search paper, expected near" + why);
  return Complex::full;
}

/// A complex as arrays, and as the mesh that they are from where the method makes one.
struct ComputedComplex {
  Complex kind;
  std::optional<Hierarchy> hierarchy = std::nullopt;
  Triangulation arrays = {};  ///< with a mesh, without neighbours

  ComplexCounts counts() const { return hierarchy ? count(hierarchy->complex) : count(arrays, kind); }
  Drawing drawing(const std::vector<Point>& points) const {
    return hierarchy ? drawing_of(points, hierarchy->complex) : drawing_of(points, arrays, kind);
  }
};

/// `connected`: pictures or counts are made of it.
ComputedComplex make(const ComplexRun& run, Complex kind, bool connected) {
  const ComplexRequest& request = run.request;
  if (!request.method.makes_mesh())
    return {.kind = kind, .arrays = build_arrays(run.points, run.alpha, kind, connected, request.options)};
  ComputedComplex made{.kind = kind, .hierarchy = build(run.points, run.alpha, request.method, request.options)};
  const SolidAlphaComplex& complex = made.hierarchy->complex;
  made.arrays.triangles = triangles(complex);
  made.arrays.isolated = complex.isolated;
  made.arrays.duplicates = complex.duplicates;
  made.arrays.distinct = complex.distinct;
  return made;
}

void write_targets(OutputSet& outputs, const std::vector<Target>& targets, const ComplexRun& run,
                   const ComputedComplex& made, bool compacted) {
  const ProgressLine line("rbpa", run.request.shows_writing, "writing");
  const TriangleMesh whole{run.points, made.arrays.triangles, made.arrays.edges, made.arrays.points};
  std::optional<CompactMesh> compact;
  std::optional<Drawing> drawing;
  for (const Target& target : targets) {
    stop_if_interrupted();
    OutputFile& file = outputs.add(target.path);
    if (is_picture(target.format)) {
      if (!drawing) drawing = made.drawing(run.points);
      const Scene scene = place(*drawing, run.request.width);
      target.format == Format::svg ? write_svg(file, scene) : write_png(file, scene);
    } else if (compacted && !is_array(target.format)) {
      if (!compact) compact.emplace(whole);
      write_triangles(file, target.format, compact->mesh());
    } else {
      // An .npy file has no vertices: its indices mean input points whatever other files hold.
      write_triangles(file, target.format, whole);
    }
    file.finish();
  }
}

std::string said(const ComputedComplex& made) {
  const Triangulation& arrays = made.arrays;
  std::string text = counted(arrays.triangles.size(), "triangle");
  if (made.kind == Complex::solid) return text + ", " + std::to_string(arrays.isolated.size()) + " isolated";
  text += ", " + counted(arrays.edges.size(), "edge") + " in no triangle";
  return text + ", " + counted(arrays.points.size(), "point") + " in neither";
}

}  // namespace

void run_mesh(const MeshArguments& arguments) {
  ComplexRequest request = parse_request(arguments);
  const Complex kind = parse_complex(arguments, request.method);
  std::optional<Format> levels;
  if (arguments.levels) levels = parse_levels(*arguments.levels, request.method);
  const std::vector<Target> targets = parse_targets(arguments.outputs, arguments.output_format,
                                                    given({arguments.stats, arguments.levels}), arguments.points, kind);
  const bool any_picture =
      std::any_of(targets.begin(), targets.end(), [](const Target& target) { return is_picture(target.format); });

  ComplexRun run = begin_run(std::move(request));
  const ComputedComplex made = make(run, kind, any_picture || arguments.stats);
  run.stats.build_seconds = run.watch.lap();

  OutputSet outputs;
  write_targets(outputs, targets, run, made, arguments.compact);
  if (levels) write_levels(outputs.add(*arguments.levels), *levels, *made.hierarchy, run.request.method);
  run.stats.write_seconds = run.watch.lap();
  if (arguments.stats) {
    run.stats.distinct = made.arrays.distinct;
    run.stats.isolated = kind == Complex::full ? made.arrays.points.size() : made.arrays.isolated.size();
    if (kind == Complex::full) run.stats.dangling_edges = made.arrays.edges.size();
    run.stats.counts = made.counts();
  }
  end_run(run, outputs);

  if (made.arrays.triangles.empty()) {
    const std::string what = kind == Complex::full ? "there is no triangle: " : "the complex is empty: ";
    say("rbpa", what + why_empty(run, made.arrays.distinct));
  }
  say_summary(run, made.arrays.duplicates.size(), said(made), list_of(targets));
}

}  // namespace rbpa::app
