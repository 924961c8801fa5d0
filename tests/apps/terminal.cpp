// Progress on a terminal.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "shared/progress.h"
#include "support/child.h"
#include "support/mesh_files.h"
#include "support/program.h"

using namespace apps_test;

namespace {

/// Runs `command` with a terminal as standard error, and as standard output if `output_too`. Returns everything shown
/// there.
std::string seen_on_terminal(const Child::Command& command, bool output_too = false) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  REQUIRE(terminal >= 0);
  REQUIRE(grantpt(terminal) == 0);
  REQUIRE(unlockpt(terminal) == 0);
  const std::string name = ptsname(terminal);
  Child child(command, [&] {
    redirect(STDOUT_FILENO, output_too ? name : "/dev/null", O_WRONLY | O_NOCTTY);
    redirect(STDERR_FILENO, name, O_WRONLY | O_NOCTTY);
  });
  std::string text;
  char buffer[4096];
  // Reading fails after the child has closed the terminal, and also before it has opened it.
  for (bool ended = false; !ended;) {
    ended = child.has_ended();
    for (ssize_t n; (n = read(terminal, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(n));
    usleep(1000);
  }
  CHECK(child.wait() == Ending{0, 0});
  close(terminal);
  return text;
}

std::string seen_of_rbpa(Child::Command arguments, bool output_too = false) {
  arguments.insert(arguments.begin(), RBPA_PROGRAM);
  return seen_on_terminal(arguments, output_too);
}

std::string seen_of_meshtopo(Child::Command arguments, bool output_too = false) {
  arguments.insert(arguments.begin(), MESHTOPO_PROGRAM);
  return seen_on_terminal(arguments, output_too);
}

/// Enough points for progress from every part of a run.
std::string many_points() {
  std::string text;
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 150; ++x) text += std::to_string(7 * x + y % 5) + " " + std::to_string(5 * y + x % 3) + "\n";
  return text;
}

const std::string gone = "\r\x1b[K";

}  // namespace

TEST_SUITE("terminal") {
  TEST_CASE("the warning that no plateau stands out comes after the line of progress") {
    const Folder folder;
    const std::string points = folder.file("p.xy", corner);
    const std::string seen = seen_of_rbpa({"shape", points, "--alpha", "plateau", "-o", folder.path("s.wkt")});
    CHECK(contains(seen, "choosing alpha, "));
    CHECK(contains(seen, gone + "rbpa: --alpha plateau: no range of alpha stands out"));
  }

  TEST_CASE("every part of a run shows progress on a terminal, and leaves nothing there; with --quiet none does") {
    const Folder folder;
    const std::string points = folder.file("p.xy", many_points());
    const std::string alpha = seen_of_rbpa({"alpha", points, "--persistence"});
    CHECK(contains(alpha, "rbpa: "));
    for (const char* part : {"reading, ", " triangles, ", "radii of ", "persistence, ", "writing, "})
      CHECK(contains(alpha, part));
    CHECK(alpha.ends_with(gone));
    const std::string mesh = seen_of_rbpa({"mesh", points, "--alpha", "auto", "-o", folder.path("m.off")});
    CHECK(contains(mesh, "choosing alpha, "));
    CHECK(contains(mesh, "writing, "));
    CHECK(contains(seen_of_rbpa({"shape", points, "--alpha", "9", "-o", folder.path("s.wkt")}), "polygons, "));
    const std::string square = folder.file("p.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9))");
    const std::string fill = seen_of_rbpa({"fill", square, "--size", "0.05", "-o", folder.path("f.off")});
    for (const char* part : {"reading, ", "filling, ", " triangles, ", "writing, "}) CHECK(contains(fill, part));
    CHECK(seen_of_rbpa({"fill", square, "--size", "1", "-q", "-o", folder.path("f.off")}).empty());
    const std::string info = seen_of_rbpa({"info", points});
    CHECK(contains(info, "sorting 22.5 k points, "));
    CHECK(info.ends_with(gone));
    CHECK(seen_of_rbpa({"alpha", points, "--persistence", "-q"}).empty());
    CHECK(seen_of_rbpa({"mesh", points, "--alpha", "auto", "-q", "-o", folder.path("m.off")}).empty());
    CHECK(seen_of_rbpa({"shape", points, "--alpha", "9", "-q", "-o", folder.path("s.wkt")}).empty());
    CHECK(seen_of_rbpa({"info", points, "-q"}).empty());
  }

  TEST_CASE("every part of a run of meshtopo shows progress on a terminal") {
    const Folder folder;
    const std::string mesh = folder.file("m.off", pyramid_off);
    const std::string seen =
        seen_of_meshtopo({mesh, "--repair", "-o", folder.path("r.off"), "--generators", folder.path("l.obj")});
    for (const char* part : {"meshtopo: ", "reading, ", "topology of 5 faces, ", "repair, ", "loops, ", "writing, "})
      CHECK(contains(seen, part));
    CHECK(seen.ends_with(gone));
    CHECK(seen_of_meshtopo({mesh, "-q", "--repair", "-o", folder.path("r.off")}).empty());
    CHECK(seen_of_meshtopo({mesh, "-q"}).empty());
  }

  TEST_CASE("the line of progress moves while a program waits") {
    const Folder folder;
    const std::string pipe = folder.path("p.xy");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    Child late({"/bin/sh", "-c", "exec 3>'" + pipe + "'; sleep 1.3; printf '0 0\\n1 0\\n0 1\\n' >&3"});
    const std::string seen = seen_of_rbpa({"info", pipe});
    CHECK(contains(seen, "reading, 0 s"));
    CHECK(contains(seen, "reading, 1 s"));
  }

  TEST_CASE("the line of progress does not mix with output to the terminal") {
    const Folder folder;
    const std::string points = folder.file("p.xy", corner), mesh = folder.file("m.off", pyramid_off);
    CHECK_FALSE(contains(seen_of_rbpa({"alpha", points, "--csv"}, true), "writing"));
    CHECK_FALSE(
        contains(seen_of_rbpa({"mesh", points, "--alpha", "1", "-o", "-", "--output-format", "off"}, true), "writing"));
    CHECK_FALSE(contains(seen_of_meshtopo({mesh}, true), "writing"));
    CHECK(contains(seen_of_meshtopo({mesh, "-o", folder.path("r.txt")}, true), "writing"));
  }
}

TEST_SUITE("progress") {
  using rbpa::app::progress_text;

  TEST_CASE("the time left is shown when it can be estimated") {
    CHECK(progress_text({0, 1000}, 0.1) == "0 triangles");
    CHECK(progress_text({100, 1000000}, 0.02) == "100 triangles, 5.00 k/s");
    CHECK(progress_text({19999, 1000000}, 60) == "20.0 k triangles, 333/s");
    CHECK(progress_text({1000000, 1000000}, 1.9) == "1.00 M triangles, 526 k/s");
    CHECK(progress_text({1000000, 1000000}, 2) == "1.00 M triangles, 500 k/s, at most 2 s left");
  }

  TEST_CASE("a long time is shown in minutes and hours") {
    CHECK(progress_text({20000, 1000000}, 1) == "20.0 k triangles, 20.0 k/s");
    CHECK(progress_text({20000, 1000000}, 3) == "20.0 k triangles, 6.67 k/s, at most 4 min left");
    CHECK(progress_text({20000, 1000000}, 100) == "20.0 k triangles, 200/s, at most 2 h left");
    CHECK(rbpa::app::short_duration(119.9) == "119 s");
    CHECK(rbpa::app::short_duration(7199) == "119 min");
  }
}
