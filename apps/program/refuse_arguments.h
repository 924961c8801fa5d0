// What: reports command lines that CLI11 refuses, in the same words for all programs.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "io/failure.h"
#include "program/exit_code.h"

namespace rbpa::app {

/// Returns the message about an unknown `word` after `called`: the program, with its verb if one is given.
inline std::string unexpected(const std::string& word, const CLI::App& app, const std::string& called) {
  const std::string found = "found " + in_quotes(word) + ", expected ", way = " (see " + called + " --help)";
  std::string verbs;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    verbs += (verbs.empty() ? "" : ", ") + verb->get_name();
  if (app.get_subcommands().empty() && !verbs.empty()) return found + "one of " + verbs + way;
  return found + (word.starts_with('-') ? "an option" : "no more arguments") + " of " + called + way;
}

/// Prints on standard error what is wrong with the command line that `app` refused by `error`; returns wrong_usage.
inline int refuse_arguments(const CLI::App& app, const CLI::ParseError& error) {
  const auto verbs = app.get_subcommands();
  const std::string called = app.get_name() + (verbs.empty() ? "" : " " + verbs.front()->get_name());
  // A required option may be missing because its name is misspelled.
  const std::vector<std::string> unknown = app.remaining(true);
  return report(app.get_name(),
                unknown.empty() ? std::string(error.what()) + " (see " + called + " --help)"
                                : unexpected(unknown.front(), app, called),
                wrong_usage);
}

}  // namespace rbpa::app
