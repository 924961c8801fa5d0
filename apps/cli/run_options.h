// What: how a verb runs, which changes nothing of what it makes.
#pragma once

#include <optional>
#include <string>

namespace rbpa::app {

/// What the command line says, as text.
struct RunArguments {
  std::optional<std::string> threads;
  bool quiet = false;
};

struct RunOptions {
  unsigned threads = 0;  ///< at most so many work; 0: as many as there are processors
  bool quiet = false;
};

/// The most that --threads takes: more than processors, so that a command line may be the same on any machine.
constexpr unsigned max_threads = 1024;

/// `threads`: a whole number from 1 to max_threads. Throws WrongUsage naming the value.
RunOptions parse_run(const RunArguments& arguments);

}  // namespace rbpa::app
