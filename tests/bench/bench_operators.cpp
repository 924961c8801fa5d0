// Measures the operators of libmeshops, OpenMesh and CGAL at the same sites of the same mesh. Times are processor times
// per operation. All contestants of an operation must leave the same mesh; otherwise nothing is measured.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/operator_contest.h"

namespace meshops_bench {
namespace {

constexpr int passes = 3;  // per repetition

void measure(benchmark::State& state, const Entry& entry, const Task& task) {
  const auto contestant = entry.make(task);
  contestant->pass();  // allocates memory before the passes that count
  for ([[maybe_unused]] const auto _ : state)
    state.SetIterationTime(contestant->pass() / static_cast<double>(task.steps));
}

std::ostream& operator<<(std::ostream& out, const Shape& shape) {
  return out << shape.vertices << " vertices, " << shape.edges << " edges, " << shape.faces
             << " faces, sum of triangles " << shape.triangles;
}

/// Returns whether two results agree. Sewing leaves one vertex of two, and each contestant may leave another one.
bool agree(Operation operation, Shape a, Shape b) {
  if (operation == Operation::sew_curves) a.triangles = b.triangles = 0;
  return a == b;
}

/// Returns whether all leave the same mesh. Names those that do not on standard error.
bool verify(const std::string& name, const std::vector<Entry>& entries, const Task& task) {
  std::optional<Shape> expected;
  bool same = true;
  for (const Entry& entry : entries) {
    const auto contestant = entry.make(task);
    contestant->pass();
    const Shape shape = contestant->shape();
    if (!expected) expected = shape;
    if (agree(task.operation, shape, *expected)) continue;
    same = false;
    std::cerr << name << ": " << entries.front().name << " leaves " << *expected << "; " << entry.name << " leaves "
              << shape << '\n';
  }
  return same;
}

std::vector<Entry> all_entries(Operation operation) {
  std::vector<Entry> entries = meshops_entries(operation);
  for (auto more : {openmesh_entries, cgal_entries})
    for (Entry& entry : more(operation)) entries.push_back(entry);
  return entries;
}

/// Contest that is made when first needed and kept to the end: with a filter, only the selected contests are made.
struct Contest {
  std::string name;
  Operation operation;
  Ground ground;
  std::optional<Task> task;
  bool sound = false;

  bool ready() {
    if (!task) {
      task = make_task(operation, ground);
      sound = verify(name, all_entries(operation), *task);
    }
    return sound;
  }
};

void add(Operation operation, Ground ground) {
  static std::map<std::pair<Operation, Ground>, Contest> contests;
  Contest& contest = contests[{operation, ground}];
  contest = {std::string(name(operation)) + "/" + std::string(name(ground)), operation, ground, {}, false};
  for (const Entry& entry : all_entries(operation))
    benchmark::RegisterBenchmark((contest.name + "/" + std::string(entry.name)).c_str(),
                                 [entry, &contest](benchmark::State& state) {
                                   if (contest.ready())
                                     measure(state, entry, *contest.task);
                                   else
                                     state.SkipWithError("the contestants do not leave the same mesh");
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kNanosecond)
        ->Iterations(passes);
}

void add_all() {
  for (const Operation operation :
       {Operation::split_edge, Operation::split_face, Operation::flip, Operation::collapse, Operation::split_vertex,
        Operation::open_curve, Operation::close_curve, Operation::unglue, Operation::glue, Operation::build_mesh})
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
