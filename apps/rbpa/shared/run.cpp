#include "shared/run.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "io/failure.h"
#include "io/lowest_values.h"
#include "io/number.h"
#include "shared/point_arguments.h"

namespace rbpa::app {

unsigned RunOptions::threads_or_all() const {
  return threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1U);
}

RunOptions parse_run(const RunArguments& arguments) {
  RunOptions options{.quiet = arguments.quiet, .stats = arguments.stats};
  if (arguments.threads)
    options.threads =
        static_cast<unsigned>(parse_whole("--threads", *arguments.threads, {.least = 1, .greatest = max_threads}));
  return options;
}

PointFile Run::read_points(const PointSource& source) const {
  PointSource limited = source;
  limited.threads = options_.threads;
  PointFile file = read([&] { return rbpa::app::read_points(limited); });
  const auto warn = [&](const std::string& text) { summarize(input_name(source.path) + ": " + text); };
  for (const std::string& text : file.warnings) warn(text);
  require_fields(file.kept, source.keeps, input_name(source.path));
  if (file.heights.differ() && !source.heights && !find_column(file.kept, file.height_name) &&
      !find_column(file.kept, "z"))
    warn("z of " + counted(file.points.size(), "point") +
         " is not used (rbpa mesh keeps heights, rbpa grid interpolates them; rbpa surface and solid work in space)");
  return file;
}

SpacePoints Run::read_points(const SpacePointSource& source) const {
  CloudRequest limited = source.choice;
  limited.threads = options_.threads;
  SpacePoints file = read([&] { return read_space_points(source.path, source.format, limited); });
  warning(file.warnings);
  require_fields(file.kept, source.choice.keeps, input());
  return file;
}

void Run::warning_on_fields(const std::vector<PointColumn>& columns, const std::vector<Target>& targets,
                            std::size_t duplicates) const {
  warning(fields_left_out(columns, targets));
  if (!columns.empty() && duplicates > 0)
    warning(counted(duplicates, "point") + (duplicates == 1 ? " lies" : " lie") +
            " on others: triangles have the fields of the first point of each place");
}

void Run::complete_heights(std::vector<double>& z) const {
  const auto has_none = [](double height) { return !std::isfinite(height); };
  const auto without = static_cast<std::size_t>(std::count_if(z.begin(), z.end(), has_none));
  std::replace_if(z.begin(), z.end(), has_none, 0.0);
  if (without == z.size())
    z.clear();
  else if (without > 0)
    warning(counted(without, "point") + (without == 1 ? " has" : " have") + " no z: 0 is written in its place");
}

void Run::take_lowest_heights(std::span<const Duplicate> duplicates, std::vector<double>& z) const {
  if (z.empty()) return;
  if (const std::size_t places = take_lowest(duplicates, z); places > 0)
    warning(counted(places, "place") + (places == 1 ? " has" : " have") +
            " points of several heights: the lowest counts");
}

void Run::summarize(const std::string& text) const {
  if (!options_.quiet) say("rbpa", text);
}

}  // namespace rbpa::app
