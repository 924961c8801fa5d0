#include "bench/surface_contest.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "bench/shell_run.h"
#include "bench/stopwatch.h"
#include "examples/ball_pivoting.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa_bench {
namespace {

std::string with_threads(const std::string& name, unsigned threads) {
  return threads == 1 ? name : name + " " + std::to_string(threads) + " threads";
}

rbpa::Surface surface_of(const SurfacePoints& samples, double radius, unsigned threads) {
  return rbpa::surface(samples.points, samples.normals, radius, {.threads = threads});
}

Run ended(const Stopwatch& watch, std::size_t triangles) {
  Run run{watch.seconds(), triangles};
  run.processor_seconds = watch.processor_seconds();
  return run;
}

void replace(std::string& text, const std::string& name, const std::string& value) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + value.size()))
    text.replace(at, name.size(), value);
}

void write_ply(const std::filesystem::path& path, const SurfacePoints& samples) {
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << samples.points.size() << "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) file << "property double " << name << "\n";
  file << "end_header\n";
  for (std::size_t i = 0; i < samples.points.size(); ++i)
    for (const rbpa::Point3* p : {&samples.points[i], &samples.normals[i]})
      for (const double coordinate : {p->x, p->y, p->z})
        file.write(reinterpret_cast<const char*>(&coordinate), sizeof coordinate);
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

std::size_t faces_of_ply(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("wrote no mesh");
  std::string line;
  std::getline(file, line);
  if (!line.starts_with("ply")) throw std::runtime_error("wrote something that is not PLY");
  while (std::getline(file, line) && !line.starts_with("end_header")) {
    std::istringstream words(line);
    std::string element, kind;
    std::size_t count = 0;
    if (words >> element >> kind >> count && element == "element" && kind == "face") return count;
  }
  throw std::runtime_error("wrote PLY without faces");
}

}  // namespace

SurfaceContestant surface_with(unsigned threads) {
  return {with_threads("surface", threads), [threads](const SurfacePoints& samples, double radius) {
            const Stopwatch watch;
            const rbpa::Surface surface = surface_of(samples, radius, threads);
            return ended(watch, surface.triangles.size());
          }};
}

SurfaceContestant surface_mesh_with(unsigned threads) {
  return {with_threads("surface + mesh", threads), [threads](const SurfacePoints& samples, double radius) {
            const Stopwatch watch;
            const rbpa::SurfaceMesh made = rbpa::surface_mesh(samples.points, surface_of(samples, radius, threads));
            return ended(watch, made.mesh.n_faces());
          }};
}

SurfaceContestant ball_pivoting_on_engine() {
  return {"on the engine", [](const SurfacePoints& samples, double radius) {
            const Stopwatch watch;
            const rbpa::RollingBall ball(samples.points, samples.normals, radius);
            rbpa::Mesh mesh;
            constexpr std::size_t supply = 4096;
            meshops::Front front(mesh, samples.points.size(), supply);
            BallPivoting policy(ball, front, front.next_level().carried);
            meshops::advance(front, policy);
            front.finish();
            return ended(watch, mesh.n_faces());
          }};
}

SurfaceContestant surface_program(const std::string& name, const std::string& command) {
  for (const char* needed : {"{in}", "{out}"})
    if (command.find(needed) == std::string::npos)
      throw std::invalid_argument("found '" + command + "', expected a command with " + needed);
  const auto run = [command](const SurfacePoints& samples, double radius) {
    const RunFolder folder;
    const auto in = folder / "points.ply", out = folder / "mesh.ply";
    write_ply(in, samples);
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", radius);
    std::string line = command;
    replace(line, "{in}", quoted(in.string()));
    replace(line, "{out}", quoted(out.string()));
    replace(line, "{radius}", text);
    const ShellRun ended = run_shell(line, folder / "said");
    Run result{ended.seconds, faces_of_ply(out), ended.clock};
    result.process_bytes = ended.peak_bytes;
    return result;
  };
  return {name, run, /*is_exact=*/false, /*is_program=*/true};
}

Contest measure_surface(const SurfacePoints& samples, double radius, const std::vector<SurfaceContestant>& contestants,
                        const Settings& settings) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", radius);
  Contest contest{samples.name, text, samples.points.size(), std::vector<Outcome>(contestants.size())};
  for (std::size_t i = 0; i < contestants.size(); ++i) contest.outcomes[i].contestant = contestants[i].name;
  const auto hold_round = [&](std::size_t round) {
    for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
      const std::size_t i = (turn + round) % contestants.size();
      Outcome& outcome = contest.outcomes[i];
      if (!outcome.failure.empty() || outcome.seconds.sum() > settings.patience) continue;
      try {
        const Run run = contestants[i].run(samples, radius * samples.spacing);
        outcome.seconds.of.push_back(settings.by_processor ? run.processor_seconds.value_or(run.seconds) : run.seconds);
        outcome.triangles = run.triangles;
        outcome.clock = run.clock;
        if (run.process_bytes) outcome.bytes = run.process_bytes;
      } catch (const std::exception& error) {
        outcome.failure = error.what();
      }
    }
  };
  if (settings.warm) {
    hold_round(0);
    for (Outcome& outcome : contest.outcomes)
      if (outcome.seconds.sum() <= settings.patience) outcome.seconds.of.clear();
  }
  for (int round = 0; round < settings.runs; ++round) hold_round(static_cast<std::size_t>(round));
  const Outcome& first = contest.outcomes[0];
  for (std::size_t i = 1; i < contestants.size(); ++i)
    if (Outcome& outcome = contest.outcomes[i];
        contestants[i].is_exact && outcome.failure.empty() && outcome.triangles != first.triangles)
      outcome.wrong = std::to_string(outcome.triangles) + " triangles, expected " + std::to_string(first.triangles);
  return contest;
}

}  // namespace rbpa_bench
