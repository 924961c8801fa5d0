// What: declares the verbs for points in space.
#include <CLI/App.hpp>
#include <string>

#include "rbpa/verb_options.h"
#include "shared/verbs.h"

namespace rbpa::app {

namespace {

void add_space_point_options(CLI::App& verb, SpacePointArguments& arguments) {
  verb.add_option("POINTS", arguments.points, "File of points in space, .gz or not, or - for standard input")
      ->required();
  add_value(verb, "--format", arguments.format, "NAME",
            "Set the format of POINTS, if its ending does not tell: " + endings(Use::space));
  add_value(verb, "--columns", arguments.columns, "X,Y,Z[,NX,NY,NZ]",
            "Read x, y, z, and the normal if given, from these columns of text: numbers from 1, or names of "
            "the header; colors are in the columns that the header calls red, green and blue, or r, g and b");
  add_selection_options(verb, arguments);
  add_waters_option(verb, arguments.waters);
}

}  // namespace

CLI::App* add_surface(CLI::App& app, SurfaceArguments& arguments) {
  CLI::App& verb =
      *app.add_subcommand("surface", "Make triangles through points in space, by a ball of a given radius");
  add_space_point_options(verb, arguments);
  add_value(verb, "--radius", arguments.radius, "R[,R2,...]|auto",
            "Set the radius of the ball (required: auto, or a radius, about 1 to 4 times the distance between "
            "neighbors); with several in ascending order, each closes gaps that the smaller ones leave; auto: choose "
            "them by the gaps between the points")
      ->required();
  add_value(verb, "--max-radius", arguments.max_radius, "R",
            "Replace radii of --radius auto above R, in units of the points, by R (by default there is no limit)");
  add_value(verb, "--normals", arguments.normals, "NAME",
            "Take normals from the file, estimate them, or use none and make triangles on both sides of "
            "everything that the ball can touch (default: file if it has normals, else estimate)");
  add_value(verb, "--neighbors", arguments.neighbors, "K",
            "Estimate normals from planes through each point and its K nearest others (default 16)");
  add_value(verb, "--viewpoint", arguments.viewpoint, "X,Y,Z",
            "Turn normals, also those of the file, toward the place from which the points were seen; three "
            "columns: toward a place of its own for each point");
  add_switch(verb, "--flip", arguments.flip, "Turn all normals around, after everything else");
  add_value(verb, "--color", arguments.color, "NAME",
            "Color files and pictures by points, the colors of the file (default), or by normals, the "
            "confidence of each estimated normal: blue, or orange if it is in doubt");
  add_value(verb, "--drop-outliers", arguments.drop_outliers, "K|auto",
            "Leave out points whose distance to their 8th nearest point is more than K times the median of these "
            "distances (auto: 4 times); do not use it for scans whose density differs by more than that");
  add_value(verb, "--scale-space", arguments.scale_space, "N|auto",
            "Reduce noise: roll the ball over points moved onto local planes in N steps, or until they lie "
            "still (auto); files have the original points");
  add_switch(verb, "--moved", arguments.moved, "Write the points as moved by --scale-space");
  add_output_options(verb, arguments, endings(Use::surface));
  add_fields_option(verb, arguments.fields);
  add_switch(verb, "--compact", arguments.compact,
             "Leave out vertices that no triangle uses (.npy keeps input indices)");
  add_switch(verb, "--manifold", arguments.manifold,
             "Write a vertex for each sheet where sheets of the surface touch, so that all edges have one or "
             "two triangles; .ply has the input index of each vertex as 'point'. Leave out unused vertices "
             "too (.npy keeps input indices)");
  add_value(verb, "--keep-largest", arguments.keep_largest, "K", "Keep only the K components of the largest area");
  add_value(verb, "--drop-small", arguments.drop_small, "N|area=A",
            "Drop components of fewer than N triangles, or of an area below A, in squared units of the points");
  add_value(verb, "--shell", arguments.shell, "all|outer|largest",
            "Keep, with --normals none, all shells (default); outer: those that the ball touches from outside; "
            "largest: the outer shell with the largest area");
  add_value(verb, "--fill-holes", arguments.fill_holes, "all|rims|N|length=L",
            "Fill holes by triangles between their points that intersect nothing: all holes; rims: the rims of "
            "sheets as well; N: holes of at most N edges; length=L: holes at most that long");
  add_switch(verb, "--watertight", arguments.watertight,
             "Drop open islands, fill holes and rims, and write a closed --manifold surface without "
             "crossings, also after the rounding of .stl and .glb; if that is not possible, write nothing, "
             "print what stays open, and exit with 1");
  add_value(
      verb, "--shift", arguments.shift, "X,Y,Z|auto",
      "Subtract X,Y,Z, or with auto the center of the vertices' box, from all coordinates of .stl and .glb, which "
      "are in single precision. Print the shift, and write it into the header of .stl; the node of .glb "
      "moves the mesh back to its place");
  add_switch(verb, "--refine", arguments.refine,
             "Add points inside the fillings of --fill-holes or --watertight, so that they are as fine and "
             "smooth as the surface around them");
  add_value(verb, "--faces", arguments.faces, "N|P%|error=E",
            "Decimate the surface, after everything else, until N triangles are left, or P percent, between "
            "points of the input; error=E: as long as no point of it is farther than E from the surface before, "
            "which is certified. What is closed stays closed, and the topology the same; with --watertight no "
            "triangles begin to cross. Leave out unused vertices (.npy keeps input indices). Boundary curves "
            "are reported, and written by --holes, as they were before");
  add_switch(verb, "--no-crossings", arguments.no_crossings,
             "With --faces, collapse no edge by which triangles would cross or touch that did not before; --watertight "
             "implies it");
  add_value(verb, "--holes", arguments.holes, "FILE",
            "Write the boundary curves as polylines, .obj, in groups 'rim', 'hole' and 'island'");
  add_switch(verb, "--suggest-repairs", arguments.repairs,
             "Try repairs for each hole, and list what closes it in the summary, --json and --stats: one more radius, "
             "normals to turn around, or a filling");
  add_switch(verb, "--json", arguments.json, "Print everything as JSON, with each hole and its causes");
  add_stats_option(verb, arguments.run.stats);
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa surface scan.ply --radius 0.01 -o mesh.ply -o picture.png\n"
      "  rbpa surface scan.xyz --radius auto -o mesh.obj --holes holes.obj\n"
      "  rbpa surface scan.ply --radius auto --drop-small 100 --manifold -o mesh.ply\n"
      "  rbpa surface body.xyz --radius 2 --normals none --shell outer -o closed.stl\n"
      "  rbpa surface scan.ply --radius auto --keep-largest 1 --watertight -o print.stl\n"
      "  rbpa surface scan.ply --radius auto --keep-largest 1 --watertight --refine -o print.stl\n"
      "  rbpa surface scan.ply --radius auto --keep-largest 1 --watertight --faces 10000 -o small.stl\n"
      "  rbpa surface scan.ply --radius 0.01 --suggest-repairs -o mesh.ply\n"
      "  rbpa surface noisy.ply --scale-space auto --moved --radius auto -o smooth.ply\n"
      "  rbpa surface scan.xyz --radius 2,5 --normals estimate --json > holes.json\n\n"
      "Vertices of a mesh file are the input points in input order. The summary says why the surface ends at a hole, "
      "and why points are unused.\n");
}

CLI::App* add_solid(CLI::App& app, SolidArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "solid", "Make tetrahedra of points in space: the solid alpha complex, with its boundary and voids");
  add_space_point_options(verb, arguments);
  add_value(verb, "--alpha", arguments.alpha, "R|inf|auto|min|plateau",
            "Set the largest circumradius (required: a radius in units of the points, inf, min, auto or "
            "plateau); inf: the Delaunay "
            "triangulation; min: the least that covers every point; auto: the least that has every point in "
            "one solid component; plateau, plateau:K: one around which parts and voids hardly change")
      ->required();
  add_value(verb, "--cover", arguments.cover, "SHARE",
            "Let auto and min cover only this share of the points, such as 0.99, so that single points do "
            "not decide");
  add_value(verb, "--box", arguments.box, "LX,LY,LZ|auto",
            "Take the points as those of a periodic box with these sides; coordinates count modulo the "
            "sides. Voids have a dimension: the number of directions in which they percolate, 0 if they are "
            "closed. auto: the cell of a molecule's file");
  add_output_options(verb, arguments, endings(Use::solid));
  add_fields_option(verb, arguments.fields);
  add_value(verb, "--boundary", arguments.boundary, "FILE",
            "Write the boundary as a closed surface, with a vertex for each side where the solid touches "
            "itself: " +
                endings(Use::boundary) +
                ". ply has the input index of each vertex as 'point'; npy has the input indices of the "
                "triangles");
  add_value(
      verb, "--shift", arguments.shift, "X,Y,Z|auto",
      "Subtract X,Y,Z, or with auto the center of the vertices' box, from all coordinates of a boundary as .stl or "
      ".glb, which are in single precision. Print the shift, and write it into the header of .stl; the "
      "node of .glb moves the mesh back to its place");
  add_value(verb, "--voids", arguments.voids, "FILE",
            "Write each void, the largest first: " + table_endings(Use::voids) +
                ". obj has a closed surface in a group of its own for each void; json has the input indices of "
                "its points and triangles, and the names of atoms in a molecule's file. "
                "volume_between_points is the volume of its tetrahedra, volume_outside_balls the part at least "
                "alpha from every point");
  add_switch(verb, "--void-radii", arguments.void_radii,
             "Add to --voids, as csv or json, the radii at which each void closes and is filled, and how many "
             "larger voids it was split from (needs the whole triangulation)");
  add_value(verb, "--pockets", arguments.pockets, "FILE",
            "Write the pockets, which close only above alpha, as csv or json: volume and radius when they "
            "close, and the triangle that closes them, their mouth");
  add_value(verb, "--voids-above", arguments.voids_above, "VOLUME",
            "Write only voids and pockets of a volume above this, in cubed units of the points (default 0)");
  add_value(verb, "--top", arguments.top, "K",
            "Write only the K largest voids and the K largest pockets (by default all)");
  add_value(verb, "--complex", arguments.complex, "solid|full",
            "Bound voids by full, the full alpha complex, whose triangles without a tetrahedron stop a ball "
            "of radius alpha as well, or by solid, the tetrahedra alone (default full with --voids, "
            "--pockets or --box, else solid)");
  add_switch(verb, "--balls", arguments.balls,
             "Also compute volume and area of the union of balls of radius alpha around all points");
  add_switch(verb, "--json", arguments.json, "Print counts and sizes as JSON, also of each component and each void");
  add_stats_option(verb, arguments.run.stats);
  add_width_option(verb, arguments.width);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa solid atoms.xyz --alpha 3 -o solid.vtu --boundary skin.stl\n"
      "  rbpa solid foam.ply --alpha 0.2 --voids voids.obj --json > foam.json\n"
      "  rbpa solid atoms.pdb --alpha 3.1 --voids voids.csv --void-radii --pockets pockets.csv --top 20\n"
      "  rbpa solid points.npy --alpha inf -o delaunay.npy --threads 1\n"
      "  rbpa solid frame.xyz --alpha 2.5 --box 40,40,60 --voids channels.csv\n\n"
      "Vertices of a mesh file are the input points in input order; rows of .npy are four input indices. A void is a "
      "bounded component of the outside. A picture shows the boundary. With --box each tetrahedron is written once, "
      "with its corner of the least index in the box; other corners may be periodic images of points.\n");
}

CLI::App* add_balls(CLI::App& app, BallsArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "balls", "Measure the union of balls around atoms: areas and volumes, of each atom too, and contacts");
  verb.add_option("ATOMS", arguments.atoms,
                  "File of a molecule or of points in space, .gz or not, or - for standard input")
      ->required();
  add_value(verb, "--format", arguments.format, "NAME",
            "Set the format of ATOMS, if its ending does not tell: " + endings(Use::space));
  add_value(verb, "--probe", arguments.probe, "R",
            "Add R to each radius: 1.4 for water, if lengths are in angstroms; areas are then accessible to the "
            "center of the probe");
  add_ball_radii_options(verb, arguments, "Take", " (default: those of the file, if it has some, else bondi)");
  add_value(verb, "--models", arguments.models, "all|1,3,10-20|FIRST:LAST:STEP",
            "Measure these models, or frames, of the file: numbers from 1 (default 1); 1:1000:10 and, to the end of "
            "the file, 1::10 are every tenth. Rows have their frame if "
            "there may be several");
  add_value(verb, "--box", arguments.box, "LX,LY,LZ|A,B,C,ALPHA,BETA,GAMMA|auto",
            "Measure the balls of a box that repeats with all their images, per box: its sides, one length for "
            "all, or lengths and angles of a cell, the angles in degrees; auto: the cell of each frame in the "
            "file");
  add_value(verb, "--where", arguments.where, "CONDITION",
            "Take only atoms that fulfill a condition on their columns: \"chain == 'A' and resseq < 100\"");
  add_waters_option(verb, arguments.waters);
  add_switch(verb, "--no-ligands", arguments.no_ligands, "Leave out records HETATM other than water");
  add_switch(verb, "--no-hydrogens", arguments.no_hydrogens, "Leave out hydrogen and its isotopes");
  add_switch(verb, "--alternates", arguments.alternates,
             "Keep all alternate locations (by default the one of the highest occupancy in each residue)");
  add_output_options(verb, arguments, endings(Use::rows));
  add_value(verb, "--contacts", arguments.contacts, "FILE",
            "Write the contacts of balls, a row for each pair: area of the disc that both share, length of its "
            "arcs on the surface (0 if there are none), distance of the centers: " +
                table_endings(Use::rows));
  add_value(verb, "--interfaces", arguments.interfaces, "FILE",
            "Write a row for each two groups of --group that meet: the area of the surface of each, alone, that "
            "the other one covers, and the area of the contacts between them: " +
                table_endings(Use::rows));
  add_value(
      verb, "--voids", arguments.voids, "FILE",
      "Write the voids that the balls with the probe enclose, the largest first: volume of their tetrahedra "
      "and outside of the balls, area, center and radius of the largest ball that fits in, input indices of "
      "the atoms around; with --box, csv and json have the number of directions in which each percolates; obj has "
      "the surface of the tetrahedra, pml and cxc are scripts for PyMOL and ChimeraX: " +
          table_endings(Use::lined));
  add_value(verb, "--pockets", arguments.pockets, "FILE",
            "Write the pockets in the same way, with the number of their mouths, the area of these, and the radius "
            "of the largest ball that fits into one; not with --box, which has no outside to open to: " +
                table_endings(Use::lined));
  add_switch(
      verb, "--pores", arguments.pores,
      "Add to summary and JSON the radii of the largest ball that fits in between the balls without the probe, of "
      "the largest that passes through a box that repeats, of the largest on its way, and of the largest that "
      "passes along each edge (requires --box)");
  add_value(verb, "--group", arguments.group, "residue|chain|column:NAME",
            "Sum up the rows of each residue, of each chain, or of each value in a column; contacts are then "
            "those between different groups");
  add_switch(verb, "--json", arguments.json, "Print the radii that were used, counts and sizes as JSON");
  add_stats_option(verb, arguments.run.stats);
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa balls protein.pdb --probe 1.4 -o atoms.csv\n"
      "  rbpa balls complex.cif --probe 1.4 --group chain -o chains.csv --interfaces interfaces.csv\n"
      "  rbpa balls frames.pdb --probe 1.4 --models all --group residue -o residues.csv\n"
      "  rbpa balls packing.csv --radii column:radius --json\n\n"
      "OUT has a row for each atom: the names that the file gives it, radius (without the probe), area of its sphere "
      "on the surface of the union, volume of its part of the union, and whether it is buried, without any area. "
      "Areas and volumes are those of the balls with the probe, in units of the file; the summary has those without "
      "it (van der Waals), too. Molecular (Connolly) volumes and areas are not computed.\n");
}

}  // namespace rbpa::app
