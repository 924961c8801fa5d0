// What: runs the program `meshtopo`: declares its command line, and returns its exit code.
#include <CLI/App.hpp>
#include <memory>
#include <sstream>
#include <string>

#include "io/bytes/descriptor.h"
#include "io/interrupt.h"
#include "io/mesh/write_mesh.h"
#include "meshtopo/check.h"
#include "meshtopo/run_topology.h"
#include "program/exit_code.h"
#include "program/manual.h"
#include "program/narrow_help.h"
#include "program/refuse_arguments.h"

namespace rbpa::app {
namespace {

constexpr const char* program = "meshtopo";

int main(int argc, char** argv) {
  occupy_standard_streams();
  catch_interrupts();
  CLI::App app(
      "Report the topology of a mesh, and list where it is not a manifold\n\n"
      "The report counts vertices, edges, faces, components and boundary curves, gives the genus, and lists each "
      "defect that keeps the faces from being an oriented 2-manifold with boundary. Options change the mesh in this "
      "order: --weld, --drop-small and --keep-largest, --orient, --repair, --fill-holes, --close-tunnels-below, "
      "--decimate, --remesh. The "
      "result is reported, checked and written.\n",
      program);
  app.formatter(std::make_shared<NarrowHelp>());
  app.set_version_flag("--version", std::string("meshtopo ") + RBPA_VERSION);
  TopologyArguments arguments;
  app.add_option("MESH", arguments.meshes, "Mesh files, or - for standard input");
  app.add_option("--format", arguments.format,
                 "Set the format of the meshes, if their ending does not tell: " + endings(Use::mesh))
      ->type_name("NAME");
  app.add_flag("--json", arguments.json, "Write the report as JSON")->disable_flag_override();
  app.add_option(
         "-o,--output", arguments.output,
         "Write the report to this file, as JSON or text by its ending json or txt; - is standard output. With "
         "--repair without OUT, or with an option that changes the mesh and an ending of a mesh, write the mesh")
      ->type_name("OUT");
  const CLI::Option* const repair =
      app.add_option("--repair", arguments.repaired,
                     "Write an oriented surface made of MESH, and list the changes: " + endings(Use::mesh))
          ->type_name("OUT")
          ->expected(0, 1);
  app.add_option("--output-format", arguments.output_format,
                 "Set the format of the written mesh, if its ending does not tell")
      ->type_name("NAME");
  app.add_option("--shift", arguments.shift,
                 "Subtract X,Y,Z, or with auto the center of the vertices' box, from all coordinates of a mesh written "
                 "as .stl, which has single precision. Print the shift, and write it into the file's header")
      ->type_name("X,Y,Z|auto");
  app.add_option("--generators", arguments.generators,
                 "Write loops that generate the first homology, as polylines: " + endings(Use::polylines))
      ->type_name("OUT");
  app.add_flag("--shortest", arguments.shortest,
               "With --generators, write the basis of the least total length, which takes minutes for large meshes")
      ->disable_flag_override();
  app.add_option(
         "--weld", arguments.weld,
         "Merge vertices that a chain with no step longer than D joins, in units of the vertices; 0: those at equal "
         "positions. Drop faces that become degenerate or repeat another")
      ->type_name("D");
  app.add_option("--keep-largest", arguments.keep_largest, "Keep only the K components with the largest areas")
      ->type_name("K");
  app.add_option(
         "--drop-small", arguments.drop_small,
         "Drop components with fewer than N triangles, or with an area below A, in squared units of the vertices")
      ->type_name("N|area=A");
  app.add_flag("--orient", arguments.orient,
               "Reverse faces so that those of a component agree, and closed components face outward, or inward if "
               "they are walls of cavities: within an odd number of others")
      ->disable_flag_override();
  app.add_option("--fill-holes", arguments.fill_holes,
                 "Fill holes, after a repair, by triangles between their vertices that intersect nothing: all holes; "
                 "rims: the rims of sheets as well; N: holes of at most N edges; length=L: holes at most that long")
      ->type_name("all|rims|N|length=L");
  app.add_option(
         "--close-tunnels-below", arguments.close_tunnels_below,
         "Cut handles and close tunnels that have a loop shorter than L around them, in units of the vertices, if the "
         "new faces intersect nothing; after holes are filled")
      ->type_name("L");
  app.add_option("--decimate", arguments.decimate,
                 "Collapse edges of a mesh of triangles until N faces are left, or P percent, moving vertices so that "
                 "the surface changes least; error=E: as long as no point of it is farther than E from the faces "
                 "before, which is certified. What is closed stays closed, and the topology the same")
      ->type_name("N|P%|error=E");
  app.add_flag("--no-crossings", arguments.no_crossings,
               "With --decimate, collapse no edge by which faces would cross or touch that did not before; exact")
      ->disable_flag_override();
  app.add_option("--progressive", arguments.progressive,
                 "With --decimate, write all steps between the mesh before and after to this file, the coarse mesh "
                 "first: --at-faces reads it")
      ->type_name("OUT");
  app.add_option("--at-faces", arguments.at_faces,
                 "Read meshes that --progressive wrote, each at the greatest number of faces up to N that it has")
      ->type_name("N");
  app.add_option("--remesh", arguments.remesh,
                 "Make the edges of a mesh of triangles about as long as LENGTH, in units of the vertices, with six at "
                 "a vertex, after a decimation; with error=E shorter where the surface curves, so that triangles are "
                 "about within E of it. Sharp edges and boundary curves stay, and the topology is the same")
      ->type_name("LENGTH[,error=E]");
  app.add_option("--check", arguments.checks,
                 "Check properties of each mesh, such as closed,manifold,oriented,genus=0,components=1; print a line "
                 "on standard error for each that does not hold, and exit with code 4. Check the changed mesh, and a "
                 "written mesh as a reader of the file finds it")
      ->type_name("LIST")
      ->expected(1)
      ->take_all();
  app.add_option("--max-defects", arguments.max_defects, "List at most N defects in the text report")
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("-q,--quiet", arguments.quiet,
               "Print neither progress nor the text report; warnings and checks that fail are printed all the same")
      ->disable_flag_override();
  app.footer(
      "Examples:\n"
      "  meshtopo bunny.ply\n"
      "  meshtopo part.stl --json -o report.json\n"
      "  meshtopo scan.obj --repair clean.off --generators loops.obj\n"
      "  meshtopo *.stl -q --check closed,manifold,genus=0\n"
      "  meshtopo part.stl --weld 1e-6 --keep-largest 1 --orient -o part.ply\n"
      "  meshtopo scan.ply --repair whole.ply --fill-holes all --check closed\n"
      "  meshtopo scan.ply --decimate 10000 -o small.ply --check closed\n"
      "  meshtopo scan.ply --decimate 500 --progressive scan.pm\n"
      "  meshtopo scan.pm --at-faces 20000 -o part.ply\n"
      "  meshtopo part.stl --weld 0 --remesh 2.5 -o even.ply\n\n"
      "Properties for --check: " +
      known_checks() +
      ". A mesh is closed if every edge has two faces.\n"
      "Vertices and faces are numbered as in the file, from 0.\n" +
      std::string(exit_codes));
  add_manual(app, std::string("meshtopo ") + RBPA_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {  // help, version, manual page or completion
    std::ostringstream text, nothing;
    app.exit(e, text, nothing);
    return run(program, [&] { print(text.str()); });
  } catch (const CLI::ParseError& e) {
    return refuse_arguments(app, e);
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
  // Declare the options within run(), which reports an exhausted memory.
  const int failed = rbpa::app::run(rbpa::app::program, [&] { code = rbpa::app::main(argc, argv); });
  return failed != 0 ? failed : code;
}
