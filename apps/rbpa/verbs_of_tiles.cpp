// What: declares the verb `stream`, which works tile by tile on more points than fit into memory.
#include <CLI/App.hpp>
#include <string>

#include "io/cloud/cloud.h"
#include "rbpa/verb_options.h"
#include "shared/verbs.h"
#include "tiles/stream_arguments.h"

namespace rbpa::app {

CLI::App* add_stream(CLI::App& app, StreamArguments& arguments) {
  CLI::App& verb = *app.add_subcommand(
      "stream",
      "Make the same triangles and polygons of more points than fit into memory, through tiles on a "
      "disk");
  verb.add_option("POINTS", arguments.inputs,
                  "Files of points, .gz or not, and folders of such files; print which files of a folder are read, and "
                  "which are left out")
      ->required();
  add_format_options(verb, arguments);
  verb.get_option("--resolution")->group("");  // hidden, as parsing refuses it with the reason
  add_value(verb, "--alpha", arguments.radius.alpha, "R",
            "Set the largest circumradius (required: a finite radius in units of the points; rbpa alpha on a "
            "sample shows which to choose)")
      ->required();
  add_output_options(verb, arguments, stream_formats());
  add_group_by_option(verb, arguments, "Make a shape");
  add_area_options(verb, arguments);
  add_value(verb, "--memory", arguments.memory, "SIZE",
            "Limit the memory of the run: a size such as 500M or 4G, at least 64M");
  add_value(verb, "--scratch", arguments.scratch, "DIR",
            "Keep tiles in this folder, new or empty (by default in one next to the first OUT, removed at the "
            "end)");
  add_switch(verb, "--resume", arguments.resume, "Continue the run in --scratch where it stopped, or begin one");
  add_value(verb, "--tile-size", arguments.tile_size, "S",
            "Limit tiles to S points, at least 16 (by default as many as memory allows)");
  add_switch(verb, "--keep-tiles", arguments.keep_tiles,
             "Keep the files of tiles in --scratch (by default they are removed at the end)");
  add_run_options(verb, arguments.run);
  return with_footer(
      verb,
      "Examples:\n"
      "  rbpa stream lidar/*.las --alpha 2 --memory 1G --scratch /data/scratch -o footprint.geojson\n"
      "  rbpa stream lidar/ --alpha 2 -o footprint.wkt -o triangles.npy -o 'tiles/*.ply'\n"
      "  rbpa stream lidar/*.las --alpha 2 --scratch /data/scratch -o footprint.geojson --resume\n\n"
      "The files have the same bytes as those of rbpa shape and rbpa mesh for all points in one file. Files are read "
      "twice, and the scratch takes about as much room as LAS files do. Some megabytes of " +
          streamed_formats() + " are in memory at a time; files in other formats are read as a whole.\n");
}

}  // namespace rbpa::app
