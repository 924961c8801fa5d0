#include "plane/picture_outputs.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

#include "io/bytes/same_file.h"
#include "picture/picture.h"

namespace rbpa::app {

void add_picture(Run& run, const Target& target, const Drawing& drawing, int width, const std::optional<Crs>& crs) {
  const Scene scene = place(drawing, width);
  run.add(target.path, [&](OutputFile& file) { write_picture(file, target.format, scene); });
  const double size = scene.pixel_size, x = scene.corner.x + size / 2, y = scene.corner.y - size / 2;
  const bool is_on_map =
      crs && !crs->is_geocentric() && size > 0 && std::isfinite(size) && std::isfinite(x) && std::isfinite(y);
  const auto world = target.format == Format::png ? world_file_of(target.path) : std::nullopt;
  if (!world) return;
  if (is_on_map)
    run.add_world_file(*world,
                       [&](OutputFile& file) { file.write_all(size, "\n0\n0\n", -size, "\n", x, "\n", y, "\n"); });
  else if (std::error_code error; std::filesystem::exists(*world, error))
    run.summarize(*world + ": this world file is of an earlier picture");
}

}  // namespace rbpa::app
