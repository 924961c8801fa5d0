// What: declares the verbs about points in the plane.
#include <CLI/App.hpp>
#include <string>

#include "cli/shared_options.h"
#include "cli/verbs.h"
#include "io/polygon/ogr.h"
#include "program/exit_code.h"

namespace rbpa::app {

CLI::App* add_mesh(CLI::App& app, MeshArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "mesh", "Triangles of the solid alpha complex: Delaunay triangles with circumradius <= alpha");
  add_group_options(verb, arguments, "Triangles");
  add_alpha_options(verb, arguments);
  add_output_options(verb, arguments, target_formats(Use::triangles));
  add_switch(verb, "--compact", arguments.compact, "Leave out vertices that nothing uses (.npy keeps input indices)");
  verb.add_option("--complex", arguments.complex,
                  "solid, or full (with the edges and points of the alpha complex that are in no triangle)")
      ->type_name("NAME")
      ->capture_default_str();
  add_method_options(verb, arguments.method);
  verb.add_option("--search", arguments.method.search,
                  "near, or paper (as it was published, slow); the result is the same")
      ->type_name("NAME")
      ->capture_default_str();
  verb.add_option("--levels", arguments.levels,
                  "Write what happened on each level of hrbpa and the topology after it, as csv or json; - is CSV on "
                  "standard output")
      ->type_name("FILE");
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa mesh points.xy --alpha 0.3 -o mesh.ply -o picture.png\n"
      "  rbpa mesh cities.csv --columns lon,lat --alpha inf -o delaunay.off\n"
      "  rbpa mesh points.xy --alpha auto --components 2 -o mesh.ply\n"
      "  rbpa mesh lidar.las --where \"classification == 2\" --alpha inf -o tin.ply -o tin.geojson\n"
      "  rbpa mesh points.xy --alpha 0.3 --method hrbpa --levels levels.csv\n"
      "  rbpa mesh points.xy --alpha 0.3 --complex full -o mesh.obj -o arrays.npy\n"
      "  rbpa mesh trees.csv --columns x,y --group-by crown --alpha auto -o crowns.vtu\n"
      "  generate | rbpa mesh - --alpha 2 -o - --output-format obj > mesh.obj\n\n"
      "Vertices of a mesh file are the input points in input order: an index means the same in both. They keep z,\n"
      "where the input has one. Points that --where or --skip-invalid leaves out count in arrays.npy.\n"
      "The full complex is lines f, l and p of an .obj; of arrays.npy, which has the triangles, there are\n"
      "arrays.edges.npy and arrays.points.npy beside it. Of groups .vtu and .ply have the number of each triangle's\n"
      "group, from 0 in the order in which rbpa shape --group-by lists them.\n" +
      std::string(exit_codes));
  return &verb;
}

CLI::App* add_alpha(CLI::App& app, AlphaArguments& arguments) {
  CLI::App& verb =
      *app.add_subcommand("alpha", "Every radius at which the complex changes, and which of them to choose");
  add_group_options(verb, arguments, "What to choose");
  add_auto_options(verb, arguments);
  CLI::Option* json = add_switch(verb, "--json", arguments.json, "Everything as JSON");
  add_switch(verb, "--csv", arguments.csv, "A line for every radius; with --persistence, for every pair")
      ->excludes(json);
  add_switch(verb, "--persistence", arguments.persistence, "Births and deaths of components and holes");
  verb.add_option("--dimension", arguments.dimension,
                  "2, or 3: of points in space, with tunnels and voids; the full alpha complex, CSV has every pair")
      ->type_name("2|3")
      ->capture_default_str();
  add_waters_option(verb, arguments.waters);
  verb.add_option("--complex", arguments.complex,
                  "Whose persistence: solid (default), or full (with edges and points that are in no triangle)")
      ->type_name("NAME");
  verb.add_option("-o,--output", arguments.picture,
                  "Picture to write, .svg: the counts against alpha, and the persistence")
      ->type_name("OUT");
  verb.add_option("--representatives", arguments.representatives,
                  "Where the pairs are, as a file: .geojson, holes as polygons at their birth and before their death; "
                  "in space " +
                      std::string(cycle_formats) + ", cycles around tunnels and surfaces around voids")
      ->type_name("FILE");
  verb.add_option("--top", arguments.top,
                  "Of these in each dimension the K that last longest (100, unless --min-persistence)")
      ->type_name("K");
  verb.add_option("--min-persistence", arguments.min_persistence, "Of these those with death - birth at least P")
      ->type_name("P");
  verb.add_option("--levels", arguments.levels,
                  "Of these what is at some radii alone, with commas between them, at the first and the last; hrbpa, "
                  "hrbpa:K: at the levels of rbpa mesh --method hrbpa [--leaf-capacity K]")
      ->type_name("RADII");
  add_run_options(verb, arguments.run, "No progress");
  verb.footer(
      "min is the least alpha at which every distinct point is in a triangle; auto the least at which moreover there "
      "are at most K solid components. A plateau is a range of alpha over which parts and holes hardly change; the "
      "best is "
      "recommended. Parts are solid components: they hang together through edges, components through points.\n\n"
      "Examples:\n  rbpa alpha points.xy\n  rbpa alpha points.xy --csv > radii.csv\n"
      "  rbpa alpha points.xy --json --persistence --complex full > diagram.json\n"
      "  rbpa alpha points.xy --representatives holes.geojson --top 10\n"
      "  rbpa alpha points.xy --representatives holes.geojson --levels hrbpa:64\n"
      "  rbpa alpha atoms.pdb --dimension 3 --representatives cycles.obj --min-persistence 1\n"
      "  rbpa alpha fixes.csv --columns x,y --group-by animal --csv\n\n" +
      std::string(exit_codes));
  return &verb;
}

CLI::App* add_shape(CLI::App& app, ShapeArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "shape",
      "The alpha solid as polygons with holes, valid under OGC Simple Features\n\n"
      "Which alpha to choose: plateau first. It is a radius around which the shape hardly changes, and single points "
      "far from the others do not decide it. A number, where you know which gaps are to stay open. min covers every "
      "point, and auto does so in one piece, so that the loneliest point decides them; with --cover 0.99 they leave "
      "out 1 point of 100, and may then have many parts and pinholes. `rbpa alpha POINTS` shows what each gives.\n");
  add_group_options(verb, arguments, "Shapes");
  add_alpha_options(verb, arguments);
  add_output_options(verb, arguments, target_formats(Use::shape));
  add_method_options(verb, arguments.method);
  verb.add_option("--min-hole-area", arguments.min_hole_area,
                  "Fill holes that enclose less, and what lies in them; inf fills all")
      ->type_name("A")
      ->capture_default_str();
  verb.add_option("--min-part-area", arguments.min_part_area, "Drop polygons of less area, after holes are filled")
      ->type_name("A")
      ->capture_default_str();
  verb.add_option("--isolated", arguments.isolated,
                  "File for the points in no polygon, by its ending: " + std::string(isolated_formats) +
                      (has_gdal() ? ", gpkg, fgb" : ""))
      ->type_name("FILE");
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa shape points.xy --alpha plateau -o shape.geojson -o picture.png\n"
      "  rbpa shape cities.csv --columns lon,lat --alpha 0.5 --min-hole-area 0.1 -o - --output-format wkt\n"
      "  rbpa shape lidar.las --where \"classification == 6\" --alpha 2 -o roofs.geojson\n"
      "  rbpa shape fixes.csv --columns x,y --group-by animal --alpha auto --cover 0.95 -o ranges.geojson\n"
      "  rbpa shape tiles/*.las --group-by-file --alpha 2 -o footprints.geojson\n"
      "  rbpa shape points.xy --alpha auto --cover 0.99 --min-part-area 2 --min-hole-area 2 -o shape.wkt\n\n"
      "GeoJSON has a Feature for each polygon, with its number, area, perimeter, holes and points; WKT is one "
      "MULTIPOLYGON; CSV has the points, each with the number of the polygon that it is in. Of groups GeoJSON has a "
      "Feature for each, and CSV a line; --alpha follows the points of each by itself, and may be column:NAME, a "
      "number beside them. Coordinates are those of "
      "the input, to the last bit, and areas are in their unit squared.\n" +
      std::string(exit_codes));
  return &verb;
}

CLI::App* add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("info", "How many points there are, how many twice, their box and spacing");
  add_group_options(verb, arguments, "The same");
  add_switch(verb, "--json", arguments.json, "As JSON");
  add_switch(verb, "-q,--quiet", arguments.quiet, "As for the other verbs; this one says nothing but what is asked");
  verb.footer(
      "The spacing is the square root of box area / distinct points: a first idea of a good alpha.\n\n"
      "Examples:\n  rbpa info points.xy --json\n  rbpa info fixes.csv --columns x,y --group-by animal\n\n" +
      std::string(exit_codes));
  return &verb;
}

CLI::App* add_report(CLI::App& app, ReportArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("report", "A page to look at: the complex at every radius, in a browser");
  add_point_options(verb, arguments);
  verb.add_option("-o,--output", arguments.output, "Page to write, .html; - is standard output")
      ->type_name("OUT")
      ->required();
  verb.add_option("--dimension", arguments.dimension,
                  "2, or 3: of points in space, with tunnels and voids, and a boundary to turn around")
      ->type_name("2|3")
      ->capture_default_str();
  add_waters_option(verb, arguments.waters);
  add_auto_options(verb, arguments);
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "One file with everything in it, for any browser, offline: a slider over alpha, counts, the persistence diagram, "
      "and the shape as GeoJSON and SVG. About 110 bytes a point; smooth with some hundred thousand. In space the "
      "boundary "
      "can be turned, and a click on a pair shows its cycle, or the surface around its void; about 190 bytes a "
      "point.\n\n"
      "Examples:\n  rbpa report points.xy -o report.html\n  rbpa report atoms.pdb --dimension 3 -o report.html\n\n" +
      std::string(exit_codes));
  return &verb;
}

}  // namespace rbpa::app
