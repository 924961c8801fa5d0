// What: declares the verbs `fill`, `surface` and `solid`: polygons to fill, and points in space.
#include <CLI/App.hpp>
#include <string>

#include "cli/shared_options.h"
#include "cli/verbs.h"
#include "program/exit_code.h"

namespace rbpa::app {

namespace {

void add_space_point_options(CLI::App& verb, SpacePointArguments& arguments) {
  verb.add_option("POINTS", arguments.points, "File of points in space, .gz or not, or - for standard input")
      ->required();
  verb.add_option("--format", arguments.format,
                  "Format of POINTS, where its ending does not say: " + std::string(space_formats))
      ->type_name("NAME");
  verb.add_option(
          "--columns", arguments.columns,
          "Columns of text: x, y, z, or with the normal's as well; numbers from 1, or header names; colours are those "
          "that the header calls red, green and blue, or r, g and b")
      ->type_name("X,Y,Z[,NX,NY,NZ]");
  add_selection_options(verb, arguments);
  add_waters_option(verb, arguments.waters);
}

}  // namespace

CLI::App* add_fill(CLI::App& app, FillArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("fill", "Polygons with holes as triangles of a wanted size");
  verb.add_option("POLYGON", arguments.polygons, "File of polygons, .gz or not, or - for standard input")->required();
  verb.add_option("--format", arguments.format,
                  "Format of POLYGON, where its ending does not say: " + std::string(polygon_formats))
      ->type_name("NAME");
  verb.add_option("--size", arguments.size,
                  "Length that edges are to have, required, in units of the polygons; where others ask for less, the "
                  "greatest; inf: no point is added, the constrained Delaunay triangulation")
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
  add_switch(verb, "--skip-invalid", arguments.skip_invalid,
             "Go on without features that are not valid, and say how many");
  add_output_options(verb, arguments, target_formats(Use::triangles));
  add_stats_option(verb, arguments.stats);
  add_width_option(verb, arguments.width);
  add_switch(verb, "-q,--quiet", arguments.quiet, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa fill lake.geojson --size 0.01 -o lake.ply -o lake.png\n"
      "  rbpa fill coast.wkt --size 0.5 --grade 0.3 -o coast.vtu\n"
      "  rbpa fill plate.poly --size 2 --size-at cracks.txt -o plate.off\n"
      "  zcat lake.wkt.gz | rbpa fill - --format wkt --size 0.01 --keep-boundary -o lake.npy\n\n"
      "Rings may touch in single points (OGC Simple Features); what crosses or overlaps is refused, and feature and "
      "place\n"
      "are named. Features may share edges, along which triangles meet in whole edges, or overlap. Each triangle of "
      ".ply "
      "and\n"
      ".vtu has the number of its feature, from 0, as 'feature'; .vtu has the numbers among its GeoJSON properties "
      "too.\n"
      "Vertices of a mesh file are those of POLYGON in its order, then those on edges that were cut, then those "
      "inside.\n" +
      std::string(exit_codes));
  return &verb;
}

CLI::App* add_surface(CLI::App& app, SurfaceArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("surface", "Triangles through points in space, by a ball of a given radius");
  add_space_point_options(verb, arguments);
  verb.add_option("--radius", arguments.radius,
                  "Radius of the ball, required, in units of the points; several, ascending, close what the smaller "
                  "ones left open; auto takes them from the gaps between the points")
      ->type_name("R[,R2,...]|auto")
      ->required();
  verb.add_option("--max-radius", arguments.max_radius, "With --radius auto: larger radii become this one")
      ->type_name("R");
  verb.add_option("--normals", arguments.normals,
                  "file, estimate, or none (both sides of everything the ball can touch); by default those of the "
                  "file where it has any, else estimate")
      ->type_name("NAME");
  verb.add_option("--neighbors", arguments.neighbors,
                  "Estimate normals, from planes through each point and so many others, the nearest (16 by default)")
      ->type_name("K");
  verb.add_option(
          "--viewpoint", arguments.viewpoint,
          "Where the points were seen from, or the columns that say where each was: normals are turned toward it, "
          "those of the file too")
      ->type_name("X,Y,Z");
  add_switch(verb, "--flip", arguments.flip, "Turn all normals around, after all else");
  verb.add_option("--color", arguments.color,
                  "Colours of files and pictures: points, those of the file (by default), or normals, how sure each "
                  "estimated normal is: blue, or orange where it is in doubt")
      ->type_name("NAME");
  verb.add_option(
          "--drop-outliers", arguments.drop_outliers,
          "Leave out points that are more than K times as far from their 8th nearest as the median point is (auto: 4). "
          "Not for scans whose density differs by more than that")
      ->type_name("K|auto");
  verb.add_option("--scale-space", arguments.scale_space,
                  "For noise: the ball rolls over points that are moved onto local planes in N steps, or in as many as "
                  "they take to lie still; files have the points as they came")
      ->type_name("N|auto");
  add_switch(verb, "--moved", arguments.moved, "With --scale-space: files have the points where they are moved to");
  add_output_options(verb, arguments, surface_formats);
  add_switch(verb, "--compact", arguments.compact,
             "Leave out vertices that no triangle uses (.npy keeps input indices)");
  add_switch(
      verb, "--manifold", arguments.manifold,
      "Where sheets of the surface touch, a vertex for each, so that a reader finds edges of one or two triangles; "
      ".ply has the input index of each vertex as 'point'. Leaves out unused vertices too (.npy keeps input "
      "indices)");
  verb.add_option("--keep-largest", arguments.keep_largest, "Keep only so many components, those of the largest area")
      ->type_name("K");
  verb.add_option("--drop-small", arguments.drop_small,
                  "Drop components of fewer than N triangles, or of an area below A, in squared units of the points")
      ->type_name("N|area=A");
  verb.add_option("--shell", arguments.shell,
                  "With --normals none: all shells (by default), outer: those that the ball touches from outside, or "
                  "largest: of these the one of the largest area")
      ->type_name("all|outer|largest");
  verb.add_option("--fill-holes", arguments.fill_holes,
                  "Fill holes by triangles between their points that cross nothing: all, rims as well, those of at "
                  "most N edges, or of a length of at most L")
      ->type_name("all|rims|N|length=L");
  add_switch(
      verb, "--watertight", arguments.watertight,
      "Drop open islands, fill holes and rims, and write a closed --manifold surface without crossings, which holds "
      "of what .stl and .glb keep of it too; where that cannot be, write nothing, say what is left, and exit "
      "with 1");
  verb.add_option(
          "--shift", arguments.shift,
          "Of .stl and .glb, in single precision: subtract X,Y,Z from all coordinates, or the middle of their box. "
          "What is "
          "subtracted is said, and stands in the header of .stl; .glb keeps the place, as its node is moved back")
      ->type_name("X,Y,Z|auto");
  add_switch(
      verb, "--refine", arguments.refine,
      "With --fill-holes or --watertight: add points inside what is filled, so that it is as fine and as smooth as "
      "the surface around it");
  verb.add_option("--holes", arguments.holes,
                  "Write the boundary curves as polylines, .obj, in groups 'rim', 'hole' and 'island'")
      ->type_name("FILE");
  add_switch(verb, "--remedies", arguments.remedies,
             "Look for what closes each hole: one more radius, normals that are to be turned, or a filling; each is "
             "tried. For the summary, --json and --stats");
  add_switch(verb, "--json", arguments.json, "Everything, with each hole and its causes, as JSON on standard output");
  add_stats_option(verb, arguments.stats);
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa surface scan.ply --radius 0.01 -o mesh.ply -o picture.png\n"
      "  rbpa surface scan.xyz --radius auto -o mesh.obj --holes holes.obj\n"
      "  rbpa surface scan.ply --radius auto --drop-small 100 --manifold -o mesh.ply\n"
      "  rbpa surface body.xyz --radius 2 --normals none --shell outer -o closed.stl\n"
      "  rbpa surface scan.ply --radius auto --keep-largest 1 --watertight -o print.stl\n"
      "  rbpa surface scan.ply --radius auto --keep-largest 1 --watertight --refine -o print.stl\n"
      "  rbpa surface scan.ply --radius 0.01 --remedies -o mesh.ply\n"
      "  rbpa surface noisy.ply --scale-space auto --moved --radius auto -o smooth.ply\n"
      "  rbpa surface scan.xyz --radius 2,5 --normals estimate --json > holes.json\n\n"
      "Vertices of a mesh file are the input points in input order. Why the surface ends at a hole, and why\n"
      "points are unused, is said.\n" +
      std::string(exit_codes));
  return &verb;
}

CLI::App* add_solid(CLI::App& app, SolidArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "solid", "Tetrahedra of points in space: the solid alpha complex, with its boundary and voids");
  add_space_point_options(verb, arguments);
  verb.add_option(
          "--alpha", arguments.alpha,
          "Largest circumradius, required, in units of the points; inf: the Delaunay triangulation; min: the least "
          "that covers every point; auto: the least that has every point in one solid component; plateau, plateau:K: "
          "where "
          "parts and voids hardly change")
      ->type_name("R|inf|auto|min|plateau")
      ->required();
  verb.add_option(
          "--cover", arguments.cover,
          "Share of the points that auto and min are about, such as 0.99, so that single ones do not decide them")
      ->type_name("SHARE");
  verb.add_option(
          "--box", arguments.box,
          "Points are those of a box with these sides that repeats, as under periodic boundary conditions; "
          "coordinates count modulo the sides. Voids have a dimension: in how many directions they percolate, 0 "
          "where they are closed. auto: the cell of a molecule's file")
      ->type_name("LX,LY,LZ|auto");
  add_output_options(verb, arguments, solid_formats);
  verb.add_option("--boundary", arguments.boundary,
                  "Write the boundary as a closed surface, where the solid touches itself with a vertex for each side "
                  "of it: ply (which has the input index of each vertex as 'point'), off, obj, stl, glb, vtu; or the "
                  "input indices of its triangles, npy")
      ->type_name("FILE");
  verb.add_option(
          "--shift", arguments.shift,
          "Of a boundary as .stl or .glb, in single precision: subtract X,Y,Z from all coordinates, or the middle of "
          "their box. What is "
          "subtracted is said, and stands in the header of .stl; .glb keeps the place, as its node is moved back")
      ->type_name("X,Y,Z|auto");
  verb.add_option(
          "--voids", arguments.voids,
          "Write each void, the largest first: obj, a closed surface in a group of its own; json, with the input "
          "indices of its points and triangles, and what a molecule's file calls the atoms; csv. volume_between_points "
          "is that of its tetrahedra, "
          "volume_outside_balls what of it is at least alpha from every point")
      ->type_name("FILE");
  add_switch(
      verb, "--void-radii", arguments.void_radii,
      "With --voids as csv or json, also the radii at which each closes and is filled, and how many voids it was "
      "parted from (needs all of the triangulation)");
  verb.add_option(
          "--pockets", arguments.pockets,
          "What closes only above alpha, as csv or json: volume and radius then, and the triangle that closes it, "
          "its mouth")
      ->type_name("FILE");
  verb.add_option("--voids-above", arguments.voids_above, "Of --voids and --pockets those of more volume")
      ->type_name("VOLUME");
  verb.add_option("--top", arguments.top, "Of --voids and --pockets the K largest")->type_name("K");
  verb.add_option(
          "--complex", arguments.complex,
          "What voids are outside of: full, the full alpha complex, whose triangles without a tetrahedron stop "
          "a ball of radius alpha as well; solid, the tetrahedra alone (default full with --voids, --pockets or "
          "--box, else solid)")
      ->type_name("solid|full");
  add_switch(verb, "--balls", arguments.balls,
             "Also compute volume and area of the union of balls of radius alpha around all points");
  add_switch(verb, "--json", arguments.json,
             "Counts and sizes, of each component and each void too, as JSON on standard output");
  add_stats_option(verb, arguments.stats);
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa solid atoms.xyz --alpha 3 -o solid.vtu --boundary skin.stl\n"
      "  rbpa solid foam.ply --alpha 0.2 --voids voids.obj --json > foam.json\n"
      "  rbpa solid atoms.pdb --alpha 3.1 --voids voids.csv --void-radii --pockets pockets.csv --top 20\n"
      "  rbpa solid points.npy --alpha inf -o delaunay.npy --threads 1\n"
      "  rbpa solid frame.xyz --alpha 2.5 --box 40,40,60 --voids channels.csv\n\n"
      "Vertices of a mesh file are the input points in input order; rows of .npy are four input indices. A void is a "
      "bounded component of what is outside. A picture shows the boundary. With --box each tetrahedron is written "
      "once, where its corner of the least index is in the box; other corners may be images of points.\n" +
      std::string(exit_codes));
  return &verb;
}

}  // namespace rbpa::app
