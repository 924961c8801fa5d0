// What: the verbs of `rbpa` as the command line declares them: options, help and examples.
// Law:  each adds its verb to the program and returns it; what the command line says of it is in the arguments once it is parsed,
//       and judged by the verb itself.
#pragma once

#include <CLI/App.hpp>

#include "cli/alpha_verb.h"
#include "cli/fill_verb.h"
#include "cli/info_verb.h"
#include "cli/merge_verb.h"
#include "cli/mesh_verb.h"
#include "cli/report_verb.h"
#include "cli/shape_verb.h"
#include "cli/stream_arguments.h"
#include "cli/stream_verb.h"
#include "cli/surface_verb.h"
#include "cli/tile_verb.h"

namespace rbpa::app {

CLI::App* add_mesh(CLI::App& app, MeshArguments& arguments);
CLI::App* add_alpha(CLI::App& app, AlphaArguments& arguments);
CLI::App* add_shape(CLI::App& app, ShapeArguments& arguments);
CLI::App* add_fill(CLI::App& app, FillArguments& arguments);
CLI::App* add_surface(CLI::App& app, SurfaceArguments& arguments);
CLI::App* add_stream(CLI::App& app, StreamArguments& arguments);
CLI::App* add_tile(CLI::App& app, TileArguments& arguments);
CLI::App* add_merge(CLI::App& app, MergeArguments& arguments);
CLI::App* add_info(CLI::App& app, InfoArguments& arguments);
CLI::App* add_report(CLI::App& app, ReportArguments& arguments);

}  // namespace rbpa::app
