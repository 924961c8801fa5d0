#include "cli/run_options.h"

#include <charconv>
#include <system_error>

#include "io/failure.h"

namespace rbpa::app {

RunOptions parse_run(const RunArguments& arguments) {
  RunOptions options{.quiet = arguments.quiet};
  if (!arguments.threads) return options;
  const std::string& text = *arguments.threads;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, options.threads);
  if (error != std::errc() || end != last || options.threads < 1 || options.threads > most_threads)
    throw WrongUsage("--threads: found " + in_quotes(text) + ", expected a whole number from 1 to " +
                     std::to_string(most_threads));
  return options;
}

}  // namespace rbpa::app
