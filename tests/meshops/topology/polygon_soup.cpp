// Lists that do not split corners into faces: every function that reads a soup refuses them by name, and reads nothing
// beyond them.
#include "meshops/topology/polygon_soup.h"

#include <doctest/doctest.h>

#include <string>

#include "meshops/core/contract.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/examine.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "support/meshes.h"
#include "support/refusal.h"

using namespace meshops;
using namespace meshops::test;

namespace {

PolygonSoup with_begin(std::vector<std::size_t> begin) {
  PolygonSoup soup;
  soup.points = 4;
  soup.corners = {0, 1, 2, 2, 1, 3};
  soup.begin = std::move(begin);
  return soup;
}

/// Checks the message of every function that reads a soup.
void check_refused(const PolygonSoup& soup, const std::string& message) {
  CAPTURE(message);
  TestMesh mesh;
  CHECK(refusal([&] { require_parted(soup); }) == message);
  CHECK(refusal([&] { (void)find_defects(soup); }) == message);
  CHECK(refusal([&] { (void)report(soup); }) == message);
  CHECK(refusal([&] { (void)examine(soup); }) == message);
  CHECK(refusal([&] { (void)repair(soup); }) == message);
  CHECK(refusal([&] { (void)build_mesh(mesh, soup); }) == message);
  CHECK(mesh.n_vertices() == 0);
}

}  // namespace

TEST_SUITE("polygon soup") {
  TEST_CASE("lists that split corners into faces are accepted, whatever the corners") {
    for (const auto& begin : {std::vector<std::size_t>{0, 3, 6}, {0, 6}, {0, 0, 3, 3, 6, 6}})
      CHECK_NOTHROW(require_parted(with_begin(begin)));
    CHECK_NOTHROW(require_parted(PolygonSoup{}));
  }

  TEST_CASE("an entry of begin beyond the corners is refused, and nothing there is read") {
    check_refused(with_begin({0, 3, 6, 9}),
                  "PolygonSoup: begin[3] is 9; expected 6, the number of corners, as it is the last");
    check_refused(
        with_begin({0, 3, static_cast<std::size_t>(-1)}),
        "PolygonSoup: begin[2] is 18446744073709551615; expected 6, the number of corners, as it is the last");
  }

  TEST_CASE("corners outside every face are refused") {
    check_refused(with_begin({3, 6}), "PolygonSoup: begin[0] is 3; expected 0");
    check_refused(with_begin({0, 3}),
                  "PolygonSoup: begin[1] is 3; expected 6, the number of corners, as it is the last");
    check_refused(with_begin({0}), "PolygonSoup: begin[0] is 0; expected 6, the number of corners, as it is the last");
  }

  TEST_CASE("descending entries of begin are refused") {
    check_refused(with_begin({0, 9, 6}), "PolygonSoup: begin[2] is 6; expected no less than begin[1], which is 9");
    check_refused(with_begin({0, 3, 2, 6}), "PolygonSoup: begin[2] is 2; expected no less than begin[1], which is 3");
  }

  TEST_CASE("an empty begin is refused, as of a soup that was moved from") {
    check_refused(with_begin({}), "PolygonSoup: begin is empty; expected 0, and then the end of each face");
  }
}
