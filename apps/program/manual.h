// What: a program's command line as a manual page and as completions of shells: from the same declarations as
//       --help.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace rbpa::app {

/// A page of section 1 in roff: all verbs with their options, examples and exit codes. `name` is "PROGRAM VERSION".
std::string man_page(const CLI::App& app, const std::string& name);

/// A script to be sourced by bash, or put where it looks for completions.
std::string bash_completion(const CLI::App& app);

/// A function in zsh's `fpath`, as _PROGRAM.
std::string zsh_completion(const CLI::App& app);

/// Adds `--man` and `--completion SHELL`, which end the parsing with a CLI::Success that has the text. Call it when
/// everything else is declared.
void add_manual(CLI::App& app, const std::string& name);

}  // namespace rbpa::app
