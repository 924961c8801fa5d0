// Standard output that is full, closed, or without a reader; and names in messages.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <random>
#include <string>
#include <vector>

#include "io/failure.h"
#include "support/child.h"
#include "support/program.h"

using namespace apps_test;

namespace {

const std::string full_message = "standard output: cannot write: No space left on device\n";

/// Runs `command` with a pipe for its standard output, which is closed after `bytes` are read, and standard error in
/// the file "errors".
Ending with_reader_of(std::size_t bytes, const Folder& folder, const Child::Command& command) {
  int ends[2];
  REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
  Child child(command, [&] {
    redirect(STDOUT_FILENO, ends[1]);
    redirect(STDERR_FILENO, folder.path("errors"), O_WRONLY | O_CREAT | O_TRUNC);
  });
  close(ends[1]);
  for (char byte; bytes > 0 && read(ends[0], &byte, 1) == 1; --bytes) continue;
  close(ends[0]);
  return child.wait();
}

}  // namespace

TEST_SUITE("standard output") {
  TEST_CASE("help and version fail if they cannot be written") {
    const Folder folder;
    for (const std::string what : {"--help", "--version", "mesh --help", "info --help"}) {
      CAPTURE(what);
      const Outcome outcome =
          folder.run("/bin/sh", std::string("-c '") + RBPA_PROGRAM + " " + what + " >/dev/full'", 1);
      CHECK(outcome.err == "rbpa: " + full_message);
    }
    for (const std::string what : {"--help", "--version"}) {
      const Outcome outcome =
          folder.run("/bin/sh", std::string("-c '") + MESHTOPO_PROGRAM + " " + what + " >/dev/full'", 1);
      CHECK(outcome.err == "meshtopo: " + full_message);
    }
  }

  TEST_CASE("a reader that goes away ends a run with 141, silently, and nothing is left") {
    const Folder folder;
    std::string points;
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) points += std::to_string(random()) + " " + std::to_string(random()) + "\n";
    const std::string path = folder.file("p.xy", points);
    std::string mesh = "OFF\n3 50000 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (int i = 0; i < 50000; ++i) mesh += "3 0 1 2\n";
    const std::string soup = folder.file("m.off", mesh);
    const std::string stats = folder.path("s.json"), picture = folder.path("a.svg");
    const std::vector<Child::Command> commands = {
        {RBPA_PROGRAM, "alpha", path, "--csv", "-q", "-o", picture, "--stats", stats},
        {RBPA_PROGRAM, "alpha", path, "--json", "-q"},
        {RBPA_PROGRAM, "mesh", path, "--alpha", "inf", "-o", "-", "--output-format", "obj", "--stats", stats, "-q"},
        {RBPA_PROGRAM, "shape", path, "--alpha", "2e7", "-o", "-", "--output-format", "svg", "--stats", stats, "-q"},
        {MESHTOPO_PROGRAM, soup, "--json", "--generators", picture.substr(0, picture.size() - 3) + "obj", "--repair",
         "-o", folder.path("r.off")}};
    for (const Child::Command& command : commands)
      for (const std::size_t bytes : {std::size_t{0}, std::size_t{10}, std::size_t{5000}}) {
        CAPTURE(command[1]);
        CHECK(with_reader_of(bytes, folder, command) == Ending{141, 0});
        CHECK(folder.content("errors").empty());
        CHECK(folder.names() == std::vector<std::string>{"errors", "m.off", "p.xy"});
      }
    // A short output may be in the pipe before its reader goes, so the run may end either way, but silently.
    const Ending info = with_reader_of(0, folder, {RBPA_PROGRAM, "info", path});
    CHECK((info == Ending{141, 0} || info == Ending{0, 0}));
    CHECK(folder.content("errors").empty());
    CHECK(with_reader_of(0, folder, {RBPA_PROGRAM, "--help"}).by_itself());
    CHECK(folder.content("errors").empty());
  }

  TEST_CASE("bytes for a closed stream do not get into a file") {
    const Folder folder;
    const std::string path = folder.file("p.xy", corner);
    Child child({RBPA_PROGRAM, "alpha", path, "-o", folder.path("a.svg"), "--stats", folder.path("s.json")},
                [] { close(STDOUT_FILENO); });
    CHECK(child.wait() == Ending{1, 0});
    Child quiet({RBPA_PROGRAM, "mesh", path, "--alpha", "1", "-o", folder.path("m.off")}, [] {
      close(STDOUT_FILENO);
      close(STDERR_FILENO);
      close(STDIN_FILENO);
    });
    CHECK(quiet.wait() == Ending{0, 0});
    CHECK(folder.names() == std::vector<std::string>{"m.off", "p.xy"});
    CHECK(folder.content("m.off") == "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  }
}

TEST_SUITE("messages") {
  using rbpa::app::printable;

  TEST_CASE("control characters are escaped, and letters of any script stay") {
    CHECK(printable("a b'c\"d\\e") == "a b'c\"d\\e");
    CHECK(printable("für 雪 \xF0\x9F\x8C\x8D") == "für 雪 \xF0\x9F\x8C\x8D");
    CHECK(printable("a\nb\rc\td") == "a\\nb\\rc\\td");
    CHECK(printable(std::string_view("\x1b[31m\0\x7f", 7)) == "\\x1b[31m\\x00\\x7f");
    CHECK(printable("\xC2\x9B"
                    "31m") == "\\xc2\\x9b31m");  // a control character of two bytes
    CHECK(printable("\xE2\x80\xAE"
                    "fdp") == "\\xe2\\x80\\xaefdp");        // from right to left
    CHECK(printable("\xE2\x80\xA8") == "\\xe2\\x80\\xa8");  // another end of a line
    CHECK(printable("\xE2\x80\xA6") == "\xE2\x80\xA6");     // three dots
  }

  TEST_CASE("bytes that are not UTF-8 are escaped one by one") {
    CHECK(printable("\xFF"
                    "a\x80") == "\\xffa\\x80");
    CHECK(printable("\xC3") == "\\xc3");  // cut off
    CHECK(printable("\xE2\x82x") == "\\xe2\\x82x");
    CHECK(printable("\xC0\xAF\xE0\x80\xAF") == "\\xc0\\xaf\\xe0\\x80\\xaf");  // longer than need be
    CHECK(printable("\xED\xA0\x80") == "\\xed\\xa0\\x80");                    // a surrogate
    CHECK(printable("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");           // beyond Unicode
    CHECK(printable("\xF8\x88\x80\x80\x80") == "\\xf8\\x88\\x80\\x80\\x80");
  }

  TEST_CASE("a message is one line, whatever is in a name") {
    const Folder folder;
    const std::string name = "a\x1b[31m\nb\xFF.xy", shown = "a\\x1b[31m\\nb\\xff.xy";
    CHECK(folder.rbpa("info '" + name + "'").err ==
          "rbpa: " + shown + ": found no such file, expected a file of points\n");
    folder.file(name, "0 0\n1 \x1b[2Jx\n");
    CHECK(folder.rbpa("info '" + name + "'").err ==
          "rbpa: " + shown + ":2: found '\\x1b[2Jx', expected a number" + skipping_hint + "\n");
    folder.file(name, corner);
    CHECK(folder.rbpa("mesh '" + name + "' --alpha 1 -o 'm\n.off'").err ==
          "rbpa: 3 points, 1 triangle, 0 isolated -> m\\n.off\n");
    CHECK(folder.rbpa("info p.xy --\x1b[31m").err ==
          "rbpa: found '--\\x1b[31m', expected an option of rbpa info (see rbpa info --help)\n");
    CHECK(folder.rbpa("mesh p.xy --alpha '\n' -o m.off").err ==
          "rbpa: --alpha: found '\\n', expected a radius (a number > 0, or inf), auto, min, plateau or plateau:K\n");
    CHECK(folder.meshtopo("'" + name + "' --format off").err ==
          "meshtopo: " + shown + ":2: found '1 0', expected the end of the file after 0 face lines as line 1 says\n");
    CHECK(folder.meshtopo("m.off --max-defects '\x1b'").err ==
          "meshtopo: --max-defects: found '\\x1b', expected a whole number from 0\n");
  }
}
