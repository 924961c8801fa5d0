#include "io/polygon/summaries.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

constexpr std::string_view statistics[] = {"min", "max", "mean", "sum", "majority"};

/// Returns the row of the minimum, maximum or majority of `sorted`, pairs of a value and its row; else no_row.
template <typename Entry>
std::uint32_t row_of(Statistic statistic, const std::vector<Entry>& sorted) {
  if (sorted.empty()) return Attribute::no_row;
  if (statistic != Statistic::majority) return (statistic == Statistic::min ? sorted.front() : sorted.back()).second;
  std::size_t best = 0, most = 0;
  for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
    while (end < sorted.size() && sorted[end].first == sorted[first].first) ++end;
    if (end - first > most) most = end - first, best = first;
  }
  return sorted[best].second;
}

/// Calls use(value), where value(row) is the number or the text of that row.
template <typename Use>
void with_values(const PointColumn& column, const Use& use) {
  if (column.is_text) return use([&](std::uint32_t row) { return std::string_view(column.text(row)); });
  with_type(column.type, [&](auto zero) { use([&](std::uint32_t row) { return column.value<decltype(zero)>(row); }); });
}

}  // namespace

std::vector<SummaryChoice> parse_summaries(const std::optional<std::string>& text, bool any_holds,
                                           const std::string& formats) {
  std::vector<SummaryChoice> choices;
  if (!text) return choices;
  if (!any_holds) throw WrongUsage("--summarize requires -o in a format with attributes: one of " + formats);
  for (const std::string_view word : split_at_commas(*text)) {
    const std::size_t colon = std::min(word.rfind(':'), word.size());
    const auto* const found =
        std::find(std::begin(statistics), std::end(statistics), word.substr(std::min(colon + 1, word.size())));
    if (colon == 0 || found == std::end(statistics))
      bad_usage("--summarize", in_quotes(word),
                "FIELD:STATISTIC, several with commas between them; a statistic is min, max, mean, sum or majority");
    const SummaryChoice choice{std::string(word.substr(0, colon)), static_cast<Statistic>(found - statistics)};
    if (std::find(choices.begin(), choices.end(), choice) == choices.end()) choices.push_back(choice);
  }
  return choices;
}

std::optional<FieldChoice> with_summaries(std::optional<FieldChoice> choice,
                                          const std::vector<SummaryChoice>& summaries) {
  if (!choice && !summaries.empty()) choice.emplace().names.emplace();
  if (!summaries.empty() && choice->names) choice->names->emplace_back();  // summaries_of() requires the fields
  for (const SummaryChoice& summary : summaries)
    if (choice->names) choice->names->push_back(summary.field);
  return choice;
}

std::vector<Attribute> summaries_of(const std::vector<SummaryChoice>& choices, std::span<const PointColumn> columns,
                                    const Groups& groups, const std::string& file) {
  std::vector<Attribute> attributes;
  for (const SummaryChoice& choice : choices) {
    const PointColumn& column = require_column(columns, choice.field, "--summarize", file);
    const Statistic statistic = choice.statistic;
    const std::string word(statistics[static_cast<std::size_t>(statistic)]);
    if (column.is_text && statistic != Statistic::majority)
      bad_input(file, "texts in field " + in_quotes(choice.field),
                "numbers, as --summarize " + choice.field + ":" + word + " requires (majority takes texts)");
    PointColumn totals;
    std::vector<std::uint32_t> rows;
    with_values(column, [&](const auto& value) {
      using Value = std::invoke_result_t<decltype(value), std::uint32_t>;
      for (std::size_t group = 0; group < groups.size(); ++group) {
        if (group % 256 == 0) stop_if_interrupted();
        std::vector<std::pair<Value, std::uint32_t>> sorted;
        for (const std::uint32_t row : groups[group])
          if (!column.is_missing(row)) sorted.emplace_back(value(row), row);
        std::sort(sorted.begin(), sorted.end());
        if constexpr (std::is_arithmetic_v<Value>) {
          long double sum = 0;
          for (const auto& entry : sorted) sum += static_cast<long double>(entry.first);
          if (statistic == Statistic::mean) sum /= static_cast<long double>(sorted.size());
          totals.append(sorted.empty() ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(sum));
        }
        rows.push_back(row_of(statistic, sorted));
      }
    });
    Attribute& attribute = attributes.emplace_back(Attribute{choice.field + "_" + word, view_of(column), {}});
    if (statistic == Statistic::mean || statistic == Statistic::sum)
      attribute.column = std::make_shared<PointColumn>(std::move(totals));
    else
      attribute.rows = std::move(rows);
  }
  return attributes;
}

}  // namespace rbpa::app
