#include "plane/level_report.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "io/failure.h"
#include "rbpa/plane/level_topology.h"

namespace rbpa::app {
namespace {

struct Item {
  std::string_view name;
  std::variant<std::uint64_t, double> value;
};

std::array<Item, 13> items_of(const Level& level, const ComplexCounts& counts, std::size_t triangles_before) {
  return {{{"level", static_cast<std::uint64_t>(level.number)},
           {"alpha", level.alpha},
           {"transferred", level.transferred},
           {"taking_part", level.taking_part},
           {"advancing", level.advancing},
           {"triangles_added", level.triangles - triangles_before},
           {"triangles", level.triangles},
           {"solid_components", counts.solid_components},
           {"components", counts.components},
           {"holes", counts.holes},
           {"boundary_curves", counts.boundary_curves},
           {"covered", counts.points_covered},
           {"seconds", level.seconds}}};
}

/// Calls line(items) for each level; `items` are the names and values of the columns for the level.
template <typename Line>
void for_each_level(const Hierarchy& hierarchy, Line line) {
  const std::vector<ComplexCounts> counts = level_topology(hierarchy);
  std::size_t before = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    line(items_of(hierarchy.levels[i], counts[i], before));
    before = hierarchy.levels[i].triangles;
  }
}

void write_value(OutputFile& file, const Item& item) {
  std::visit([&](const auto value) { file.write_number(value); }, item.value);
}

void write_csv(OutputFile& file, const Hierarchy& hierarchy) {
  const char* before = "";
  for (const Item& item : items_of({}, {}, 0)) {
    file.write_all(std::exchange(before, ","), item.name);
  }
  file.write("\n");
  for_each_level(hierarchy, [&](const auto& items) {
    before = "";
    for (const Item& item : items) {
      file.write(std::exchange(before, ","));
      write_value(file, item);
    }
    file.write("\n");
  });
}

void write_json(OutputFile& file, const Hierarchy& hierarchy, const Method& method) {
  file.write_all("{\n  \"least_radius\": ", hierarchy.least_radius,
                 ",\n  \"leaf_capacity\": ", method.leaf_capacity.value_or(0), ",\n  \"levels\": [");
  const char* line = "\n    {";
  for_each_level(hierarchy, [&](const auto& items) {
    const char* before = std::exchange(line, ",\n    {");
    for (const Item& item : items) {
      file.write_all(std::exchange(before, ", "), "\"", item.name, "\": ");
      const double* number = std::get_if<double>(&item.value);
      if (number && std::isinf(*number))
        file.write("\"inf\"");  // as in the report of --stats
      else
        write_value(file, item);
    }
    file.write("}");
  });
  file.write(hierarchy.levels.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace

Format parse_levels(const std::string& path, const Method& method) {
  if (!method.leaf_capacity) throw WrongUsage("--levels requires --method hrbpa");
  return target_of("--levels", path, Use::levels).format;
}

void write_levels(OutputFile& file, Format format, const Hierarchy& hierarchy, const Method& method) {
  format == Format::csv ? write_csv(file, hierarchy) : write_json(file, hierarchy, method);
}

}  // namespace rbpa::app
