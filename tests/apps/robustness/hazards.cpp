#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "robustness/moments.h"
#include "robustness/run.h"

using apps_test::Child;
using apps_test::Ending;
using apps_test::Folder;
using apps_test::redirect;
using namespace robustness;

namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool with_address_sanitizer = true;
#else
constexpr bool with_address_sanitizer = false;
#endif

const std::string old_content = "what was there before\n";

/// Two kinds of reports contain times: these are complete if they have both ends.
bool is_whole(const std::string& name, const std::string& found, const std::string& expected) {
  if (name != "stats.json" && name != "levels.json") return found == expected;
  return found.starts_with("{\n") && found.ends_with("\n}\n");
}

/// A folder with the inputs, outputs of an earlier run, and the file of messages.
class Scene {
 public:
  explicit Scene(const Run& run) : run_(run) {
    make_inputs(folder_);
    for (const std::string& name : run.outputs) folder_.file(name, old_content);
    folder_.file("said", "");
    folder_.file("printed", "");
    names_ = folder_.names();
  }

  const Folder& folder() const { return folder_; }
  const Run& run() const { return run_; }
  std::string input() const { return folder_.path(run_.input); }
  Child::Command command() const { return command_of(run_, folder_); }
  /// Redirects output and messages to files.
  void record() const {
    redirect(STDOUT_FILENO, folder_.path("printed"), O_WRONLY | O_TRUNC);
    redirect(STDERR_FILENO, folder_.path("said"), O_WRONLY | O_TRUNC);
  }
  std::string said() const { return folder_.content("said"); }

  bool has_made(const Reference& reference) const {
    return std::all_of(run_.outputs.begin(), run_.outputs.end(), [&](const std::string& name) {
      return is_whole(name, folder_.content(name), reference.outputs.at(name));
    });
  }

  /// The law: a run that reports a failure has changed nothing, and one that reports success has made all
  /// files. `heard`: its messages have a place to go to.
  void check(const Ending& ending, const Reference& reference, bool heard = true) const {
    CAPTURE(ending.code);
    CAPTURE(ending.signal);
    const std::string message = said();
    CAPTURE(message);
    if (ending.signal == SIGKILL) clear();
    for (const std::string& name : run_.outputs) {
      CAPTURE(name);
      const std::string found = folder_.content(name);
      const bool is_old = found == old_content, is_new = is_whole(name, found, reference.outputs.at(name));
      CHECK((is_old || is_new));
      if (ending.by_itself()) CHECK((ending.code == 0 ? is_new : is_old));
    }
    CHECK(folder_.names() == names_);
    const auto lines = std::count(message.begin(), message.end(), '\n');
    if (!heard) return;
    CHECK(lines == (ending.by_itself() && ending.code != 0 && ending.code != 141 ? 1 : 0));
  }

 private:
  /// The next run in the folder.
  void clear() const {
    folder_.file("corner.xy", apps_test::corner);
    REQUIRE(folder_.rbpa("info corner.xy --stats corner.json").code == 0);
    fs::remove(folder_.path("corner.json"));
    if (run_.name == "stream") {  // that leaves more, which the next of its kind clears
      REQUIRE(folder_.rbpa("stream corner.xy --alpha 9 -o corner.npy -q").code == 0);
      fs::remove(folder_.path("corner.npy"));
    }
    fs::remove(folder_.path("corner.xy"));
  }

  Run run_;
  Folder folder_;
  std::vector<std::string> names_;
};

using Random = std::mt19937;

void sleep(double seconds) { usleep(static_cast<useconds_t>(1e6 * seconds)); }

double up_to(double end, Random& random) { return std::uniform_real_distribution<double>(0, end)(random); }

/// Calls happens(scene, reference, random) for each of the runs at each moment.
template <typename Happens>
void for_each_moment(const std::vector<Run>& runs, unsigned seed, Happens happens) {
  for (const Run& run : runs) {
    CAPTURE(run.name);
    const Reference& reference = reference_of(run);
    Random random(seed);
    for (int moment = 0; moment < moments(); ++moment) {
      CAPTURE(moment);
      const Scene scene(run);
      happens(scene, reference, random);
    }
  }
}

void signals(int signal) {
  CAPTURE(signal);
  for_each_moment(runs_into_files(), 10, [&](const Scene& scene, const Reference& reference, Random& random) {
    Child child(scene.command(), [&] { scene.record(); });
    sleep(up_to(1.1 * reference.seconds, random));
    if (!child.has_ended()) child.send(signal);
    const Ending ending = child.wait();
    // Before main() a signal ends the program as any other.
    CHECK((ending == Ending{0, 0} || ending == Ending{130, 0} || ending == Ending{-1, signal}));
    if (ending.signal == signal && signal != SIGKILL) CHECK(scene.said().empty());
    scene.check(ending, reference);
  });
}

std::size_t largest_of(const Reference& reference) {
  std::size_t largest = reference.printed.size();
  for (const auto& [name, content] : reference.outputs) largest = std::max(largest, content.size());
  return largest;
}

void limit(int resource, std::size_t value) {
  const rlimit both{value, value};
  if (setrlimit(static_cast<__rlimit_resource>(resource), &both) != 0) _exit(125);
}

/// A disk of 64 MiB in memory, for new folders while the object lives. Requires: root.
class SmallDisk {
 public:
  SmallDisk() : path_(place_.path("disk")) {
    fs::create_directory(path_);
    is_there_ = mount("robustness", path_.c_str(), "tmpfs", MS_NOSUID, "size=64m") == 0;
    if (is_there_) setenv("TMPDIR", path_.c_str(), 1);
  }
  ~SmallDisk() {
    if (!is_there_) return;
    unsetenv("TMPDIR");
    umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool is_there() const { return is_there_; }
  /// Fills the disk except for so many bytes.
  void leave(std::size_t bytes) const {
    const std::size_t free = fs::space(path_).available;
    std::ofstream(path_ + "/ballast") << std::string(free - std::min(free, bytes), 'x');
  }
  void clear() const { fs::remove(path_ + "/ballast"); }

 private:
  Folder place_;
  std::string path_;
  bool is_there_ = false;
};

}  // namespace

TEST_SUITE("robustness") {
  TEST_CASE("a signal leaves no file behind") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) signals(signal);
  }

  TEST_CASE("a limit of file size leaves old outputs or whole new ones") {
    for_each_moment(runs_into_files(), 11, [](const Scene& scene, const Reference& reference, Random& random) {
      const auto most = static_cast<std::size_t>(up_to(1.1 * static_cast<double>(largest_of(reference)), random));
      Child child(scene.command(), [&] {
        scene.record();
        limit(RLIMIT_FSIZE, std::max<std::size_t>(most, 100));  // room for the message
      });
      const Ending ending = child.wait();
      CHECK((ending == Ending{0, 0} || ending == Ending{1, 0}));
      if (ending.code == 1) CHECK(scene.said().find(": cannot write: File too large\n") != std::string::npos);
      scene.check(ending, reference);
    });
  }

  TEST_CASE("a full disk leaves old outputs or whole new ones") {
    const SmallDisk disk;
    if (!disk.is_there()) {
      MESSAGE("SKIPPED: no small disk can be mounted here");
      return;
    }
    for_each_moment(runs_into_files(), 16, [&](const Scene& scene, const Reference& reference, Random& random) {
      std::size_t size = reference.printed.size();
      for (const auto& [name, content] : reference.outputs) size += content.size();
      disk.leave(static_cast<std::size_t>(up_to(1.2 * static_cast<double>(size), random)));
      Child child(scene.command(), [&] { scene.record(); });
      const Ending ending = child.wait();
      disk.clear();
      CHECK((ending == Ending{0, 0} || ending == Ending{1, 0}));
      // Output goes to the disk as well, and so do the messages.
      const std::string said = scene.said();
      const bool before =
          scene.run().name == "stream" && said.find(" free on its disk, expected ") != std::string::npos;
      if (ending.code == 1 && !said.empty() && !before)
        CHECK(said.find(": cannot write: No space left on device\n") != std::string::npos);
      scene.check(ending, reference, false);
    });
  }

  TEST_CASE("a full disk for standard output is reported") {
    for_each_moment(runs_to_standard_output(), 12, [](const Scene& scene, const Reference& reference, Random&) {
      Child child(scene.command(), [&] {
        scene.record();
        redirect(STDOUT_FILENO, "/dev/full", O_WRONLY);
      });
      const Ending ending = child.wait();
      CHECK(ending == Ending{1, 0});
      scene.check(ending, reference);
    });
  }

  TEST_CASE("a pipe that its reader closes ends the run") {
    for_each_moment(runs_to_standard_output(), 13, [](const Scene& scene, const Reference& reference, Random& random) {
      int ends[2];
      REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
      Child child(scene.command(), [&] {
        scene.record();
        redirect(STDOUT_FILENO, ends[1]);
      });
      close(ends[1]);
      std::string buffer(4096, '\0');
      double left = up_to(1.1 * static_cast<double>(reference.printed.size()), random);
      for (ssize_t count = 1; left > 0 && count > 0; left -= static_cast<double>(count))
        count = read(ends[0], buffer.data(), std::min(buffer.size(), static_cast<std::size_t>(left) + 1));
      close(ends[0]);
      const Ending ending = child.wait();
      CHECK((ending == Ending{0, 0} || ending == Ending{141, 0}));
      scene.check(ending, reference);
    });
  }

  TEST_CASE("too little memory ends the run with a message") {
    if (with_address_sanitizer) {
      MESSAGE("SKIPPED: the address sanitizer takes memory for itself");
      return;
    }
    for_each_moment(runs_into_files(), 14, [](const Scene& scene, const Reference& reference, Random& random) {
      const double bytes = std::exp2(23 + up_to(7, random));  // 8 MiB to 1 GiB
      Child child(scene.command(), [&] {
        scene.record();
        limit(RLIMIT_AS, static_cast<std::size_t>(bytes));
      });
      const Ending ending = child.wait();
      CAPTURE(bytes);
      // If not even its libraries fit, the program does not begin: the system kills it or reports that, or the C++
      // runtime ends it in an initializer of a library.
      const bool is_ended_by_runtime =
          ending.signal == SIGABRT && scene.said().starts_with("terminate called without an active exception");
      if (ending.code == 127 || ending.signal == SIGKILL || ending.signal == SIGSEGV || is_ended_by_runtime) {
        Child begins({scene.command().front(), "--version"}, [&] {
          redirect(STDOUT_FILENO, "/dev/null", O_WRONLY);
          limit(RLIMIT_AS, static_cast<std::size_t>(0.9 * bytes));
        });
        CHECK(begins.wait() != Ending{0, 0});
        CHECK_FALSE(scene.said().starts_with("rbpa: "));
        CHECK_FALSE(scene.said().starts_with("meshtopo: "));
        return;
      }
      CHECK((ending == Ending{0, 0} || ending == Ending{1, 0}));
      scene.check(ending, reference);
    });
  }

  TEST_CASE("an input that is shortened is refused") {
    for_each_moment(runs_into_files(), 15, [](const Scene& scene, const Reference& reference, Random& random) {
      Child child(scene.command(), [&] { scene.record(); });
      sleep(up_to(std::min(reference.seconds, 0.03), random));
      shorten(scene.input());
      const Ending ending = child.wait();
      CHECK((ending == Ending{0, 0} || ending == Ending{3, 0}));
      // The program may not have begun to read: then the half is the whole input.
      const Reference& half = reference_of(scene.run(), Input::half);
      scene.check(ending, half.is_done && scene.has_made(half) ? half : reference);
    });
  }
}
