// What: makes the manual page and the shell completions of a program from the same declarations as --help.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace rbpa::app {

/// Returns a page of section 1 in roff: the description, all verbs with the options that --help lists, examples and
/// exit codes. `name` is "PROGRAM VERSION".
std::string man_page(const CLI::App& app, const std::string& name);

/// Returns a script for bash to source, or to put where bash looks for completions.
std::string bash_completion(const CLI::App& app);

/// Returns a function to put in zsh's `fpath` as _PROGRAM.
std::string zsh_completion(const CLI::App& app);

/// Adds `--man` and `--completion SHELL`, which end parsing with a CLI::Success that contains the text. Requires:
/// everything else is declared.
void add_manual(CLI::App& app, const std::string& name);

}  // namespace rbpa::app
