#include "plane/picture_outputs.h"

#include <cmath>
#include <string>
#include <string_view>

#include "io/words.h"
#include "picture/picture.h"

namespace rbpa::app {

void add_picture(Run& run, const Target& target, const Drawing& drawing, int width, const std::optional<Crs>& crs) {
  const Scene scene = place(drawing, width);
  run.add(target.path, [&](OutputFile& file) { write_picture(file, target.format, scene); });
  const double size = scene.pixel_size, x = scene.corner.x + size / 2, y = scene.corner.y - size / 2;
  const bool is_on_map = crs && size > 0 && std::isfinite(size) && std::isfinite(x) && std::isfinite(y);
  if (!is_on_map || target.format != Format::png || !same_letters(ending(target.path), "png")) return;
  std::string path = target.path;
  path.replace(path.size() - 2, 2, path.ends_with('G') ? "GW" : "gw");
  run.add(path, [&](OutputFile& file) { file.write_all(size, "\n0\n0\n", -size, "\n", x, "\n", y, "\n"); });
}

}  // namespace rbpa::app
