// What: the fields of LAS point records, formats 0 to 10, by their names.
// Source: ASPRS, LAS specification 1.4 R15, section 2.6.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/scalar.h"

namespace rbpa::app {

constexpr unsigned last_las_format = 10;

/// Bytes of a record of the format.
std::size_t las_record_size(unsigned format);

/// Where a field is: a number at an offset, or some bits of it.
struct LasField {
  std::size_t offset;
  Scalar type;
  unsigned first_bit = 0, bits = 0;  ///< all of it where bits is 0
  double unit = 1;                   ///< by which the number is multiplied

  double value(const char* record) const;
};

/// The field of that name, in whose letters case and underscores do not count: "ReturnNumber" is return_number. Nothing
/// where the format, of a file of version 1.minor, has no such field.
std::optional<LasField> find_las_field(std::string_view name, unsigned format, unsigned minor);

/// Whether any format has a field of that name; x, y and z are names, and no fields: they need scale and offset.
bool is_las_field(std::string_view name);

/// 0, 1 or 2 of x, y and z.
std::optional<std::size_t> las_axis(std::string_view name);

/// All names for messages: "x, y, z, intensity, ...".
std::string las_field_names();

}  // namespace rbpa::app
