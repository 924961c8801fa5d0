#include "meshtopo/arguments.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "io/bytes/number.h"
#include "io/bytes/same_file.h"
#include "io/failure.h"
#include "io/mesh/write_mesh.h"

namespace rbpa::app {
namespace {

MeshSource parse_source(const std::string& path, const std::optional<std::string>& format) {
  if (path == "-" && !format) throw WrongUsage("-: found no --format, expected one of " + std::string(mesh_formats));
  const std::optional<Format> known = find_format(Use::mesh, format ? std::string_view(*format) : input_ending(path));
  if (known) return {path, *known};
  if (format) refuse_name("--format", *format, mesh_formats);
  refuse_ending(path, mesh_formats, "--format");
}

std::optional<Format> writable(std::string_view name) {
  const std::optional<Format> known = find_format(Use::mesh, name);
  return known && can_write_mesh(*known) ? known : std::nullopt;
}

/// As in rbpa, the name decides where the ending does not.
RepairTarget parse_repair_target(const std::string& option, const std::string& path,
                                 const std::optional<std::string>& format) {
  if (format && !writable(*format)) refuse_name("--output-format", *format, written_mesh_formats);
  if (path == "-" && !format)
    throw WrongUsage(option + " -: found no --output-format, expected one of " + std::string(written_mesh_formats));
  if (const std::optional<Format> known = writable(ending(path))) return {path, *known};
  if (!format) refuse_ending(path, written_mesh_formats, "--output-format");
  return {path, *writable(*format)};
}

GeneratorTarget parse_generator_target(const std::string& path) {
  if (const std::optional<Format> known = find_format(Use::polylines, ending(path))) return {path, *known};
  throw WrongUsage("--generators: found the ending " + in_quotes(ending(path)) + ", expected one of " +
                   std::string(polyline_formats));
}

/// By the ending, or by --json.
ReportTarget parse_report_target(const std::string& path, bool json) {
  if (path == "-") return {path, json ? ReportFormat::json : ReportFormat::text};
  const std::string_view name = ending(path);
  const auto is = [name](std::string_view known) {
    return std::equal(name.begin(), name.end(), known.begin(), known.end(),
                      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  };
  if (find_format(Use::mesh, name))
    throw WrongUsage(path + ": found the ending " + in_quotes(name) +
                     " of a mesh, expected json or txt for a report, or --repair OUT to write a mesh");
  if (is("txt") && json) throw WrongUsage(path + ": found the ending 'txt' with --json, expected json");
  if (json || is("json")) return {path, ReportFormat::json};
  if (name.empty() || is("txt")) return {path, ReportFormat::text};
  refuse_ending(path, "json, txt", "--json");
}

}  // namespace

std::vector<std::string> TopologyPlan::outputs() const {
  std::vector<std::string> paths;
  if (repaired) paths.push_back(repaired->path);
  if (generators) paths.push_back(generators->path);
  if (report) paths.push_back(report->path);
  return paths;
}

TopologyPlan plan(TopologyArguments arguments) {
  // `--repair MESH -o OUT`: what stands behind --repair is the mesh, as long as there is no other.
  if (!arguments.mesh && arguments.output && !arguments.repaired.empty())
    arguments.mesh = std::exchange(arguments.repaired, std::string());
  if (!arguments.mesh)
    throw WrongUsage("MESH: found none, expected a mesh file, or - for standard input (see meshtopo --help)");
  TopologyPlan plan{.source = parse_source(*arguments.mesh, arguments.format),
                    .max_defects = parse_whole("--max-defects", arguments.max_defects, {}),
                    .quiet = arguments.quiet};
  if (arguments.output_format && !arguments.repair) throw WrongUsage("--output-format: found no --repair, expected it");
  const bool output_is_mesh = arguments.repair && arguments.repaired.empty();
  if (arguments.output && !output_is_mesh) {
    plan.report = parse_report_target(*arguments.output, arguments.json);
    if (arguments.quiet && plan.report->format == ReportFormat::text)
      throw WrongUsage("-o: found --quiet and no --json, expected a report to write");
  } else if (arguments.json || !arguments.quiet) {
    plan.report = parse_report_target("-", arguments.json);
  }
  if (arguments.repair) {
    if (output_is_mesh && !arguments.output)
      throw WrongUsage("--repair: found no OUT, expected a file for the repaired mesh");
    const std::string option = output_is_mesh ? "-o" : "--repair";
    const std::string& path = output_is_mesh ? *arguments.output : arguments.repaired;
    plan.repaired = parse_repair_target(option, path, arguments.output_format);
    if (plan.report && path == "-" && plan.report->path == "-")
      throw WrongUsage(option +
                       " -: found standard output for the report and the mesh, expected another file or --quiet");
  }
  if (arguments.generators) plan.generators = parse_generator_target(*arguments.generators);
  require_different(plan.outputs(), *arguments.mesh, "the mesh");
  return plan;
}

}  // namespace rbpa::app
