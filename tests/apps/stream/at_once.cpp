// Runs that share a folder do not hinder each other, and leave nothing behind.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "robustness/moments.h"
#include "support/child.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
namespace fs = std::filesystem;

namespace {

void make_input(const Folder& folder, std::size_t count) {
  rbpa_test::Random random(41);
  std::vector<double> values(2 * count);
  for (double& value : values) value = double(random.below(10'000)) / 100;
  folder.file("a.f64xy", {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
}

Child::Command command(const Folder& folder, const std::string& target, const std::vector<std::string>& more = {}) {
  Child::Command words = {RBPA_PROGRAM, "stream", folder.path("a.f64xy"), "--alpha",   "2", "--tile-size",
                          "500",        "-o",     folder.path(target),    "--threads", "1", "-q"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Returns the number of a process that has ended.
pid_t dead_process() {
  Child child({"/bin/true"});
  child.wait();
  return child.id();
}

}  // namespace

TEST_CASE("twelve runs at once in one folder, next to the leftovers of dead ones, all finish and leave nothing") {
  const Folder folder;
  make_input(folder, 2000);
  Child alone(command(folder, "t.npy"));
  REQUIRE(alone.wait() == Ending{0, 0});
  const std::string wanted = folder.content("t.npy");
  const int rounds = robustness::moments() > 8 ? 25 : 2;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    const std::string dead = ".rbpa-stream-" + std::to_string(dead_process());
    fs::create_directories(folder.path(dead + "/tiles"));
    folder.file(dead + "/lock", "");
    fs::create_directory(folder.path(dead + "-01234567"));
    std::vector<std::unique_ptr<Child>> runs;
    for (int i = 0; i < 12; ++i)
      runs.push_back(std::make_unique<Child>(command(folder, "t" + std::to_string(i) + ".npy"), [&] {
        redirect(STDERR_FILENO, folder.path("said"), O_WRONLY | O_CREAT | O_APPEND);
      }));
    for (const auto& run : runs) CHECK(run->wait() == Ending{0, 0});
    CHECK(folder.content("said") == "");
    for (int i = 0; i < 12; ++i) {
      const std::string name = "t" + std::to_string(i) + ".npy";
      CHECK(folder.content(name) == wanted);
      fs::remove(folder.path(name));
    }
    fs::remove(folder.path("said"));
    CHECK(folder.names() == std::vector<std::string>{"a.f64xy", "t.npy"});
  }
}

TEST_CASE("a folder of a process with the same number, as in another container, hinders no run") {
  const Folder folder;
  make_input(folder, 2000);
  std::string other;
  Child child(command(folder, "t.npy"), [&] {
    const std::string mine = folder.path(".rbpa-stream-" + std::to_string(getpid()));
    fs::create_directory(mine);
    const int lock = open((mine + "/lock").c_str(), O_RDWR | O_CREAT, 0666);  // open in the program as well
    if (flock(lock, LOCK_EX | LOCK_NB) != 0) _exit(99);
  });
  other = ".rbpa-stream-" + std::to_string(child.id());
  CHECK(child.wait() == Ending{0, 0});
  CHECK(folder.names() == std::vector<std::string>{other, "a.f64xy", "t.npy"});
}

TEST_CASE("a run killed while the scratch is made leaves nothing that the next does not remove") {
  const Folder folder;
  make_input(folder, 2000);
  const std::vector<std::string> more = {"--scratch", folder.path("s"), "--resume"};
  const auto check = [&] {
    Child child(command(folder, "t.npy", more));
    CHECK(child.wait() == Ending{0, 0});
    CHECK(folder.names() == std::vector<std::string>{"a.f64xy", "t.npy"});
  };
  // The folder as it is between two steps.
  fs::create_directory(folder.path("s.rbpa-new"));
  check();
  folder.file("s.rbpa-new/created", (fs::create_directory(folder.path("s.rbpa-new")), ""));
  check();
  fs::create_directory(folder.path("s"));
  folder.file("s/created", "");
  check();
  fs::create_directories(folder.path("s/tiles"));
  folder.file("s/created", "");
  folder.file("s/lock", "");
  check();
  // Also at random early moments.
  std::mt19937 random(42);
  const int kills = robustness::moments() > 8 ? 300 : 16;
  for (int kill = 0; kill < kills; ++kill) {
    CAPTURE(kill);
    Child child(command(folder, "t.npy", more));
    usleep(static_cast<useconds_t>(random() % 12'000));
    child.send(SIGKILL);
    child.wait();
    if (kill % 4 == 3) check();
  }
  check();
}

TEST_CASE("an empty folder that a user has made stays, whatever a run does in it") {
  const Folder folder;
  make_input(folder, 2000);
  fs::create_directory(folder.path("s"));
  Child child(command(folder, "t.npy", {"--scratch", folder.path("s")}));
  CHECK(child.wait() == Ending{0, 0});
  CHECK(folder.names() == std::vector<std::string>{"a.f64xy", "s", "t.npy"});
  CHECK(fs::is_empty(folder.path("s")));
}
