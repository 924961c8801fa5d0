// Names may have any bytes; pipes and devices are refused at once.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
namespace fs = std::filesystem;

namespace {

std::string points() {
  rbpa_test::Random random(51);
  std::string text;
  for (int i = 0; i < 400; ++i)
    text += std::to_string(random.below(2000)) + " " + std::to_string(random.below(2000)) + "\n";
  return text;
}

/// Runs `rbpa ARGUMENTS`, which is killed if it hangs.
Outcome limited(const Folder& folder, const std::string& arguments) {
  return folder.run("timeout", std::string("-s KILL 60 ") + RBPA_PROGRAM + " " + arguments);
}

void check_refused(const Folder& folder, const std::string& arguments, const std::string& part) {
  CAPTURE(arguments);
  const Outcome outcome = limited(folder, arguments);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 3);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(contains(outcome.err, part));
}

}  // namespace

TEST_CASE("inputs, targets and scratch may have names in Latin-1") {
  const std::string e = "\xe9";
  const Folder plain, folder;
  plain.file("p.xy", points());
  REQUIRE(plain.rbpa("stream p.xy --alpha 90 --tile-size 60 -o t.npy -o p.wkt -q").code == 0);
  folder.file("p" + e + ".xy", points());
  const auto check = [&](const std::string& triangles, const std::string& polygons) {
    CHECK(folder.content(triangles) == plain.content("t.npy"));
    CHECK(folder.content(polygons) == plain.content("p.wkt"));
  };
  const std::string run_key = "stream 'p" + e + ".xy' --alpha 90 --tile-size 60 -q ";
  const std::string targets = "-o 't" + e + ".npy' -o 'p" + e + ".wkt' ";
  CHECK(folder.rbpa(run_key + targets + "--stats 's" + e + ".json'").code == 0);
  check("t" + e + ".npy", "p" + e + ".wkt");
  CHECK(folder.has("s" + e + ".json"));

  const std::string scratch = "--scratch 's" + e + "' --keep-tiles ";
  CHECK(folder.rbpa(run_key + targets + scratch).code == 0);
  CHECK(folder.rbpa(run_key + targets + scratch + "--resume").code == 0);
  check("t" + e + ".npy", "p" + e + ".wkt");
  says(folder, run_key + "-o 'q" + e + ".npy' " + scratch + "--resume", 2,
       "--resume: found -o q\\xe9.npy, expected -o t\\xe9.npy -o p\\xe9.wkt, as the run in ");
  folder.file("q" + e + "%E9.xy", points());
  says(folder, "stream 'q" + e + "%E9.xy' --alpha 90 --tile-size 60 -q " + targets + scratch + "--resume", 2,
       "--resume: found the input ");
}

TEST_CASE("a pipe or a device is refused at once, before anything is made of the other files") {
  const Folder folder("p.xy", points());
  for (const char* name : {"f.npy", "f.xy", "f.las", "f.csv.gz"}) {
    REQUIRE(mkfifo(folder.path(name).c_str(), 0666) == 0);
    for (const std::string before : {"", "p.xy "})
      check_refused(
          folder, "stream " + before + name + " --alpha 1 -o t.npy",
          std::string(name) + ": found a pipe, a socket or a device, expected a regular file, as it is read twice");
    fs::remove(folder.path(name));
  }
  check_refused(folder, "stream /dev/null --format xy --alpha 1 -o t.npy",
                "/dev/null: found a pipe, a socket or a device");
}
