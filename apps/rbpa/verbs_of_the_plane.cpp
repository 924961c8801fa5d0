// What: declares the verbs for points and polygons in the plane.
#include <CLI/App.hpp>
#include <string>

#include "io/polygon/ogr.h"
#include "rbpa/verb_options.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

CLI::Option* add_segment_options(CLI::App& verb, SegmentArguments& arguments) {
  CLI::Option* const segments =
      add_value(verb, "--segments", arguments.segments, "LINES",
                "Make the sides of the lines and polygons of this file edges of triangles, such as breaklines of a "
                "terrain: constrained Delaunay triangles. Vertices of lines are points too; fields are not kept");
  add_switch(verb, "--split-crossings", arguments.split_crossings,
             "Split sides where they cross, at the nearest doubles, instead of refusing them")
      ->needs(segments);
  return segments;
}

}  // namespace

CLI::App* add_mesh(CLI::App& app, MeshArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "mesh", "Make the triangles of the solid alpha complex: Delaunay triangles with circumradius <= alpha");
  arguments.columns_may_have_z = true;
  add_group_options(verb, arguments, "Make triangles");
  add_alpha_options(verb, arguments);
  add_output_options(verb, arguments, endings(Use::triangles) + with_world_file);
  add_fields_option(verb, arguments.fields);
  add_switch(verb, "--compact", arguments.compact, "Leave out vertices that nothing uses (.npy keeps input indices)");
  add_value(verb, "--complex", arguments.complex, "NAME",
            "Make the solid complex, which is triangles alone, or the full one, which also has the edges and points of "
            "the alpha complex that are in no triangle");
  add_switch(verb, "--inside", arguments.inside,
             "Keep only triangles inside closed lines and polygons, by the even-odd rule")
      ->needs(add_segment_options(verb, arguments));
  add_method_options(verb, arguments.method);
  add_value(verb, "--search", arguments.method.search, "NAME",
            "Search near each edge, or as in the published paper (slow); the result is the same");
  add_value(verb, "--levels", arguments.levels, "FILE",
            "Write the number of triangles made on each level of hrbpa, and the topology after it: " +
                table_endings(Use::levels));
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa mesh points.xy --alpha 0.3 -o mesh.ply -o picture.png\n"
      "  rbpa mesh cities.csv --columns lon,lat --alpha inf -o delaunay.off\n"
      "  rbpa mesh points.xy --alpha auto --components 2 -o mesh.ply\n"
      "  rbpa mesh lidar.las --where \"classification == 2\" --alpha inf -o tin.ply -o tin.geojson\n"
      "  rbpa mesh ground.csv --alpha inf --segments breaklines.geojson -o tin.obj\n"
      "  rbpa mesh points.xy --alpha 0.3 --method hrbpa --levels levels.csv\n"
      "  rbpa mesh points.xy --alpha 0.3 --complex full -o mesh.obj -o arrays.npy\n"
      "  rbpa mesh trees.csv --columns x,y --group-by crown --alpha auto -o crowns.vtu\n"
      "  generate | rbpa mesh - --alpha 2 -o - --output-format obj > mesh.obj\n\n"
      "Vertices of a mesh file are the input points in input order: an index means the same in both. They keep z if "
      "the input has it; vertices of --segments follow, and places where sides were split. In arrays.npy indices also "
      "count points that --where or --skip-invalid leaves out. The full "
      "complex is in lines f, l and p of an .obj; arrays.npy has its triangles, and arrays.edges.npy and "
      "arrays.points.npy next to it the rest. For groups .vtu and .ply have the number of each triangle's group, from "
      "0 in the order in which rbpa shape --group-by lists them.\n");
}

CLI::App* add_alpha(CLI::App& app, AlphaArguments& arguments) {
  CLI::App& verb =
      *app.add_subcommand("alpha", "Print the radii at which the complex changes, and which of them to choose");
  add_group_options(verb, arguments, "Print the radii to choose");
  add_auto_options(verb, arguments);
  CLI::Option* json = add_switch(verb, "--json", arguments.json, "Print everything as JSON");
  add_switch(verb, "--csv", arguments.csv, "Print a line for every radius, or with --persistence for every pair")
      ->excludes(json);
  add_switch(verb, "--persistence", arguments.persistence, "Add births and deaths of components and holes");
  add_value(verb, "--dimension", arguments.dimension, "2|3",
            "Take POINTS as points of the plane (2) or of space (3). In space compute the full alpha complex, with its "
            "tunnels and voids; --csv prints every pair");
  add_waters_option(verb, arguments.waters);
  add_ball_radii_options(
      verb, arguments, "With --dimension 3 take POINTS as balls with",
      ": births and deaths are powers p, at which a ball of radius R has the squared radius R^2 + p");
  add_value(verb, "--complex", arguments.complex, "NAME",
            "Compute the persistence of the solid complex (default), or of the full one, with edges and "
            "points in no triangle");
  add_value(verb, "-o,--output", arguments.picture, "OUT",
            "Write a picture, .svg: the counts against alpha, and the persistence");
  add_value(verb, "--representatives", arguments.representatives, "FILE",
            "Write where the pairs are. In the plane, geojson: each hole as polygons at its birth and before its "
            "death. In space, " +
                endings(Use::cycles) + ": cycles around tunnels and surfaces around voids");
  add_value(verb, "--top", arguments.top, "K",
            "Write only the K most persistent pairs of each dimension (default 100, unless --min-persistence "
            "is given)");
  add_value(verb, "--min-persistence", arguments.min_persistence, "P",
            "Write only pairs with death - birth at least P, a length in units of the points");
  add_value(verb, "--levels", arguments.levels, "RADII",
            "Write only pairs that are alive at one of these radii, each as it is at the first and at the last of "
            "them; hrbpa, hrbpa:K: at the radii of the levels of rbpa mesh --method hrbpa [--leaf-capacity K]");
  add_run_options(verb, arguments.run, "Print neither progress nor warnings about the input");
  return with_footer(
      verb,
      "min is the least alpha at which every distinct point is in a triangle; auto the least at which there are also "
      "at most K solid components. A plateau is a range of alpha over which parts and holes hardly change; the best "
      "is recommended. Parts are solid components, connected through edges; components are connected through "
      "points.\n\n"
      "Examples:\n"
      "  rbpa alpha points.xy\n"
      "  rbpa alpha points.xy --csv > radii.csv\n"
      "  rbpa alpha points.xy --json --persistence --complex full > diagram.json\n"
      "  rbpa alpha points.xy --representatives holes.geojson --top 10\n"
      "  rbpa alpha points.xy --representatives holes.geojson --levels hrbpa:64\n"
      "  rbpa alpha atoms.pdb --dimension 3 --representatives cycles.obj --min-persistence 1\n"
      "  rbpa alpha atoms.pdb --dimension 3 --radii bondi --csv > powers.csv\n"
      "  rbpa alpha fixes.csv --columns x,y --group-by animal --csv\n\n");
}

CLI::App* add_shape(CLI::App& app, ShapeArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "shape",
      "Make polygons with holes of the alpha solid, valid under OGC Simple Features\n\n"
      "Which alpha to choose: plateau first. It is a radius around which parts and holes hardly change, and single "
      "points "
      "far from the others do not decide it. Give a number if you know which gaps are to stay open. min covers every "
      "point, and auto does so in one piece, so the most isolated point decides; with --cover 0.99 they leave out 1 "
      "point of 100, and may then have many parts and pinholes. `rbpa alpha POINTS` shows what each gives.\n");
  add_group_options(verb, arguments, "Make a shape");
  add_alpha_options(verb, arguments);
  add_output_options(verb, arguments, endings(Use::shape) + with_world_file);
  add_method_options(verb, arguments.method);
  add_area_options(verb, arguments);
  add_value(verb, "--isolated", arguments.isolated, "FILE",
            "Write the points in no polygon to this file, in the format of its ending: " + endings(Use::isolated));
  add_value(verb, "--summarize", arguments.summarize, "LIST",
            "Add statistics of fields to each polygon, or to each group: FIELD:STATISTIC, several with commas "
            "between them, such as intensity:mean,class:majority; min, max, mean, sum or majority");
  add_fields_option(verb, arguments.fields, "where points are listed: in .csv, .gpkg and --isolated");
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa shape points.xy --alpha plateau -o shape.geojson -o picture.png\n"
      "  rbpa shape cities.csv --columns lon,lat --alpha 0.5 --min-hole-area 0.1 -o - --output-format wkt\n"
      "  rbpa shape lidar.las --where \"classification == 6\" --alpha 2 -o roofs.geojson\n"
      "  rbpa shape fixes.csv --columns x,y --group-by animal --alpha auto --cover 0.95 -o ranges.geojson\n"
      "  rbpa shape tiles/*.las --group-by-file --alpha 2 -o footprints.geojson\n"
      "  rbpa shape points.xy --alpha auto --cover 0.99 --min-part-area 2 --min-hole-area 2 -o shape.wkt\n\n"
      "GeoJSON has a Feature for each polygon, with its number, area, perimeter, holes and points; WKT is one "
      "MULTIPOLYGON; CSV has the points, each with the number of the polygon that contains it. For groups GeoJSON "
      "has a Feature for each group, and CSV a line; --alpha is chosen for each group by itself, and may be "
      "column:NAME, a column of radii. Coordinates are those of the input, to the last bit, and areas are in their "
      "unit squared.\n");
}

CLI::App* add_discs(CLI::App& app, DiscsArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "discs",
      "Measure the union of discs around points: covered area, boundary, components and holes of the coverage");
  add_point_options(verb, arguments);
  add_value(verb, "--radius", arguments.radius, "R|column:NAME",
            "Set the radius of all discs (required: a radius in units of the points, or column:NAME); column:NAME: "
            "a column or field with the radius of each")
      ->required();
  add_output_options(verb, arguments, endings(Use::shape) + with_world_file);
  add_value(verb, "--corners", arguments.corners, "N",
            "Give a whole circle this number of corners in polygons and pictures");
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa discs stations.csv --columns x,y --radius 500 -o covered.geojson\n"
      "  rbpa discs trees.csv --radius column:crown -o crowns.csv -o crowns.wkt\n\n"
      "GeoJSON and WKT have the components as polygons with holes, whose corners are on the circles; the printed area "
      "and boundary are those of the discs themselves. CSV has a line for each disc: the number of its polygon, its "
      "radius, the area of its part of the union, which is the part in its power cell, and the length of its circle on "
      "the boundary; a disc without a part has no number. Which discs meet is decided exactly. Discs that only touch "
      "are in different polygons.\n");
}

CLI::App* add_voronoi(CLI::App& app, VoronoiArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("voronoi", "Make the Voronoi cells of points as polygons that tile a boundary");
  add_point_options(verb, arguments);
  add_value(verb, "--clip", arguments.clip, "box|hull|shape|POLYGON",
            "Cut the cells at a box a tenth larger than the points, at their convex hull, at their alpha shape, or at "
            "the polygons of a file, which share no edge");
  add_value(verb, "--alpha", arguments.alpha, "R|plateau[:K]|auto|min|inf",
            "With --clip shape, as rbpa shape takes it (default plateau)");
  add_output_options(verb, arguments, endings(Use::shape) + with_world_file);
  add_fields_option(verb, arguments.fields, "on the cells of .geojson and .gpkg, and in .csv");
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa voronoi stations.csv --columns x,y -o cells.geojson -o cells.png\n"
      "  rbpa voronoi trees.csv --clip shape --alpha 20 -o crowns.geojson\n"
      "  rbpa voronoi schools.geojson --clip district.geojson -o catchments.gpkg\n\n"
      "Cells tile the boundary: neighbors have the same corners, areas add up, and every polygon is valid under OGC "
      "Simple "
      "Features, after rounding too. GeoJSON has a Feature for each polygon, with \"point\", the input index of its "
      "point from 0, and the fields of the point; a cell has several polygons where the boundary is not convex. The "
      "cell "
      "of equal points has the index of the first. CSV has a line for each point, with the number of its first "
      "polygon, "
      "and none for a point whose cell is outside of the boundary.\n");
}

CLI::App* add_grid(CLI::App& app, GridArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("grid", "Interpolate heights of points: a raster of cells, and contour lines");
  arguments.columns_may_have_z = true;
  add_point_options(verb, arguments);
  add_value(verb, "--cell", arguments.cell, "S",
            "Set the size of the square cells of a raster, in units of the points");
  add_value(verb, "--contours", arguments.contours, "H1,H2,...|every:STEP",
            "Draw contour lines at these heights, or at all multiples of STEP");
  add_value(verb, "--value", arguments.value, "z|COLUMN",
            "Interpolate z, the third coordinate, or this column or field of numbers");
  add_value(verb, "--method", arguments.method, "linear|natural",
            "Fill cells linearly in each triangle, or by natural neighbors, which is smooth across sides of "
            "triangles; contour lines are linear");
  add_value(verb, "--alpha", arguments.alpha, "R|plateau[:K]|auto|min|inf",
            "Leave gaps open: use only triangles of circumradius at most R, or as rbpa shape chooses the radius");
  add_value(verb, "--extent", arguments.extent, "X0,Y0,X1,Y1",
            "Cover this box with cells instead of that of the points, such as a tile without its margin");
  add_segment_options(verb, arguments);
  add_output_options(verb, arguments, endings(Use::heights) + with_world_file);
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa grid tile.laz --where \"classification == 2\" --cell 1 -o dtm.asc\n"
      "  rbpa grid levels.csv --value depth --alpha 50 --cell 5 --method natural -o depth.npy\n"
      "  rbpa grid tile.laz --where \"classification == 2\" --contours every:5 -o lines.geojson\n"
      "  rbpa grid ground.csv --segments breaklines.geojson --cell 1 -o dtm.asc\n\n"
      "A cell has the value at its center; a cell whose center is in no triangle has none: -9999 in .asc, NaN in .npy. "
      "Sides of the raster are at multiples of the size of a cell, so that rasters of tiles fit together; the top row "
      "is first. GeoJSON has a LineString for each line, with \"height\" and \"closed\"; WKT is one MULTILINESTRING Z. "
      "Of points on one place the first counts. Rasters of any size are written block by block.\n");
}

CLI::App* add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App& verb =
      *app.add_subcommand("info", "Print the number of points and duplicates, their box and their spacing");
  add_group_options(verb, arguments, "Print a line");
  add_switch(verb, "--json", arguments.json, "Print JSON");
  add_run_options(verb, arguments.run, "Print neither progress nor warnings about the input");
  return with_footer(
      verb,
      "The spacing is the square root of box area / distinct points: a first guess of a good alpha. Of LAS and LAZ the "
      "version, the format of points, the compressor, scale and offset are printed, and the numbers of points by class "
      "and by return.\n\n"
      "Examples:\n"
      "  rbpa info points.xy --json\n"
      "  rbpa info tile.laz --where \"classification == 2\"\n"
      "  rbpa info fixes.csv --columns x,y --group-by animal\n\n");
}

CLI::App* add_report(CLI::App& app, ReportArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("report", "Write a page for the browser that shows the complex at every radius");
  add_point_options(verb, arguments);
  add_value(verb, "-o,--output", arguments.output, "OUT",
            "Write this page (required: a name such as page.html); - is standard output")
      ->required();
  add_value(verb, "--dimension", arguments.dimension, "2|3",
            "Take POINTS as points of the plane (2) or of space (3). In space the page shows tunnels and voids, and a "
            "boundary that can be turned");
  add_waters_option(verb, arguments.waters);
  add_auto_options(verb, arguments);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "The page is one file with everything in it, for any browser, offline: a slider over alpha, counts, the "
      "persistence diagram, and the shape as GeoJSON and SVG. It takes about 110 bytes a point, and is smooth with "
      "some hundred thousand points. In space the boundary can be turned, and a click on a pair shows its cycle, or "
      "the surface around its void; about 190 bytes a point.\n\n"
      "Examples:\n"
      "  rbpa report points.xy -o report.html\n"
      "  rbpa report atoms.pdb --dimension 3 -o report.html\n\n");
}

CLI::App* add_fill(CLI::App& app, FillArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("fill", "Fill polygons with holes by triangles of a wanted size");
  verb.add_option("POLYGON", arguments.polygons, "File of polygons, .gz or not, or - for standard input")->required();
  add_value(verb, "--format", arguments.format, "NAME",
            "Set the format of POLYGON, if its ending does not tell: " + endings(Use::polygons));
  add_value(verb, "--size", arguments.size, "H",
            "Make edges of about this length (required: a length in units of the polygons, or inf), and shorter "
            "ones where "
            "--size-at or --grade ask for them; inf: add no point, which gives the constrained Delaunay "
            "triangulation")
      ->required();
  add_value(verb, "--size-at", arguments.size_at, "FILE",
            "Read x, y and a size from each line of this text: make edges of about that length there, and "
            "longer ones farther away");
  add_value(verb, "--grade", arguments.grade, "G",
            "Let sizes grow by G for each unit of distance from the places of --size-at (default 0.25), and "
            "from the polygons' own edges, whose lengths count only if this is given");
  add_switch(verb, "--keep-boundary", arguments.keep_boundary,
             "Keep the edges of the polygons whole (by default those longer than the size are cut)");
  add_switch(verb, "--skip-invalid", arguments.skip_invalid, "Skip features that are not valid, and print how many");
  add_output_options(verb, arguments, endings(Use::triangles) + with_world_file);
  add_stats_option(verb, arguments.run.stats);
  add_width_option(verb, arguments.width);
  add_switch(verb, "-q,--quiet", arguments.run.quiet, quiet_about_summary);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa fill lake.geojson --size 0.01 -o lake.ply -o lake.png\n"
      "  rbpa fill coast.wkt --size 0.5 --grade 0.3 -o coast.vtu\n"
      "  rbpa fill plate.poly --size 2 --size-at cracks.txt -o plate.off\n"
      "  zcat lake.wkt.gz | rbpa fill - --format wkt --size 0.01 --keep-boundary -o lake.npy\n\n"
      "Rings may touch in single points (OGC Simple Features). Rings that cross or overlap are refused; the message "
      "names feature and place. Features may overlap, or share edges, along which triangles meet in whole edges. "
      "Each triangle of .ply and .vtu has the number of its feature, from 0, as 'feature'; .vtu also has the numeric "
      "GeoJSON properties. Vertices of a mesh file are those of POLYGON in its order, then those on edges that were "
      "cut, then those inside.\n");
}

}  // namespace rbpa::app
