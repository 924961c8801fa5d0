// What: the properties of GeoJSON's Features as fields of points, for conditions, groups, and columns that are kept.
// Law:  a point has the properties of its Feature; a point in no Feature has none.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "io/text/condition.h"
#include "io/text/line_selection.h"

namespace rbpa::app {

/// A property of a Feature; without a text it is missing.
struct Property {
  std::string name;
  std::string text = {};
  double number = std::numeric_limits<double>::quiet_NaN();  ///< 1 for true, 0 for false
  bool is_text = false;                                      ///< a text in quotes, true or false
};

class FeatureProperties {
 public:
  using Refuse = std::function<void(const std::string& found, const std::string& expected)>;  ///< throws BadInput

  /// `refuse` names the current place of the file.
  FeatureProperties(const std::optional<Condition>& where, const std::optional<FieldChoice>& keeps, Refuse refuse);

  bool any() const { return where_ || keeps_; }
  /// Returns whether the value of a property of this name is read. Records that a Feature has the property.
  bool takes(const std::string& name);
  /// Refuses "a list" or "an object" as the property of this name if an option requests its value.
  void require_scalar(const std::string& name, const std::string& found) const;

  /// Ends a Feature, to which the points from number `first` on belong; earlier ones that are not ended are in none.
  /// Removes points for which the condition is false, and appends the values of columns for the others. Throws
  /// BadInput.
  void end_feature(const std::vector<Property>& properties, std::size_t first, PointFile& file);
  /// Completes the columns and the warnings of the file `name`. Throws BadInput if it has points, and no Feature has a
  /// property that an option requests.
  void finish(const std::string& name, PointFile& file);

 private:
  using Kind = WantedColumn::Kind;

  void end_points(const std::vector<Property>& properties, std::size_t count, PointFile& file);
  double number(const std::vector<Property>& properties, const std::string& name) const;
  void add_columns(const std::vector<Property>& properties, PointFile& file) const;

  std::optional<Condition> where_;
  std::optional<FieldChoice> keeps_;
  Refuse refuse_;
  std::size_t ended_ = 0;                       // number of points that are ended, and not removed
  std::map<std::string, bool> requested_ = {};  // by the condition; whether some Feature has the property
  std::optional<Selection> selection_ = std::nullopt;
  std::vector<TextNumbers> numbers_ = {};  // of the texts in each of the condition's columns
};

}  // namespace rbpa::app
