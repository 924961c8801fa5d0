#include "rbpa/space/balls/measure_solid.h"

#include <cmath>
#include <limits>
#include <utility>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/persistence/choose_solid_alpha.h"
#include "rbpa/space/solid/solid_radii.h"

namespace rbpa {

MeasuredSolid measure_solid(std::span<const Point3> points, const MeasureSolidOptions& options) {
  const bool needs_all = options.alpha.rule != AlphaRule::given || options.full || options.triangulation;
  const bool has_boundary = options.boundary || options.counts || options.components;
  const GoOn go_on = go_on_of(options.progress, points.size());
  const Checkpoint check = checkpoint_of(go_on);
  const auto begin = [&](SolidStep step) {
    if (check) check();
    if (options.on_step) options.on_step(step);
  };

  MeasuredSolid made;
  if (options.on_step) options.on_step(SolidStep::tetrahedra);
  made.alpha = options.alpha.radius;
  made.solid =
      solid(points, needs_all ? std::numeric_limits<double>::infinity() : made.alpha,
            {.neighbors = has_boundary || needs_all, .threads = options.threads, .progress = options.progress});
  if (needs_all) {
    begin(SolidStep::choosing);
    made.triangulation = std::move(made.solid);
    made.radii = circumradii(points, made.triangulation.simplices, options.threads, go_on);
    ChosenSolidAlpha chosen =
        choose_solid_alpha(options.alpha, points, made.triangulation, made.radii, go_on, options.threads);
    made.alpha = chosen.alpha;
    made.plateaus = std::move(chosen.plateaus);
    made.solid = within(made.triangulation, made.radii, made.alpha, options.threads);
  }
  if (has_boundary) {
    begin(SolidStep::boundary);
    made.boundary = solid_boundary(made.solid, options.threads);
  }
  if (options.counts || options.full || options.components) begin(SolidStep::counting);
  CheckpointOfThreads checkpoint(go_on);
  const GoOn goes_on = [&] { return checkpoint.goes_on(); };
  Voids of_solid;
  FullTopology full;
  Threads threads = threads_for(points.size(), options.threads);
  for_each_index(threads, 4, [&](std::size_t task) {
    checkpoint();
    if (task == 0 && options.full)
      full = full_topology(points, made.triangulation, made.radii, made.alpha, options.threads, goes_on);
    if (task == 1 && options.counts) of_solid = voids(points, made.solid, made.boundary);
    if (task == 2 && options.components) made.components = solid_components(points, made.solid, made.boundary).all;
    if (task == 3 && options.counts) made.measures = measure(points, made.boundary.surface);
  });
  made.counts = of_solid.counts;
  if (options.full) made.full = full.counts;
  made.voids = std::move(options.full ? full.voids.all : of_solid.all);
  made.full_void_boundary = std::move(full.voids.boundary);
  if (options.balls && std::isfinite(made.alpha)) {
    begin(SolidStep::balls);
    made.balls = union_of_balls(points, made.alpha, {.threads = options.threads, .progress = on_progress_of(go_on)});
  }
  return made;
}

}  // namespace rbpa
