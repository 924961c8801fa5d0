// What: the program `meshtopo`: its command line and exit codes.
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
  app.add_option("MESH", arguments.meshes, "Mesh files, or - for standard input");
  app.add_option("--format", arguments.format,
                 "Format of the meshes, where their ending does not say: " + std::string(mesh_formats))
      ->type_name("NAME");
  app.add_flag("--json", arguments.json, "The report as JSON")->disable_flag_override();
  app.add_option(
         "-o,--output", arguments.output,
         "File to write the report to, by its ending json or txt; - is standard output. With --repair that names no "
         "file, or with an option that changes the mesh and the ending of one, the mesh")
      ->type_name("OUT");
  const CLI::Option* const repair =
      app.add_option("--repair", arguments.repaired,
                     "Write an oriented surface made of MESH, and say what was done: " + std::string(mesh_formats))
          ->type_name("OUT")
          ->expected(0, 1);
  app.add_option("--output-format", arguments.output_format,
                 "Format of the mesh that is written, where its ending does not say")
      ->type_name("NAME");
  app.add_option("--shift", arguments.shift,
                 "Of a mesh that is written as .stl, in single precision: subtract X,Y,Z from all coordinates, or the "
                 "middle of their box. What is subtracted is said, and stands in the file's header")
      ->type_name("X,Y,Z|auto");
  app.add_option("--generators", arguments.generators,
                 "Write loops that generate the first homology, as polylines: " + std::string(polyline_formats))
      ->type_name("OUT");
  app.add_flag("--shortest", arguments.shortest,
               "With --generators: the basis of the least total length, which large meshes take minutes for")
      ->disable_flag_override();
  app.add_option("--weld", arguments.weld,
                 "Make one vertex of those that a chain with no step longer than D joins; 0: of those at equal "
                 "places. Drops faces that become degenerate or repeat another")
      ->type_name("D");
  app.add_option("--keep-largest", arguments.keep_largest, "Keep only so many components, those of the largest area")
      ->type_name("K");
  app.add_option("--drop-small", arguments.drop_small,
                 "Drop components of fewer than N triangles, or of an area below A, in squared units of the vertices")
      ->type_name("N|area=A");
  app.add_flag(
         "--orient", arguments.orient,
         "Reverse faces so that those of a component agree, and closed ones face outward, or inward where they are "
         "the walls of cavities: in an odd number of others")
      ->disable_flag_override();
  app.add_option(
         "--fill-holes", arguments.fill_holes,
         "Fill holes by triangles between their vertices that cross nothing: all, rims of sheets as well, those "
         "of at most N edges, or of a length of at most L; after a repair")
      ->type_name("all|rims|N|length=L");
  app.add_option("--close-tunnels-below", arguments.close_tunnels_below,
                 "Cut handles and close tunnels around which a loop shorter than L goes, where nothing crosses; after "
                 "holes are filled")
      ->type_name("L");
  app.add_option("--check", arguments.checks,
                 "Properties that each mesh is to have, such as closed,manifold,oriented,genus=0,components=1; exit "
                 "code 4 when one does not hold, and a line for each on standard error. Of the mesh as a reader of the "
                 "file finds it, when one is written, and as it is changed")
      ->type_name("LIST")
      ->expected(1)
      ->take_all();
  app.add_option("--max-defects", arguments.max_defects, "How many defects the report for people names")
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("-q,--quiet", arguments.quiet, "Neither progress nor a report for people")->disable_flag_override();
  app.footer(
      "Examples:\n"
      "  meshtopo bunny.ply\n"
      "  meshtopo part.stl --json -o report.json\n"
      "  meshtopo scan.obj --repair clean.off --generators loops.obj\n"
      "  meshtopo *.stl -q --check closed,manifold,genus=0\n"
      "  meshtopo part.stl --weld 1e-6 --keep-largest 1 --orient -o part.ply\n"
      "  meshtopo scan.ply --repair whole.ply --fill-holes all --check closed\n\n"
      "Properties for --check: closed (every edge has two faces), manifold, oriented, orientable; and, as in genus=0, "
      "vertices, edges, faces, euler, components, boundary_curves, genus, pinches, isolated, defects, "
      "geometric_defects.\n"
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
  ExitCode found = done;
  const int code = run(program, [&] { found = run_topology(arguments); });
  return code == done ? found : code;
}

}  // namespace
}  // namespace rbpa::app

int main(int argc, char** argv) {
  int code = 0;
  // Within run(), as memory may run out while options are declared.
  const int failed = rbpa::app::run(rbpa::app::program, [&] { code = rbpa::app::main(argc, argv); });
  return failed != 0 ? failed : code;
}
