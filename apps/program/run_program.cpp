#include "program/run_program.h"

#include <algorithm>
#include <memory>
#include <sstream>

#include "io/bytes/descriptor.h"
#include "io/interrupt.h"
#include "program/manual.h"
#include "program/narrow_help.h"
#include "program/refuse_arguments.h"

namespace rbpa::app {
namespace {

int parse_and_work(const Program& program, int argc, char** argv) {
  CLI::App app(program.description, program.name);
  app.formatter(std::make_shared<NarrowHelp>());
  const std::string version = std::string(program.name) + " " + RBPA_VERSION;
  app.set_version_flag("--version", version);
  const std::function<ExitCode()> work = program.declare(app);
  add_manual(app, version);
  try {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (program.edit) program.edit(words, app);
    std::reverse(words.begin(), words.end());  // the order in which CLI11 parses words
    app.parse(words);
  } catch (const CLI::Success& e) {  // help, version, manual page or completion
    std::ostringstream text, nothing;
    app.exit(e, text, nothing);
    return run(program.name, [&] { print(text.str()); });
  } catch (const CLI::ParseError& e) {
    return refuse_arguments(app, e);
  }
  ExitCode found = done;
  const int code = run(program.name, [&] { found = work(); });
  return code == done ? found : code;
}

}  // namespace

int run_program(const Program& program, int argc, char** argv) {
  occupy_standard_streams();
  catch_interrupts();
  int code = 0;
  // Declare the options within run(), which reports an exhausted memory.
  const int failed = run(program.name, [&] { code = parse_and_work(program, argc, argv); });
  return failed != 0 ? failed : code;
}

}  // namespace rbpa::app
