// The lines that `rbpa stream --tasks` prints, as a user copies them: make, xargs, Slurm; whatever happens on the way.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <random>
#include <sstream>

#include "robustness/moments.h"
#include "support/child.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
namespace fs = std::filesystem;

namespace {

void make_input(const Folder& folder) {
  rbpa_test::Random random(41);
  std::vector<double> values(16'000);
  for (double& value : values) value = double(random.below(10'000)) / 100;
  folder.file("p.f64xy", {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
}

constexpr const char* run_key = "p.f64xy --alpha 1.5 --tile-size 400";

struct Made {
  std::string triangles, polygons;
};

const Made& expected() {
  static const Made made = [] {
    const Folder folder;
    make_input(folder);
    REQUIRE(folder.rbpa(std::string("mesh p.f64xy --alpha 1.5 -q -o t.npy")).code == 0);
    REQUIRE(folder.rbpa(std::string("shape p.f64xy --alpha 1.5 -q -o p.geojson")).code == 0);
    return Made{folder.content("t.npy"), folder.content("p.geojson")};
  }();
  return made;
}

/// What the program prints: a line for each way to run the tasks.
std::vector<std::string> ways(const Folder& folder, const std::string& more) {
  const Outcome outcome = folder.rbpa("stream " + std::string(run_key) + " " + more);
  CHECK(outcome.err.find(" tasks in 3 lists -> ") != std::string::npos);
  REQUIRE(outcome.code == 0);
  std::vector<std::string> lines;
  std::istringstream text(outcome.out);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  REQUIRE(lines.size() == 4);
  return lines;
}

Outcome shell(const Folder& folder, const std::string& line) {
  folder.file("line.sh", line + "\n");
  return folder.run("sh", "line.sh");
}

void check_made(const Folder& folder, const std::string& where = "") {
  CHECK(folder.content(where + "t.npy") == expected().triangles);
  CHECK(folder.content(where + "p.geojson") == expected().polygons);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("make runs the tasks under difficult names, and repeats only missing ones") {
  const Folder folder;
  make_input(folder);
  const std::string odd = "a b'c$x#y:z%(\\é,";
  fs::create_directory(folder.path(odd));
  const std::string quoted = "\"a b'c\\$x#y:z%(\\\\é,\"";
  const auto lines = ways(
      folder, "--tasks " + quoted + "/T -o " + quoted + "/t.npy -o " + quoted + "/p.geojson -o " + quoted + "/'*.ply'");
  Outcome outcome = shell(folder, lines[0]);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  check_made(folder, odd + "/");
  CHECK(folder.has(odd + "/000000.ply"));
  outcome = shell(folder, lines[0]);
  CHECK(count_of(outcome.out, "/rbpa ") == 0);

  fs::remove(folder.path(odd + "/p.geojson"));
  outcome = shell(folder, lines[0]);
  CHECK(count_of(outcome.out, "/rbpa ") == 1);
  check_made(folder, odd + "/");

  fs::remove(folder.path(odd + "/T/partials/1-000003.partial"));
  outcome = shell(folder, lines[0]);
  CHECK(count_of(outcome.out, "/rbpa tile") == 1);
  CHECK(count_of(outcome.out, "/rbpa merge") == 2);
  check_made(folder, odd + "/");
}

TEST_CASE("xargs runs the tasks, and so does GNU parallel if it is installed") {
  const Folder folder;
  make_input(folder);
  const auto lines = ways(folder, "--tasks 'my tasks' -o t.npy -o p.geojson");
  CHECK(lines[1].find("xargs") != std::string::npos);
  CHECK(shell(folder, lines[1]).code == 0);
  check_made(folder);
  fs::remove(folder.path("t.npy"));
  if (folder.run("sh", "-c 'command -v parallel'").code != 0) {
    MESSAGE("SKIPPED: no GNU parallel");
    return;
  }
  CHECK(shell(folder, lines[2]).code == 0);
  check_made(folder);
}

TEST_CASE("Slurm gets an array for each list, with every line once, each after the one before") {
  const Folder folder;
  make_input(folder);
  const auto lines = ways(folder, "--tasks 'my tasks' -o t.npy -o p.geojson");
  // In the place of sbatch: does the tasks of an array, the last first, and says the number of the job.
  folder.file(
      "sbatch",
      "#!/bin/sh\n"
      "echo \"$*\" >> \"$SAID\"\n"
      "for word; do case $word in --array=1-*) count=${word#--array=1-};; --wrap=*) work=${word#--wrap=};; esac; done\n"
      "k=$count\n"
      "while [ $k -gt 0 ]; do SLURM_ARRAY_TASK_ID=$k sh -c \"$work\" || exit; k=$((k - 1)); done\n"
      "echo $((7000 + $(wc -l < \"$SAID\")))';cluster'\n");
  chmod(folder.path("sbatch").c_str(), 0755);
  const std::string before = "PATH=\"$PWD:$PATH\" SAID=\"$PWD/said\" ";
  Outcome outcome = shell(folder, before + lines[3] + " --mem=2G");
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("1-tiles.txt: job 7001, ") == 0);
  CHECK(outcome.out.ends_with("3-targets.txt: job 7003, 1 tasks\n"));
  check_made(folder);
  const std::string said = folder.content("said");
  CHECK(count_of(said, "--mem=2G") == 3);
  CHECK(count_of(said, "--dependency=afterok:7001 ") == 1);
  CHECK(count_of(said, "--dependency=afterok:7002 ") == 1);
  CHECK(count_of(said, "--dependency=") == 2);

  // More lines than an array may have.
  for (const char* name : {"t.npy", "p.geojson"}) fs::remove(folder.path(name));
  fs::remove_all(folder.path("my tasks/partials"));
  fs::create_directory(folder.path("my tasks/partials"));
  std::string script = folder.content("my tasks/slurm.sh");
  script.replace(script.find("most=1000"), 9, "most=7");
  folder.file("my tasks/slurm.sh", script);
  outcome = shell(folder, before + lines[3]);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(folder.content("said").find("--array=1-7 ") != std::string::npos);
  check_made(folder);
}

TEST_CASE(
    "make killed with its tasks at any moment, and again, is continued by the next, and no file is half written") {
  std::mt19937 random(42);
  for (int moment = 0; moment < robustness::moments() / 4; ++moment) {
    const Folder folder;
    make_input(folder);
    ways(folder, "--tasks T -o t.npy -o p.geojson");
    int kills = 0;
    for (; kills < 12; ++kills) {
      Child make({"/usr/bin/make", "-j2", "-f", folder.path("T/Makefile")}, [&] {
        setpgid(0, 0);
        redirect(STDOUT_FILENO, "/dev/null", O_WRONLY);
        redirect(STDERR_FILENO, "/dev/null", O_WRONLY);
      });
      usleep(static_cast<useconds_t>(std::uniform_int_distribution<int>(0, 200'000)(random)));
      if (make.has_ended()) break;
      kill(-make.id(), moment % 2 == 0 ? SIGKILL : SIGTERM);
      make.wait();
      for (const char* name : {"t.npy", "p.geojson"})
        if (folder.has(name))
          CHECK(folder.content(name) == (name[0] == 't' ? expected().triangles : expected().polygons));
    }
    CHECK(folder.run("make", "-j2 -f T/Makefile").code == 0);
    check_made(folder);
    // The last that was killed may not have been dead yet when the next one looked; the one after that finds its
    // folder.
    fs::remove(folder.path("t.npy"));
    CHECK(folder.run("make", "-f T/Makefile").code == 0);
    check_made(folder);
    for (const std::string& name : folder.names()) CHECK(!name.starts_with(".rbpa-stream"));
  }
}

TEST_CASE("cutting killed at any moment is continued by --resume") {
  std::mt19937 random(43);
  for (int moment = 0; moment < robustness::moments() / 4; ++moment) {
    const Folder folder;
    make_input(folder);
    const std::string more = " --tasks T -o t.npy -o p.geojson";
    Child child({RBPA_PROGRAM, "stream", folder.path("p.f64xy"), "--alpha", "1.5", "--tile-size", "400", "--tasks",
                 folder.path("T"), "-o", folder.path("t.npy"), "-o", folder.path("p.geojson"), "-q"});
    usleep(static_cast<useconds_t>(std::uniform_int_distribution<int>(0, 60'000)(random)));
    child.send(SIGKILL);
    child.wait();
    ways(folder, "--resume" + more);
    CHECK(folder.run("make", "-j2 -f T/Makefile").code == 0);
    check_made(folder);
  }
}

TEST_CASE("a task without room fails with one line, leaves nothing, and can be run again") {
  const Folder folder;
  make_input(folder);
  ways(folder, "--tasks T -o t.npy -o p.geojson");
  const auto limited = [&](const std::string& list) {
    return shell(folder, "ulimit -f 1; trap '' XFSZ; sh -c \"$(head -n 1 T/" + list + ")\"");
  };
  Outcome outcome = limited("1-tiles.txt");
  CHECK(outcome.code == 1);
  CHECK(outcome.err.find(": cannot write: File too large\n") != std::string::npos);
  CHECK(count_of(outcome.err, "\n") == 1);
  CHECK(fs::is_empty(folder.path("T/partials")));
  CHECK(fs::is_empty(folder.path("T/triangles")));
  REQUIRE(folder.run("make", "-j2 -f T/Makefile").code == 0);
  for (const char* name : {"t.npy", "p.geojson"}) fs::remove(folder.path(name));
  const std::vector<std::string> before = folder.names();
  for (const char* list : {"2-merges.txt", "3-targets.txt"}) {
    outcome = limited(list);
    CHECK(outcome.code == 1);
    CHECK(outcome.err.find(": cannot write: File too large\n") != std::string::npos);
  }
  CHECK(folder.names() == before);
  CHECK(folder.run("make", "-j2 -f T/Makefile").code == 0);
  check_made(folder);
}
