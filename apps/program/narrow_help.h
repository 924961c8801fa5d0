// What: formats help in lines of at most 100 characters, unless one word is longer; lists verbs by their summaries.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstddef>
#include <sstream>
#include <string>

namespace rbpa::app {

/// Returns the summary of a verb: the first line of its description. The help of the verb shows all lines.
inline std::string summary_of(const CLI::App& verb) {
  const std::string description = verb.get_description();
  return description.substr(0, description.find('\n'));
}

class NarrowHelp : public CLI::Formatter {
 public:
  static constexpr std::size_t columns = 100;

  /// Returns the help of CLI11 with lines above 100 characters broken. The rest of an indented line is indented to the
  /// column of the descriptions; the rest of any other line begins at the left.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::istringstream lines(CLI::Formatter::make_help(app, name, mode));
    std::string text;
    for (std::string line; std::getline(lines, line); text += line + "\n") {
      const std::size_t indent = line.starts_with(' ') ? get_column_width() : 0;
      while (line.size() > columns) {
        const std::size_t blank = line.rfind(' ', columns);
        if (blank == std::string::npos || blank <= indent) break;  // one word is longer
        text += line.substr(0, blank) + "\n";
        line = std::string(indent, ' ') + line.substr(blank + 1);
      }
    }
    return text;
  }

  std::string make_subcommand(const CLI::App* verb) const override {
    std::ostringstream text;
    CLI::detail::format_help(text, verb->get_display_name(true), summary_of(*verb), get_column_width());
    return text.str();
  }
};

}  // namespace rbpa::app
