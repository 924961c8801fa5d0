#include "shared/stats.h"

#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/bytes/write_json.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Returns the peak memory of this process, in bytes.
std::size_t peak_bytes() {
  // Read VmHWM, which exec() resets: the value of getrusage() includes the process that started the program.
  std::ifstream status("/proc/self/status");
  constexpr std::string_view key = "VmHWM:";
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::strtoull(line.c_str() + key.size(), nullptr, 10) * 1024;  // from kibibytes
  struct rusage usage {};  // if there is no /proc
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

void write_stats(OutputFile& file, Json report, unsigned threads, const Json& seconds) {
  report["threads"] = threads;
  report["seconds"] = seconds;
  report["peak_bytes"] = peak_bytes();
  write_json(file, report, 2);
}

void write_stats(OutputFile& file, const Stats& stats) {
  const auto counted = [&](std::size_t ComplexCounts::*member) {
    return stats.counts ? Json((*stats.counts).*member) : Json(nullptr);
  };
  Json alpha = or_null(stats.alpha);
  if (stats.alpha && std::isinf(*stats.alpha)) alpha = "inf";
  Json report = {{"points", stats.points},
                 {"distinct", stats.distinct},
                 {"isolated", or_null(stats.isolated)},
                 {"triangles", counted(&ComplexCounts::triangles)},
                 {"vertices", counted(&ComplexCounts::points_covered)},
                 {"edges", counted(&ComplexCounts::edges)},
                 {"boundary_curves", counted(&ComplexCounts::boundary_curves)},
                 {"solid_components", counted(&ComplexCounts::solid_components)},
                 {"components", counted(&ComplexCounts::components)},
                 {"holes", counted(&ComplexCounts::holes)},
                 {"alpha", alpha},
                 {"alpha_rule", or_null(stats.alpha_rule)},
                 {"method", stats.counts ? Json(stats.method) : Json(nullptr)},
                 {"threads", stats.threads}};
  if (stats.groups) {
    report["distinct"] = nullptr;
    report["triangles"] = stats.groups->triangles;
    report["groups"] = stats.groups->groups;
    report["groups_without_polygon"] = stats.groups->without_polygon;
  }
  if (stats.dangling_edges) report["dangling_edges"] = *stats.dangling_edges;
  if (stats.polygons) {
    report["polygons"] = *stats.polygons;
    report["polygon_holes"] = stats.of_polygons.holes;
    report["area"] = stats.of_polygons.area;  // null if the area exceeds the range of double
    report["perimeter"] = stats.of_polygons.perimeter;
  }
  if (stats.fill) {
    report["points_on_boundary"] = stats.fill->on_boundary;
    report["points_inside"] = stats.fill->inside;
    report["retreats"] = stats.fill->retreats;
    report["features"] = stats.fill->features;
    report["invalid_features"] = stats.fill->left_out;
  }
  if (stats.tiles) report["tiles"] = *stats.tiles;
  report["seconds"] = {{"read", stats.read_seconds},
                       {"choose", or_null(stats.choose_seconds)},
                       {"build", or_null(stats.build_seconds)},
                       {"write", or_null(stats.write_seconds)}};
  if (stats.count_seconds) report["seconds"]["count"] = *stats.count_seconds;
  if (stats.cut_seconds) report["seconds"]["cut"] = *stats.cut_seconds;
  report["peak_bytes"] = peak_bytes();
  write_json(file, report, 2);
}

}  // namespace rbpa::app
