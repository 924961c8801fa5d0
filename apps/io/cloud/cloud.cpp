#include "io/cloud/cloud.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/bytes/number.h"
#include "io/cloud/images.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/las_header.h"
#include "io/cloud/off.h"
#include "io/cloud/ply.h"
#include "io/cloud/readers.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

constexpr CloudFormat cloud_formats[] = {{Format::text, open_table, names_of_columns, true},
                                         {Format::las, open_las, names_of_las_fields, true},
                                         {Format::npy, open_npy, nullptr, true},
                                         {Format::raw, open_raw, nullptr, true},
                                         {Format::ply, open_ply, names_of_properties},
                                         {Format::pcd, open_pcd, names_of_properties},
                                         {Format::off, open_off},
                                         {Format::obj, open_obj}};

struct FormatClaim {
  Format format;
  double (*size)(std::string_view first, const std::string& name);
};
constexpr FormatClaim claims[] = {{Format::npy, claimed_npy_size}, {Format::las, claimed_las_size},
                                  {Format::ply, claimed_ply_size}, {Format::off, claimed_off_size},
                                  {Format::pcd, claimed_pcd_size}, {Format::pgm, claimed_pgm_size}};

template <typename T>
void load_all(std::vector<double>& column, const char* at, std::size_t stride, std::endian order) {
  if (order == std::endian::native) {
    for (double& value : column) {
      value = static_cast<double>(load<T>(at, std::endian::native));
      at += stride;
    }
    return;
  }
  for (double& value : column) {
    value = static_cast<double>(load<T>(at, order));
    at += stride;
  }
}

}  // namespace

const CloudFormat* cloud_format(Format format) {
  const auto found = std::find_if(std::begin(cloud_formats), std::end(cloud_formats),
                                  [format](const CloudFormat& known) { return known.format == format; });
  return found == std::end(cloud_formats) ? nullptr : found;
}

std::optional<FieldNames> fields_of(Format format) {
  const CloudFormat* known = cloud_format(format);
  if (known == nullptr || known->fields == nullptr) return std::nullopt;
  return known->fields();
}

Claim claim_of(Format format, bool skip_invalid) {
  if (format == Format::las && skip_invalid) return {};
  for (const FormatClaim& claim : claims)
    if (claim.format == format)
      return {claim.size, format == Format::las ? " (--skip-invalid reads what is there)" : ""};
  return {};
}

void require_finite(const CloudBlock& block, std::size_t first, const std::string& name) {
  bool finite = true;
  for (std::size_t k = 0; k < CloudBlock::color; ++k)
    for (const double value : block.column[k]) finite &= value - value == 0;
  if (finite) return;
  for (std::size_t i = 0; i < block.count; ++i)
    for (std::size_t k = 0; k < CloudBlock::color; ++k)
      if (!block.column[k].empty() && !std::isfinite(block.column[k][i]))
        bad_input(name + (k < CloudBlock::normal ? ": point " : ": normal of point ") + std::to_string(first + i),
                  in_quotes(ShortestText(block.column[k][i])), "a finite number");
}

void load_column(std::vector<double>& column, Scalar type, const char* at, std::size_t stride, std::size_t count,
                 std::endian order) {
  column.resize(count);
  switch (type) {
    case Scalar::int8:
      return load_all<std::int8_t>(column, at, stride, order);
    case Scalar::uint8:
      return load_all<std::uint8_t>(column, at, stride, order);
    case Scalar::int16:
      return load_all<std::int16_t>(column, at, stride, order);
    case Scalar::uint16:
      return load_all<std::uint16_t>(column, at, stride, order);
    case Scalar::int32:
      return load_all<std::int32_t>(column, at, stride, order);
    case Scalar::uint32:
      return load_all<std::uint32_t>(column, at, stride, order);
    case Scalar::int64:
      return load_all<std::int64_t>(column, at, stride, order);
    case Scalar::uint64:
      return load_all<std::uint64_t>(column, at, stride, order);
    case Scalar::float32:
      return load_all<float>(column, at, stride, order);
    case Scalar::float64:
      return load_all<double>(column, at, stride, order);
  }
}

void clear_fields(CloudBlock& block, std::size_t columns) {
  block.fields.resize(columns);
  for (std::vector<double>& field : block.fields) field.clear();
}

void append_fields(const CloudBlock& block, std::vector<std::vector<double>>& fields) {
  fields.resize(block.fields.size());
  for (std::size_t k = 0; k < fields.size(); ++k)
    fields[k].insert(fields[k].end(), block.fields[k].begin(), block.fields[k].end());
}

void PointSelection::remark(std::vector<std::string>& remarks) const {
  if (selects_)
    remarks.push_back(std::to_string(selected_) + " of " + counted(points_, "point") + " are as --where asks");
}

void PointSelection::select(CloudBlock& block, std::span<const std::vector<double>> fields, std::size_t first,
                            const std::string& name) {
  std::vector<std::uint8_t> kept(block.count);
  clear_fields(block, columns_);
  for (std::size_t i = 0; i < block.count; ++i) {
    for (std::size_t k = 0; k < fields.size(); ++k) values_[k] = fields[k][i];
    kept[i] = holds() ? 1 : 0;
    if (kept[i] != 0) {
      append_columns(block);
      continue;
    }
    for (std::vector<double>& column : block.column)
      if (!column.empty()) column[i] = 0;  // whatever it was
  }
  require_finite(block, first, name);
  for (std::vector<double>& column : block.column) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < column.size(); ++i)
      if (kept[i] != 0) column[count++] = column[i];
    column.resize(count);
  }
  block.count = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), std::uint8_t{1}));
}

FieldNames names_of_properties() {
  FieldNames names = names_of_columns();
  return {names.are, "the name of a field (in double quotes where it is no word)", false};
}

}  // namespace rbpa::app
