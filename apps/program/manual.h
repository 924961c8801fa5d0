// What: makes the manual page and the shell completions of a program from the declarations that --help uses.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace rbpa::app {

/// Returns a manual page of section 1 in roff: the description, all verbs with the options that --help lists, examples
/// and exit codes. `name` is "PROGRAM VERSION".
std::string man_page(const CLI::App& app, const std::string& name);

/// Returns a bash script that completes verbs and names of options. Bash can source the script, or find it in a folder
/// of completions.
std::string bash_completion(const CLI::App& app);

/// Returns a zsh script that completes verbs, options and files, to be stored as _PROGRAM in a folder of `fpath`.
std::string zsh_completion(const CLI::App& app);

/// Adds `--man` and `--completion SHELL`. Both end parsing with a CLI::Success that contains the text; an unknown shell
/// ends parsing with a CLI::ValidationError. Keeps a reference to `app`, and reads `app` when the option is parsed:
/// later declarations are included.
void add_manual(CLI::App& app, const std::string& name);

}  // namespace rbpa::app
