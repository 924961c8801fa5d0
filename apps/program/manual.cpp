#include "program/manual.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "io/failure.h"
#include "program/exit_code.h"
#include "program/narrow_help.h"

namespace rbpa::app {
namespace {

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_name().empty(); });
}

/// Returns the options that --help lists. Hidden options, which are in no group, are left out.
std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  return app.get_options(
      [](const CLI::Option* option) { return option->nonpositional() && !option->get_group().empty(); });
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// Returns the names of an option with their dashes, such as "-o" and "--output".
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// Returns the names of all options that --help of `app` lists; `app` is a program or a verb.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> all;
  for (const CLI::Option* option : options_of(app))
    for (const std::string& name : names_of(*option)) all.push_back(name);
  return all;
}

// ---- roff

/// Returns the text escaped for roff. No character of the text then acts as a request, an escape, a hyphen or a quote.
std::string roff(const std::string& text) {
  std::string shown;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (shown.empty() || shown.back() == '\n')) shown += "\\&";
    switch (c) {
      case '\\':
        shown += "\\e";
        break;
      case '-':
        shown += "\\-";
        break;
      case '\'':
        shown += "\\(aq";
        break;
      default:
        shown += c;
    }
  }
  return shown;
}

/// Returns the text in roff: indented lines unfilled, other lines as paragraphs.
std::string roff_paragraphs(const std::string& text) {
  std::istringstream lines(text);
  std::string shown;
  bool is_indented = false;
  for (std::string line; std::getline(lines, line);) {
    const bool indented = line.starts_with(' ');
    if (indented != is_indented) shown += indented ? ".nf\n" : ".fi\n";
    is_indented = indented;
    if (line.empty())
      shown += ".PP\n";
    else
      shown += roff(line) + "\n";
  }
  return shown + (is_indented ? ".fi\n" : "");
}

/// Returns the usage of `app` in roff, such as "rbpa mesh POINTS [OPTIONS]", where `called` is "rbpa mesh".
std::string roff_usage(const std::string& called, const CLI::App& app) {
  std::string usage = "\\fB" + roff(called) + "\\fR";
  for (const CLI::Option* positional : positionals_of(app)) usage += " \\fI" + roff(positional->get_name()) + "\\fR";
  return usage + " [\\fIOPTIONS\\fR]";
}

std::string roff_options(const CLI::App& app) {
  std::string text;
  const auto item = [&](const std::string& head, const CLI::Option& option) {
    text += ".TP\n" + head + "\n" + roff(option.get_description());
    if (const std::string usual = option.get_default_str(); !usual.empty()) text += roff(" (default: " + usual + ")");
    text += "\n";
  };
  for (const CLI::Option* positional : positionals_of(app))
    item("\\fI" + roff(positional->get_name()) + "\\fR", *positional);
  for (const CLI::Option* option : options_of(app)) {
    std::vector<std::string> names;
    for (const std::string& name : names_of(*option)) names.push_back("\\fB" + roff(name) + "\\fR");
    item(joined(names, ", ") + (takes_value(*option) ? " \\fI" + roff(option->get_type_name()) + "\\fR" : ""), *option);
  }
  return text;
}

/// Returns the footer of the help without the exit codes: the manual page has a section for them.
std::string footer_of(const CLI::App& app) {
  std::string footer = app.get_footer();
  if (const auto codes = footer.find(exit_codes); codes != std::string::npos) footer.resize(codes);
  while (!footer.empty() && std::isspace(static_cast<unsigned char>(footer.back())) != 0) footer.pop_back();
  return footer;
}

// ---- shells

/// Returns the text as a shell word in single quotes.
std::string in_single_quotes(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) {
    if (c == '\'')
      safe += "'\\''";
    else
      safe += c;
  }
  return safe += "'";
}

/// Returns the text escaped for an argument of the zsh function _arguments.
std::string zsh_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string zsh_arguments(const CLI::App& app) {
  std::string text = "_arguments -S";
  for (const CLI::Option* option : options_of(app))
    for (const std::string& name : names_of(*option)) {
      std::string argument = "*" + name + (takes_value(*option) && name.starts_with("--") ? "=" : "") + "[" +
                             zsh_text(option->get_description()) + "]";
      if (takes_value(*option)) argument += ":" + zsh_text(option->get_type_name()) + ":_files";
      text += " \\\n        " + in_single_quotes(argument);
    }
  return text + " \\\n        '*:file:_files'\n";
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& name) {
  const std::string program = app.get_name();
  std::string upper = program;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const auto verbs = verbs_of(app);
  std::string page = ".TH " + upper + " 1 \"\" \"" + roff(name) + "\" \"User Commands\"\n";
  page += ".SH NAME\n" + program + " \\- " + roff(summary_of(app)) + "\n.SH SYNOPSIS\n";
  if (verbs.empty()) page += roff_usage(program, app) + "\n";
  for (const CLI::App* verb : verbs)
    page += (verb == verbs.front() ? "" : ".br\n") + roff_usage(program + " " + verb->get_name(), *verb) + "\n";
  page += ".SH DESCRIPTION\n" + roff_paragraphs(app.get_description());
  page += ".SH OPTIONS\n" + roff_options(app);
  for (const CLI::App* verb : verbs) {
    page += ".SH \"" + upper + " " + verb->get_name() + "\"\n" + roff_paragraphs(verb->get_description());
    page += roff_options(*verb) + ".PP\n" + roff_paragraphs(footer_of(*verb));
  }
  page += ".SH EXAMPLES\n" + roff_paragraphs(footer_of(app));
  return page + ".SH \"EXIT STATUS\"\n" + roff(exit_codes) + "\n";
}

std::string bash_completion(const CLI::App& app) {
  const std::string program = app.get_name(), function = "_" + program;
  std::vector<std::string> verbs;
  std::string cases;
  for (const CLI::App* verb : verbs_of(app)) {
    verbs.push_back(verb->get_name());
    cases += "    " + verb->get_name() + ") words='" + joined(option_names(*verb), " ") + "' ;;\n";
  }
  const std::string own = joined(option_names(app), " ");
  std::string text = "# Completion of " + program + " for bash.\n" + function +
                     "() {\n  local current=${COMP_WORDS[COMP_CWORD]} words\n";
  if (verbs.empty())
    text += "  words='" + own + "'\n";
  else
    text += "  case ${COMP_WORDS[1]} in\n" + cases + "    *) words='" + own +
            "' ;;\n  esac\n  if [ \"$COMP_CWORD\" -eq 1 ]; then\n" + "    words='" + joined(verbs, " ") + " " + own +
            "'\n    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n    return\n  fi\n";
  text += "  case $current in\n    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$current\")) ;;\n";
  // Leave names of files and folders, also those with blanks, to the completion of bash itself.
  text += "    *) COMPREPLY=() ;;\n  esac\n}\ncomplete -o bashdefault -o default -F " + function + " " + program + "\n";
  return text;
}

std::string zsh_completion(const CLI::App& app) {
  const auto verbs = verbs_of(app);
  std::string text = "#compdef " + app.get_name() + "\n";
  if (verbs.empty()) return text + zsh_arguments(app);
  text += "if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n  local -a verbs=(\n";
  for (const CLI::App* verb : verbs)
    text += "    " + in_single_quotes(verb->get_name() + ":" + zsh_text(summary_of(*verb))) + "\n";
  text += "  )\n  _describe verb verbs\nelse\n  case $words[2] in\n";
  for (const CLI::App* verb : verbs)
    text += "    " + verb->get_name() + ")\n      shift words; (( CURRENT-- ))\n      " + zsh_arguments(*verb) +
            "      ;;\n";
  return text + "    *)\n      " + zsh_arguments(app) + "      ;;\n  esac\nfi\n";
}

namespace {

/// Ends parsing by a CLI::Success, which prints `text`. Requires: `text` ends in a line end, which CLI11 adds again.
[[noreturn]] void answer(std::string text) {
  text.pop_back();
  throw CLI::CallForVersion(text, 0);
}

}  // namespace

void add_manual(CLI::App& app, const std::string& name) {
  app.add_flag_callback(
      "--man", [&app, name] { answer(man_page(app, name)); }, "Print the manual page, for `man -l` and for packages");
  app.add_option_function<std::string>(
         "--completion",
         [&app](const std::string& shell) {
           if (shell == "bash") answer(bash_completion(app));
           if (shell == "zsh") answer(zsh_completion(app));
           throw CLI::ValidationError("--completion", "found " + in_quotes(shell) + ", expected bash or zsh");
         },
         "Print the completion for bash or zsh: source <(" + app.get_name() + " --completion bash)")
      ->type_name("SHELL");
}

}  // namespace rbpa::app
