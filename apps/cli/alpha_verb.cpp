#include "cli/alpha_verb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/arguments.h"
#include "cli/build.h"
#include "cli/progress.h"
#include "cli/stats.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/interrupt.h"
#include "io/message.h"
#include "io/number.h"
#include "io/output_file.h"
#include "io/same_file.h"
#include "picture/filtration_plot.h"
#include "rbpa/filtration/covering.h"
#include "rbpa/filtration/filtration.h"
#include "rbpa/filtration/persistence.h"

namespace rbpa::app {
namespace {

struct Report {
  std::size_t points = 0;
  std::size_t most_components = 1;
  double cover = 1;  ///< share of the points, of the next two
  Filtration filtration = {};
  std::optional<double> least_covering = std::nullopt;   ///< "min"
  std::optional<double> least_connected = std::nullopt;  ///< "auto"
  std::optional<std::vector<PersistencePair>> pairs = std::nullopt;
};

ComplexKind parse_complex(const AlphaArguments& arguments) {
  if (!arguments.complex) return ComplexKind::solid;
  if (!arguments.persistence) throw WrongUsage("--complex: found no --persistence, which is what it is about");
  return parse_is_full(*arguments.complex) ? ComplexKind::full : ComplexKind::solid;
}

/// What the report is to be about.
struct Request {
  std::size_t most_components;
  double cover;
  bool with_pairs;
  ComplexKind kind;  ///< whose pairs
};

Report examine(const std::vector<Point>& points, const Request& request, const RunOptions& run) {
  const SolidAlphaComplex delaunay = build(points, std::numeric_limits<double>::infinity(), run);
  Report report{.points = points.size(), .most_components = request.most_components, .cover = request.cover};
  {
    const ProgressLine line("rbpa", !run.quiet, "radii of " + counted(delaunay.mesh.n_faces(), "triangle"));
    report.filtration = filtration(delaunay, points, until_interrupted());
  }
  stop_if_interrupted();
  const auto least = [&](std::optional<std::size_t> most_components) {
    return smallest_covering(delaunay, report.filtration, {request.cover, most_components}, until_interrupted());
  };
  report.least_covering = least(std::nullopt);
  report.least_connected = least(request.most_components);
  if (request.with_pairs) {
    const ProgressLine line("rbpa", !run.quiet, "persistence");
    report.pairs = persistence(delaunay, points, report.filtration, request.kind, until_interrupted());
  }
  return report;
}

/// A loop over many lines that notices Ctrl-C.
template <typename Lines, typename Write>
void for_each_line(const Lines& lines, const Write& write) {
  std::size_t count = 0;
  for (const auto& line : lines) {
    if (++count % 65536 == 0) stop_if_interrupted();
    write(line);
  }
}

void write_count(OutputFile& out, std::size_t count) { out.write_number(static_cast<std::uint64_t>(count)); }

// JSON: absent is null; a number too large for double is "inf", as in --stats.

void write_json(OutputFile& out, double value) {
  if (std::isinf(value))
    out.write("\"inf\"");
  else
    out.write_number(value);
}

void write_json(OutputFile& out, const std::optional<double>& value) {
  if (value)
    write_json(out, *value);
  else
    out.write("null");
}

void write_json(OutputFile& out, const FiltrationStep& step) {
  out.write("{\"alpha\": ");
  write_json(out, step.alpha);
  const auto item = [&](std::string_view name, std::size_t count) {
    out.write(", \"");
    out.write(name);
    out.write("\": ");
    write_count(out, count);
  };
  item("triangles", step.triangles);
  item("solid_components", step.solid_components);
  item("components", step.components);
  item("holes", step.holes);
  item("covered", step.covered);
  out.write(", \"area\": ");
  write_json(out, step.area);
  out.write("}");
}

void write_json(OutputFile& out, const PersistencePair& pair) {
  out.write("{\"dimension\": ");
  write_count(out, static_cast<std::size_t>(pair.dimension));
  out.write(", \"birth\": ");
  write_json(out, pair.birth);
  out.write(", \"death\": ");
  write_json(out, pair.death);
  out.write("}");
}

template <typename Lines>
void write_array(OutputFile& out, std::string_view name, const Lines& lines) {
  out.write(",\n  \"");
  out.write(name);
  out.write("\": [");
  const char* before = "\n    ";
  for_each_line(lines, [&](const auto& line) {
    out.write(before);
    write_json(out, line);
    before = ",\n    ";
  });
  out.write(lines.empty() ? "]" : "\n  ]");
}

void write_json(OutputFile& out, const Report& report) {
  out.write("{\n  \"auto\": ");
  write_json(out, report.least_connected);
  out.write(",\n  \"min\": ");
  write_json(out, report.least_covering);
  write_array(out, "critical", report.filtration.steps);
  if (report.pairs) write_array(out, "pairs", *report.pairs);
  out.write("\n}\n");
}

void write_csv(OutputFile& out, const std::vector<FiltrationStep>& steps) {
  out.write("alpha,triangles,solid_components,components,holes,covered,area\n");
  for_each_line(steps, [&](const FiltrationStep& step) {
    out.write_number(step.alpha);
    for (const std::size_t count : {step.triangles, step.solid_components, step.components, step.holes, step.covered}) {
      out.write(",");
      write_count(out, count);
    }
    out.write(",");
    out.write_number(step.area);
    out.write("\n");
  });
}

void write_csv(OutputFile& out, const std::vector<PersistencePair>& pairs) {
  out.write("dimension,birth,death\n");
  for_each_line(pairs, [&](const PersistencePair& pair) {
    write_count(out, static_cast<std::size_t>(pair.dimension));
    out.write(",");
    out.write_number(pair.birth);
    out.write(",");
    if (pair.death) out.write_number(*pair.death);
    out.write("\n");
  });
}

std::string text_of(const std::optional<double>& value) {
  return value ? std::string(std::string_view(ShortestText(*value))) : "none";
}

std::string for_people(const Report& report) {
  const auto& steps = report.filtration.steps;
  std::string text = "points    " + std::to_string(report.points) + ", " + std::to_string(report.filtration.distinct) +
                     " of them distinct\n";
  const std::string pieces = counted(report.most_components, "solid component");
  const bool every = report.cover == 1;
  text += "min       " + text_of(report.least_covering) + "  (least alpha that covers " +
          (every ? "every point" : "a share of " + text_of(report.cover) + " of the points") + ")\n";
  text += "auto      " + text_of(report.least_connected) +
          (every ? "  (moreover in at most " + pieces : "  (moreover with at most " + pieces + ", without the others") +
          ")\n";
  text += "critical  " + std::to_string(steps.size()) + (steps.size() == 1 ? " radius" : " radii");
  if (!steps.empty()) text += ", from " + text_of(steps.front().alpha) + " to " + text_of(steps.back().alpha);
  text += "\n";
  if (report.pairs) {
    const auto holes = std::count_if(report.pairs->begin(), report.pairs->end(),
                                     [](const PersistencePair& pair) { return pair.dimension == 1; });
    const auto components = static_cast<std::ptrdiff_t>(report.pairs->size()) - holes;
    text += "pairs     " + std::to_string(components) + " of components, " + std::to_string(holes) + " of holes\n";
  }
  return text;
}

void write(OutputFile& out, const Report& report, const AlphaArguments& arguments) {
  if (arguments.json)
    write_json(out, report);
  else if (!arguments.csv)
    out.write(for_people(report));
  else if (report.pairs)
    write_csv(out, *report.pairs);
  else
    write_csv(out, report.filtration.steps);
  out.finish();
}

}  // namespace

void run_alpha(const AlphaArguments& arguments) {
  const Request request{.most_components = parse_components(arguments.components),
                        .cover = arguments.cover ? parse_cover(*arguments.cover) : 1,
                        .with_pairs = arguments.persistence || arguments.picture,
                        .kind = parse_complex(arguments)};
  const RunOptions run = parse_run(arguments.run);
  const PointSource source = parse_source(arguments);
  if (arguments.picture && shape_format(ending(*arguments.picture)) != ShapeFormat::svg)
    throw WrongUsage(*arguments.picture + ": found the ending " + in_quotes(ending(*arguments.picture)) +
                     ", expected svg");
  std::vector<std::string> outputs{"-"};
  if (arguments.picture) outputs.push_back(*arguments.picture);
  if (arguments.stats) outputs.push_back(*arguments.stats);
  require_different(outputs, arguments.points, "points");
  Stopwatch watch;
  const std::vector<Point> points = read(source, run.quiet).points;
  Stats stats{.read_seconds = watch.lap()};
  Report report = examine(points, request, run);
  stats.build_seconds = watch.lap();

  // What cannot be written is found out before anything is said on standard output.
  OutputSet files;
  OutputFile* picture = arguments.picture ? &files.add(*arguments.picture) : nullptr;
  OutputFile* stats_file = arguments.stats ? &files.add(*arguments.stats) : nullptr;
  std::optional<ProgressLine> line(std::in_place, "rbpa", !run.quiet && !written_to_terminal(outputs), "writing");
  if (picture) {
    picture->write(svg_of({report.filtration.steps, *report.pairs, report.least_covering, report.least_connected}));
    picture->finish();
    if (!arguments.persistence) report.pairs.reset();
  }
  write(files.add("-"), report, arguments);
  stats.write_seconds = watch.lap();
  if (stats_file) {
    stats.points = points.size();
    stats.threads = threads_used(points.size(), run.threads);
    stats.distinct = report.filtration.distinct;
    write_stats(*stats_file, stats);
    stats_file->finish();
  }
  files.publish();
  line.reset();
  if (report.filtration.steps.empty()) {
    const char* why = report.filtration.distinct < 3 ? "fewer than three distinct points" : "all points are collinear";
    say("rbpa", std::string("the complex is empty at every alpha: ") + why);
  }
}

}  // namespace rbpa::app
