// An empty complex is an answer: exit code 0, with a message on standard error.
#include <doctest/doctest.h>

#include "support/program.h"

using namespace apps_test;

namespace {

void is_empty_because(const std::string& content, const std::string& reason) {
  CAPTURE(content);
  const Folder folder("p.xy", content);
  CHECK(folder.rbpa("mesh p.xy --alpha 1 -o m.npy --quiet", 0).err == "rbpa: the complex is empty: " + reason + "\n");
  CHECK(folder.has("m.npy"));
}

}  // namespace

TEST_SUITE("empty complex") {
  TEST_CASE("0, 1 and 2 points give an empty complex") {
    is_empty_because("# no point at all\n", "fewer than three distinct points (0)");
    is_empty_because("1 2\n", "fewer than three distinct points (1)");
    is_empty_because("1 2\n3 4\n", "fewer than three distinct points (2)");
  }
  TEST_CASE("equal points give an empty complex") {
    is_empty_because("1 2\n1 2\n1 2\n1 2\n", "fewer than three distinct points (1)");
  }
  TEST_CASE("collinear points give an empty complex") {
    is_empty_because("0 0\n1 1\n2 2\n5 5\n", "all points are collinear");
  }
  TEST_CASE("a too small alpha gives an empty complex") {
    is_empty_because("0 0\n10 0\n0 10\n", "no triangle has circumradius <= 1");
  }
}
