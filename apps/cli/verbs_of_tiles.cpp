// What: declares the verbs that work tile by tile, on more points than fit into memory.
#include <CLI/App.hpp>
#include <string>
#include <utility>

#include "cli/shared_options.h"
#include "cli/stream_arguments.h"
#include "cli/verbs.h"
#include "program/exit_code.h"

namespace rbpa::app {

CLI::App* add_stream(CLI::App& app, StreamArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "stream", "The same triangles and polygons of more points than fit into memory, by way of tiles on a disk");
  verb.add_option(
          "POINTS", arguments.inputs,
          "Files of points, .gz or not, and folders of such files, of which a note lists what is read and what is not")
      ->required();
  add_format_options(verb, arguments);
  verb.add_option(
          "--alpha", arguments.radius.alpha,
          "Largest circumradius, required: a finite radius in units of the points (rbpa alpha on a sample shows "
          "which to choose)")
      ->type_name("R")
      ->required();
  add_output_options(verb, arguments, stream_formats);
  verb.add_option("--memory", arguments.memory, "Memory that the run may take, such as 500M or 4G")
      ->type_name("SIZE")
      ->capture_default_str();
  verb.add_option("--scratch", arguments.scratch,
                  "Folder for tiles, new or empty; by default one beside the first OUT that goes with the run")
      ->type_name("DIR");
  add_switch(verb, "--resume", arguments.resume, "Go on with the run in --scratch where it stopped, or begin");
  verb.add_option("--tile-size", arguments.tile_size,
                  "Points of a tile, at most, from 16 on; by default as many as memory allows")
      ->type_name("S");
  add_switch(verb, "--keep-tiles", arguments.keep_tiles, "Leave the files of tiles in --scratch");
  verb.add_option(
          "--tasks", arguments.tasks,
          "Cut only, and write to this folder, new or empty, the lists of commands (rbpa tile, rbpa merge) that do "
          "the rest, on any machines that see it; --memory is for each of them")
      ->type_name("DIR");
  // Options of rbpa shape, hidden from the help: the refusal names the verb that has them.
  for (const auto& [name, value] :
       {std::pair("--min-hole-area", &arguments.min_hole_area), std::pair("--min-part-area", &arguments.min_part_area)})
    verb.add_option(name, *value)->group("");
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
  return &verb;
}

CLI::App* add_tile(CLI::App& app, TileArguments& arguments) {
  CLI::App& verb = *app.add_subcommand("tile", "A task of rbpa stream --tasks: what one tile contributes to the whole");
  verb.add_option("TILE", arguments.tile, "File of the tile, in its folder")->required();
  verb.add_option("-o,--output", arguments.outputs,
                  "File to write, by its ending: " + std::string(tile_formats) + "; may be given once of each kind")
      ->type_name("OUT")
      ->allow_extra_args(false);
  add_stats_option(verb, arguments.stats);
  add_run_options(verb, arguments.run, "Neither progress nor summary");
  verb.footer(
      "Example:\n"
      "  rbpa tile tasks/tiles/000012.tile -o 12.partial -o 12.npy\n\n"
      "What is finished is in files beside the partial, 12.polygons and 12.holes. Triangles have the indices of the "
      "whole input. A task that is run again writes the same.\n" +
      std::string(exit_codes));
  return &verb;
}

CLI::App* add_merge(CLI::App& app, MergeArguments& arguments) {
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
  add_stats_option(verb, arguments.stats);
  add_switch(verb, "-q,--quiet", arguments.quiet, "Neither progress nor summary");
  verb.footer(
      "Examples:\n"
      "  rbpa merge 0.partial 1.partial 2.partial -o half.partial\n"
      "  rbpa merge half.partial other.partial -o footprint.geojson -o triangles.npy\n\n"
      "Of all tiles it writes what rbpa shape and rbpa mesh write of all points, to the byte. The order of the "
      "partials\n"
      "changes nothing, but neighbours should be merged first: less is open between them.\n" +
      std::string(exit_codes));
  return &verb;
}

}  // namespace rbpa::app
