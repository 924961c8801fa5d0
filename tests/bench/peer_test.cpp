#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "bench/peer.h"
#include "bench/workload.h"

using rbpa_bench::Clock;
using rbpa_bench::run_peer;

namespace {

const rbpa_test::Points corner{{0, 0}, {1, 0}, {0, 1}};

/// Returns why a command has no result.
std::string failure(const std::string& command) {
  try {
    run_peer(command, corner);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Returns a command that writes the bytes that printf makes of `format`.
std::string writes(const std::string& format) { return "sh -c 'printf \"" + format + "\" >\"$2\"' peer"; }

}  // namespace

TEST_CASE("a peer reads the points and writes the triangles") {
  rbpa_bench::Triangles triangles;
  const std::string reads = R"sh(sh -c 'test "$(od -An -tf8 "$1" | tr -s " \n" " ")" = " 0 0 1 0 0 1 " || exit 1;)sh"
                            R"sh( printf "\000\000\000\000\001\000\000\000\002\000\000\000" >"$2"' peer)sh";
  const rbpa_bench::Run run = run_peer(reads, corner, &triangles);
  CHECK(run.triangles == 1);
  CHECK(triangles == rbpa_bench::Triangles{{0, 1, 2}});
}

TEST_CASE("a peer's time is the one it reports, or that of its process") {
  const rbpa_bench::Run says = run_peer("sh -c 'echo seconds 0.125 >&2; : >\"$2\"' peer", corner);
  CHECK(says.seconds == 0.125);
  CHECK(says.clock == Clock::peer);
  const rbpa_bench::Run silent = run_peer("sh -c 'sleep 0.05; : >\"$2\"' peer", corner);
  CHECK(silent.seconds >= 0.05);
  CHECK(silent.clock == Clock::process);
}

TEST_CASE("a peer that fails is reported as failed, with the reason") {
  CHECK(failure("sh -c 'exit 3' peer") == "ended with 3");
  CHECK(failure("sh -c 'echo no memory >&2; exit 1' peer") == "ended with 1: no memory");
  CHECK(failure("sh -c 'kill -9 $$' peer").starts_with("ended "));  // the shell may turn signal 9 into 137
  CHECK(failure("no_such_program 2>/dev/null") == "ended with 127");
  CHECK(failure("true") == "wrote no triangles");
  CHECK(failure(writes("abcde")) == "wrote 5 bytes, expected 12 for each triangle");
  CHECK(failure(writes("\\000\\000\\000\\000\\001\\000\\000\\000\\003\\000\\000\\000")) ==
        "triangle 0 has point 3 of 3");
  CHECK(failure("sh -c 'echo seconds many >&2; : >\"$2\"' peer") ==
        "said 'seconds many', expected seconds and a number above 0");
}

TEST_CASE("the example of a peer finds what rbpa finds") {
  const rbpa_test::Points points = rbpa_bench::grid.make(400);
  rbpa_bench::Triangles ours, theirs;
  const std::size_t expected =
      rbpa_bench::run_rbpa(points, std::numeric_limits<double>::infinity(), 1, &ours).triangles;
  const rbpa_bench::Run run = run_peer(RBPA_EXAMPLE_PEER, points, &theirs);
  CHECK(expected == 722);
  CHECK(run.triangles == expected);
  CHECK(run.clock == Clock::peer);
  CHECK(rbpa_test::canonical(theirs) == rbpa_test::canonical(ours));
}
