// What: what is to be done with the tiles of a run, as lists of commands, a Makefile, and a script for Slurm.
// Law:  the lines of one list may run at the same time and in any order when the lists before it are done; a line that is run
//       again writes the same. Names may have any character but a newline.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stream/manifest.h"
#include "stream/request.h"
#include "stream/scratch.h"

namespace rbpa::app {

struct TaskOptions {
  std::string program = "rbpa";  ///< as a shell finds it
  unsigned threads = 1;          ///< of each task
  unsigned fan_in = 16;          ///< the most partials of one merge, from 2 on
};

struct TaskLists {
  std::uint64_t tasks = 0;
  std::vector<std::string> levels = {};  ///< names of the lists in the folder
};

/// Throws WrongUsage where a name has a newline.
void require_lines(const StreamRequest& request, const TaskOptions& options);

/// Requires that. Throws Failure, Cancelled.
TaskLists write_lists(const StreamRequest& request, const TaskOptions& options, const Scratch& scratch,
                      const Manifest& manifest);

/// Lines to copy that run them.
std::string how_to_run(const std::string& folder);

/// The text as one word of a POSIX shell.
std::string shell_word(const std::string& text);

}  // namespace rbpa::app
