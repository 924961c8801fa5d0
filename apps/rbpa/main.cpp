// What: runs the program `rbpa`: reads the command line, and runs a verb.
#include <CLI/App.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "program/run_program.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

struct Verb {
  const CLI::App* declared;
  std::function<void()> run;
};

template <typename Arguments>
Verb verb(CLI::App& app, CLI::App* (*add)(CLI::App&, Arguments&), void (*run)(const Arguments&)) {
  const auto arguments = std::make_shared<Arguments>();
  return {add(app, *arguments), [=] { run(*arguments); }};
}

std::function<ExitCode()> declare(CLI::App& app) {
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  rbpa info points.xy\n"
      "  rbpa shape points.xy --alpha plateau -o outline.geojson\n"
      "  rbpa mesh points.xy --alpha 0.3 -o mesh.ply -o picture.png\n"
      "\n"
      "See `rbpa help VERB` for each verb.");
  const std::vector<Verb> verbs = {
      verb(app, add_mesh, run_mesh),    verb(app, add_alpha, run_alpha),     verb(app, add_shape, run_shape),
      verb(app, add_discs, run_discs),  verb(app, add_voronoi, run_voronoi), verb(app, add_grid, run_grid),
      verb(app, add_fill, run_fill),    verb(app, add_surface, run_surface), verb(app, add_solid, run_solid),
      verb(app, add_balls, run_balls),  verb(app, add_stream, run_stream),   verb(app, add_info, run_info),
      verb(app, add_report, run_report)};
  return [verbs] {
    for (const Verb& verb : verbs)
      if (verb.declared->parsed()) verb.run();  // one is: a verb is required
    return done;
  };
}

/// Turns "help VERB" into "VERB --help", and "help" alone into "--help".
void edit(std::vector<std::string>& words, const CLI::App& app) {
  // Accept --remedies, the name of --suggest-repairs in version 0.1.
  std::replace(words.begin(), words.end(), std::string("--remedies"), std::string("--suggest-repairs"));
  if (words.empty() || words[0] != "help") return;
  words.erase(words.begin());
  const auto is_asked_for = [&](const CLI::App* verb) { return verb->check_name(words[0]); };
  if (words.empty() || !app.get_subcommands(is_asked_for).empty()) words.push_back("--help");
}

}  // namespace
}  // namespace rbpa::app

int main(int argc, char** argv) {
  return rbpa::app::run_program(
      {.name = "rbpa",
       .description = "Outlines and triangles of points in the plane, surfaces and solids of points in space",
       .declare = rbpa::app::declare,
       .edit = rbpa::app::edit},
      argc, argv);
}
