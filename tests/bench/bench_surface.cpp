// Measures ball pivoting in space, in turn in one process: rbpa::surface(), the policy on the engine, and Open3D.
// docs/reference/performance.md.
//   bench_surface [--points=N] [--runs=N] [--radius=2] [--slow] [--set=NAME] [--growth=N] [--by-processor]
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cmath>
#include <cstdio>

#include "bench/options.h"
#include "bench/peers.h"
#include "bench/process.h"
#include "bench/tables.h"
#include "examples/ball_pivoting.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa_bench {
namespace {

struct Wanted {
  SurfacePoints samples;
  double radius;  ///< in spacings

  double length() const { return radius * samples.spacing; }
};

rbpa::Surface surface_of(const Wanted& wanted, unsigned threads) {
  return rbpa::surface(wanted.samples.points, wanted.samples.normals, wanted.length(), {.threads = threads});
}

/// Runs rbpa::surface(), with arrays as result.
Contestant arrays(const Wanted& wanted, unsigned threads) {
  return {threads == 1 ? "surface" : "surface 2 threads", [&wanted, threads] {
            const Stopwatch watch;
            const rbpa::Surface surface = surface_of(wanted, threads);
            return watch.run(surface.triangles.size());
          }};
}

/// Runs surface_mesh() after rbpa::surface().
Contestant mesh(const Wanted& wanted) {
  return {"surface + mesh", [&wanted] {
            const Stopwatch watch;
            const rbpa::SurfaceMesh made = rbpa::surface_mesh(wanted.samples.points, surface_of(wanted, 1));
            return watch.run(made.mesh.n_faces());
          }};
}

/// Runs the policy of apps/examples/ball_pivoting.h on the advancing front: a mesh.
Contestant on_engine(const Wanted& wanted) {
  return {"on the engine", [&wanted] {
            const Stopwatch watch;
            const rbpa::RollingBall ball(wanted.samples.points, wanted.samples.normals, wanted.length());
            rbpa::Mesh result;
            constexpr std::size_t supply = 4096;
            meshops::Front front(result, wanted.samples.points.size(), supply);
            BallPivoting policy(ball, front, front.next_level().carried);
            meshops::advance(front, policy);
            front.finish();
            return watch.run(result.n_faces());
          }};
}

std::vector<Contestant> contestants(const Wanted& wanted) {
  std::vector<Contestant> all = {arrays(wanted, 1), arrays(wanted, 2), mesh(wanted), on_engine(wanted)};
  if (const auto peer = open3d(wanted.samples, wanted.length())) all.push_back(*peer);
  return all;
}

std::vector<Wanted> all_wanted(std::size_t n, bool slow, double radius, const std::string& set) {
  std::vector<Wanted> all;
  if (slow) {
    for (const SurfacePoints& samples :
         {on_sphere(n, 0), on_scan_lines(n), with_outliers(n), on_street(n), on_grid(n), ten_times(n)})
      for (const double spacings : {1.0, 2.0, 4.0}) all.push_back({samples, spacings});
  } else {
    const SurfacePoints sphere = on_sphere(n, 0), torus = on_double_torus(n), noisy = on_sphere(n, 0.1);
    all = {{sphere, 2}, {sphere, 4}, {torus, 2}, {torus, 4}, {noisy, 2}};
  }
  std::erase_if(all, [&](const Wanted& wanted) {
    return (radius != 0 && radius != wanted.radius) || (!set.empty() && set != wanted.samples.name);
  });
  return all;
}

Contest hold(const Wanted& wanted, const std::vector<Contestant>& all, const Settings& settings) {
  return {wanted.samples.name, text("%g", wanted.radius), wanted.samples.points.size(), in_turn(all, settings)};
}

/// Measures spheres of 100,000 points, twice as many, and so on.
void growth(std::size_t most, const Settings& settings) {
  for (std::size_t count = 100000; count <= most; count *= 2) {
    const Wanted wanted = {on_sphere(count, 0), 2};
    print_times(hold(wanted, {arrays(wanted, 1), arrays(wanted, 2), mesh(wanted)}, settings));
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  double radius = 0;
  std::size_t most = 0;
  std::string set;
  bool by_processor = false, slow = false;
  const Sizes sizes = read_sizes(
      argc, argv, {},
      {{"--slow", &slow, "measure the sets on which a point may cost more: lines, outliers, a street, a grid"},
       {"--set", &set, "measure only this set, such as street"},
       {"--radius", &radius, "measure only this radius, in spacings: 1, 2 or 4"},
       {"--growth", &most, "also measure spheres of 100000 points, twice as many, and so on up to N"},
       {"--by-processor", &by_processor, "measure processor seconds, of all threads"}});
  const std::vector<Wanted> wanted = all_wanted(sizes.points, slow, radius, set);
  if (wanted.empty()) {
    std::fprintf(stderr, "bench_surface: no set has this name, or this radius\n");
    return 2;
  }
  std::printf("%s; %d runs of each in turn after one that does not count; memory stays with the process.\n\n",
              machine().c_str(), sizes.runs);
  std::printf(
      "Nanoseconds a point%s: median (least–most); how many times as long as the first. The radius is in spacings.\n\n",
      by_processor ? ", by the processor's time of all threads" : "");
  std::fflush(stdout);  // otherwise child processes would print it again
  std::vector<double> bytes;
  for (const Wanted& each : wanted)
    for (const Contestant& contestant : contestants(each))
      bytes.push_back(in_child<double>([&] { return rise_of_peak([&] { contestant.run(); }); }).value_or(NAN));
  keep_memory();
  const Settings settings = {.runs = sizes.runs, .warm = true, .by_processor = by_processor};
  std::vector<Contest> contests;
  std::size_t weighed = 0;
  print_head({"points"}, columns({"number", "radius", "triangles"}, contestants(wanted[0])));
  for (const Wanted& each : wanted) {
    contests.push_back(hold(each, contestants(each), settings));
    for (Outcome& outcome : contests.back().outcomes) outcome.bytes = bytes[weighed++];
    print_times(contests.back());
  }
  growth(most, settings);
  print_bytes(contests);
}
