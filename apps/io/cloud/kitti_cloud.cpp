// What:   reads the scans of a Velodyne as KITTI stores them: points of four numbers, without a header.
// Source: A. Geiger, P. Lenz, C. Stiller, R. Urtasun, "Vision meets robotics: the KITTI dataset", 2013.
#include <algorithm>
#include <iterator>
#include <utility>

#include "io/cloud/element_cloud.h"
#include "io/failure.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

constexpr std::string_view fields[] = {"x", "y", "z", "reflectance"};

/// Returns the rule for names of fields: x, y, z, reflectance, in letters of either case.
FieldNames names_of_kitti_fields() {
  return {[](std::string_view word) {
            return std::any_of(std::begin(fields), std::end(fields),
                               [&](std::string_view field) { return same_letters(word, field); });
          },
          "a field of .bin: x, y, z, reflectance"};
}

std::unique_ptr<Cloud> open_kitti(Content content, const CloudRequest& request) {
  PlyElement point{.name = "point", .noun = "point"};
  for (const std::string_view field : fields) point.properties.push_back({std::string(field), Scalar::float32});
  const std::string_view data = content.ahead();
  if (data.size() % point.least_size() != 0)
    bad_input(content.name(), counted(data.size(), "byte"), "a multiple of 16 (x, y, z and reflectance in float32)");
  point.count = data.size() / point.least_size();
  PointLayout layout{.has_room = true};
  for (std::size_t k = 0; k < (request.in_space ? 3 : 2); ++k) layout.columns.emplace_back(k, k);
  if (request.heights) layout.height = 2;
  return open_elements(std::move(content),
                       {.binary = std::endian::little, .elements = {std::move(point)}, .data = data}, std::move(layout),
                       request);
}

}  // namespace

/// Reads x, y, z and reflectance, of little-endian float32, of each point. Requires: content in memory.
const CloudFormat kitti_reader = {
    .open = open_kitti, .fields = names_of_kitti_fields, .skips_invalid = true, .has_signature = false};

}  // namespace rbpa::app
