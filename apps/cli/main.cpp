// The program `rbpa`: what its command line takes, and what its exit codes mean.
#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/alpha_verb.h"
#include "cli/fill_verb.h"
#include "cli/info_verb.h"
#include "cli/merge_verb.h"
#include "cli/mesh_verb.h"
#include "cli/report_verb.h"
#include "cli/run_options.h"
#include "cli/shape_verb.h"
#include "cli/shared_options.h"
#include "cli/stream_arguments.h"
#include "cli/stream_verb.h"
#include "cli/surface_verb.h"
#include "cli/tile_verb.h"
#include "io/descriptor.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/ogr/ogr.h"
#include "program/exit_code.h"
#include "program/manual.h"
#include "program/narrow_help.h"

namespace rbpa::app {
namespace {

constexpr const char* program = "rbpa";

void add_mesh(CLI::App& app, MeshArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "mesh", "Triangles of the solid alpha complex: Delaunay triangles with circumradius <= alpha");
  add_point_options(verb, arguments);
  add_alpha_options(verb, arguments);
  add_output_options(verb, arguments, output_formats);
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
  verb.add_option("--width", arguments.width, "Width of pictures in pixels")
      ->type_name("PIXELS")
      ->capture_default_str();
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa mesh points.xy --alpha 0.3 -o mesh.ply -o picture.png\n"
      "  rbpa mesh cities.csv --columns lon,lat --alpha inf -o delaunay.off\n"
      "  rbpa mesh points.xy --alpha auto --components 2 -o mesh.ply\n"
      "  rbpa mesh points.xy --alpha 0.3 --method hrbpa --levels levels.csv\n"
      "  rbpa mesh points.xy --alpha 0.3 --complex full -o mesh.obj -o arrays.npy\n"
      "  generate | rbpa mesh - --alpha 2 -o - --output-format obj > mesh.obj\n\n"
      "Vertices of a mesh file are the input points in input order: an index means the same in both.\n"
      "The full complex is lines f, l and p of an .obj; of arrays.npy, which has the triangles, there are\n"
      "arrays.edges.npy and arrays.points.npy beside it.\n" +
      std::string(exit_codes));
}

void add_alpha(CLI::App& app, AlphaArguments& arguments) {
  CLI::App& verb =
      *app.add_subcommand("alpha", "Every radius at which the complex changes, and which of them to choose");
  add_point_options(verb, arguments);
  verb.add_option("--components", arguments.components, "How many solid components `auto` may have at most")
      ->type_name("K")
      ->capture_default_str();
  add_cover_option(verb, arguments.cover);
  CLI::Option* json = add_switch(verb, "--json", arguments.json, "Everything as JSON");
  add_switch(verb, "--csv", arguments.csv, "A line for every radius; with --persistence, for every pair")
      ->excludes(json);
  add_switch(verb, "--persistence", arguments.persistence, "Births and deaths of components and holes");
  verb.add_option("--complex", arguments.complex,
                  "Whose persistence: solid (default), or full (with edges and points that are in no triangle)")
      ->type_name("NAME");
  verb.add_option("-o,--output", arguments.picture,
                  "Picture to write, .svg: the counts against alpha, and the persistence")
      ->type_name("OUT");
  add_run_options(verb, arguments.run, "No progress");
  verb.footer(
      "min is the least alpha at which every distinct point is in a triangle; auto the least at which moreover there "
      "are at most K solid components. A plateau is a range of alpha over which parts and holes hardly change; the "
      "best is "
      "recommended. Parts are solid components: they hang together through edges, components through points.\n\n"
      "Examples:\n  rbpa alpha points.xy\n  rbpa alpha points.xy --csv > radii.csv\n"
      "  rbpa alpha points.xy --json --persistence --complex full > diagram.json\n\n" +
      std::string(exit_codes));
}

void add_shape(CLI::App& app, ShapeArguments& arguments) {
  CLI::App& verb =
      *app.add_subcommand("shape", "The alpha solid as polygons with holes, valid under OGC Simple Features");
  add_point_options(verb, arguments);
  add_alpha_options(verb, arguments);
  add_output_options(verb, arguments, std::string(shape_formats) + (has_gdal() ? ", gpkg, fgb, shp" : ""));
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
  verb.add_option("--width", arguments.width, "Width of pictures in pixels")
      ->type_name("PIXELS")
      ->capture_default_str();
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa shape points.xy --alpha plateau -o shape.geojson -o picture.png\n"
      "  rbpa shape points.xy --alpha auto --cover 0.99 -o shape.wkt\n"
      "  rbpa shape cities.csv --columns lon,lat --alpha 0.5 --min-hole-area 0.1 -o - --output-format wkt\n"
      "  rbpa shape lidar.las --where \"classification == 6\" --alpha 2 -o roofs.geojson\n\n"
      "GeoJSON has a Feature for each polygon, with its number, area, perimeter, holes and points; WKT is one\n"
      "MULTIPOLYGON; CSV has the points, each with the number of the polygon that it is in.\n"
      "Coordinates are those of the input, to the last bit, and areas are in their unit squared.\n" +
      std::string(exit_codes));
}

void add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("info", "How many points there are, how many twice, their box and spacing");
  add_point_options(verb, arguments);
  add_switch(verb, "--json", arguments.json, "As JSON");
  add_switch(verb, "-q,--quiet", arguments.quiet, "As for the other verbs; this one says nothing but what is asked");
  verb.footer(
      "The spacing is the square root of box area / distinct points: a first idea of a good alpha.\n\n"
      "Example:\n  rbpa info points.xy --json\n\n" +
      std::string(exit_codes));
}

void add_report(CLI::App& app, ReportArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("report", "A page to look at: the complex at every radius, in a browser");
  add_point_options(verb, arguments);
  verb.add_option("-o,--output", arguments.output, "Page to write, .html; - is standard output")
      ->type_name("OUT")
      ->required();
  verb.add_option("--components", arguments.components, "How many solid components `auto` may have at most")
      ->type_name("K")
      ->capture_default_str();
  add_cover_option(verb, arguments.cover);
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "One file with everything in it, for any browser, offline: a slider over alpha, counts, the persistence diagram, "
      "and the shape as GeoJSON and SVG. About 110 bytes a point; smooth with some hundred thousand.\n\n"
      "Example:\n  rbpa report points.xy -o report.html\n\n" +
      std::string(exit_codes));
}

void add_stream(CLI::App& app, StreamArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "stream", "The same triangles and polygons of more points than fit into memory, by way of tiles on a disk");
  verb.add_option("POINTS", arguments.inputs, "Files of points, .gz or not, and folders of such files")->required();
  add_format_options(verb, arguments);
  verb.add_option(
          "--alpha", arguments.radius.alpha,
          "Largest circumradius, required: a finite radius in units of the points (rbpa alpha on a sample shows "
          "which to choose)")
      ->type_name("R")
      ->required();
  verb.add_option("-o,--output", arguments.outputs,
                  "File to write, by its ending: " + std::string(stream_formats) +
                      "; - is standard output; may be given several times")
      ->type_name("OUT")
      ->allow_extra_args(false);
  verb.add_option("--output-format", arguments.output_format, "Format of an OUT whose ending does not say")
      ->type_name("NAME");
  verb.add_option("--memory", arguments.memory, "Memory that the run may take, such as 500M or 4G")
      ->type_name("SIZE")
      ->capture_default_str();
  verb.add_option("--scratch", arguments.scratch,
                  "Folder for tiles, new or empty; by default one beside the first OUT that goes with the run")
      ->type_name("DIR");
  add_switch(verb, "--resume", arguments.resume, "Go on with the run in --scratch where it stopped, or begin");
  verb.add_option("--tile-size", arguments.tile_size, "Points of a tile, at most; by default as many as memory allows")
      ->type_name("S");
  add_switch(verb, "--keep-tiles", arguments.keep_tiles, "Leave the files of tiles in --scratch");
  verb.add_option(
          "--tasks", arguments.tasks,
          "Cut only, and write to this folder, new or empty, the lists of commands (rbpa tile, rbpa merge) that do "
          "the rest, on any machines that see it; --memory is for each of them")
      ->type_name("DIR");
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa stream lidar/*.las --alpha 2 --memory 1G --scratch /data/scratch -o footprint.geojson\n"
      "  rbpa stream lidar/ --alpha 2 -o footprint.wkt -o triangles.npy -o 'tiles/*.ply'\n"
      "  rbpa stream lidar/*.las --alpha 2 --scratch /data/scratch -o footprint.geojson --resume\n\n"
      "The files are the same to the byte as those of rbpa shape and rbpa mesh of all points in one file. Files are "
      "read\n"
      "twice, and the scratch takes about as much as LAS files do. Of .npy, .f64xy, LAS and text some megabytes are "
      "in\n"
      "memory at a time, of other formats a whole file.\n" +
      std::string(exit_codes));
}

void add_fill(CLI::App& app, FillArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("fill", "Polygons with holes as triangles of a wanted size");
  verb.add_option("POLYGON", arguments.polygons, "File of polygons, .gz or not, or - for standard input")->required();
  verb.add_option("--format", arguments.format,
                  "Format of POLYGON, where its ending does not say: " + std::string(polygon_formats))
      ->type_name("NAME");
  verb.add_option("--size", arguments.size,
                  "Length that edges are to have, required, in units of the polygons; where others ask for less, the "
                  "greatest")
      ->type_name("H")
      ->required();
  verb.add_option(
          "--size-at", arguments.size_at,
          "Text with x, y and a size on each line: about the length of edges at that place, from which they grow")
      ->type_name("FILE");
  verb.add_option("--grade", arguments.grade,
                  "How much sizes grow for each unit of distance: from those of --size-at (0.25 by default), and from "
                  "the polygons' own edges, which without this ask for nothing")
      ->type_name("G");
  add_switch(verb, "--keep-boundary", arguments.keep_boundary,
             "Leave the edges of the polygons whole; by default those that are longer than the size are cut");
  add_output_options(verb, arguments, output_formats);
  verb.add_option("--stats", arguments.stats, "Write sizes, times and peak memory as JSON")->type_name("FILE");
  verb.add_option("--width", arguments.width, "Width of pictures in pixels")
      ->type_name("PIXELS")
      ->capture_default_str();
  add_switch(verb, "-q,--quiet", arguments.quiet, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa fill lake.geojson --size 0.01 -o lake.ply -o lake.png\n"
      "  rbpa fill coast.wkt --size 0.5 --grade 0.3 -o coast.vtu\n"
      "  rbpa fill plate.poly --size 2 --size-at cracks.txt -o plate.off\n"
      "  zcat lake.wkt.gz | rbpa fill - --format wkt --size 0.01 --keep-boundary -o lake.npy\n\n"
      "Polygons that cross or touch themselves or each other are refused, and the place is named.\n"
      "Vertices of a mesh file are those of POLYGON in its order, then those on edges that were cut, then those "
      "inside.\n" +
      std::string(exit_codes));
}

void add_surface(CLI::App& app, SurfaceArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("surface", "Triangles through points in space, by a ball of a given radius");
  verb.add_option("POINTS", arguments.points, "File of points in space, .gz or not, or - for standard input")
      ->required();
  verb.add_option("--format", arguments.format,
                  "Format of POINTS, where its ending does not say: " + std::string(space_formats))
      ->type_name("NAME");
  verb.add_option("--columns", arguments.columns,
                  "Columns of text: x, y, z, or with the normal's as well; numbers from 1, or header names")
      ->type_name("X,Y,Z[,NX,NY,NZ]");
  add_selection_options(verb, arguments);
  verb.add_option("--radius", arguments.radius,
                  "Radius of the ball, required, in units of the points; several, ascending, close what the smaller "
                  "ones left open; auto takes them from the gaps between the points")
      ->type_name("R[,R2,...]|auto")
      ->required();
  verb.add_option("--normals", arguments.normals,
                  "file, estimate, or none (both sides of everything the ball can touch); by default those of the "
                  "file where it has any, else estimate")
      ->type_name("NAME");
  add_output_options(verb, arguments, surface_formats);
  add_switch(verb, "--compact", arguments.compact,
             "Leave out vertices that no triangle uses (.npy keeps input indices)");
  verb.add_option("--holes", arguments.holes, "Write the boundary curves as polylines, .obj")->type_name("FILE");
  add_switch(verb, "--json", arguments.json, "Everything, with each hole and its causes, as JSON on standard output");
  verb.add_option("--stats", arguments.stats, "Write sizes, times and peak memory as JSON")->type_name("FILE");
  verb.add_option("--width", arguments.width, "Width of pictures in pixels")
      ->type_name("PIXELS")
      ->capture_default_str();
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa surface scan.ply --radius 0.01 -o mesh.ply -o picture.png\n"
      "  rbpa surface scan.xyz --radius auto -o mesh.obj --holes holes.obj\n"
      "  rbpa surface scan.xyz --radius 2,5 --normals estimate --json > holes.json\n\n"
      "Vertices of a mesh file are the input points in input order. Why the surface ends at a hole, and why\n"
      "points are unused, is said.\n" +
      std::string(exit_codes));
}

void add_tile(CLI::App& app, TileArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("tile", "A task of rbpa stream --tasks: what one tile contributes to the whole");
  verb.add_option("TILE", arguments.tile, "File of the tile, in its folder")->required();
  verb.add_option("-o,--output", arguments.outputs,
                  "File to write, by its ending: " + std::string(tile_formats) + "; may be given once of each kind")
      ->type_name("OUT")
      ->allow_extra_args(false);
  verb.add_option("--stats", arguments.stats, "Write sizes, times and peak memory as JSON")->type_name("FILE");
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Example:\n"
      "  rbpa tile tasks/tiles/000012.tile -o 12.partial -o 12.npy\n\n"
      "What is finished is in files beside the partial, 12.polygons and 12.holes. Triangles have the indices of the\n"
      "whole input. A task that is run again writes the same.\n" +
      std::string(exit_codes));
}

void add_merge(CLI::App& app, MergeArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("merge", "A task of rbpa stream --tasks: partials become one, or the whole");
  verb.add_option("PARTIALS", arguments.partials, "Partials of rbpa tile or rbpa merge, any number in any order")
      ->required();
  verb.add_option("-o,--output", arguments.outputs,
                  "File to write, by its ending: " + std::string(merge_formats) + "; - is standard output")
      ->type_name("OUT")
      ->allow_extra_args(false);
  verb.add_option("--output-format", arguments.output_format, "Format of an OUT whose ending does not say")
      ->type_name("NAME");
  verb.add_option("--memory", arguments.memory, "Memory for what is put in order at the end, such as 500M or 4G")
      ->type_name("SIZE")
      ->capture_default_str();
  verb.add_option(
          "--scratch", arguments.scratch,
          "Folder for what does not fit into memory at the end, new or empty; by default one beside the first OUT")
      ->type_name("DIR");
  verb.add_option("--stats", arguments.stats, "Write sizes, times and peak memory as JSON")->type_name("FILE");
  add_switch(verb, "-q,--quiet", arguments.quiet, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa merge 0.partial 1.partial 2.partial -o half.partial\n"
      "  rbpa merge half.partial other.partial -o footprint.geojson -o triangles.npy\n\n"
      "Of all tiles it writes what rbpa shape and rbpa mesh write of all points, to the byte. The order of the "
      "partials\n"
      "changes nothing, but neighbours should be merged first: less is open between them.\n" +
      std::string(exit_codes));
}

/// "rbpa mesh", or "rbpa" where no verb was given.
std::string asked_for(const CLI::App& app) {
  const auto verbs = app.get_subcommands();
  return verbs.empty() ? program : program + (" " + verbs.front()->get_name());
}

std::string unexpected(const std::string& word, const CLI::App& app) {
  const std::string found = "found " + in_quotes(word) + ", expected ";
  if (app.get_subcommands().empty())
    return found + "mesh, alpha, shape, fill, surface, stream, tile, merge, info or report (see rbpa --help)";
  const std::string verb = asked_for(app);
  return found + (word.starts_with('-') ? "an option" : "no more arguments") + " of " + verb + " (see " + verb +
         " --help)";
}

/// What was asked, last word first, as CLI has it. "help VERB" is "VERB --help".
std::vector<std::string> words_of(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    const auto is_asked_for = [&](const CLI::App* verb) { return verb->check_name(words[0]); };
    if (words.empty() || !app.get_subcommands(is_asked_for).empty()) words.push_back("--help");
  }
  std::reverse(words.begin(), words.end());
  return words;
}

int main(int argc, char** argv) {
  occupy_standard_streams();
  catch_interrupts();
  CLI::App app("Solid alpha complexes of points in the plane, by restricted ball pivoting", "rbpa");
  app.formatter(std::make_shared<NarrowHelp>());
  app.set_version_flag("--version", std::string("rbpa ") + RBPA_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Examples:\n  rbpa info points.xy\n  rbpa mesh points.xy --alpha 0.3 -o mesh.ply -o picture.png\n\n"
      "`rbpa help VERB` says more.");
  MeshArguments mesh;
  ShapeArguments shape;
  StreamArguments stream;
  TileArguments tile;
  MergeArguments merge;
  InfoArguments info;
  AlphaArguments alpha;
  ReportArguments report_page;
  FillArguments fill;
  SurfaceArguments surface;
  add_mesh(app, mesh);
  add_alpha(app, alpha);
  add_shape(app, shape);
  add_fill(app, fill);
  add_surface(app, surface);
  // Tasks call the program as it was called.
  if (argc > 0 && std::string_view(argv[0]).find('/') != std::string_view::npos)
    stream.program = std::filesystem::absolute(argv[0]).lexically_normal().string();
  add_stream(app, stream);
  add_tile(app, tile);
  add_merge(app, merge);
  add_info(app, info);
  add_report(app, report_page);
  add_manual(app, std::string("rbpa ") + RBPA_VERSION);
  try {
    app.parse(words_of(app, argc, argv));
  } catch (const CLI::Success& e) {  // help or version
    std::ostringstream text, nothing;
    app.exit(e, text, nothing);
    return run(program, [&] { print(text.str()); });
  } catch (const CLI::ParseError& e) {
    // What is missing may be there under a wrong name.
    const std::vector<std::string> unknown = app.remaining(true);
    if (!unknown.empty()) return report(program, unexpected(unknown.front(), app), wrong_usage);
    return report(program, std::string(e.what()) + " (see " + asked_for(app) + " --help)", wrong_usage);
  }
  if (app.got_subcommand("mesh")) return run(program, [&] { run_mesh(mesh); });
  if (app.got_subcommand("alpha")) return run(program, [&] { run_alpha(alpha); });
  if (app.got_subcommand("shape")) return run(program, [&] { run_shape(shape); });
  if (app.got_subcommand("fill")) return run(program, [&] { run_fill(fill); });
  if (app.got_subcommand("surface")) return run(program, [&] { run_surface(surface); });
  if (app.got_subcommand("stream")) return run(program, [&] { run_stream(stream); });
  if (app.got_subcommand("tile")) return run(program, [&] { run_tile(tile); });
  if (app.got_subcommand("merge")) return run(program, [&] { run_merge(merge); });
  if (app.got_subcommand("report")) return run(program, [&] { run_report(report_page); });
  return run(program, [&] { run_info(info); });
}

}  // namespace
}  // namespace rbpa::app

int main(int argc, char** argv) { return rbpa::app::main(argc, argv); }
