#include "io/mesh/ply_fields.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <string_view>

namespace rbpa::app {
namespace {

template <typename To>
constexpr bool fits(std::int64_t least, std::uint64_t greatest) {
  return least >= std::int64_t{std::numeric_limits<To>::min()} &&
         greatest <= std::uint64_t{std::numeric_limits<To>::max()};
}

std::string property_name(std::string_view name) {
  std::string result;
  for (const char c : name) result += static_cast<unsigned char>(c) <= ' ' || c == 0x7F ? '_' : c;
  return result.empty() ? "field" : result;
}

std::string_view name_of(Scalar type) {
  constexpr std::string_view names[] = {"char", "uchar", "short", "ushort", "int", "uint", "", "", "float", "double"};
  return names[static_cast<std::size_t>(type)];
}

}  // namespace

std::optional<Scalar> ply_type(const PointColumn& column) {
  return with_type(column.type, [&](auto zero) -> std::optional<Scalar> {
    using Value = decltype(zero);
    if constexpr (!std::is_integral_v<Value> || sizeof(Value) < 8) {
      return column.type;
    } else {
      Value least = 0, greatest = 0;
      bool is_exact = true;
      for (std::size_t i = 0; i < column.size(); ++i) {
        const Value value = column.value<Value>(i);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
        is_exact = is_exact && is_exact_in_double(value);
      }
      const auto from = static_cast<std::int64_t>(least);
      const auto to = static_cast<std::uint64_t>(greatest);
      if (fits<std::int32_t>(from, to)) return Scalar::int32;
      if (from == 0 && to <= std::numeric_limits<std::uint32_t>::max()) return Scalar::uint32;
      return is_exact ? std::optional(Scalar::float64) : std::nullopt;
    }
  });
}

PlyFields::PlyFields(const VertexFields& fields) : fields_(fields) {
  std::set<std::string> taken = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "point", "confidence"};
  for (const PointColumn& column : fields.columns) {
    const std::optional<Scalar> type = ply_type(column);
    if (!type) continue;
    const std::string name =
        untaken(property_name(column.name), [&](const std::string& other) { return taken.contains(other); });
    taken.insert(name);
    properties_.push_back({&column, *type});
    lines_ += "property " + std::string(name_of(*type)) + " " + name + "\n";
    if (column.is_text) comments_ += "comment " + name + ": " + legend_of(column) + "\n";
  }
}

void PlyFields::write(OutputFile& file, std::size_t vertex) const {
  const std::size_t row = fields_.row(vertex);
  for (const Property& property : properties_)
    with_type(property.column->type, [&](auto zero) {
      const auto value = property.column->value<decltype(zero)>(row);
      if (property.type == property.column->type)
        file.write_binary(value);
      else
        with_type(property.type, [&](auto to) { file.write_binary(static_cast<decltype(to)>(value)); });
    });
}

}  // namespace rbpa::app
