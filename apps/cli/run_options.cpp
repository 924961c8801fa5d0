#include "cli/run_options.h"

#include "io/bytes/number.h"

namespace rbpa::app {

RunOptions parse_run(const RunArguments& arguments) {
  RunOptions options{.quiet = arguments.quiet};
  if (arguments.threads)
    options.threads =
        static_cast<unsigned>(parse_whole("--threads", *arguments.threads, {.least = 1, .greatest = max_threads}));
  return options;
}

}  // namespace rbpa::app
