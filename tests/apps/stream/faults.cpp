// Whatever happens to a run, the next one resumes it and makes the same bytes.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "robustness/moments.h"
#include "support/child.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Two files of points in a square with holes.
void make_input(const Folder& folder, std::size_t count) {
  rbpa_test::Random random(1);
  for (const char* name : {"a.f64xy", "b.f64xy"}) {
    std::vector<double> values(count);
    for (double& value : values) value = double(random.below(100'000)) / 100;
    folder.file(name, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
  }
}

constexpr std::size_t some = 60'000;

Child::Command command(const Folder& folder, const std::vector<std::string>& more) {
  Child::Command words = {RBPA_PROGRAM,
                          "stream",
                          folder.path("a.f64xy"),
                          folder.path("b.f64xy"),
                          "--alpha",
                          "3.2",
                          "--tile-size",
                          "1500",
                          "-o",
                          folder.path("t.npy"),
                          "-o",
                          folder.path("p.geojson"),
                          "-q"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Child::Command with_scratch(const Folder& folder) {
  return command(folder, {"--scratch", folder.path("scratch"), "--resume"});
}

struct Made {
  std::string triangles, polygons;
  double seconds = 0;
};

/// The result of an undisturbed run.
const Made& expected() {
  static const Made made = [] {
    const Folder folder;
    make_input(folder, some);
    const auto start = Clock::now();
    Child child(command(folder, {}));
    REQUIRE(child.wait() == Ending{0, 0});
    const double seconds = seconds_since(start);
    CHECK(folder.names() == std::vector<std::string>{"a.f64xy", "b.f64xy", "p.geojson", "t.npy"});
    return Made{folder.content("t.npy"), folder.content("p.geojson"), seconds};
  }();
  return made;
}

void check_done(const Folder& folder) {
  CHECK(folder.content("t.npy") == expected().triangles);
  CHECK(folder.content("p.geojson") == expected().polygons);
  std::string names;
  for (const std::string& name : folder.names()) names += name + " ";
  CHECK(names == "a.f64xy b.f64xy p.geojson t.npy ");
}

void finish(const Folder& folder) {
  Child child(with_scratch(folder));
  CHECK(child.wait() == Ending{0, 0});
  check_done(folder);
}

void sleep(double seconds) { usleep(static_cast<useconds_t>(1e6 * seconds)); }

/// Returns the message of a run that fails.
std::string refusal(const Folder& folder, const std::string& arguments) {
  const Outcome outcome = folder.rbpa("stream " + arguments);
  CHECK(outcome.code != 0);
  return outcome.err;
}

}  // namespace

TEST_CASE("a run killed at any moment, and again, is resumed") {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> share(0, 1.05);
  const int moments = robustness::moments() > 8 ? 150 : robustness::moments();  // two kills each, in the mean
  for (int moment = 0; moment < moments; ++moment) {
    CAPTURE(moment);
    const Folder folder;
    make_input(folder, some);
    for (int kill = 0; kill < 1 + moment % 3; ++kill) {
      Child child(with_scratch(folder));
      sleep(share(random) * expected().seconds);
      child.send(SIGKILL);
      child.wait();
      for (const char* name : {"t.npy", "p.geojson"})
        if (folder.has(name))
          CHECK(folder.content(name) == (name[0] == 't' ? expected().triangles : expected().polygons));
    }
    finish(folder);
  }
}

TEST_CASE("a signal ends a run at once; its scratch stays only if it was named") {
  for (const bool named : {false, true})
    for (const double share : {0.1, 0.6}) {
      const Folder folder;
      make_input(folder, 10 * some);
      Child child(named ? with_scratch(folder) : command(folder, {}));
      sleep(share * 4 * expected().seconds);
      if (child.has_ended()) continue;  // a fast machine
      const auto start = Clock::now();
      child.send(SIGINT);
      const Ending ending = child.wait();
      if (ending == Ending{0, 0} && seconds_since(start) < 0.1) continue;  // it was all but done
      CHECK(ending == Ending{130, 0});
      CHECK(seconds_since(start) < 2);  // a third of a second on an idle machine
      std::vector<std::string> names = {"a.f64xy", "b.f64xy"};
      if (named) names.push_back("scratch");
      CHECK(folder.names() == names);
    }
}

TEST_CASE("the next run removes the leftovers of a killed one next to its target") {
  const Folder folder;
  make_input(folder, 10 * some);
  Child child(command(folder, {}));
  const auto any_scratch = [&] {
    for (const std::string& name : folder.names())
      if (name.starts_with(".rbpa-stream-") && fs::exists(folder.path(name) + "/manifest.json")) return true;
    return false;
  };
  while (!any_scratch() && !child.has_ended()) usleep(1000);
  child.send(SIGKILL);
  child.wait();
  CHECK(any_scratch());
  make_input(folder, some);
  Child next(command(folder, {}));
  CHECK(next.wait() == Ending{0, 0});
  check_done(folder);
}

TEST_CASE("files of tiles that were changed or cut off are made again") {
  rbpa_test::Random random(3);
  for (int round = 0; round < 6; ++round) {
    const Folder folder;
    make_input(folder, some);
    {  // all tiles, and nothing computed
      Child child(command(folder, {"--scratch", folder.path("scratch"), "--keep-tiles"}));
      REQUIRE(child.wait() == Ending{0, 0});
      REQUIRE(fs::exists(folder.path("scratch/manifest.json")));
      fs::remove(folder.path("t.npy"));
    }
    std::size_t tiles = 0;
    for (const auto& entry : fs::directory_iterator(folder.path("scratch/tiles"))) {
      if (tiles++ % 20 != 0) continue;
      std::string content = read_file(entry.path());
      const std::size_t at = random.below(content.size());
      if (round % 3 == 0)
        fs::remove(entry.path());
      else if (round % 3 == 1)
        fs::resize_file(entry.path(), at);
      else {
        content[at] = char(content[at] ^ 16);
        std::ofstream(entry.path(), std::ios::binary) << content;
      }
    }
    CHECK(tiles > 30);
    Child child(command(folder, {"--scratch", folder.path("scratch"), "--keep-tiles", "--resume"}));
    CHECK(child.wait() == Ending{0, 0});
    CHECK(folder.content("t.npy") == expected().triangles);
    CHECK(folder.content("p.geojson") == expected().polygons);
  }
}

TEST_CASE("a run with another request is not resumed") {
  const Folder folder;
  make_input(folder, 1000);
  const std::string same = "a.f64xy b.f64xy --alpha 3 -o t.npy --scratch s --keep-tiles -q";
  REQUIRE(folder.rbpa("stream " + same).code == 0);
  CHECK(refusal(folder, same) ==
        "rbpa: --scratch: found a run in s, expected --resume to continue it, or another folder\n");
  CHECK(folder.rbpa("stream " + same + " --resume").code == 0);
  const auto check = [&](const std::string& arguments, const std::string& part) {
    const std::string text = refusal(folder, arguments + " --scratch s --keep-tiles -q --resume");
    CAPTURE(text);
    CHECK(text.starts_with("rbpa: --resume: found "));
    CHECK(contains(text, part));
  };
  check("a.f64xy b.f64xy --alpha 4 -o t.npy",
        "found --alpha 4.0, expected --alpha 3.0, as the run in s has (or remove s to start again)");
  check("a.f64xy --alpha 3 -o t.npy", "found 1 input (a.f64xy), expected 2 inputs (a.f64xy b.f64xy), as");
  check("b.f64xy a.f64xy --alpha 3 -o t.npy", "found the input b.f64xy, expected a.f64xy, as");
  check("a.f64xy b.f64xy --alpha 3 -o u.npy",
        "found -o u.npy, expected -o t.npy, as the run in s has (or remove s to start again)");
  check("a.f64xy b.f64xy --alpha 3 -o t.npy --memory 500M",
        "found --memory 524288000 (bytes), expected --memory 1073741824 (bytes), as");
  check("a.f64xy b.f64xy --alpha 3 -o t.npy --tile-size 77", "found --tile-size 77, expected no --tile-size, as");
  check("a.f64xy b.f64xy --alpha 3 -o t.npy --format f64xy",
        "found --format f64xy, expected no option that says how POINTS are read, as");
  std::string content = folder.content("b.f64xy");
  folder.file("b.f64xy", content.substr(0, content.size() / 2));
  check("a.f64xy b.f64xy --alpha 3 -o t.npy", "found b.f64xy, which has changed since the run in s began");
  folder.file("s/manifest.json", "{}");
  CHECK(contains(refusal(folder, same + " --resume"), "s/manifest.json: found a file that was truncated or changed"));
}

TEST_CASE("a folder that another run uses is refused") {
  const Folder folder;
  make_input(folder, 20 * some);
  Child child(with_scratch(folder));
  while (!fs::exists(folder.path("scratch/manifest.json"))) usleep(1000);
  const Outcome outcome = folder.rbpa("stream a.f64xy --alpha 1 -o x.npy --scratch scratch --resume -q");
  if (!child.has_ended()) {
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "another run is using the folder"));
  }
}

TEST_CASE("a limit of file size gives one line, and the next run continues") {
  std::mt19937 random(21);
  for (int moment = 0; moment < robustness::moments() / 2; ++moment) {
    const Folder folder;
    make_input(folder, some);
    // From the size of tiles to that of the targets.
    const double most = std::exp(std::uniform_real_distribution<double>(std::log(2000), std::log(3e6))(random));
    Child child(with_scratch(folder), [&] {
      redirect(STDERR_FILENO, folder.path("said"), O_WRONLY | O_CREAT | O_TRUNC);
      const rlimit both{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
      setrlimit(RLIMIT_FSIZE, &both);
    });
    const Ending ending = child.wait();
    const std::string said = folder.content("said");
    fs::remove(folder.path("said"));
    CAPTURE(most);
    CAPTURE(said);
    CHECK((ending == Ending{0, 0} || ending == Ending{1, 0}));
    if (ending.code == 1) {
      CHECK(contains(said, ": cannot write: File too large\n"));
      CHECK(std::count(said.begin(), said.end(), '\n') == 1);
      finish(folder);
    }
  }
}

TEST_CASE("a full disk gives one line, and the next run continues") {
  const Folder place;
  const std::string disk = place.path("disk");
  fs::create_directory(disk);
  if (mount("stream", disk.c_str(), "tmpfs", MS_NOSUID, "size=16m") != 0) {
    MESSAGE("SKIPPED: no small disk can be mounted here");
    return;
  }
  setenv("TMPDIR", disk.c_str(), 1);
  std::mt19937 random(22);
  for (int moment = 0; moment < robustness::moments() / 2; ++moment) {
    const Folder folder;
    make_input(folder, some);
    const std::size_t left = std::uniform_int_distribution<std::size_t>(0, 8'000'000)(random);
    const std::size_t free = fs::space(disk).available;
    std::ofstream(disk + "/ballast") << std::string(free - std::min(free, left), 'x');
    Child child(with_scratch(folder),
                [&] { redirect(STDERR_FILENO, place.path("said"), O_WRONLY | O_CREAT | O_TRUNC); });
    const Ending ending = child.wait();
    fs::remove(disk + "/ballast");
    const std::string said = place.content("said");
    CAPTURE(left);
    CAPTURE(said);
    CHECK((ending == Ending{0, 0} || ending == Ending{1, 0}));
    if (ending.code == 1) {
      const bool known = contains(said, " free on its disk, expected ");
      CHECK((known || contains(said, "No space left on device\n")));
      CHECK(std::count(said.begin(), said.end(), '\n') == 1);
      finish(folder);
    }
  }
  unsetenv("TMPDIR");
  umount2(disk.c_str(), MNT_DETACH);
}

TEST_CASE("a run stays within its memory") {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  MESSAGE("SKIPPED: sanitizers take memory for themselves");
#else
  const Folder folder;
  const bool nightly = robustness::moments() > 8;
  make_input(folder, nightly ? 6'000'000 : 1'000'000);
  const auto check = [&](const std::string& memory, const std::string& alpha, const std::string& threads) {
    CAPTURE(memory);
    CAPTURE(alpha);
    CAPTURE(threads);
    REQUIRE(folder
                .rbpa("stream a.f64xy b.f64xy --alpha " + alpha + " --memory " + memory + " --threads " + threads +
                      " -o t.npy -o p.geojson -q --stats s.json")
                .code == 0);
    const std::string stats = folder.content("s.json");
    const std::size_t at = stats.find("\"peak_bytes\": ");
    REQUIRE(at != std::string::npos);
    CHECK(std::stoull(stats.substr(at + 14)) < std::stoull(memory) << 20U);
  };
  for (const char* memory : {"64M", "128M"}) check(memory, "0.9", "2");
  if (!nightly) return;
  // Polygons in all tiles, with hundreds of thousands of holes, and everything around tiles.
  for (const char* alpha : {"0.2", "0.4", "0.5", "8"})
    for (const char* threads : {"1", "4"})
      for (const char* memory : {"64M", "128M"}) check(memory, alpha, threads);
#endif
}
