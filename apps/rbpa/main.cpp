// What: runs the program `rbpa`: reads the command line, and runs a verb.
#include <CLI/App.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "io/bytes/descriptor.h"
#include "io/interrupt.h"
#include "program/exit_code.h"
#include "program/manual.h"
#include "program/narrow_help.h"
#include "program/refuse_arguments.h"
#include "shared/verbs.h"

namespace rbpa::app {
namespace {

constexpr const char* program = "rbpa";

/// Returns the words of the command line in reverse order, as CLI11 parses them. "help VERB" becomes "VERB --help", and
/// "help" alone "--help".
std::vector<std::string> words_of(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  // Accept --remedies, the name of --suggest-repairs in version 0.1.
  std::replace(words.begin(), words.end(), std::string("--remedies"), std::string("--suggest-repairs"));
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    const auto is_asked_for = [&](const CLI::App* verb) { return verb->check_name(words[0]); };
    if (words.empty() || !app.get_subcommands(is_asked_for).empty()) words.push_back("--help");
  }
  std::reverse(words.begin(), words.end());
  return words;
}

int main(int argc, char** argv) {
  occupy_standard_streams();
  catch_interrupts();
  CLI::App app("Outlines and triangles of points in the plane, surfaces and solids of points in space", "rbpa");
  app.formatter(std::make_shared<NarrowHelp>());
  app.set_version_flag("--version", std::string("rbpa ") + RBPA_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  rbpa info points.xy\n"
      "  rbpa shape points.xy --alpha plateau -o outline.geojson\n"
      "  rbpa mesh points.xy --alpha 0.3 -o mesh.ply -o picture.png\n"
      "\n"
      "See `rbpa help VERB` for each verb.");
  MeshArguments mesh;
  ShapeArguments shape;
  StreamArguments stream;
  InfoArguments info;
  AlphaArguments alpha;
  ReportArguments report_page;
  DiscsArguments discs;
  VoronoiArguments voronoi;
  GridArguments grid;
  FillArguments fill;
  SurfaceArguments surface;
  SolidArguments solid;
  BallsArguments balls;
  struct Verb {
    const CLI::App* declared;
    std::function<void()> run;
  };
  const std::vector<Verb> verbs = {{add_mesh(app, mesh), [&] { run_mesh(mesh); }},
                                   {add_alpha(app, alpha), [&] { run_alpha(alpha); }},
                                   {add_shape(app, shape), [&] { run_shape(shape); }},
                                   {add_discs(app, discs), [&] { run_discs(discs); }},
                                   {add_voronoi(app, voronoi), [&] { run_voronoi(voronoi); }},
                                   {add_grid(app, grid), [&] { run_grid(grid); }},
                                   {add_fill(app, fill), [&] { run_fill(fill); }},
                                   {add_surface(app, surface), [&] { run_surface(surface); }},
                                   {add_solid(app, solid), [&] { run_solid(solid); }},
                                   {add_balls(app, balls), [&] { run_balls(balls); }},
                                   {add_stream(app, stream), [&] { run_stream(stream); }},
                                   {add_info(app, info), [&] { run_info(info); }},
                                   {add_report(app, report_page), [&] { run_report(report_page); }}};
  add_manual(app, std::string("rbpa ") + RBPA_VERSION);
  try {
    app.parse(words_of(app, argc, argv));
  } catch (const CLI::Success& e) {  // help, version, manual page or completion
    std::ostringstream text, nothing;
    app.exit(e, text, nothing);
    return run(program, [&] { print(text.str()); });
  } catch (const CLI::ParseError& e) {
    return refuse_arguments(app, e);
  }
  const auto chosen =
      std::find_if(verbs.begin(), verbs.end(), [](const Verb& verb) { return verb.declared->parsed(); });
  return run(program, chosen->run);  // chosen is never the end: a verb is required
}

}  // namespace
}  // namespace rbpa::app

int main(int argc, char** argv) {
  int code = 0;
  // Declare the options within run(), which reports an exhausted memory.
  const int failed = rbpa::app::run(rbpa::app::program, [&] { code = rbpa::app::main(argc, argv); });
  return failed != 0 ? failed : code;
}
