// `rbpa shape` needs little memory for a point, and warns at the beginning if there is less.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/formats.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;

// Sanitizers take memory for themselves.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

constexpr std::size_t count = 400'000;

void make_points(const Folder& folder) {
  rbpa_test::Random random(71);
  std::vector<double> values(2 * count);
  for (double& value : values) value = double(random.below(1U << 30U)) * 0x1p-30 * std::sqrt(double(count));
  folder.file("p.f64xy", {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
}

}  // namespace

TEST_SUITE("shape") {
  TEST_CASE("a footprint takes about a hundred bytes a point, in every format") {
    const Folder folder;
    make_points(folder);
    for (const char* target : {"t.wkt", "t.csv"}) {
      CAPTURE(target);
      const std::string command =
          std::string(RBPA_PROGRAM) + " shape p.f64xy --alpha 1 --threads 1 -q --stats s.json -o ";
      // A shell is between, as a process begins with the peak memory of the one that it is forked from.
      REQUIRE(folder.run("sh", "-c '" + command + target + "; true'").code == 0);
      const auto stats = nlohmann::json::parse(folder.content("s.json"));
      const double program = rbpa::app::has_gdal() ? 30e6 : 10e6;
      CHECK((stats.at("peak_bytes").get<double>() - program) / double(count) < 125);
    }
  }

  TEST_CASE("a warning before the work says that memory may not suffice, and names rbpa stream") {
    const Folder folder;
    make_points(folder);
    const auto limited = [&](std::size_t mebibytes, const std::string& more) {
      return folder.run("sh", "-c 'ulimit -v " + std::to_string(mebibytes << 10U) + "; " + RBPA_PROGRAM +
                                  " shape p.f64xy --alpha 1 --threads 1 -o t.wkt " + more + "'");
    };
    const std::string said = "p.f64xy: 400000 points take about 40 MB of memory here, more than the ";
    const Outcome with_plenty = limited(8192, "");
    CHECK(with_plenty.code == 0);
    CHECK(!contains(with_plenty.err, "rbpa stream"));
    bool is_said = false;
    for (std::size_t mebibytes = 256; mebibytes > 16 && !is_said; mebibytes = mebibytes * 3 / 4) {
      const Outcome outcome = limited(mebibytes, "");
      is_said = outcome.err.starts_with("rbpa: " + said);
      // Without the warning the memory suffices.
      if (!is_said) REQUIRE(outcome.code == 0);
      if (!is_said) continue;
      CHECK(contains(outcome.err, " MB available (rbpa stream makes the same within the limit of its --memory)\n"));
      CHECK((outcome.code == 0 || outcome.code == 1));
    }
    CHECK(is_said);
  }
}

#endif
