// What: declares the options that several verbs have.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "io/formats.h"
#include "io/polygon/ogr.h"
#include "program/exit_code.h"
#include "program/options.h"
#include "shared/alpha_option.h"
#include "shared/method.h"
#include "shared/point_arguments.h"
#include "shared/run.h"

namespace rbpa::app {

template <typename Arguments>
void add_selection_options(CLI::App& verb, Arguments& arguments) {
  add_switch(verb, "--skip-invalid", arguments.skip_invalid,
             "Skip lines of text, records of LAS, and points with NaN, that are no points, and print how many");
  add_value(verb, "--where", arguments.where, "CONDITION",
            "Take only points that fulfill a condition on fields of LAS, PLY or PCD, columns of text, or properties "
            "of GeoJSON: \"classification == 6 and z > 3\", or for texts \"group in ('A', 'B')\"");
  add_value(verb, "--bounds", arguments.bounds, "X0,Y0,X1,Y1[,Z0,Z1]",
            "Take only points in this box, boundary included; of COPC only nodes that meet it are read");
  add_value(verb, "--resolution", arguments.resolution, "R",
            "Take fewer points: of COPC the levels down to the first whose spacing is at most R, of other files "
            "the first point in each cell of side R");
}

inline void add_fields_option(CLI::App& verb, std::optional<std::string>& fields,
                              const std::string& where = "at the vertices of .ply and .vtu") {
  add_value(verb, "--fields", fields, "NAMES",
            "Keep these fields of the points, or all, or none, " + where + " (default all)");
}

inline void add_waters_option(CLI::App& verb, bool& waters) {
  add_switch(verb, "--waters", waters,
             "Read the atoms of water of a molecule too (by default they are left out, except those that "
             "--where names, as resname == 'HOH')");
}

/// Adds --radii and --radius-default. `before` and `after` are parts of the help of --radii.
inline void add_ball_radii_options(CLI::App& verb, BallRadiiArguments& arguments, const std::string& before,
                                   const std::string& after) {
  add_value(verb, "--radii", arguments.radii, "bondi|protor|column:NAME|FILE",
            before +
                " radii by element of Bondi, those of ProtOr for amino acids, a column of the file, or "
                "a FILE of lines 'ELEMENT RADIUS', 'RESIDUE ATOM RADIUS' or '* ATOM RADIUS', with "
                "Bondi's for all others" +
                after);
  add_value(verb, "--radius-default", arguments.radius_default, "R",
            "Take R for atoms without a radius, which are refused otherwise");
}

inline void add_stats_option(CLI::App& verb, std::optional<std::string>& file) {
  add_value(verb, "--stats", file, "FILE", "Write counts, times in seconds and peak memory in bytes as JSON");
}

inline void add_area_options(CLI::App& verb, AreaArguments& arguments) {
  add_value(
      verb, "--min-hole-area", arguments.min_hole_area, "A",
      "Fill holes that enclose less than this area, in squared units of the points, with everything in them; inf: "
      "all holes");
  add_value(verb, "--min-part-area", arguments.min_part_area, "A",
            "Drop polygons of less than this area, in squared units of the points, after holes are filled");
}

inline void add_width_option(CLI::App& verb, std::string& width) {
  add_value(verb, "--width", width, "PIXELS", "Set the width of pictures in pixels");
}

template <typename Arguments>
void add_format_options(CLI::App& verb, Arguments& arguments) {
  add_value(verb, "--format", arguments.format, "NAME",
            "Set the format of POINTS, if its ending does not tell: " + endings(Use::points) +
                (has_gdal() ? ", or ogr for all that GDAL reads (gpkg, fgb, shp, ...)" : ""));
  const bool may_have_z = arguments.columns_may_have_z;
  add_value(verb, "--columns", arguments.columns, may_have_z ? "X,Y[,Z]" : "X,Y",
            "Read x and y, " + std::string(may_have_z ? "and heights if given, " : "") +
                "or geometries, from these columns of text: numbers from 1, or names of the header "
                "(by default those that the header names, else 1,2)");
  add_selection_options(verb, arguments);
  add_switch(verb, "--vertices", arguments.vertices, "Take the vertices of lines and polygons as points");
  add_value(verb, "--crs", arguments.crs, "CRS",
            "Set the coordinate reference system of the points, such as EPSG:28992");
  if (has_gdal())
    add_value(verb, "--layer", arguments.layer, "NAME",
              "Read this layer of a file that GDAL reads, if there are several");
  add_switch(verb, "--shift-longitude", arguments.shift_longitude,
             "Add 360 to longitudes below 0: for points on both sides of the antimeridian");
  add_value(verb, "--foreground", arguments.foreground, "NAME",
            "Take the dark or the light pixels of an image as points (by default the dark ones if most pixels "
            "of its border are light, and the reverse)");
  add_value(verb, "--threshold", arguments.threshold, "T",
            "Count a pixel as light if it has at least this share of white (default 0.5)");
  add_stats_option(verb, arguments.run.stats);
}

template <typename Arguments>
void add_point_options(CLI::App& verb, Arguments& arguments) {
  verb.add_option("POINTS", arguments.points, "File of points, .gz or not, or - for standard input")->required();
  add_format_options(verb, arguments);
}

template <typename Arguments>
void add_group_by_option(CLI::App& verb, Arguments& arguments, const std::string& what) {
  add_value(verb, "--group-by", arguments.group_by, "COLUMN",
            what +
                " for each group of points: those with the same value in a column of text, by its name, in a field of "
                "LAS, PLY "
                "or PCD, or in a property of GeoJSON; of several columns, a,b, those with the same value in each");
}

/// Adds the options about points and groups. POINTS may be several files.
template <typename Arguments>
void add_group_options(CLI::App& verb, Arguments& arguments, const std::string& what) {
  verb.add_option("POINTS", arguments.inputs,
                  "File of points, .gz or not, or - for standard input; several files if points are in groups")
      ->required()
      ->each([&arguments](const std::string& file) {
        if (arguments.points.empty()) arguments.points = file;
      });
  add_format_options(verb, arguments);
  add_group_by_option(verb, arguments, what);
  add_switch(verb, "--group-by-file", arguments.group_by_file, what + " for each file of points");
}

inline void add_method_options(CLI::App& verb, MethodArguments& arguments) {
  add_value(verb, "--method", arguments.method, "NAME",
            "Use rbpa, or hrbpa (levels of doubling radii, from the densest points up); the result is the "
            "same");
  add_value(verb, "--leaf-capacity", arguments.leaf_capacity, "K",
            "Put at most K points into a leaf of the quadtree; hrbpa takes its first radius from the "
            "smallest leaf");
}

inline void add_cover_option(CLI::App& verb, std::optional<std::string>& cover) {
  add_value(verb, "--cover", cover, "SHARE",
            "Let min and auto cover only this share of the points, such as 0.99, so that outliers do not "
            "decide; auto then leaves out small components as well (default 1)");
}

/// Adds the options about `auto` and `min` for verbs without --alpha.
template <typename Arguments>
void add_auto_options(CLI::App& verb, Arguments& arguments) {
  add_value(verb, "--components", arguments.components, "K", "Let auto have at most K solid components");
  add_cover_option(verb, arguments.cover);
}

template <typename Arguments>
void add_alpha_options(CLI::App& verb, Arguments& arguments) {
  RadiusArguments& radius = arguments.radius;
  add_value(verb, "--alpha", radius.alpha, "R|plateau[:K]|auto|min|inf",
            "Set the largest circumradius (required): a radius in units of the points, or inf; plateau: a radius "
            "around which parts and holes hardly change; plateau:K: the K-th best of these; min: the least that "
            "covers every point; auto: the least that does so in at most --components solid components (rbpa "
            "alpha lists them all)");
  add_value(verb, "--alpha-squared", radius.squared, "A",
            "Set the square of the radius instead of --alpha, as in CGAL");
  add_value(verb, "--alpha-inverse", radius.inverse, "A",
            "Set one over the radius instead of --alpha, as in Python's alphashape; 0 for inf");
  add_value(verb, "--components", radius.components, "K", "Let auto have at most K solid components (default 1)");
  add_cover_option(verb, radius.cover);
  verb.callback([&radius] {
    const int given = radius.alpha.has_value() + radius.squared.has_value() + radius.inverse.has_value();
    const auto refuse = [](const char* why) { throw CLI::RequiredError(why, CLI::ExitCodes::RequiredError); };
    if (given == 0)
      refuse("--alpha is required: a radius, plateau, auto, min or inf (rbpa alpha POINTS lists the choices)");
    if (given > 1) refuse("--alpha, --alpha-squared and --alpha-inverse cannot be combined");
  });
}

/// The text of help after the formats of verbs that draw the plane.
inline constexpr const char* with_world_file = " (.png with a world file .pgw, if coordinates have a known system)";

template <typename Arguments>
void add_output_options(CLI::App& verb, Arguments& arguments, std::string_view formats) {
  add_value(verb, "-o,--output", arguments.outputs, "OUT",
            "Write this file, in the format of its ending: " + std::string(formats) +
                "; - is standard output; may be given several times")
      ->allow_extra_args(false);
  add_value(verb, "--output-format", arguments.output_format, "NAME",
            "Set the format of each OUT whose ending does not tell");
}

/// Returns the endings of a table to write, for help.
inline std::string table_endings(Use use) { return endings(use) + "; - is csv on standard output"; }

/// Help of --quiet in verbs that print a summary.
inline constexpr const char* quiet_about_summary = "Print no progress, no warnings about the input, and no summary";

inline void add_run_options(CLI::App& verb, RunArguments& arguments, const std::string& quiet = quiet_about_summary) {
  add_value(verb, "--threads", arguments.threads, "N",
            "Use at most N threads (by default one for each processor); the result is the same");
  add_switch(verb, "-q,--quiet", arguments.quiet, quiet);
}

/// Ends the help of the verb with a text, examples for the most part, and the exit codes. Returns the verb.
inline CLI::App* with_footer(CLI::App& verb, const std::string& text) {
  return verb.footer(text + std::string(exit_codes));
}

}  // namespace rbpa::app
