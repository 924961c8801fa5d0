#include "io/text/line_selection.h"

#include "io/text/fields.h"

namespace rbpa::app {

void LineSelection::find_columns(const std::vector<std::string_view>& names, const Lines& lines,
                                 const std::string& name) {
  if (!where_) return;
  if (names.empty())
    bad_input(name, "no header line",
              "one with the names that " +
                  std::string(where_->option_of(where_->columns() > 0 ? where_->fields()[0] : "")) + " asks for");
  for (const std::string& field : where_->fields()) columns_.push_back(find_column(names, field, lines, name));
  for (const Condition::Text& text : where_->texts())
    text_columns_.push_back(find_column(names, text.field, lines, name));
  selection_.emplace(*where_);
}

void LineSelection::add_remarks(bool any_points, const std::string& name, std::vector<std::string>& remarks) const {
  if (selection_) selection_->remark("line", remarks);
  if (skipped_ == 0) return;
  if (!any_points && (!selection_ || selection_->all_held()))
    bad_input(name, counted(skipped_, "line") + " and no point", "at least one (" + first_skipped_ + ")");
  remarks.push_back(counted(skipped_, "line") + (skipped_ == 1 ? " is" : " are") +
                    " left out: " + (skipped_ == 1 ? "" : "the first is ") + first_skipped_);
}

}  // namespace rbpa::app
