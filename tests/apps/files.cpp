// Files that change, links, one file under two names, and the leftovers of killed runs.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "support/child.h"
#include "support/program.h"

using namespace apps_test;
namespace fs = std::filesystem;

namespace {

/// Returns the position of a process in a file that it has open.
std::size_t position_in(pid_t process, const std::string& path) {
  const fs::path descriptors = "/proc/" + std::to_string(process) + "/fd";
  std::error_code error;
  for (fs::directory_iterator entry(descriptors, error), end; !error && entry != end; entry.increment(error)) {
    if (fs::read_symlink(entry->path(), error) != path) continue;
    std::ifstream info("/proc/" + std::to_string(process) + "/fdinfo/" + entry->path().filename().string());
    std::string label;
    std::size_t position = 0;
    if (info >> label >> position) return position;
  }
  return 0;
}

/// Returns whether a child has ended, without waiting for it.
bool has_ended(pid_t process) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == process;
}

/// Runs `rbpa info` on a large file, and `change(path)` after it has read a part. Returns the message.
std::string message_after(const std::function<void(const std::string&)>& change, Ending& ending) {
  const Folder folder;
  const std::string path = folder.file("p.f64xy", ""), errors = folder.file("errors", "");
  for (int attempt = 0; attempt < 50; ++attempt) {
    fs::resize_file(path, std::uintmax_t{256} << 20U);
    Child child({RBPA_PROGRAM, "info", path}, [&] {
      redirect(STDERR_FILENO, errors, O_WRONLY | O_TRUNC);
      redirect(STDOUT_FILENO, "/dev/null", O_WRONLY);
    });
    // The child runs for short moments, so that it has not read all before this process, on a busy machine, runs again.
    while (!has_ended(child.id()) && position_in(child.id(), path) == 0) {
      kill(child.id(), SIGCONT);
      usleep(100);
      kill(child.id(), SIGSTOP);
    }
    change(path);
    kill(child.id(), SIGCONT);
    ending = child.wait();
    if (ending != Ending{0, 0}) return folder.content("errors");  // else it had read all
  }
  return "";
}

void refuses(const Outcome& outcome, int code, const std::string& message) {
  CHECK(outcome.code == code);
  CHECK(outcome.err == "rbpa: " + message + "\n");
  CHECK(outcome.out.empty());
}

bool is_abandoned(const std::string& name) { return name.starts_with(".rbpa-"); }

std::size_t count_abandoned(const Folder& folder) {
  const auto names = folder.names();
  return static_cast<std::size_t>(std::count_if(names.begin(), names.end(), is_abandoned));
}

/// Returns a run that has written most of m.off and waits for a reader of the pipe `pipe`.
std::function<Child::Command()> waiting_run(const Folder& folder) {
  folder.file("p.xy", corner);
  REQUIRE(mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  return [&folder]() -> Child::Command {
    return {RBPA_PROGRAM,         "mesh", folder.path("p.xy"), "--alpha",         "1",   "-o",
            folder.path("m.off"), "-o",   folder.path("pipe"), "--output-format", "off", "-q"};
  };
}

void wait_for_file(const Folder& folder) {
  for (int wait = 0; wait < 5000 && count_abandoned(folder) == 0; ++wait) usleep(1000);
  REQUIRE(count_abandoned(folder) == 1);
}

}  // namespace

TEST_SUITE("input files") {
  TEST_CASE("a file that is shortened, extended or written while it is read is refused with a message") {
    const std::string expected = ", expected a file that does not change while it is read (start again)\n";
    Ending ending;
    const std::string shorter = message_after([](const std::string& path) { fs::resize_file(path, 4096); }, ending);
    CHECK(ending == Ending{3, 0});
    CHECK(contains(shorter, "p.f64xy: found "));
    CHECK(contains(shorter, " bytes where there were 268435456" + expected));
    const std::string longer =
        message_after([](const std::string& path) { fs::resize_file(path, std::uintmax_t{257} << 20U); }, ending);
    CHECK(ending == Ending{3, 0});
    CHECK(contains(longer, "p.f64xy: found more than the 268435456 bytes there were" + expected));
    const std::string other = message_after(
        [](const std::string& path) {
          std::fstream file(path, std::ios::in | std::ios::out);
          file.seekp(255 << 20U) << "another";
        },
        ending);
    CHECK(ending == Ending{3, 0});
    CHECK(contains(other, "p.f64xy: found a change while it was read" + expected));
  }

  TEST_CASE("standard input that is a file is read from its current position") {
    const Folder folder("p.xy", "not a point\n0 0\n1 0\n0 1\n");
    const std::string run = std::string("-c '(read line; \"") + RBPA_PROGRAM + "\" info - --json) < p.xy'";
    CHECK(contains(folder.run("/bin/sh", run, 0).out, "\"points\": 3"));
  }

  TEST_CASE("a file without a size is read to its end") {
    const Folder folder;  // no points, but all of its text
    CHECK(folder.rbpa("info /proc/self/comm --format text").err ==
          "rbpa: /proc/self/comm:1: found 'rbpa', expected two numbers\n");
  }

  TEST_CASE("a disk that fails while a file is read ends the run with a message") {
    // Reading memory at address 0 fails with the error of a bad disk.
    refuses(Folder(), "info /proc/self/mem --format text", 1, "/proc/self/mem: cannot read: Input/output error");
  }

  TEST_CASE("non-blocking standard input and output are waited for") {
    const Folder folder;
    signal(SIGPIPE, SIG_IGN);  // should it end early
    int in[2], out[2];
    REQUIRE(pipe2(in, O_CLOEXEC | O_NONBLOCK) == 0);
    REQUIRE(pipe2(out, O_CLOEXEC | O_NONBLOCK) == 0);
    Child child({RBPA_PROGRAM, "mesh", "-", "--alpha", "inf", "-o", "-", "--output-format", "obj", "-q"}, [&] {
      redirect(STDIN_FILENO, in[0]);
      redirect(STDOUT_FILENO, out[1]);
    });
    close(in[0]);
    close(out[1]);
    usleep(20'000);  // it asks before there is anything
    std::string points;
    for (int i = 0; i < 4000; ++i) points += std::to_string(i) + " " + std::to_string(i % 7) + "\n";
    REQUIRE(write(in[1], points.data(), points.size()) == static_cast<ssize_t>(points.size()));
    close(in[1]);
    usleep(100'000);  // more than a pipe holds
    std::string text(1 << 20, '\0');
    std::size_t size = 0;
    while (true) {
      const ssize_t count = read(out[0], text.data() + size, text.size() - size);
      if (count == 0) break;
      if (count > 0) size += static_cast<std::size_t>(count);
      if (count < 0) usleep(1000);
    }
    close(out[0]);
    CHECK(child.wait() == Ending{0, 0});
    folder.file("p.xy", points);
    CHECK(text.substr(0, size) == folder.rbpa("mesh p.xy --alpha inf -o - --output-format obj -q").out);
  }
}

TEST_SUITE("links") {
  TEST_CASE("a file is made through dangling links, and the links stay") {
    const Folder folder("p.xy", corner);
    fs::create_directory(folder.path("to"));
    fs::create_symlink("to/second", folder.path("first.off"));
    fs::create_symlink("../m.off", folder.path("to/second"));
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1 -o first.off -q").code == 0);
    CHECK(fs::is_symlink(folder.path("first.off")));
    CHECK(fs::is_symlink(folder.path("to/second")));
    CHECK(folder.content("m.off").starts_with("OFF\n"));
    folder.file("m.off", "old");
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1 -o first.off -q").code == 0);
    CHECK(fs::is_symlink(folder.path("first.off")));
    CHECK(folder.content("m.off").starts_with("OFF\n"));
  }

  TEST_CASE("a loop of links is named before anything is read, and stays") {
    const Folder folder;
    fs::create_symlink("b.off", folder.path("a.off"));
    fs::create_symlink("a.off", folder.path("b.off"));
    refuses(folder, "mesh none.xy --alpha 1 -o a.off", 1,
            "a.off: found a loop or more than 40 symbolic links, expected a file to write");
    CHECK(fs::is_symlink(folder.path("a.off")));
    CHECK(folder.names().size() == 2);
  }

  TEST_CASE("a link into a missing folder is refused before anything is read") {
    const Folder folder;
    fs::create_symlink("none/m.off", folder.path("a.off"));
    refuses(folder, "mesh none.xy --alpha 1 -o a.off", 1, "a.off: found no folder 'none', expected one to write to");
  }
}

TEST_SUITE("the same file") {
  TEST_CASE("standard input from the file to be written is refused") {
    const Folder folder;
    const std::string points = "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n";
    folder.file("p.off", points);
    fs::create_hard_link(folder.path("p.off"), folder.path("q.off"));
    const std::string found = ".off: found the file of points, expected another file to write to";
    refuses(folder, "mesh - --format off --alpha 1 -o p.off <p.off", 2, "p" + found);
    refuses(folder, "shape - --format off --alpha 1 -o - --output-format wkt --stats q.off <p.off", 2, "q" + found);
    CHECK(folder.content("p.off") == points);
    folder.file("m.off", points);
    meshtopo_refuses(folder, "- --format off --repair -o m.off <m.off", 2,
                     "m.off: found the file of the mesh, expected another file to write to");
    CHECK(folder.content("m.off") == points);
  }

  TEST_CASE("standard output into the file that is read, or into another output, is refused") {
    const Folder folder;
    const std::string points = folder.file("p.xy", corner), program = RBPA_PROGRAM;
    const auto shell = [&](const std::string& command) { return folder.run("/bin/sh", "-c '" + command + "'"); };
    const std::string found = "found the file of points, expected another file to write to";
    refuses(shell(program + " info p.xy >>p.xy"), 2, "standard output: " + found);
    refuses(shell(program + " alpha - <p.xy >>p.xy"), 2, "standard output: " + found);
    CHECK(folder.content("p.xy") == corner);
    folder.file("s.json", "");
    refuses(shell(program + " info p.xy --stats s.json >>s.json"), 2,
            "s.json: found twice among the files to write, expected once");
  }

  TEST_CASE("two links to one file that does not exist yet are refused") {
    const Folder folder("p.xy", corner);
    fs::create_symlink("m.off", folder.path("a.off"));
    fs::create_symlink("m.off", folder.path("b.off"));
    refuses(folder, "mesh p.xy --alpha 1 -o a.off -o b.off", 2,
            "b.off: found twice among the files to write, expected once");
  }

  TEST_CASE("devices and pipes may be shared") {
    const Folder folder("p.xy", corner);
    CHECK(folder
              .run("/bin/sh", std::string("-c '") + RBPA_PROGRAM +
                                  " mesh - --alpha 1 -o /dev/null -o - --output-format off -q </dev/null >/dev/null'")
              .err == "rbpa: standard input: found an empty file, expected points\n");
  }
}

TEST_SUITE("what a killed run leaves") {
  TEST_CASE("a dead run's file is removed by the next run that writes into the folder, a living run's is not") {
    const Folder folder;
    const auto command = waiting_run(folder);
    Child living(command());
    wait_for_file(folder);
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1 -o n.off -q").code == 0);
    CHECK(count_abandoned(folder) == 1);
    living.send(SIGKILL);
    CHECK(living.wait() == Ending{-1, SIGKILL});
    CHECK(count_abandoned(folder) == 1);
    REQUIRE(folder.rbpa("info p.xy --stats s.json").code == 0);
    CHECK(folder.names() == std::vector<std::string>{"n.off", "p.xy", "pipe", "s.json"});
  }

  TEST_CASE("a dead run's file is removed by meshtopo too, also where a link leads") {
    const Folder folder;
    fs::create_directory(folder.path("to"));
    folder.file("to/.rbpa-1-0.tmp", "of a process that lives, but has nothing to do with it");
    folder.file("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    fs::create_symlink("to/r.json", folder.path("r.json"));
    REQUIRE(folder.meshtopo("m.off --json -o r.json").code == 0);
    CHECK_FALSE(folder.has("to/.rbpa-1-0.tmp"));
    CHECK(folder.has("to/r.json"));
  }

  TEST_CASE("only files whose whole name matches are removed") {
    const Folder folder("p.xy", corner);
    const std::vector<std::string> kept = {".rbpa-.tmp",    ".rbpa-1-.tmp",    ".rbpa--1.tmp", ".rbpa-1-1.tmp.xy",
                                           ".rbpa-1-x.tmp", ".rbpa-1-1-1.tmp", "rbpa-1-1.tmp", ".rbpa-1-1tmp"};
    for (const std::string& name : kept) folder.file(name, "x");
    fs::create_directory(folder.path(".rbpa-1-2.tmp"));
    fs::create_symlink("p.xy", folder.path(".rbpa-1-3.tmp"));
    REQUIRE(mkfifo(folder.path(".rbpa-1-4.tmp").c_str(), 0600) == 0);
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1 -o m.off -q").code == 0);
    CHECK(folder.names().size() == kept.size() + 5);
  }

  TEST_CASE("a dead run's file does not hinder a run with the same process number") {
    const Folder folder;
    const auto command = waiting_run(folder);
    Child first(command(), [&] {  // as if the number had been used before
      std::ofstream(folder.path(".rbpa-" + std::to_string(getpid()) + "-0.tmp")) << "left";
    });
    const int pipe = open(folder.path("pipe").c_str(), O_RDONLY);
    std::string text(4096, '\0');
    while (read(pipe, text.data(), text.size()) > 0) continue;
    CHECK(first.wait() == Ending{0, 0});
    close(pipe);
    CHECK(folder.names() == std::vector<std::string>{"m.off", "p.xy", "pipe"});
  }
}
