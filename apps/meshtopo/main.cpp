// The program `meshtopo`: its command line, and what its exit codes mean.
#include <CLI/App.hpp>
#include <memory>
#include <sstream>
#include <string>

#include "io/bytes/descriptor.h"
#include "io/interrupt.h"
#include "io/mesh/write_mesh.h"
#include "meshtopo/run_topology.h"
#include "program/exit_code.h"
#include "program/manual.h"
#include "program/narrow_help.h"

namespace rbpa::app {
namespace {

constexpr const char* program = "meshtopo";

int main(int argc, char** argv) {
  occupy_standard_streams();
  catch_interrupts();
  CLI::App app("Topology of a mesh: what it has of everything, and where it is no surface", program);
  app.formatter(std::make_shared<NarrowHelp>());
  app.set_version_flag("--version", std::string("meshtopo ") + RBPA_VERSION);
  TopologyArguments arguments;
  app.add_option("MESH", arguments.mesh, "Mesh file, or - for standard input");
  app.add_option("--format", arguments.format,
                 "Format of MESH, where its ending does not say: " + std::string(mesh_formats))
      ->type_name("NAME");
  app.add_flag("--json", arguments.json, "The report as JSON")->disable_flag_override();
  app.add_option(
         "-o,--output", arguments.output,
         "File to write the report to, by its ending json or txt; - is standard output. With --repair that names no "
         "file, the mesh")
      ->type_name("OUT");
  const CLI::Option* const repair = app.add_option("--repair", arguments.repaired,
                                                   "Write an oriented surface made of MESH, and say what was done: " +
                                                       std::string(written_mesh_formats))
                                        ->type_name("OUT")
                                        ->expected(0, 1);
  app.add_option("--output-format", arguments.output_format,
                 "Format of the repaired mesh, where its ending does not say")
      ->type_name("NAME");
  app.add_option("--generators", arguments.generators,
                 "Write loops that generate the first homology, as polylines: " + std::string(polyline_formats))
      ->type_name("OUT");
  app.add_option("--max-defects", arguments.max_defects, "How many defects the report for people names")
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("-q,--quiet", arguments.quiet, "Neither progress nor a report for people")->disable_flag_override();
  app.footer(
      "Examples:\n"
      "  meshtopo bunny.ply\n"
      "  meshtopo part.stl --json -o report.json\n"
      "  meshtopo scan.obj --repair clean.off --generators loops.obj\n\n"
      "Vertices and faces are numbered as in the file, from 0.\n" +
      std::string(exit_codes));
  add_manual(app, std::string("meshtopo ") + RBPA_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {  // help or version
    std::ostringstream text, nothing;
    app.exit(e, text, nothing);
    return run(program, [&] { print(text.str()); });
  } catch (const CLI::ParseError& e) {
    return report(program, std::string(e.what()) + " (see meshtopo --help)", wrong_usage);
  }
  arguments.repair = repair->count() > 0;
  return run(program, [&] { run_topology(arguments); });
}

}  // namespace
}  // namespace rbpa::app

int main(int argc, char** argv) { return rbpa::app::main(argc, argv); }
