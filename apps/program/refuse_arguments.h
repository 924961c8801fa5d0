// What: reports command lines that CLI11 refuses, in the same words for all programs.
#pragma once

#include <CLI/App.hpp>
#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "io/failure.h"
#include "program/exit_code.h"

namespace rbpa::app {

/// Returns "is it WORD? " for the first of `words` whose beginning agrees longest with `word`; empty if at most half of
/// `word`, or at most one letter after "--", agrees.
inline std::string nearest(const std::string& word, const std::vector<std::string>& words) {
  const auto agreeing = [&](const std::string& known) {
    return std::mismatch(word.begin(), word.end(), known.begin(), known.end()).first - word.begin();
  };
  const auto less = [&](const std::string& a, const std::string& b) { return agreeing(a) < agreeing(b); };
  const auto best = std::max_element(words.begin(), words.end(), less);
  const bool is_near = best != words.end() && 2 * agreeing(*best) > std::ssize(word) &&
                       agreeing(*best) > (word.starts_with("--") ? 3 : 0);
  return is_near ? "is it " + *best + "? " : "";
}

/// Returns the message about an unknown `word` on a command line. `called` is the program, followed by the verb if one
/// is given. An empty `word` means that a verb is missing.
inline std::string unexpected(const std::string& word, const CLI::App& app, const std::string& called) {
  const std::string found = "found " + (word.empty() ? "no verb" : in_quotes(word)) + ", expected ",
                    way = "see " + called + " --help)";
  std::vector<std::string> verbs, options;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back(verb->get_name());
  const auto chosen = app.get_subcommands();
  if (chosen.empty() && !verbs.empty())
    return found + "one of " + listed(verbs, ", ") + " (" + nearest(word, verbs) + way;
  if (!word.starts_with('-')) return found + "no more arguments of " + called + " (" + way;
  for (const CLI::Option* option : (chosen.empty() ? app : *chosen.front()).get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  return found + "an option of " + called + " (" + nearest(word, options) + way;
}

/// Returns a message of CLI11 in our words. The message about a missing value names the expected value; the message
/// about a missing option adds what its description has in the brackets "(required: ...)".
inline std::string in_our_words(std::string message, const CLI::App& verb) {
  constexpr std::string_view value = ": 1 required ", no_value = " missing", no_option = " is required",
                             note = "(required: ", most = ": At Most 1 required but received ";
  if (const std::size_t at = message.find(most); at != std::string::npos)
    return message.replace(at, most.size(), ": found ") + " values, expected one";
  if (const std::size_t at = message.find(value); at != std::string::npos && message.ends_with(no_value)) {
    message.resize(message.size() - no_value.size());
    return message.replace(at, value.size(), ": found no value, expected ");
  }
  const CLI::Option* const option =
      message.starts_with("--") ? verb.get_option_no_throw(message.substr(0, message.find(' '))) : nullptr;
  if (option == nullptr || !message.ends_with(no_option)) return message;
  const std::string description = option->get_description();
  const std::size_t at = description.find(note);
  if (at == std::string::npos) return message;
  const std::size_t begin = at + note.size();
  return message + ": " + description.substr(begin, description.find(')', begin) - begin);
}

/// Prints on standard error why `app` refused the command line with `error`, and returns wrong_usage.
inline int refuse_arguments(const CLI::App& app, const CLI::ParseError& error) {
  const auto verbs = app.get_subcommands();
  const std::string called = app.get_name() + (verbs.empty() ? "" : " " + verbs.front()->get_name());
  // Report an unknown word first: a required option may be missing because its name is misspelled.
  const std::vector<std::string> unknown = app.remaining(true);
  const bool lacks_verb = verbs.empty() && app.get_require_subcommand_min() > 0 &&
                          dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (!unknown.empty() || lacks_verb)
    return report(app.get_name(), unexpected(unknown.empty() ? "" : unknown.front(), app, called), wrong_usage);
  return report(app.get_name(),
                in_our_words(error.what(), verbs.empty() ? app : *verbs.front()) + " (see " + called + " --help)",
                wrong_usage);
}

}  // namespace rbpa::app
