// What: declares the verbs of `rbpa`: for each verb the arguments as text, the declaration, and the run.
// Law:  a run checks its command line, and throws WrongUsage, before it reads anything, except what only the input
//       decides: the format of standard input, equal columns of a table, the number of plateaus. A run also throws
//       BadInput, Failure, ClosedPipe (io/failure.h) and Cancelled (rbpa/base/error.h). It leaves no output file behind
//       when it throws.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shared/complex_run.h"

namespace CLI {
class App;
}

namespace rbpa::app {

/// The options about segments that become edges, as text.
struct SegmentArguments {
  std::optional<std::string> segments;  ///< path of a file with lines
  bool split_crossings = false;
};

/// The arguments of `rbpa mesh`, which makes files of triangles and pictures from a file of points.
struct MeshArguments : ComplexArguments, SegmentArguments {
  std::string complex = "solid";
  std::optional<std::string> levels, fields;
  bool compact = false, inside = false;
};
void run_mesh(const MeshArguments& arguments);
/// Runs `rbpa mesh` for each group of the points. Requires: arguments.has_groups().
void run_group_meshes(const MeshArguments& arguments);

/// The arguments of `rbpa shape`, which makes files of polygons and pictures from a file of points.
struct ShapeArguments : ComplexArguments, AreaArguments {
  std::optional<std::string> isolated;  ///< path of a file for the points in no polygon
  std::optional<std::string> fields, summarize;
};
void run_shape(const ShapeArguments& arguments);
/// Runs `rbpa shape` for each group of the points. Requires: arguments.has_groups().
void run_group_shapes(const ShapeArguments& arguments);

/// The arguments of `rbpa discs`, which measures the union of discs around points.
struct DiscsArguments : PointArguments, OutputArguments {
  std::string radius, corners = "64";
};
void run_discs(const DiscsArguments& arguments);

/// The arguments of `rbpa voronoi`, which makes the cells of points as polygons.
struct VoronoiArguments : PointArguments, OutputArguments {
  std::string clip = "box";
  std::optional<std::string> alpha, fields;
};
void run_voronoi(const VoronoiArguments& arguments);

/// The arguments of `rbpa grid`, which interpolates heights: rasters and contour lines.
struct GridArguments : PointArguments, OutputArguments, SegmentArguments {
  std::optional<std::string> cell, contours, extent;
  std::string method = "linear", alpha = "inf", value = "z";
};
void run_grid(const GridArguments& arguments);

/// The arguments of verbs that compute all radii.
struct RadiiArguments : PointArguments {
  std::string components = "1";      ///< the most solid components at the radius `auto`
  std::optional<std::string> cover;  ///< share of the points that `auto` and `min` cover
  RunArguments run;
};

/// The options about representatives of persistence pairs.
struct RepresentativeArguments {
  std::optional<std::string> representatives;  ///< path of the file to write
  std::optional<std::string> min_persistence, top;
  std::optional<std::string> levels;  ///< radii with commas between them, or hrbpa or hrbpa:K
};

/// The arguments of `rbpa alpha`, which prints the critical radii of points, and recommends one.
struct AlphaArguments : RadiiArguments, GroupArguments, RepresentativeArguments, BallRadiiArguments {
  std::optional<std::string> picture;  ///< path of an .svg file to write
  bool json = false;
  bool csv = false;
  bool persistence = false;
  std::optional<std::string>
      complex;  ///< kind of the complex whose persistence is computed: solid (the default) or full
  std::string dimension = "2";
};
void run_alpha(const AlphaArguments& arguments);
/// Prints the radii to choose from for each group of the points. Requires: arguments.has_groups().
void run_group_alpha(const AlphaArguments& arguments);

/// The arguments of `rbpa report`, which writes a page that shows the complex at every radius.
struct ReportArguments : RadiiArguments {
  std::string output;  ///< path of an .html file to write, or "-"
  std::string dimension = "2";
};
void run_report(const ReportArguments& arguments);

/// The arguments of `rbpa info`, which prints facts about a file of points.
struct InfoArguments : PointArguments, GroupArguments {
  bool json = false;
  RunArguments run;
};
void run_info(const InfoArguments& arguments);

/// The arguments of `rbpa fill`, which makes files of triangles and pictures from a file of polygons.
struct FillArguments : OutputArguments {
  std::string polygons;  ///< path of the file of polygons
  std::optional<std::string> format;
  std::string size;
  std::optional<std::string> size_at;
  std::optional<std::string> grade;
  bool keep_boundary = false;
  bool skip_invalid = false;
};
void run_fill(const FillArguments& arguments);

/// The arguments of `rbpa surface`, which makes files of triangles and pictures from a file of points in space.
struct SurfaceArguments : SpacePointArguments, OutputArguments {
  std::string radius;
  std::optional<std::string> max_radius, normals, neighbors, viewpoint, color, drop_outliers, scale_space, holes,
      fields, shell, keep_largest, drop_small, fill_holes, faces, shift;
  bool flip = false, moved = false, refine = false, no_crossings = false, repairs = false, compact = false,
       manifold = false, watertight = false, json = false;
};
void run_surface(const SurfaceArguments& arguments);

/// The arguments of `rbpa solid`, which makes tetrahedra from a file of points in space.
struct SolidArguments : SpacePointArguments, OutputArguments {
  std::string alpha;
  std::optional<std::string> cover;  ///< share of the points that `auto` and `min` cover
  std::optional<std::string> box, boundary, shift, voids, complex, fields;
  std::optional<std::string> pockets, voids_above, top;
  bool void_radii = false, balls = false, json = false;
};
void run_solid(const SolidArguments& arguments);

/// The arguments of `rbpa balls`, which measures the union of balls around atoms.
struct BallsArguments : OutputArguments, BallRadiiArguments {
  std::string atoms;  ///< path of the file; "-" means standard input
  std::optional<std::string> format, where, models, box, contacts, interfaces, voids, pockets, group;
  std::string probe = "0";
  bool waters = false, no_ligands = false, no_hydrogens = false, alternates = false, pores = false, json = false;
};
void run_balls(const BallsArguments& arguments);

/// The arguments of `rbpa stream`, which makes triangles and polygons of more points than fit into memory.
struct StreamArguments : PointArguments, OutputArguments, AreaArguments {
  std::vector<std::string> inputs;  ///< files, and folders of files; parsing sets `points` to one file after another
  std::optional<std::string> group_by;  ///< as GroupArguments::group_by
  RadiusArguments radius;
  std::string memory = "1G";
  std::optional<std::string> tile_size;
  std::optional<std::string> scratch;
  bool keep_tiles = false;
  bool resume = false;
};
void run_stream(const StreamArguments& arguments);

/// Add a verb with its options, help and examples to `app`, and return the verb. The verb keeps a reference to
/// `arguments`; parsing the command line sets them.
CLI::App* add_mesh(CLI::App& app, MeshArguments& arguments);
CLI::App* add_alpha(CLI::App& app, AlphaArguments& arguments);
CLI::App* add_shape(CLI::App& app, ShapeArguments& arguments);
CLI::App* add_discs(CLI::App& app, DiscsArguments& arguments);
CLI::App* add_voronoi(CLI::App& app, VoronoiArguments& arguments);
CLI::App* add_grid(CLI::App& app, GridArguments& arguments);
CLI::App* add_fill(CLI::App& app, FillArguments& arguments);
CLI::App* add_surface(CLI::App& app, SurfaceArguments& arguments);
CLI::App* add_solid(CLI::App& app, SolidArguments& arguments);
CLI::App* add_balls(CLI::App& app, BallsArguments& arguments);
CLI::App* add_stream(CLI::App& app, StreamArguments& arguments);
CLI::App* add_info(CLI::App& app, InfoArguments& arguments);
CLI::App* add_report(CLI::App& app, ReportArguments& arguments);

}  // namespace rbpa::app
