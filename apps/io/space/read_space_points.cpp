#include "io/space/read_space_points.h"

#include <cmath>

#include "io/failure.h"
#include "io/gunzip.h"
#include "io/input_bytes.h"
#include "io/las/las_header.h"
#include "io/las/selection.h"
#include "io/number.h"
#include "io/off_header.h"
#include "io/ply_data.h"
#include "io/space/pcd_header.h"
#include "io/space/readers.h"

namespace rbpa::app {
namespace {

SpacePoints parse(std::string_view bytes, const std::string& name, SpaceFormat format, const SpaceChoice& choice) {
  switch (format) {
    case SpaceFormat::ply:
      return read_ply_space(bytes, name);
    case SpaceFormat::off:
      return read_off_space(bytes, name);
    case SpaceFormat::obj:
      return read_obj_space(bytes, name);
    case SpaceFormat::pcd:
      return read_pcd_space(bytes, name);
    case SpaceFormat::npy:
      return read_npy_space(bytes, name);
    case SpaceFormat::las:
      return read_las_space(bytes, name, choice);
    case SpaceFormat::text:
      break;
  }
  return read_space_table(bytes, name, choice);
}

Claim claim_of(SpaceFormat format, const SpaceChoice& choice) {
  switch (format) {
    case SpaceFormat::ply:
      return {claimed_ply_size};
    case SpaceFormat::off:
      return {claimed_off_size};
    case SpaceFormat::pcd:
      return {claimed_pcd_size};
    case SpaceFormat::npy:
      return {claimed_npy_space_size};
    case SpaceFormat::las:
      return las_claim(choice.skip_invalid);
    default:
      return {};
  }
}

std::string normal_of(std::size_t point, const std::string& name) {
  return name + ": normal of point " + std::to_string(point);
}

/// A normal says a direction.
void require_directions(const SpacePoints& file, const std::string& name) {
  for (std::size_t i = 0; i < file.normals.size(); ++i)
    if (file.normals[i] == Point3{}) bad_input(normal_of(i, name), "'0 0 0'", "a vector of another length than 0");
}

}  // namespace

std::optional<FieldNames> fields_of(SpaceFormat format) {
  if (format == SpaceFormat::text) return names_of_columns();
  if (format == SpaceFormat::las) return names_of_las_fields();
  return std::nullopt;
}

void append_numbers(std::span<const double> values, SpacePoints& file, const std::string& name) {
  const std::size_t index = file.points.size();
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]))
      bad_input(k < 3 ? name + ": point " + std::to_string(index) : normal_of(index, name),
                in_quotes(ShortestText(values[k])), "a finite number");
  file.points.push_back({values[0], values[1], values[2]});
  if (values.size() == 6) file.normals.push_back({values[3], values[4], values[5]});
}

void reserve_points(SpacePoints& file, std::size_t count, bool normals, bool colors) {
  file.points.reserve(count);
  if (normals) file.normals.reserve(count);
  if (colors) file.colors.reserve(count);
}

SpacePoints read_space_points(const std::string& path, SpaceFormat format, const SpaceChoice& choice) {
  InputBytes input(path, "a file of points");
  if (is_gzip(input.bytes())) input.gunzip(claim_of(format, choice));
  return space_points_in(input.bytes(), input.name(), format, choice);
}

SpacePoints space_points_in(std::string_view bytes, const std::string& name, SpaceFormat format,
                            const SpaceChoice& choice) {
  // No points may be meant; no bytes at all come from a command that failed before.
  if (bytes.empty()) bad_input(name, "an empty file", "points");
  SpacePoints file = parse(bytes, name, format, choice);
  require_directions(file, name);
  return file;
}

}  // namespace rbpa::app
