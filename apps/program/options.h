// What: declares options in one way for all programs. Help, manual page and completions are made from the declarations.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <type_traits>

namespace rbpa::app {

/// Adds an option with a value, which help calls `type`. Help shows the default of a text, unless the text is empty.
template <typename Value>
CLI::Option* add_value(CLI::App& app, const std::string& names, Value& value, const std::string& type,
                       const std::string& what) {
  CLI::Option* const option = app.add_option(names, value, what)->type_name(type);
  if constexpr (std::is_same_v<Value, std::string>) option->capture_default_str();
  return option;
}

/// Adds an option without a value. A value, as in --quiet=7, is refused.
inline CLI::Option* add_switch(CLI::App& app, const std::string& names, bool& flag, const std::string& what) {
  return app.add_flag(names, flag, what)->disable_flag_override();
}

}  // namespace rbpa::app
