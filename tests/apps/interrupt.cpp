// Ctrl-C leaves nothing behind.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "support/program.h"

using namespace apps_test;

namespace {

/// Starts `rbpa mesh`, its points coming from a named pipe.
pid_t start(const Folder& folder) {
  const pid_t child = fork();
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, 2);
    execl(RBPA_PROGRAM, RBPA_PROGRAM, "mesh", folder.path("pipe.f64xy").c_str(), "--alpha", "inf", "-o",
          folder.path("m.off").c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  return child;
}

int exit_code(pid_t child) {
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("a signal while points are read, and one while triangles are made") {
  for (const int sig : {SIGINT, SIGTERM})
    for (const bool all_points_sent : {false, true}) {
      CAPTURE(sig);
      CAPTURE(all_points_sent);
      const Folder folder;
      REQUIRE(mkfifo(folder.path("pipe.f64xy").c_str(), 0600) == 0);
      const pid_t child = start(folder);
      // Opening waits for the program to read. Enough points follow for several seconds of work.
      const int pipe = open(folder.path("pipe.f64xy").c_str(), O_WRONLY);
      REQUIRE(pipe >= 0);
      std::string chunk(1 << 20, '\0');
      unsigned state = 1;
      double* values = reinterpret_cast<double*>(chunk.data());
      for (int block = 0; block < (all_points_sent ? 64 : 2); ++block) {
        for (std::size_t i = 0; i < chunk.size() / sizeof(double); ++i)
          values[i] = static_cast<double>(state = state * 1664525u + 1013904223u);
        for (std::size_t sent = 0; sent < chunk.size();) {
          const ssize_t n = write(pipe, chunk.data() + sent, chunk.size() - sent);
          REQUIRE(n > 0);
          sent += static_cast<std::size_t>(n);
        }
      }
      // Not closed before the signal is sent: the program is then reading, or has just begun to compute.
      if (all_points_sent) close(pipe);
      REQUIRE(kill(child, sig) == 0);
      CHECK(exit_code(child) == 130);
      if (!all_points_sent) close(pipe);
      CHECK(folder.names() == std::vector<std::string>{"pipe.f64xy"});
    }
}
