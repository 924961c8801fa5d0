// What: finds the fields of LAS point records, formats 0 to 10, by name, for `--where`; computes coordinates.
// Source: ASPRS, LAS specification 1.4 R15, section 2.6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_columns.h"
#include "io/scalar.h"
#include "io/text/condition.h"

namespace rbpa::app {

constexpr unsigned last_las_format = 10;

/// Returns the least size in bytes of a point record of the format. Requires: format ≤ 10.
std::size_t las_record_size(unsigned format);

/// The place of a field in a record: a number at an offset in bytes, or some bits of that number.
struct LasField {
  std::size_t offset;
  Scalar type;
  unsigned first_bit = 0, bits = 0;  ///< bits = 0: the field is the whole number
  double unit = 1;                   ///< factor by which the number is multiplied
  double shift = 0;                  ///< number that is added to the product

  double value(const char* record) const;
  /// Returns the type that holds all values.
  Scalar kept_type() const { return bits > 0 ? Scalar::uint8 : unit != 1 || shift != 0 ? Scalar::float64 : type; }
  /// Appends the value in a record to a column of kept_type().
  void append_to(PointColumn& column, const char* record) const;
};

struct NamedLasField {
  std::string name;
  LasField field;
};

/// Returns the fields of records of `length` bytes, in their order: those of the format in a file of version 1.minor,
/// and those that `extra`, the data of the record about extra bytes, describes, except bytes without a type. A list
/// is a field "name[0]", "name[1]", … for each of its values.
std::vector<NamedLasField> all_las_fields(unsigned format, unsigned minor, std::size_t length, std::string_view extra);

/// Returns the field called `name`; case and underscores do not count: "ReturnNumber" is return_number. Returns nothing
/// if the format, in a file of version 1.minor, has no such field.
std::optional<LasField> find_las_field(std::string_view name, unsigned format, unsigned minor);

class ScaledInteger {
 public:
  ScaledInteger(double scale, double offset);

  double operator()(std::int32_t value) const {
    if (exact_) return static_cast<double>(value * factor_ + summand_) / divisor_;
    return static_cast<double>(value) * scale_ + offset_;
  }

 private:
  double scale_, offset_;
  bool exact_ = false;
  std::int64_t factor_ = 0, summand_ = 0;  // scale and offset times divisor_, a power of ten
  double divisor_ = 1;
};

/// Returns the rule for names of fields: any word, as extra bytes may have any name. Messages list the known names.
FieldNames names_of_las_fields();

/// The place, in a record, of a value that a condition reads.
struct LasPlace {
  LasField field;
  std::optional<std::size_t> axis = std::nullopt;  ///< 0, 1, 2 for x, y, z, which need scale and offset
  bool is_kept = false;                            ///< the value is not read, as the reader keeps the field itself

  double value(const char* record, std::span<const ScaledInteger> axes) const {
    return axis ? axes[*axis](load<std::int32_t>(record + field.offset, std::endian::little)) : field.value(record);
  }
};

/// Returns the places of condition.fields(), in their order, for records of point format `format` in a file of version
/// 1.minor, whose fields are `all`. Throws BadInput that names the file `name` if such records lack a field.
std::vector<LasPlace> find_las_places(const Condition& condition, unsigned format, unsigned minor,
                                      const std::vector<NamedLasField>& all, const std::string& name);

}  // namespace rbpa::app
