#include "stream/runs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "io/number.h"
#include "shared/verbs.h"

namespace stream_test {

using apps_test::Folder;

namespace {

std::string text_of(double alpha) { return rbpa::app::text_of(alpha); }

}  // namespace

std::string raw(std::span<const rbpa::Point> points) {
  return {reinterpret_cast<const char*>(points.data()), points.size_bytes()};
}

Made take(const Folder& folder) {
  Made made{folder.content("t.npy"), folder.content("p.geojson"), folder.content("p.wkt")};
  const std::string stats = folder.content("s.json");
  for (const char* key : {"\"polygons\": ", "\"area\": ", "\"perimeter\": "}) {
    const std::size_t at = stats.find(key);
    REQUIRE(at != std::string::npos);
    made.totals += stats.substr(at, stats.find('\n', at) + 1 - at);
  }
  for (const char* name : {"t.npy", "p.geojson", "p.wkt", "s.json"}) std::filesystem::remove(folder.path(name));
  return made;
}

Made wanted(const Folder& folder, const std::string& file, double alpha, const rbpa::app::AreaArguments& areas) {
  rbpa::app::MeshArguments mesh;
  mesh.points = folder.path(file);
  mesh.radius.alpha = text_of(alpha);
  mesh.outputs = {folder.path("t.npy")};
  mesh.run.quiet = true;
  rbpa::app::run_mesh(mesh);
  rbpa::app::ShapeArguments shape;
  shape.points = folder.path(file);
  shape.radius.alpha = text_of(alpha);
  shape.outputs = {folder.path("p.geojson"), folder.path("p.wkt")};
  static_cast<rbpa::app::AreaArguments&>(shape) = areas;
  shape.run.stats = folder.path("s.json");
  shape.run.quiet = true;
  rbpa::app::run_shape(shape);
  return take(folder);
}

Made streamed(const Folder& folder, const std::vector<std::string>& files, double alpha, const How& how) {
  const std::vector<std::string> before = folder.names();
  rbpa::app::StreamArguments stream;
  for (const std::string& file : files) stream.inputs.push_back(folder.path(file));
  stream.radius.alpha = text_of(alpha);
  stream.outputs = {folder.path("t.npy"), folder.path("p.geojson"), folder.path("p.wkt")};
  stream.memory = std::to_string(how.memory);
  if (how.tile_size > 0) stream.tile_size = std::to_string(std::max<std::uint64_t>(how.tile_size, 16));
  static_cast<rbpa::app::AreaArguments&>(stream) = how.areas;
  stream.run.stats = folder.path("s.json");
  stream.run.quiet = true;
  stream.run.threads = std::to_string(how.threads);
  rbpa::app::run_stream(stream);
  const Made made = take(folder);
  CHECK(folder.names() == before);
  return made;
}

}  // namespace stream_test
