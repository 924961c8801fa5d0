// Ctrl-C leaves nothing behind.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/child.h"
#include "support/program.h"

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
  // Not closed before the signal is sent: the program is then reading, or has just begun to compute.
  if (input_ends) close(pipe);
  child.send(sig);
  CHECK(child.wait() == Ending{130, 0});
  if (!input_ends) close(pipe);
  CHECK(folder.names() == std::vector<std::string>{pipe_name});
}

}  // namespace

TEST_CASE("a signal while points are read, and one while triangles are made, by either method") {
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

TEST_CASE("a signal while the output waits for who reads it, after several threads have worked") {
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
    // As long as bytes come in, the pipe is not full.
    for (int before = -1, now = 0; now != before; usleep(50'000)) {
      before = now;
      REQUIRE(ioctl(pipe, FIONREAD, &now) == 0);
      if (now == 0) before = -1;
    }
    // Once more, should the program have been about to wait.
    while (!child.has_ended()) {
      child.send(sig);
      usleep(50'000);
    }
    CHECK(child.wait() == Ending{130, 0});
    close(pipe);
  }
  CHECK(folder.names() == std::vector<std::string>{"p.f64xy", "pipe.off"});
}

TEST_CASE("a signal while a mesh is read, and one while its topology is computed") {
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

TEST_CASE("a signal while points in space are read, and one while their surface is made") {
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
