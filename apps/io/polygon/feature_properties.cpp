#include "io/polygon/feature_properties.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/text/typed_words.h"

namespace rbpa::app {
namespace {

/// Returns the property called `name`; a missing one if there is none.
const Property& property_of(const std::vector<Property>& properties, const std::string& name) {
  static const Property missing = {};
  const auto found =
      std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.name == name; });
  return found == properties.end() ? missing : *found;
}

}  // namespace

FeatureProperties::FeatureProperties(const std::optional<Condition>& where, const std::optional<FieldChoice>& keeps,
                                     Refuse refuse)
    : where_(where), keeps_(keeps), refuse_(std::move(refuse)) {
  if (!where_) return;
  selection_.emplace(*where_);
  numbers_.resize(where_->columns());
  for (const std::string& field : where_->fields()) requested_.emplace(field, false);
  for (const Condition::Text& text : where_->texts()) requested_.emplace(text.field, false);
}

bool FeatureProperties::takes(const std::string& name) {
  const auto found = requested_.find(name);
  if (found != requested_.end()) found->second = true;
  return found != requested_.end() || (keeps_ && keeps_->has(name));
}

void FeatureProperties::require_scalar(const std::string& name, const std::string& found) const {
  if (requested_.count(name) > 0)
    refuse_(found + " as property " + in_quotes(name),
            "a text or a number, as " + std::string(where_->option_of(name)) + " requires");
}

/// Returns the number of a property that the condition reads, NaN if it is missing.
double FeatureProperties::number(const std::vector<Property>& properties, const std::string& name) const {
  const Property& property = property_of(properties, name);
  const NumberFault fault = property.text.empty() ? NumberFault::none : parse_whole_number(property.text).fault;
  if (property.is_text && std::isnan(property.number) && !property.text.empty())
    refuse_(in_quotes(property.text), expected_instead(NumberFault::not_a_number) + std::string(of_where));
  if (!property.is_text && fault == NumberFault::rounded_integer)
    refuse_(in_quotes(property.text), expected_instead(fault) + std::string(of_where));
  return property.number;
}

void FeatureProperties::end_feature(const std::vector<Property>& properties, std::size_t first, PointFile& file) {
  if (!any()) return;
  end_points({}, std::max(first, ended_) - ended_, file);
  end_points(properties, file.points.size() - ended_, file);
}

/// Ends the next `count` points, those of one Feature or in none.
void FeatureProperties::end_points(const std::vector<Property>& properties, std::size_t count, PointFile& file) {
  if (count == 0) return;
  if (keeps_) add_columns(properties, file);
  if (where_) {
    const auto is_text = [&](std::size_t i) {
      return property_of(properties, where_->texts()[i].field).text == where_->texts()[i].text;
    };
    const auto number_of = [&](std::size_t i) { return number(properties, where_->fields()[i]); };
    const bool held = selection_->holds(number_of, is_text);
    for (std::size_t i = 0; i < count; ++i, ++file.all_points)
      if (held) file.index.push_back(static_cast<std::uint32_t>(file.all_points));
    if (!held) {
      const auto remove = [&](auto& values) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(ended_);
        values.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
      };
      remove(file.points);
      return remove(file.z);
    }
    file.fields.resize(where_->columns());
    for (std::size_t k = 0; k < where_->columns(); ++k) {
      const std::string& name = where_->column(k).name;
      const Property& property = property_of(properties, name);
      const Kind kind = where_->column(k).kind;
      if (kind == Kind::text && property.is_text && !property.text.empty()) {
        file.keys_are_texts.resize(where_->columns());
        file.keys_are_texts[k] = true;
      }
      file.fields[k].resize(ended_ + count, kind == Kind::text     ? numbers_[k].number_of(property.text)
                                            : kind == Kind::number ? number(properties, name)
                                            : property.is_text     ? std::numeric_limits<double>::quiet_NaN()
                                                                   : property.number);
    }
  }
  for (PointColumn& column : file.kept) {
    const Property& property = property_of(properties, column.name);
    for (std::size_t i = 0; i < count; ++i)
      property.is_text ? append_text(column, property.text) : append_word(column, property.text);
  }
  ended_ += count;
}

/// Adds a column for each property that is kept and has none yet.
void FeatureProperties::add_columns(const std::vector<Property>& properties, PointFile& file) const {
  for (const Property& property : properties) {
    const bool is_known = std::any_of(file.kept.begin(), file.kept.end(),
                                      [&](const PointColumn& column) { return column.name == property.name; });
    if (is_known || property.text.empty() || !keeps_->has(property.name)) continue;
    file.kept.push_back({.name = property.name, .type = Scalar::int64});
    for (std::size_t i = 0; i < ended_; ++i) append_word(file.kept.back(), "");  // earlier points have no value
  }
}

void FeatureProperties::finish(const std::string& name, PointFile& file) {
  if (!where_) return;
  for (const auto& [property, is_there] : requested_)
    if (!is_there && file.all_points > 0)
      bad_input(name, "no Feature with a property " + in_quotes(property),
                "at least one, as " + std::string(where_->option_of(property)) + " requires");
  selection_->warning("feature", file.warnings);
  for (std::size_t k = 0; k < where_->columns(); ++k) {
    file.texts.emplace_back();
    if (where_->column(k).kind == Kind::text) file.texts[k] = numbers_[k].take_texts();
    const PointColumn* const kept = find_column(file.kept, where_->column(k).name);
    if (where_->column(k).kind != Kind::by_value || kept == nullptr || !kept->is_text) continue;
    file.texts[k] = kept->texts;
    for (std::size_t i = 0; i < kept->size(); ++i) file.fields[k][i] = kept->value<std::int32_t>(i);
  }
}

}  // namespace rbpa::app
