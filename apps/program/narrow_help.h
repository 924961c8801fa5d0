// What: the help of a program with no line longer than a terminal is wide.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstddef>
#include <sstream>
#include <string>

namespace rbpa::app {

class NarrowHelp : public CLI::Formatter {
 public:
  static constexpr std::size_t columns = 100;

  /// Lines that are too long go on under the descriptions of options where they are indented, else at the left.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::istringstream lines(CLI::Formatter::make_help(app, name, mode));
    std::string text;
    for (std::string line; std::getline(lines, line); text += line + "\n") {
      const std::size_t indent = line.starts_with(' ') ? get_column_width() : 0;
      while (line.size() > columns) {
        const std::size_t blank = line.rfind(' ', columns);
        if (blank == std::string::npos || blank <= indent) break;  // one long word
        text += line.substr(0, blank) + "\n";
        line = std::string(indent, ' ') + line.substr(blank + 1);
      }
    }
    return text;
  }
};

}  // namespace rbpa::app
