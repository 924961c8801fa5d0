// What: makes the manual page and the shell completions of a program from the same declarations as --help.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace rbpa::app {

/// Returns a page of section 1 in roff: the description, all verbs with the options that --help lists, examples and
/// exit codes. `name` is "PROGRAM VERSION".
std::string man_page(const CLI::App& app, const std::string& name);

/// Returns a script that completes verbs and names of options, for bash to source, or to put where bash looks for
/// completions.
std::string bash_completion(const CLI::App& app);

/// Returns a function that completes verbs, options and files, to put in zsh's `fpath` as _PROGRAM.
std::string zsh_completion(const CLI::App& app);

/// Adds `--man` and `--completion SHELL`, which end parsing with a CLI::Success that contains the text, or with a
/// CLI::ValidationError if the shell is neither bash nor zsh. Keeps a reference to `app`, and reads it when such an
/// option is parsed: declarations that follow are included.
void add_manual(CLI::App& app, const std::string& name);

}  // namespace rbpa::app
