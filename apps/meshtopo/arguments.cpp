#include "meshtopo/arguments.h"

#include <algorithm>
#include <utility>

#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/mesh/write_mesh.h"
#include "io/number.h"
#include "io/words.h"
#include "meshtopo/check.h"

namespace rbpa::app {
namespace {

MeshSource parse_source(const std::string& path, const std::optional<std::string>& format) {
  if (path == "-" && !format) return {path, Format::by_content};
  const std::optional<Format> known = find_format(Use::mesh, format ? std::string_view(*format) : input_ending(path));
  if (known) return {path, *known};
  if (format) refuse_name("--format", *format, endings(Use::mesh));
  refuse_ending(path, endings(Use::mesh), "--format");
}

/// Returns the target of a mesh. The ending of `path` gives the format; `format` does if the ending is unknown.
TopologyTarget parse_mesh_target(const std::string& option, const std::string& path,
                                 const std::optional<std::string>& format) {
  const std::optional<Format> named = format ? find_format(Use::mesh, *format) : std::nullopt;
  if (format && !named) refuse_name("--output-format", *format, endings(Use::mesh));
  if (path == "-" && !format) throw WrongUsage(option + " - requires --output-format: one of " + endings(Use::mesh));
  if (const std::optional<Format> known = find_format(Use::mesh, ending(path))) return {path, *known};
  if (!named) refuse_ending(path, endings(Use::mesh), "--output-format");
  return {path, *named};
}

TopologyTarget parse_generator_target(const std::string& path) {
  if (const std::optional<Format> known = find_format(Use::polylines, ending(path))) return {path, *known};
  bad_usage("--generators", "the ending " + in_quotes(ending(path)), "one of " + endings(Use::polylines));
}

/// Returns the target of a report. The ending of `path` or --json gives the format.
TopologyTarget parse_report_target(const std::string& path, bool json) {
  if (path == "-") return {path, json ? Format::json : Format::text};
  const std::string_view name = ending(path);
  const auto is = [name](std::string_view known) { return same_letters(name, known); };
  if (find_format(Use::mesh, name))
    bad_usage(path, "the ending " + in_quotes(name) + " of a mesh",
              "json or txt for a report, or --repair OUT to write a mesh (to convert: --weld 0 -o " + path + ")");
  if (is("txt") && json) bad_usage(path, "the ending 'txt' with --json", "json");
  if (json || is("json")) return {path, Format::json};
  if (name.empty() || is("txt")) return {path, Format::text};
  refuse_ending(path, "json, txt", "--json");
}

Edits parse_edits(const TopologyArguments& arguments) {
  Edits edits{.orient = arguments.orient};
  if (arguments.weld) edits.weld = parse_real("--weld", *arguments.weld, {}, "a distance, at least 0");
  if (arguments.keep_largest) edits.components.max_components = parse_keep_largest(*arguments.keep_largest);
  if (arguments.drop_small) parse_drop_small(*arguments.drop_small, edits.components);
  return edits;
}

/// Returns the first option other than --repair that changes the mesh; empty if none does.
std::string change_option(const TopologyArguments& arguments) {
  return arguments.weld                  ? "--weld"
         : arguments.keep_largest        ? "--keep-largest"
         : arguments.drop_small          ? "--drop-small"
         : arguments.orient              ? "--orient"
         : arguments.fill_holes          ? "--fill-holes"
         : arguments.close_tunnels_below ? "--close-tunnels-below"
         : arguments.decimate            ? "--decimate"
         : arguments.remesh              ? "--remesh"
         : arguments.subdivide           ? "--subdivide"
                                         : "";
}

/// Returns whether -o names the mesh and not the report. With --repair this is so if --repair has no OUT; without
/// --repair, if another option changes the mesh, and --output-format is given or the ending of -o is that of a mesh.
bool writes_mesh(const TopologyArguments& arguments) {
  if (arguments.repair) return arguments.repaired.empty();
  return (arguments.at_faces || !change_option(arguments).empty()) &&
         (arguments.output_format || find_format(Use::mesh, ending(*arguments.output)));
}

/// Parses LENGTH or LENGTH,error=E. Throws WrongUsage that names the text.
RemeshOptions parse_remesh(const std::string& text) {
  constexpr std::string_view error = ",error=";
  const std::size_t end = std::min(text.find(error), text.size());
  const auto size = [&](std::string_view word) {
    const ParsedNumber number = parse_whole_number(word);
    if (number.fault != NumberFault::none || !(number.value > 0))
      bad_usage("--remesh", in_quotes(text),
                "a length, such as 2.5, or a length and a distance, such as 2.5,error=0.1");
    return number.value;
  };
  RemeshOptions options{.length = size(std::string_view(text).substr(0, end))};
  if (end < text.size()) options.error = size(std::string_view(text).substr(end + error.size()));
  return options;
}

/// Parses loop:N or sqrt3:N. Throws WrongUsage that names the text.
SubdivisionOptions parse_subdivide(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view rule = std::string_view(text).substr(0, colon);
  const std::size_t times = parse_count(std::string_view(text).substr(std::min(colon + 1, text.size()))).value_or(0);
  if ((rule != name(SubdivisionRule::loop) && rule != name(SubdivisionRule::sqrt3)) || times == 0 || times > 1000)
    bad_usage("--subdivide", in_quotes(text), "loop:N or sqrt3:N, N the number of times, such as loop:2");
  return {.rule = rule == name(SubdivisionRule::loop) ? SubdivisionRule::loop : SubdivisionRule::sqrt3,
          .times = static_cast<unsigned>(times)};
}

/// Throws WrongUsage for options that require a single input, as they write a mesh or generators, and for a second "-".
void require_reports_alone(const TopologyArguments& arguments) {
  const auto refuse = [&](const char* option) {
    bad_usage(option, std::to_string(arguments.meshes.size()) + " meshes", "one");
  };
  if (arguments.repair) refuse("--repair");
  if (arguments.output && writes_mesh(arguments)) refuse("-o");
  if (arguments.generators) refuse("--generators");
  if (arguments.progressive) refuse("--progressive");
  if (std::count(arguments.meshes.begin(), arguments.meshes.end(), "-") > 1)
    bad_usage("MESH", "-, standard input, twice", "once");
}

}  // namespace

std::vector<std::string> TopologyPlan::outputs() const {
  std::vector<std::string> paths;
  if (progressive) paths.push_back(*progressive);
  if (written) paths.push_back(written->path);
  if (generators) paths.push_back(generators->path);
  if (report) paths.push_back(report->path);
  return paths;
}

TopologyPlan plan(TopologyArguments arguments) {
  // Accept `--repair MESH -o OUT`: without any other MESH, the argument of --repair is the mesh.
  if (arguments.meshes.empty() && arguments.output && !arguments.repaired.empty())
    arguments.meshes = {std::exchange(arguments.repaired, std::string())};
  if (arguments.meshes.empty())
    throw WrongUsage("MESH is required: a mesh file, or - for standard input (see meshtopo --help)");
  std::vector<MeshSource> sources;
  if (arguments.at_faces && arguments.format)
    throw WrongUsage("--format does not apply to progressive meshes, which --at-faces reads");
  for (const std::string& mesh : arguments.meshes)
    sources.push_back(arguments.at_faces ? MeshSource{mesh, Format::by_content} : parse_source(mesh, arguments.format));
  if (sources.size() > 1) require_reports_alone(arguments);
  TopologyPlan plan{.sources = std::move(sources),
                    .max_defects = parse_whole("--max-defects", arguments.max_defects, {}),
                    .quiet = arguments.quiet};
  plan.edits = parse_edits(arguments);
  plan.repair = arguments.repair;
  if (arguments.fill_holes) plan.fill = parse_fill_holes(*arguments.fill_holes);
  if (arguments.close_tunnels_below)
    plan.tunnels_below =
        parse_real("--close-tunnels-below", *arguments.close_tunnels_below, above_0, "a length, such as 2.5");
  if (arguments.no_crossings && !arguments.decimate) throw WrongUsage("--no-crossings requires --decimate");
  if (arguments.decimate) {
    plan.decimate = parse_decimation("--decimate", *arguments.decimate);
    plan.decimate->no_crossings = arguments.no_crossings;
  }
  if (arguments.at_faces) plan.at_faces = parse_whole("--at-faces", *arguments.at_faces, {});
  if (arguments.progressive && !arguments.decimate) throw WrongUsage("--progressive requires --decimate");
  if (arguments.progressive == "-") bad_usage("--progressive", "-", "a file (standard output is that of the report)");
  if (arguments.progressive && find_format(Use::mesh, input_ending(*arguments.progressive)))
    bad_usage("--progressive", in_quotes(*arguments.progressive) + ", with the ending of a mesh",
              "another ending, such as .pm (only --at-faces reads the file)");
  plan.progressive = arguments.progressive;
  if (arguments.remesh) plan.remesh = parse_remesh(*arguments.remesh);
  if (arguments.subdivide) plan.subdivide = parse_subdivide(*arguments.subdivide);
  for (const std::string& list : arguments.checks)
    for (Check& check : parse_checks(list)) plan.checks.push_back(std::move(check));
  const bool output_is_mesh = arguments.output && writes_mesh(arguments);
  const bool has_mesh = output_is_mesh || !arguments.repaired.empty();
  if (arguments.output_format && !has_mesh && !arguments.repair)
    throw WrongUsage("--output-format requires a mesh to write (-o OUT or --repair OUT)");
  if (arguments.output && !output_is_mesh) {
    plan.report = parse_report_target(*arguments.output, arguments.json);
    if (arguments.quiet && plan.report->format == Format::text)
      throw WrongUsage("-o cannot write a text report with --quiet, which leaves the report out (add --json)");
  } else if (arguments.json || !arguments.quiet) {
    plan.report = parse_report_target("-", arguments.json);
  }
  if (arguments.repair && !has_mesh)
    throw WrongUsage("--repair requires a file for the repaired mesh (--repair OUT or -o OUT)");
  if (has_mesh) {
    const std::string option = output_is_mesh ? "-o" : "--repair";
    const std::string& path = output_is_mesh ? *arguments.output : arguments.repaired;
    plan.written = parse_mesh_target(option, path, arguments.output_format);
    if (plan.report && path == "-" && plan.report->path == "-")
      throw WrongUsage(
          option +
          " -: the mesh and the report cannot both go to standard output (name a file for the mesh, or leave out the "
          "report with --quiet)");
  } else if (plan.changes() && plan.checks.empty() && !arguments.generators && !arguments.progressive) {
    throw WrongUsage(change_option(arguments) +
                     " changes the mesh, and requires a file for it (-o OUT or --repair OUT), or --check");
  }
  if (arguments.shift) {
    plan.shift = parse_shift("--shift", *arguments.shift);
    if (!plan.written || !has_single_precision(plan.written->format))
      throw WrongUsage("--shift applies only to .stl files, which are in single precision");
  }
  if (arguments.shortest && !arguments.generators) throw WrongUsage("--shortest requires --generators");
  plan.shortest = arguments.shortest;
  if (arguments.generators) plan.generators = parse_generator_target(*arguments.generators);
  for (const MeshSource& source : plan.sources) require_different(plan.outputs(), source.path, "the mesh");
  return plan;
}

}  // namespace rbpa::app
