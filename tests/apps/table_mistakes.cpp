// Tables with mistakes of those who wrote them: stray quotes, names that lack, exchanged axes, mixed decimal signs.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_points.h"
#include "io/crs.h"
#include "io/text/columns.h"
#include "support/program.h"
#include "support/read_table.h"

using namespace apps_test;
using rbpa::Point;
using namespace rbpa::app;

namespace {

const std::vector<Point> corners = {{0, 0}, {4, 0}, {0, 3}};
const CloudRequest skipping{.skip_invalid = true};

}  // namespace

TEST_SUITE("table mistakes") {
  TEST_CASE("of names that differ in the letter case, the pair of one case is taken") {
    for (const std::string header : {"X,x,y,sp", "x,X,Y,sp", "\"X\",\"x\",\"y\",\"sp\"", "Lon,lon,lat,n"})
      CHECK(read_table(header + "\n1,0,0,a\n2,4,0,b\n3,0,3,c\n").points == corners);
    CHECK(read_table("x,y,X\n0,0,1\n4,0,2\n0,3,3\n").points == corners);
    CHECK(read_table("x,Y\n0,0\n4,0\n0,3\n").points == corners);
  }
}
