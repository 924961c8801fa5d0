// What: runs a program by the shell and returns its output.
#pragma once

#include <doctest/doctest.h>
#include <stdio.h>
#include <sys/wait.h>

#include <string>

namespace rbpa_bench {

struct Report {
  int code;
  std::string text;  ///< standard output and standard error
};

inline Report run(const std::string& program, const std::string& arguments) {
  FILE* const pipe = popen(("'" + program + "' " + arguments + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  char part[4096];
  for (std::size_t size; (size = fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, size);
  return {WEXITSTATUS(pclose(pipe)), text};
}

}  // namespace rbpa_bench
