// What: one run of a program: its inputs and outputs, and the files that it leaves when it is hindered.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/child.h"
#include "support/program.h"

namespace robustness {

/// A command of a verb. Words that begin with '%' are names in the folder of the run.
struct Run {
  std::string name;
  std::string program;
  std::vector<std::string> arguments;
  std::string input;                 ///< the file it reads
  std::vector<std::string> outputs;  ///< the files it writes
};

/// Returns two runs for each verb of both programs: into files, and to standard output.
std::vector<Run> runs_into_files();
std::vector<Run> runs_to_standard_output();

/// The input of all runs: enough for a tenth of a second of work.
void make_inputs(const apps_test::Folder& folder);

apps_test::Child::Command command_of(const Run& run, const apps_test::Folder& folder);

/// An undisturbed run, of the whole input or of its first half, which it may refuse.
struct Reference {
  double seconds = 0;
  bool is_done = false;
  std::map<std::string, std::string> outputs = {};  ///< contents by name
  std::string printed = {};                         ///< standard output
};
enum class Input { whole, half };
const Reference& reference_of(const Run& run, Input input = Input::whole);

/// Cuts the input of a run in half.
void shorten(const std::string& path);

}  // namespace robustness
