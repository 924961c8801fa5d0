#include "io/mesh/polylines.h"

#include <nlohmann/json.hpp>

#include "io/interrupt.h"
#include "io/mesh/polygon_files.h"

namespace rbpa::app {
namespace {

void write_obj_lines(OutputFile& file, std::span<const std::array<double, 3>> positions,
                     std::span<const Polyline> loops) {
  for (const std::array<double, 3>& p : positions) write_obj_vertex(file, p);
  for (Polyline loop : loops) {
    loop.push_back(loop.front());
    file.write("l");
    write_corners(file, loop, 1);
  }
}

void write_json_lines(OutputFile& file, std::span<const std::array<double, 3>> positions,
                      std::span<const Polyline> loops) {
  using Json = nlohmann::ordered_json;
  file.write("[");
  std::string_view before = "";
  for (const Polyline& loop : loops) {
    stop_if_interrupted();
    Json points = Json::array();
    for (const std::uint32_t v : loop) points.push_back(positions[v]);
    file.write(before);
    file.write(Json{{"vertices", loop}, {"positions", points}}.dump());
    before = ",";
  }
  file.write("]\n");
}

}  // namespace

void write_polylines(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                     std::span<const Polyline> loops) {
  format == Format::obj ? write_obj_lines(file, positions, loops) : write_json_lines(file, positions, loops);
}

}  // namespace rbpa::app
