// `rbpa voronoi`: cells as polygons within a boundary, with the fields of their points, and wrong calls.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

/// Returns twice the area of a ring, which is closed.
double twice_area(const Json& ring) {
  double area = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    area += ring[i][0].get<double>() * ring[i + 1][1].get<double>() -
            ring[i][1].get<double>() * ring[i + 1][0].get<double>();
  return area;
}

double area_of(const Json& collection) {
  double area = 0;
  for (const Json& feature : collection["features"])
    for (const Json& ring : feature["geometry"]["coordinates"]) area += twice_area(ring) / 2;
  return area;
}

constexpr const char* square = "x,y,name,size\n0,0,a,1\n4,0,b,2\n4,4,c,3\n0,4,d,4\n0,0,e,5\n";

}  // namespace

TEST_SUITE("voronoi") {
  TEST_CASE("cells tile a box around the points, and have their indices and fields") {
    const Folder folder("p.csv", square);
    const Outcome outcome = folder.rbpa("voronoi p.csv -o c.geojson -o c.wkt -o c.csv -o c.svg -o c.png");
    CHECK(outcome.err ==
          "rbpa: 5 points (1 duplicate), 4 cells of 4 polygons, area 23.04 -> c.geojson, c.wkt, c.csv, c.svg, c.png\n");
    const Json json = Json::parse(folder.content("c.geojson"));
    REQUIRE(json["features"].size() == 4);
    CHECK(area_of(json) == doctest::Approx(23.04));
    const Json& first = json["features"][0]["properties"];
    CHECK(first["point"] == 0);
    CHECK(first["points"] == 2);  // with the duplicate
    CHECK(first["name"] == "a");
    CHECK(first["size"] == 1);
    CHECK(first["area"].get<double>() == doctest::Approx(23.04 / 4));
    CHECK(folder.content("c.csv") == "x,y,polygon,name,size\n0,0,1,a,1\n4,0,2,b,2\n4,4,3,c,3\n0,4,4,d,4\n0,0,1,e,5\n");
    // Cells share sides, and so are no valid MULTIPOLYGON.
    CHECK(folder.content("c.wkt").starts_with("GEOMETRYCOLLECTION (POLYGON (("));
    CHECK(folder.rbpa("voronoi p.csv --crs EPSG:28992 -q -o c.ewkt").code == 0);
    CHECK(folder.content("c.ewkt") == "SRID=28992;" + folder.content("c.wkt"));
    CHECK(!contains(folder.rbpa("voronoi p.csv --fields size -o - --output-format geojson -q").out, "\"name\""));
    CHECK(contains(folder.rbpa("voronoi p.csv --where \"name in ('b', 'd')\" -o - --output-format geojson -q").out,
                   "\"point\":3,"));
  }

  TEST_CASE("the boundary may be the hull, the alpha shape, or polygons, outside of which a point has no cell") {
    const Folder folder("p.csv", square);
    const auto area = [&](const std::string& clip) {
      return area_of(Json::parse(folder.rbpa("voronoi p.csv -q -o - --output-format geojson --clip " + clip).out));
    };
    CHECK(area("hull") == 16);
    CHECK(area("shape --alpha 3") == 16);
    CHECK(area("shape --alpha inf") == 16);
    CHECK(area("shape") == 16);
    folder.file("clip.wkt", "MULTIPOLYGON (((-1 -1, 1 -1, 1 1, -1 1, -1 -1)), ((2 2, 6 2, 6 6, 2 6, 2 2)))\n");
    CHECK(area("clip.wkt") == 20);
    const Outcome outcome = folder.rbpa("voronoi p.csv --clip clip.wkt -o c.csv");
    CHECK(outcome.err == "rbpa: 5 points (1 duplicate), 2 cells of 2 polygons, area 20 -> c.csv\n");
    CHECK(folder.content("c.csv") == "x,y,polygon,name,size\n0,0,1,a,1\n4,0,,b,2\n4,4,2,c,3\n0,4,,d,4\n0,0,1,e,5\n");
    CHECK(contains(folder.rbpa("voronoi p.csv --clip shape -o c.wkt").err, ", alpha plateau = "));
    folder.file("none.wkt", "MULTIPOINT EMPTY\n");
    CHECK(folder.rbpa("voronoi none.wkt -o c.wkt").err == "rbpa: 0 points, 0 cells of 0 polygons, area 0 -> c.wkt\n");
    CHECK(folder.content("c.wkt") == "GEOMETRYCOLLECTION EMPTY\n");
    folder.file("one.csv", "x,y\n3,4\n");
    CHECK(folder.rbpa("voronoi one.csv -o c.wkt --stats s.json -q").code == 0);
    CHECK(Json::parse(folder.content("s.json"))["polygons"] == 1);
  }

  TEST_CASE("wrong calls and boundaries are refused") {
    const Folder folder({{"p.csv", square},
                         {"bow.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))\n"},
                         {"other.wkt", "SRID=28992;POLYGON ((0 0, 4 0, 4 4, 0 0))\n"}});
    const std::pair<const char*, const char*> calls[] = {
        {"voronoi p.csv --alpha 3 -o c.wkt", "--alpha requires --clip shape"},
        {"voronoi p.csv --clip shape --alpha much -o c.wkt", "--alpha"},
        {"voronoi p.csv --clip nowhere -o c.wkt", "--clip"},
        {"voronoi p.csv --clip bow.wkt -o bow.wkt", "bow.wkt"},
        {"voronoi p.csv --fields name -o c.wkt", "--fields"},
        {"voronoi - --clip - -o c.wkt", "--clip -: found POINTS on standard input as well"},
        {"voronoi p.csv", "-o"},
    };
    for (const auto& each : calls) {
      const Outcome outcome = folder.rbpa(each.first);
      INFO(each.first);
      CHECK(outcome.code == 2);
      CHECK_MESSAGE(contains(outcome.err, each.second), outcome.err);
    }
    CHECK(folder.rbpa("voronoi p.csv --clip bow.wkt -o c.wkt").err.starts_with("rbpa: bow.wkt: "));
    CHECK(folder.rbpa("voronoi p.csv --clip bow.wkt -o c.wkt").code == 3);
    folder.file("q.wkt", "SRID=32631;MULTIPOINT (0 0, 4 0, 4 4, 0 4)\n");
    CHECK(folder.rbpa("voronoi q.wkt --clip other.wkt -o c.wkt").code == 3);
    CHECK(!folder.has("c.wkt"));
  }
}
