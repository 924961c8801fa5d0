// What: declares the options that several verbs have. Help, manual page and completions are made from the declarations.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "io/formats.h"
#include "io/polygon/ogr.h"
#include "shared/alpha_option.h"
#include "shared/method.h"
#include "shared/point_arguments.h"
#include "shared/run.h"

namespace rbpa::app {

/// Adds an option without a value. A value, as in --quiet=7, is refused.
inline CLI::Option* add_switch(CLI::App& verb, const std::string& names, bool& flag, const std::string& what) {
  return verb.add_flag(names, flag, what)->disable_flag_override();
}

template <typename Arguments>
void add_selection_options(CLI::App& verb, Arguments& arguments) {
  add_switch(verb, "--skip-invalid", arguments.skip_invalid,
             "Skip lines of text, and records of LAS, that are not points, and print how many");
  verb.add_option(
          "--where", arguments.where,
          "Take only points that fulfill a condition on fields of LAS, PLY or PCD, columns of text, or properties "
          "of GeoJSON: \"classification == 6 and z > 3\", or for texts \"group in ('A', 'B')\"")
      ->type_name("CONDITION");
  verb.add_option("--bounds", arguments.bounds,
                  "Take only points in this box, boundary included; of COPC only nodes that meet it are read")
      ->type_name("X0,Y0,X1,Y1[,Z0,Z1]");
  verb.add_option("--resolution", arguments.resolution,
                  "Take fewer points: of COPC the levels down to the first whose spacing is at most R, of other files "
                  "the first point in each cell of side R")
      ->type_name("R");
}

inline void add_fields_option(CLI::App& verb, std::optional<std::string>& fields,
                              const std::string& where = "at the vertices of .ply and .vtu") {
  verb.add_option("--fields", fields, "Keep these fields of the points, or all, or none, " + where + " (default all)")
      ->type_name("NAMES");
}

inline void add_waters_option(CLI::App& verb, bool& waters) {
  add_switch(verb, "--waters", waters,
             "Read the atoms of water of a molecule too (by default they are left out, unless --where uses "
             "resname)");
}

/// Adds --radii and --radius-default. `before` and `after` are parts of the help of --radii.
inline void add_ball_radii_options(CLI::App& verb, BallRadiiArguments& arguments, const std::string& before,
                                   const std::string& after) {
  verb.add_option("--radii", arguments.radii,
                  before +
                      " radii by element of Bondi, those of ProtOr for amino acids, a column of the file, or "
                      "a FILE of lines 'ELEMENT RADIUS', 'RESIDUE ATOM RADIUS' or '* ATOM RADIUS', with "
                      "Bondi's for all others" +
                      after)
      ->type_name("bondi|protor|column:NAME|FILE");
  verb.add_option("--radius-default", arguments.radius_default,
                  "Take R for atoms without a radius, which are refused otherwise")
      ->type_name("R");
}

inline void add_stats_option(CLI::App& verb, std::optional<std::string>& file) {
  verb.add_option("--stats", file, "Write counts, times in seconds and peak memory in bytes as JSON")
      ->type_name("FILE");
}

inline void add_area_options(CLI::App& verb, AreaArguments& arguments) {
  verb.add_option(
          "--min-hole-area", arguments.min_hole_area,
          "Fill holes that enclose less than this area, in squared units of the points, with everything in them; inf: "
          "all holes")
      ->type_name("A")
      ->capture_default_str();
  verb.add_option("--min-part-area", arguments.min_part_area,
                  "Drop polygons of less than this area, in squared units of the points, after holes are filled")
      ->type_name("A")
      ->capture_default_str();
}

inline void add_width_option(CLI::App& verb, std::string& width) {
  verb.add_option("--width", width, "Set the width of pictures in pixels")->type_name("PIXELS")->capture_default_str();
}

template <typename Arguments>
void add_format_options(CLI::App& verb, Arguments& arguments) {
  verb.add_option("--format", arguments.format,
                  "Set the format of POINTS, if its ending does not tell: " + endings(Use::points) +
                      (has_gdal() ? ", or ogr for all that GDAL reads (gpkg, fgb, shp, ...)" : ""))
      ->type_name("NAME");
  verb.add_option("--columns", arguments.columns,
                  "Read x and y, or geometries, from these columns of text: numbers from 1, or names of the header "
                  "(by default those that the header names, else 1,2)")
      ->type_name("X,Y");
  add_selection_options(verb, arguments);
  add_switch(verb, "--vertices", arguments.vertices, "Take the vertices of lines and polygons as points");
  verb.add_option("--crs", arguments.crs, "Set the coordinate reference system of the points, such as EPSG:28992")
      ->type_name("CRS");
  if (has_gdal())
    verb.add_option("--layer", arguments.layer, "Read this layer of a file that GDAL reads, if there are several")
        ->type_name("NAME");
  add_switch(verb, "--shift-longitude", arguments.shift_longitude,
             "Add 360 to longitudes below 0: for points on both sides of the antimeridian");
  verb.add_option("--foreground", arguments.pixels.foreground,
                  "Take the dark or the light pixels of an image as points (by default the dark ones if most pixels "
                  "of its border are light, and the reverse)")
      ->type_name("NAME");
  verb.add_option("--threshold", arguments.pixels.threshold,
                  "Count a pixel as light if it has at least this share of white (default 0.5)")
      ->type_name("T");
  add_stats_option(verb, arguments.stats);
}

template <typename Arguments>
void add_point_options(CLI::App& verb, Arguments& arguments) {
  verb.add_option("POINTS", arguments.points, "File of points, .gz or not, or - for standard input")->required();
  add_format_options(verb, arguments);
}

template <typename Arguments>
void add_group_by_option(CLI::App& verb, Arguments& arguments, const std::string& what) {
  verb.add_option(
          "--group-by", arguments.group_by,
          what +
              " for each group of points: those with the same value in a column of text, in a field of LAS, PLY "
              "or PCD, or in a property of GeoJSON; of several columns, a,b, those with the same value in each")
      ->type_name("COLUMN");
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
  verb.add_option("--method", arguments.method,
                  "Use rbpa, or hrbpa (levels of doubling radii, from the densest points up); the result is the "
                  "same")
      ->type_name("NAME")
      ->capture_default_str();
  verb.add_option("--leaf-capacity", arguments.leaf_capacity,
                  "Put at most K points into a leaf of the quadtree; hrbpa takes its first radius from the "
                  "smallest leaf")
      ->type_name("K");
}

inline void add_cover_option(CLI::App& verb, std::optional<std::string>& cover) {
  verb.add_option("--cover", cover,
                  "Let min and auto cover only this share of the points, such as 0.99, so that outliers do not "
                  "decide; auto then leaves out small components as well (default 1)")
      ->type_name("SHARE");
}

/// Adds the options about `auto` and `min` for verbs without --alpha.
template <typename Arguments>
void add_auto_options(CLI::App& verb, Arguments& arguments) {
  verb.add_option("--components", arguments.components, "Let auto have at most K solid components")
      ->type_name("K")
      ->capture_default_str();
  add_cover_option(verb, arguments.cover);
}

template <typename Arguments>
void add_alpha_options(CLI::App& verb, Arguments& arguments) {
  RadiusArguments& radius = arguments.radius;
  verb.add_option("--alpha", radius.alpha,
                  "Set the largest circumradius (required): a radius in units of the points, or inf; plateau: a radius "
                  "around which parts and holes hardly change; plateau:K: the K-th best of these; min: the least that "
                  "covers every point; auto: the least that does so in at most --components solid components (rbpa "
                  "alpha lists them all)")
      ->type_name("R|plateau[:K]|auto|min|inf");
  verb.add_option("--alpha-squared", radius.squared, "Set the square of the radius instead of --alpha, as in CGAL")
      ->type_name("A");
  verb.add_option("--alpha-inverse", radius.inverse,
                  "Set one over the radius instead of --alpha, as in Python's alphashape; 0 for inf")
      ->type_name("A");
  verb.add_option("--components", radius.components, "Let auto have at most K solid components (default 1)")
      ->type_name("K");
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
  verb.add_option("-o,--output", arguments.outputs,
                  "Write this file, in the format of its ending: " + std::string(formats) +
                      "; - is standard output; may be given several times")
      ->type_name("OUT")
      ->allow_extra_args(false);
  verb.add_option("--output-format", arguments.output_format, "Set the format of each OUT whose ending does not tell")
      ->type_name("NAME");
}

inline void add_run_options(CLI::App& verb, RunArguments& arguments, const std::string& quiet) {
  verb.add_option("--threads", arguments.threads,
                  "Use at most N threads (by default one for each processor); the result is the same")
      ->type_name("N");
  add_switch(verb, "-q,--quiet", arguments.quiet, quiet);
}

}  // namespace rbpa::app
