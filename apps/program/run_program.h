// What: runs a program: declares its command line, parses the command line, and returns the exit code.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <vector>

#include "program/exit_code.h"

namespace rbpa::app {

/// A program: its name, its description, and how it declares its command line.
struct Program {
  const char *name, *description;
  /// Declares the command line, and returns the work, which is run after parsing. The work returns an exit code.
  std::function<std::function<ExitCode()>(CLI::App&)> declare;
  /// Changes the words of the command line before they are parsed. May be empty.
  std::function<void(std::vector<std::string>& words, const CLI::App&)> edit = {};
};

/// Runs the program, and returns its exit code. Errors are reported as run() does.
int run_program(const Program& program, int argc, char** argv);

}  // namespace rbpa::app
