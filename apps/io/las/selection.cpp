#include "io/las/selection.h"

#include "io/failure.h"

namespace rbpa::app {
namespace {

/// The formats that have a field, for a message.
std::string formats_with(std::string_view field, unsigned minor) {
  std::string formats;
  for (unsigned format = 0; format <= last_las_format; ++format)
    if (find_las_field(field, format, minor)) formats += (formats.empty() ? "" : ", ") + std::to_string(format);
  return formats.empty() ? "one of a later version" : formats;
}

}  // namespace

FieldNames names_of_las_fields() { return {is_las_field, "a field of LAS: " + las_field_names(), false}; }

Selection::Selection(const Condition& condition, const LasRecords& records, const std::string& name)
    : axes_(records.axes), values_(condition.fields().size()), holds_(condition) {
  for (const std::string& wanted : condition.fields()) {
    if (const std::optional<std::size_t> axis = las_axis(wanted)) {
      places_.push_back({.field = {.offset = 4 * *axis, .type = Scalar::int32}, .axis = axis});
      continue;
    }
    const std::optional<LasField> field = find_las_field(wanted, records.format, records.minor);
    if (!field)
      bad_input(name, "point format " + std::to_string(records.format) + " of LAS 1." + std::to_string(records.minor),
                "one with " + wanted + ", as --where asks: " + formats_with(wanted, records.minor));
    places_.push_back({.field = *field});
  }
}

bool Selection::operator()(const char* record) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    values_[i] = place.axis ? axes_[*place.axis](load<std::int32_t>(record + place.field.offset, std::endian::little))
                            : place.field.value(record);
  }
  return holds_(values_);
}

}  // namespace rbpa::app
