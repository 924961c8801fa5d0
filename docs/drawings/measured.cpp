#include "drawings/measured.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>

namespace figures {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    words.push_back(line.substr(from, comma - from));
    from = comma + 1;
  }
  return words;
}

/// Parses numbers. Returns: nothing when one of the words is not a number above 0.
std::optional<std::vector<double>> numbers(const std::vector<std::string>& words) {
  std::vector<double> values;
  for (const std::string& word : words) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !(value > 0)) return std::nullopt;
    values.push_back(value);
  }
  return values;
}

}  // namespace

std::optional<std::size_t> Measured::column(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

Measured read_measured(const std::string& name) {
  const std::string path = std::string(RBPA_FIGURE_DATA) + "/" + name;
  std::ifstream file(path);
  Measured all;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.starts_with("# ")) {
      all.head.push_back(line.substr(2));
    } else if (all.columns.empty()) {
      all.columns = split(line);
    } else {
      const std::optional<std::vector<double>> row = numbers(split(line));
      if (!row || row->size() != all.columns.size() || (!all.rows.empty() && row->front() <= all.rows.back().front()))
        throw std::runtime_error(path + ":" + std::to_string(number) + ": found '" + line + "', expected " +
                                 std::to_string(all.columns.size()) +
                                 " numbers above 0 with commas between them, the first above that of the row before");
      all.rows.push_back(*row);
    }
  }
  if (all.head.size() != 2 || all.rows.size() < 2)
    throw std::runtime_error(path + ": found " + std::to_string(all.head.size()) + " lines of head and " +
                             std::to_string(all.rows.size()) + " rows, expected 2 and at least 2");
  return all;
}

}  // namespace figures
