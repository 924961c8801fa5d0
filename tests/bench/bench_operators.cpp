// Measures the operators of libmeshops, OpenMesh and CGAL at the same sites of the same mesh, by Google Benchmark: the
// processor's time per operation. All contestants of an operation must leave the same mesh; otherwise nothing is
// measured.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <deque>
#include <iostream>
#include <optional>
#include <string>

#include "bench/operator_contest.h"

namespace meshops_bench {
namespace {

constexpr int passes = 3;  // per repetition

struct Library {
  const char* name;
  Contestant (*at)(const Task& task);
};
constexpr Library libraries[] = {{"meshops", meshops_at}, {"openmesh", openmesh_at}, {"cgal", cgal_at}};

bool takes_part(const Library& library, Operation operation) {
  return library.at != openmesh_at || operation != Operation::sew_curves;
}

std::ostream& operator<<(std::ostream& out, const Shape& shape) {
  return out << shape.vertices << " vertices, " << shape.edges << " edges, " << shape.faces
             << " faces, sum of triangles " << shape.triangles;
}

/// Contest that is made when first needed and kept to the end: with a filter, only the selected contests are made.
struct Contest {
  std::string name;
  Operation operation;
  Ground ground;
  std::optional<Task> task = {};
  bool sound = true;

  /// Returns whether all leave the same mesh. Names those that do not on standard error.
  bool ready() {
    if (task) return sound;
    task = make_task(operation, ground);
    std::optional<Shape> expected;
    for (const Library& library : libraries) {
      if (!takes_part(library, operation)) continue;
      const Contestant contestant = library.at(*task);
      contestant.pass();
      Shape shape = contestant.shape();
      // Sewing leaves one vertex of two, and each contestant may leave another one.
      if (operation == Operation::sew_curves) shape.triangles = 0;
      if (!expected) expected = shape;
      if (shape == *expected) continue;
      sound = false;
      std::cerr << name << ": " << libraries[0].name << " leaves " << *expected << "; " << library.name << " leaves "
                << shape << '\n';
    }
    return sound;
  }

  void measure(const Library& library, benchmark::State& state) {
    if (!ready()) return state.SkipWithError("the contestants do not leave the same mesh");
    const Contestant contestant = library.at(*task);
    contestant.pass();  // allocates memory before the passes that count
    for ([[maybe_unused]] const auto _ : state)
      state.SetIterationTime(contestant.pass() / static_cast<double>(task->steps));
  }
};

void add(Operation operation, Ground ground) {
  static std::deque<Contest> contests;
  const std::string named = std::string(name(operation)) + "/" + std::string(name(ground));
  Contest& contest = contests.emplace_back(Contest{named, operation, ground});
  for (const Library& library : libraries)
    if (takes_part(library, operation))
      benchmark::RegisterBenchmark((named + "/" + library.name).c_str(),
                                   [&contest, library](benchmark::State& state) { contest.measure(library, state); })
          ->UseManualTime()
          ->Unit(benchmark::kNanosecond)
          ->Iterations(passes);
}

void add_all() {
  for (const Operation operation :
       {Operation::split_edge, Operation::split_face, Operation::flip, Operation::collapse, Operation::split_vertex,
        Operation::open_curve, Operation::close_curve, Operation::build_mesh})
    for (const Ground ground : {Ground::grid, Ground::random}) add(operation, ground);
  for (const Operation operation : {Operation::add_triangles, Operation::sew_curves}) add(operation, Ground::grid);
}

}  // namespace
}  // namespace meshops_bench

int main(int argc, char** argv) {
  // Freed memory is kept: no contestant pays for pages that the system reclaims after every pass.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, 2147483647);
  meshops_bench::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
