// What a person at a terminal sees.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;

namespace {

/// Runs `rbpa ARGUMENTS` with a terminal as standard error; returns all that appears there.
std::string seen_on_terminal(std::vector<std::string> command) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(terminal >= 0);
  REQUIRE(grantpt(terminal) == 0);
  REQUIRE(unlockpt(terminal) == 0);
  const std::string name = ptsname(terminal);
  command.insert(command.begin(), RBPA_PROGRAM);
  const pid_t child = fork();
  if (child == 0) {
    dup2(open("/dev/null", O_WRONLY), 1);
    dup2(open(name.c_str(), O_WRONLY | O_NOCTTY), 2);
    std::vector<char*> words;
    for (std::string& word : command) words.push_back(word.data());
    words.push_back(nullptr);
    execv(words[0], words.data());
    _exit(127);
  }
  std::string text;
  char buffer[4096];
  // Once nobody writes any more, reading fails. Before the child has opened it, too.
  for (int status = 0, ended = 0; !ended;) {
    ended = waitpid(child, &status, WNOHANG) == child;
    if (ended) CHECK(WEXITSTATUS(status) == 0);
    for (ssize_t n; (n = read(terminal, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(n));
    usleep(1000);
  }
  close(terminal);
  return text;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Enough points for a sign of life from every part of a run.
std::string many_points() {
  std::string text;
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 150; ++x) text += std::to_string(7 * x + y % 5) + " " + std::to_string(5 * y + x % 3) + "\n";
  return text;
}

}  // namespace

TEST_CASE("every part of a run says on a terminal that it goes on, and leaves nothing there; with --quiet none does") {
  const Folder folder;
  const std::string points = folder.file("p.xy", many_points());
  const std::string gone = "\r\x1b[K";
  const std::string alpha = seen_on_terminal({"alpha", points, "--persistence"});
  CHECK(contains(alpha, "rbpa: "));
  CHECK(contains(alpha, " triangles, "));
  CHECK(contains(alpha, "radii of "));
  CHECK(contains(alpha, "persistence, "));
  CHECK(alpha.ends_with(gone));
  const std::string mesh = seen_on_terminal({"mesh", points, "--alpha", "auto", "--stats", folder.path("s.json")});
  CHECK(contains(mesh, "choosing alpha, "));
  CHECK(seen_on_terminal({"alpha", points, "--persistence", "-q"}).empty());
  CHECK(seen_on_terminal({"mesh", points, "--alpha", "auto", "-q", "--stats", folder.path("s.json")}).empty());
}
