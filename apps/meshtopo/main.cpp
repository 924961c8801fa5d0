// What: runs the program `meshtopo`: declares its command line, and returns its exit code.
#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <string>

#include "io/mesh/write_mesh.h"
#include "meshtopo/check.h"
#include "meshtopo/run_topology.h"
#include "program/options.h"
#include "program/run_program.h"

namespace rbpa::app {
namespace {

constexpr const char* description =
    "Report the topology of a mesh, and list where it is not a manifold\n\n"
    "The report counts vertices, edges, faces, components and boundary curves, gives the genus, and lists each "
    "defect that keeps the faces from being an oriented 2-manifold with boundary. Options change the mesh in this "
    "order: --weld, --drop-small and --keep-largest, --orient, --repair, --fill-holes, --close-tunnels-below, "
    "--decimate, --remesh, --subdivide. The "
    "result is reported, checked and written.\n";

std::function<ExitCode()> declare(CLI::App& app) {
  const auto kept = std::make_shared<TopologyArguments>();
  TopologyArguments& arguments = *kept;
  app.add_option("MESH", arguments.meshes, "Mesh files, or - for standard input");
  add_value(app, "--format", arguments.format, "NAME",
            "Set the format of the meshes, if their ending does not tell: " + endings(Use::mesh));
  add_switch(app, "--json", arguments.json, "Write the report as JSON");
  add_value(app, "-o,--output", arguments.output, "OUT",
            "Write the report to this file, as JSON or text by its ending json or txt; - is standard output. With "
            "--repair without OUT, or with an option that changes the mesh and an ending of a mesh, write the mesh");
  const CLI::Option* const repair =
      add_value(app, "--repair", arguments.repaired, "OUT",
                "Write an oriented surface made of MESH, and list the changes: " + endings(Use::mesh))
          ->expected(0, 1);
  add_value(app, "--output-format", arguments.output_format, "NAME",
            "Set the format of the written mesh, if its ending does not tell");
  add_value(app, "--shift", arguments.shift, "X,Y,Z|auto",
            "Subtract X,Y,Z, or with auto the center of the vertices' box, from all coordinates of a mesh written "
            "as .stl, which has single precision. Print the shift, and write it into the file's header");
  add_value(app, "--generators", arguments.generators, "OUT",
            "Write loops that generate the first homology, as polylines: " + endings(Use::polylines));
  add_switch(app, "--shortest", arguments.shortest,
             "With --generators, write the basis of the least total length, which takes minutes for large meshes");
  add_value(app, "--weld", arguments.weld, "D",
            "Merge vertices that a chain with no step longer than D joins, in units of the vertices; 0: those at equal "
            "positions. Drop faces that become degenerate or repeat another");
  add_value(app, "--keep-largest", arguments.keep_largest, "K", "Keep only the K components with the largest areas");
  add_value(app, "--drop-small", arguments.drop_small, "N|area=A",
            "Drop components with fewer than N triangles, or with an area below A, in squared units of the vertices");
  add_switch(app, "--orient", arguments.orient,
             "Reverse faces so that those of a component agree, and closed components face outward, or inward if "
             "they are walls of cavities: within an odd number of others");
  add_value(app, "--fill-holes", arguments.fill_holes, "all|rims|N|length=L",
            "Fill holes, after a repair, by triangles between their vertices that intersect nothing: all holes; "
            "rims: the rims of sheets as well; N: holes of at most N edges; length=L: holes at most that long");
  add_value(
      app, "--close-tunnels-below", arguments.close_tunnels_below, "L",
      "Cut handles and close tunnels that have a loop shorter than L around them, in units of the vertices, if the "
      "new faces intersect nothing; after holes are filled");
  add_value(app, "--decimate", arguments.decimate, "N|P%|error=E",
            "Collapse edges of a mesh of triangles until N faces are left, or P percent, moving vertices so that "
            "the surface changes least; error=E: as long as no point of it is farther than E from the faces "
            "before, which is certified. What is closed stays closed, and the topology the same");
  add_switch(app, "--no-crossings", arguments.no_crossings,
             "With --decimate, collapse no edge by which faces would cross or touch that did not before; exact");
  add_value(app, "--progressive", arguments.progressive, "OUT",
            "With --decimate, write all steps between the mesh before and after to this file, the coarse mesh "
            "first: --at-faces reads it");
  add_value(app, "--at-faces", arguments.at_faces, "N",
            "Read meshes that --progressive wrote, each at the greatest number of faces up to N that it has");
  add_value(app, "--remesh", arguments.remesh, "LENGTH[,error=E]",
            "Make the edges of a mesh of triangles about as long as LENGTH, in units of the vertices, with six at "
            "a vertex, after a decimation; with error=E shorter where the surface curves, and no point of the result "
            "farther than E from the faces before. Sharp edges and boundary curves stay, and the topology is the same");
  add_value(app, "--subdivide", arguments.subdivide, "loop:N|sqrt3:N",
            "Make a mesh of triangles finer and smoother, N times: by Loop's rule four triangles of one, by the sqrt3 "
            "rule three; what is closed stays closed, and a boundary curve depends on itself alone");
  add_value(app, "--check", arguments.checks, "LIST",
            "Check properties of each mesh, such as closed,manifold,oriented,genus=0,components=1; print a line "
            "on standard error for each that does not hold, and exit with code 4. Check the changed mesh, and a "
            "written mesh as a reader of the file finds it")
      ->expected(1)
      ->take_all();
  add_value(app, "--max-defects", arguments.max_defects, "N", "List at most N defects in the text report");
  add_switch(app, "-q,--quiet", arguments.quiet,
             "Print neither progress nor the text report; warnings and checks that fail are printed all the same");
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
      "  meshtopo part.stl --weld 0 --remesh 2.5 -o even.ply\n"
      "  meshtopo coarse.obj --subdivide loop:2 -o smooth.ply\n\n"
      "Properties for --check: " +
      known_checks() +
      ". A mesh is closed if every edge has two faces.\n"
      "Vertices and faces are numbered as in the file, from 0.\n" +
      std::string(exit_codes));
  return [kept, repair] {
    kept->repair = repair->count() > 0;
    return run_topology(*kept);
  };
}

}  // namespace
}  // namespace rbpa::app

int main(int argc, char** argv) {
  return rbpa::app::run_program(
      {.name = "meshtopo", .description = rbpa::app::description, .declare = rbpa::app::declare}, argc, argv);
}
