#include "io/text/line_selection.h"

#include <algorithm>

#include "io/text/fields.h"
#include "io/text/odd_fields.h"

namespace rbpa::app {

void LineSelection::find_columns(const std::vector<std::string_view>& names, const Lines& lines,
                                 const std::string& name) {
  if (!where_) return;
  bool is_any = where_->selects();
  const auto require_header = [&](std::string_view option) {
    if (names.empty())
      bad_input(name, "no header line", "one with the names that " + std::string(option) + " requires");
  };
  for (std::size_t i = 0; i < where_->fields().size(); ++i) {
    const std::string& field = where_->fields()[i];
    const bool is_column = i < where_->columns();
    if (is_column) kinds_.push_back(where_->column(i).kind);
    if (is_column && where_->column(i).if_there && !has_column(names, field)) {
      places_.push_back(not_there);
      continue;
    }
    require_header(is_column ? where_->option_of(field) : "--where");
    const bool may_be_text = i > where_->columns();  // as in species == oak
    places_.push_back(
        find_column(names, field, lines, name, may_be_text ? " (texts are in quotes: == \"" + field + "\")" : ""));
    is_any = true;
  }
  for (const Condition::Text& text : where_->texts()) {
    require_header("--where");
    places_.push_back(find_column(names, text.field, lines, name));
  }
  numbers_.resize(kinds_.size());
  if (!is_any) return where_.reset();
  selection_.emplace(*where_);
}

void LineSelection::settle_kinds(std::string_view line, Lines behind, char separator) {
  auto open = static_cast<std::size_t>(std::count(kinds_.begin(), kinds_.end(), Kind::by_value));
  do {
    std::size_t place = 0;
    for (Fields fields(line, separator); open > 0 && !fields.at_end(); ++place) {
      const std::string_view field = without_quotes(fields.take());
      if (is_missing(field)) continue;
      for (std::size_t k = 0; k < kinds_.size(); ++k) {
        if (kinds_[k] != Kind::by_value || places_[k] != place) continue;
        kinds_[k] = is_number(field) ? Kind::number : Kind::text;
        --open;
      }
    }
    if (open > 0 && !behind.next_with_content()) return;
    line = behind.line();
  } while (open > 0);
}

BadInput LineSelection::with_hint(const BadInput& refusal) {
  if (std::string_view(refusal.what()).find("--skip-invalid") != std::string_view::npos) return refusal;
  return BadInput(with_way(refusal.what(), "--skip-invalid leaves out lines that are not points"));
}

void LineSelection::add_warnings(bool any_points, const std::string& name, std::vector<std::string>& warnings) const {
  if (selection_) selection_->warning("line", warnings);
  if (skipped_ == 0) return;
  if (!any_points && (!selection_ || selection_->all_held()))
    bad_input(name, counted(skipped_, "line") + " and no point", "at least one point (" + first_skipped_ + ")");
  warnings.push_back(counted(skipped_, "line") + (skipped_ == 1 ? " is" : " are") +
                     " left out: " + (skipped_ == 1 ? "" : "the first is ") + first_skipped_);
}

}  // namespace rbpa::app
