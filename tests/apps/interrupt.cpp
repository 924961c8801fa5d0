// Ctrl-C leaves nothing behind.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/arguments.h"
#include "support/child.h"
#include "support/las_file.h"
#include "support/laz_file.h"
#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;

namespace {

void send(int pipe, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = write(pipe, bytes.data() + sent, bytes.size() - sent);
    REQUIRE(n > 0);
    sent += static_cast<std::size_t>(n);
  }
}

/// Runs the command that `command_for(folder)` gives, whose input is the named pipe `pipe_name`. `send_input(pipe)`
/// writes; the signal comes while the pipe is still open, or right after it was closed.
void stops(int sig, bool input_ends, const std::string& pipe_name,
           const std::function<std::vector<std::string>(const Folder&)>& command_for,
           const std::function<void(int)>& send_input) {
  CAPTURE(sig);
  CAPTURE(input_ends);
  const Folder folder;
  REQUIRE(mkfifo(folder.path(pipe_name).c_str(), 0600) == 0);
  Child child(command_for(folder));
  // Opening waits for the program to read.
  const int pipe = open(folder.path(pipe_name).c_str(), O_WRONLY);
  REQUIRE(pipe >= 0);
  send_input(pipe);
  // The pipe is open until the signal is sent: the program is reading, or has just begun to compute.
  if (input_ends) close(pipe);
  child.send(sig);
  CHECK(child.wait() == Ending{130, 0});
  if (!input_ends) close(pipe);
  CHECK(folder.names() == std::vector<std::string>{pipe_name});
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}
/// Returns the processor time of all children that have ended.
double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}
/// Returns the processor time of a running process; nothing after it has ended.
std::optional<double> seconds_of(pid_t id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  std::stringstream text;
  text << file.rdbuf();
  const std::string stat = text.str();
  const auto name_end = stat.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(stat.substr(name_end + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0, system = 0;
  if (!(fields >> user >> system) || contains(stat, ") Z ")) return std::nullopt;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Returns the processor time that the command takes after a signal, which is sent when it has had `at` seconds;
/// nothing if it ends before.
std::optional<double> seconds_after_signal(const std::vector<std::string>& command, double at) {
  const double before = seconds_of_children();
  Child child(command);
  std::optional<double> had;
  do {
    usleep(1000);
    had = seconds_of(child.id());
  } while (had && *had < at && !child.has_ended());
  if (!had || child.has_ended()) return std::nullopt;
  child.send(SIGSTOP);  // so that it gets no processor between the two lines that follow
  had = seconds_of(child.id());
  child.send(SIGTERM);
  child.send(SIGCONT);
  const Ending ending = child.wait();
  const double all = seconds_of_children() - before;
  if (!had || ending != Ending{130, 0}) return std::nullopt;  // it was about to end
  return std::max(all - *had, 0.0);
}

/// Returns points of a unit sphere along a spiral, as lines.
std::string sphere(int count) {
  std::string text;
  for (const rbpa::Point3& p : rbpa_test::spiral(count)) text += rbpa_test::text_of(p) + "\n";
  return text;
}

/// Returns triangles on one edge, around one point, in a ring with two huge holes, or each by itself.
std::string mesh(const std::string& kind, int count) {
  std::string text;
  const auto corner = [&](double size, int i, double z) {
    const double turn = 2 * std::acos(-1.0) * i / count;
    text += "v " + std::to_string(size * std::cos(turn)) + " " + std::to_string(size * std::sin(turn)) + " " +
            std::to_string(z) + "\n";
  };
  text += "v 0 0 0\nv 0 0 1\n";
  for (int i = 0; i < count; ++i) {
    corner(1, i, 0.5);
    if (kind == "ring") corner(2, i, 0.5);
    if (kind == "each") corner(1, i + 1, 0.4);
  }
  const auto face = [&](int a, int b, int c) {
    text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  };
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    if (kind == "edge") face(1, 2, i + 3);
    if (kind == "point") face(1, i + 3, next + 3);
    if (kind == "each") face(1, 2 * i + 3, 2 * i + 4);
    if (kind != "ring") continue;
    face(2 * i + 3, 2 * i + 4, 2 * next + 4);
    face(2 * i + 3, 2 * next + 4, 2 * next + 3);
  }
  return text;
}

}  // namespace

#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
constexpr double longest = 0.3;  // seconds
#else
constexpr double longest = 3;
#endif

TEST_CASE("a program ends within 0.3 seconds of processor time after a signal at any moment, on sets made to be slow") {
  const Folder folder;
  const int more = rbpa_test::all_trials() ? 5 : 1, moments = rbpa_test::all_trials() ? 10 : 2;
  folder.file("sphere.xyz", sphere(8000 * more));
  const std::string findings = RBPA_TEST_DATA "/findings/scan_hang/";
  std::vector<std::vector<std::string>> commands;
  const auto rbpa = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), RBPA_PROGRAM);
    arguments.insert(arguments.end(), {"--threads", "1"});
    commands.push_back(std::move(arguments));
  };
  for (const std::string& points : {findings + "skew300.xyz", findings + "moment300.xyz", folder.path("sphere.xyz")}) {
    rbpa({"surface", points, "--radius", "auto", "--watertight", "--refine", "-o", folder.path("m.ply")});
    rbpa({"surface", points, "--radius", "auto", "--suggest-repairs", "-o", folder.path("m.off"), "--json"});
    rbpa({"surface", points, "--radius", "auto", "--normals", "none", "--shell", "outer", "-o", folder.path("m.off")});
    rbpa({"solid", points, "--alpha", "auto", "-o", folder.path("s.vtu"), "--boundary", folder.path("b.off")});
    rbpa({"alpha", points, "--dimension", "3", "--persistence", "--json"});
    rbpa({"balls", points, "--radius-default", "1", "-o", folder.path("b.csv"), "--contacts", folder.path("c.csv")});
  }
  for (const std::string kind : {"edge", "point", "ring", "each"}) {
    const std::string path = folder.file(kind + ".obj", mesh(kind, 3000 * more));
    commands.push_back({MESHTOPO_PROGRAM, path, "-q", "--repair", folder.path("r.off"), "--fill-holes", "rims",
                        "--generators", folder.path("g.obj"), "--shortest"});
    commands.push_back({MESHTOPO_PROGRAM, path, "-q", "--weld", "1e-6", "--orient", "--keep-largest", "2", "-o",
                        folder.path("w.off")});
  }
  // Points on one line, pictures of up to 10^8 pixels, texts that are longer than any buffer, a grid with all its equal
  // spheres, and a polygon of very many corners.
  const std::string width = rbpa_test::all_trials() ? "8192" : "3000";
  const std::size_t many = std::size_t{100'000} * static_cast<std::size_t>(more);
  std::string line;
  for (std::size_t i = 0; i < many; ++i) line += std::to_string(i) + " " + std::to_string(3 * i) + "\n";
  rbpa({"mesh", folder.file("line.xy", line), "--alpha", "1", "-o", folder.path("l.ply")});
  rbpa({"surface", folder.path("sphere.xyz"), "--radius", "auto", "-o", folder.path("s.png"), "--width", width});
  rbpa({"mesh", folder.path("sphere.xyz"), "--alpha", "inf", "-o", folder.path("p.png"), "--width", width});
  rbpa({"discs", folder.path("sphere.xyz"), "--radius", "0.02", "--corners", "1000", "-o", folder.path("d.wkt")});
  rbpa({"voronoi", folder.path("sphere.xyz"), "-o", folder.path("v.wkt")});
  rbpa({"grid", folder.path("sphere.xyz"), "--cell", "0.001", "-o", folder.path("g.asc")});
  rbpa({"grid", folder.path("sphere.xyz"), "--contours", "every:0.002", "-o", folder.path("g.wkt")});
  const std::string long_text(40'000'000, 'a'), triangle = "0,0\n1,0\n0,1\n";
  rbpa({"info", folder.file("comment.xy", "# " + long_text + "\n" + triangle)});
  rbpa({"info", folder.file("field.csv", "x,y," + long_text + "\n" + triangle)});
  rbpa({"info", folder.file("text.geojson", "{\"x\":\"" + long_text + "\",\"type\":\"Point\",\"coordinates\":[1,2]}")});
  std::string cube, ring;
  for (int i = 0; i < 4000 * more; ++i)
    cube += std::to_string(i % 20) + " " + std::to_string(i / 20 % 20) + " " + std::to_string(i / 400) + "\n";
  rbpa({"alpha", folder.file("cube.xyz", cube), "--dimension", "3", "--persistence", "--json"});
  for (std::size_t i = 0; i <= many; ++i) {
    const double turn = 2 * std::acos(-1.0) * static_cast<double>(i % many) / static_cast<double>(many);
    const double radius = 1 + 0.3 * std::sin(1000 * turn);
    ring +=
        (i == 0 ? "" : ", ") + std::to_string(radius * std::cos(turn)) + " " + std::to_string(radius * std::sin(turn));
  }
  commands.push_back({RBPA_PROGRAM, "fill", folder.file("star.wkt", "POLYGON((" + ring + "))"), "--size", "0.1",
                      "--keep-boundary", "-o", folder.path("f.ply")});
  commands.push_back(
      {MESHTOPO_PROGRAM, folder.path("ring.obj"), "-q", "--decimate", "100", "-o", folder.path("d.ply")});
  LasFile las{.points = std::vector<LasPoint>(5 * many)};
  for (std::size_t i = 0; i < las.points.size(); ++i) las.points[i].x = static_cast<std::int32_t>(i * i % 100'000);
  const std::string laz =
      laz_of(bytes_of(las), {.items = {{0, 20, 2}}, .chunks = std::vector<std::size_t>(50, many / 10)});
  commands.push_back({RBPA_PROGRAM, "info", folder.file("p.laz", laz), "--threads", "2"});
  for (const auto& command : commands) {
    const std::string name = command[1] + " " + command[2];
    CAPTURE(name);
    const double before = seconds_of_children();
    {
      Child whole(command);
      whole.wait();
    }
    const double all = seconds_of_children() - before;
    for (int i = 0; i < moments; ++i)
      if (const auto after = seconds_after_signal(command, all * (i + 0.5) / moments)) CHECK(*after < longest);
  }
}

TEST_CASE("a signal while points are read or triangles made ends a run of either method") {
  for (const int sig : {SIGINT, SIGTERM, SIGHUP})
    for (const auto& [method, all_points_sent] : {std::pair{"rbpa", false}, {"rbpa", true}, {"hrbpa", true}})
      stops(
          sig, all_points_sent, "pipe.f64xy",
          [&, method = method](const Folder& folder) -> std::vector<std::string> {
            return {RBPA_PROGRAM, "mesh", folder.path("pipe.f64xy"), "--alpha", "inf", "--method",
                    method,       "-o",   folder.path("m.off")};
          },
          [&, all_points_sent = all_points_sent](int pipe) {
            // Enough points for several seconds of work.
            std::string chunk(1 << 20, '\0');
            unsigned state = 1;
            double* values = reinterpret_cast<double*>(chunk.data());
            for (int block = 0; block < (all_points_sent ? 64 : 2); ++block) {
              for (std::size_t i = 0; i < chunk.size() / sizeof(double); ++i)
                values[i] = static_cast<double>(state = state * 1664525u + 1013904223u);
              send(pipe, chunk);
            }
          });
}

TEST_CASE("a signal while the output waits for its reader ends a run of several threads") {
  const Folder folder;
  std::string points(1 << 20, '\0');
  unsigned state = 1;
  double* values = reinterpret_cast<double*>(points.data());
  for (std::size_t i = 0; i < points.size() / sizeof(double); ++i) values[i] = state = state * 1664525u + 1013904223u;
  folder.file("p.f64xy", points);
  REQUIRE(mkfifo(folder.path("pipe.off").c_str(), 0600) == 0);
  for (const int sig : {SIGINT, SIGTERM, SIGHUP}) {
    Child child({RBPA_PROGRAM, "mesh", folder.path("p.f64xy"), "--alpha", "inf", "-o", folder.path("pipe.off")});
    const int pipe = open(folder.path("pipe.off").c_str(), O_RDONLY);
    REQUIRE(pipe >= 0);
    // While bytes arrive, the pipe is not full.
    for (int before = -1, now = 0; now != before; usleep(50'000)) {
      before = now;
      REQUIRE(ioctl(pipe, FIONREAD, &now) == 0);
      if (now == 0) before = -1;
    }
    // Sent again, in case the program was about to wait.
    while (!child.has_ended()) {
      child.send(sig);
      usleep(50'000);
    }
    CHECK(child.wait() == Ending{130, 0});
    close(pipe);
  }
  CHECK(folder.names() == std::vector<std::string>{"p.f64xy", "pipe.off"});
}

TEST_CASE("a signal while a mesh is read or its topology computed ends the run") {
  for (const int sig : {SIGINT, SIGTERM, SIGHUP})
    for (const bool all_sent : {false, true})
      stops(
          sig, all_sent, "pipe.obj",
          [](const Folder& folder) -> std::vector<std::string> {
            return {MESHTOPO_PROGRAM, folder.path("pipe.obj"), "--json", "--repair", "-o", folder.path("m.off"),
                    "--generators",   folder.path("loops.obj")};
          },
          [&](int pipe) {
            // A strip of triangles, long enough for a second of work.
            std::string text = "v 0 0 0\nv 0 1 0\n";
            for (int i = 1; i < (all_sent ? 400000 : 1000); ++i) {
              const std::string x = std::to_string(i);
              text += "v " + x + " 0 0\nv " + x + " 1 0\nf -4 -2 -3\nf -3 -2 -1\n";
            }
            send(pipe, text);
          });
}

TEST_CASE("a signal while points in space are read or their surface made ends the run") {
  for (const int sig : {SIGINT, SIGTERM, SIGHUP})
    for (const bool all_sent : {false, true})
      stops(
          sig, all_sent, "pipe.xyz",
          [](const Folder& folder) -> std::vector<std::string> {
            return {RBPA_PROGRAM,         "surface", folder.path("pipe.xyz"), "--radius", "2,3,4", "-o",
                    folder.path("m.off"), "--holes", folder.path("h.obj")};
          },
          [&](int pipe) {
            // A bumpy sheet, large enough for a second of work.
            std::string text;
            for (int i = 0; i < (all_sent ? 400000 : 1000); ++i)
              text += std::to_string(i % 600) + " " + std::to_string(i / 600) + " " + std::to_string(i * 7 % 5) + "\n";
            send(pipe, text);
          });
}
