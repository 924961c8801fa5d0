// What: statistics of fields over the points of each polygon or group, as attributes: "intensity:mean,class:majority".
// Law:  a statistic does not depend on the order of the points. Missing values (NaN, empty texts) do not count; without
//       any value the statistic is missing.
// Cost: n log n for each statistic.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/point_columns.h"
#include "io/polygon/attributes.h"
#include "rbpa/plane/groups.h"

namespace rbpa::app {

enum class Statistic { min, max, mean, sum, majority };

struct SummaryChoice {
  std::string field;
  Statistic statistic;

  bool operator==(const SummaryChoice&) const = default;
};

/// Parses the value of --summarize, each choice once; returns no choice if it is absent. Throws WrongUsage that quotes
/// the part that is not understood; or, unless `any_holds`, that no output holds statistics, but `formats` do.
std::vector<SummaryChoice> parse_summaries(const std::optional<std::string>& text, bool any_holds,
                                           const std::string& formats);

/// Returns the fields of `choice` and those of `summaries`; require_fields() does not require the latter.
std::optional<FieldChoice> with_summaries(std::optional<FieldChoice> choice,
                                          const std::vector<SummaryChoice>& summaries);

/// Returns an attribute of the groups of points for each choice, called FIELD_STATISTIC, which may view `columns`. min,
/// max and majority have the type of the field; of values that are equally frequent majority is the least. Throws
/// BadInput that names `file` if a field is missing, or if it has texts and the statistic is not majority.
std::vector<Attribute> summaries_of(const std::vector<SummaryChoice>& choices, std::span<const PointColumn> columns,
                                    const Groups& groups, const std::string& file);

}  // namespace rbpa::app
