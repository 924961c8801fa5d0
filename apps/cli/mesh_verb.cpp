#include "cli/mesh_verb.h"

#include <limits>

#include "cli/alpha_choice.h"
#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/levels.h"
#include "cli/method.h"
#include "cli/progress.h"
#include "cli/stats.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/message.h"
#include "io/output_file.h"
#include "io/write_triangles.h"
#include "picture/png.h"
#include "picture/svg.h"

namespace rbpa::app {
namespace {

bool is_picture(OutputFormat format) { return format == OutputFormat::svg || format == OutputFormat::png; }

void write_targets(OutputSet& outputs, const std::vector<Target>& targets, const std::vector<Point>& points,
                   const SolidAlphaComplex& complex, bool compacted, int width, bool shown) {
  const ProgressLine line("rbpa", shown, "writing");
  std::vector<Triangle> all;
  std::optional<CompactMesh> compact;
  std::optional<Drawing> drawing;
  for (const Target& target : targets) {
    stop_if_interrupted();
    OutputFile& file = outputs.add(target.path);
    if (is_picture(target.format)) {
      if (!drawing) drawing = drawing_of(points, complex);
      const Scene scene = place(*drawing, width);
      target.format == OutputFormat::svg ? write_svg(file, scene) : write_png(file, scene);
    } else {
      if (all.empty()) all = triangles(complex);
      // An .npy file has no vertices: its indices mean input points whatever other files hold.
      if (compacted && target.format != OutputFormat::npy) {
        if (!compact) compact.emplace(points, all);
        write_triangles(file, target.format, {compact->vertices, compact->triangles});
      } else {
        write_triangles(file, target.format, {points, all});
      }
    }
    file.finish();
  }
}

std::string summary(std::size_t points, const SolidAlphaComplex& complex, const std::string& chosen_alpha,
                    const std::vector<Target>& targets) {
  std::string text = counted(points, "point");
  if (!complex.duplicates.empty()) text += " (" + counted(complex.duplicates.size(), "duplicate") + ")";
  text +=
      ", " + counted(complex.mesh.n_faces(), "triangle") + ", " + std::to_string(complex.isolated.size()) + " isolated";
  return text + chosen_alpha + list_of(targets);
}

std::vector<std::string> reports(const MeshArguments& arguments) {
  std::vector<std::string> paths;
  for (const auto& report : {arguments.stats, arguments.levels})
    if (report) paths.push_back(*report);
  return paths;
}

}  // namespace

void run_mesh(const MeshArguments& arguments) {
  const AlphaChoice choice = parse_alpha(arguments.alpha, arguments.components);
  const Method method = parse_method(arguments.method);
  const RunOptions run = parse_run(arguments.run);
  std::optional<LevelFormat> levels;
  if (arguments.levels) levels = parse_levels(*arguments.levels, method);
  const PointSource source = parse_source(arguments.points, arguments.format, arguments.columns, arguments.pixels);
  const std::vector<Target> targets =
      parse_targets(arguments.outputs, arguments.output_format, reports(arguments), arguments.points);
  const int width = parse_width(arguments.width);

  Stats stats{.alpha_rule = name_of(choice.rule)};
  Stopwatch watch;
  const std::vector<Point> points = read(source, run.quiet);
  stats.read_seconds = watch.lap();
  stats.alpha = choose_alpha(choice, points, run);
  if (choice.rule != AlphaRule::given) stats.choose_seconds = watch.lap();
  // Points without such a radius have no triangle at any.
  const double alpha = stats.alpha.value_or(std::numeric_limits<double>::infinity());
  const Hierarchy hierarchy = build(points, alpha, method, run);
  const SolidAlphaComplex& complex = hierarchy.complex;
  stats.build_seconds = watch.lap();

  OutputSet outputs;
  write_targets(outputs, targets, points, complex, arguments.compact, width,
                !run.quiet && !written_to_terminal(arguments.outputs));
  if (levels) write_levels(outputs.add(*arguments.levels), *levels, hierarchy, method);
  stats.write_seconds = watch.lap();
  if (arguments.stats) {
    stats.points = points.size();
    stats.threads = threads_used(points.size(), run.threads);
    stats.distinct = complex.distinct;
    stats.isolated = complex.isolated.size();
    stats.counts = count(complex);
    stats.method = method.name();
    OutputFile& file = outputs.add(*arguments.stats);
    write_stats(file, stats);
    file.finish();
  }
  outputs.publish();

  if (complex.mesh.n_faces() == 0)
    say("rbpa", "the complex is empty: " + reason_for_empty(points, complex.distinct, arguments.alpha));
  if (!run.quiet) {
    const std::string chosen_alpha = said(choice, stats.alpha);
    say("rbpa", summary(points.size(), complex, chosen_alpha, targets));
  }
}

}  // namespace rbpa::app
