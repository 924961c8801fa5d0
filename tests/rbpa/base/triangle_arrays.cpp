#include "rbpa/base/triangle_arrays.h"

#include <doctest/doctest.h>

#include <limits>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "support/generate.h"
#include "support/refusal_of.h"

using rbpa::AlphaComplex;
using rbpa_test::refusal_of;

TEST_SUITE_BEGIN("arrays");

TEST_CASE("arrays of alpha_complex() are linked, and are no longer linked after any one number changes") {
  const rbpa_test::Points points = rbpa_test::sparse_grid(4, 0.9, 3);
  const AlphaComplex good = rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  REQUIRE(good.triangles.size() > 10);
  CHECK_NOTHROW(rbpa::require_linked(good, points.size()));
  const auto is_refused = [&](const AlphaComplex& bad) {
    CHECK_THROWS_AS(rbpa::require_linked(bad, points.size()), meshops::ContractViolation);
  };
  for (std::size_t t = 0; t < good.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::uint32_t other : {good.triangles[t][(k + 1) % 3], std::uint32_t{1000}}) {
        AlphaComplex bad = good;
        bad.triangles[t][k] = other;
        is_refused(bad);
      }
      for (const std::uint32_t other : {static_cast<std::uint32_t>(t), good.neighbors[t][(k + 1) % 3], 1000u}) {
        if (other == good.neighbors[t][k]) continue;
        AlphaComplex bad = good;
        bad.neighbors[t][k] = other;
        is_refused(bad);
      }
    }
  CHECK_THROWS_AS(rbpa::require_linked(good, points.size(), [] { return false; }), rbpa::Cancelled);
  AlphaComplex shorter = good;
  shorter.neighbors.pop_back();
  is_refused(shorter);
  shorter.neighbors.clear();
  CHECK(refusal_of<meshops::ContractViolation>([&] {
          rbpa::require_linked(shorter, points.size());
        }).ends_with("expected a row for each (alpha_complex() fills them in with the option neighbors)"));
}

TEST_SUITE_END();
