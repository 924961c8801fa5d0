#include "io/bytes/row_writer.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/interrupt.h"

namespace rbpa::app {

std::string csv_text(std::string_view text) {
  if (text.find_first_of(",;\"\n\r\t ") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

RowWriter::RowWriter(OutputFile& file, Format format, const std::vector<std::string>& columns)
    : file_(file), is_csv_(format == Format::csv) {
  for (const std::string& column : columns) {
    const bool is_first = before_.empty();
    if (is_csv_) file_.write((is_first ? "" : ",") + csv_text(column));
    before_.push_back(is_csv_ ? (is_first ? "" : ",") : (is_first ? "{" : ",") + json_string(column) + ":");
  }
  file_.write(is_csv_ ? "\n" : "[");
}

void RowWriter::begin_value() {
  if (next_ == 0) stop_if_interrupted();
  if (next_ == 0 && !is_csv_) file_.write(has_rows_ ? ",\n" : "\n");
  file_.write(before_[next_]);
}

void RowWriter::end_value() {
  has_rows_ = true;
  next_ = next_ + 1 == before_.size() ? 0 : next_ + 1;
  if (next_ == 0) file_.write(is_csv_ ? "\n" : "}");
}

void RowWriter::text(std::string_view value) {
  begin_value();
  file_.write(is_csv_ ? csv_text(value) : value.empty() ? "null" : json_string(value));
  end_value();
}

void RowWriter::number(double value) {
  begin_value();
  if (!std::isnan(value))
    file_.write_number(value);
  else if (!is_csv_)
    file_.write("null");
  end_value();
}

void RowWriter::count(std::uint64_t value) {
  begin_value();
  file_.write_number(value);
  end_value();
}

void RowWriter::finish() {
  if (!is_csv_) file_.write(has_rows_ ? "\n]\n" : "]\n");
}

}  // namespace rbpa::app
