// Files of GDAL: we read what GDAL writes, and GDAL reads what we write, to the last bit and with the system.
#include <doctest/doctest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "io/number.h"
#include "io/polygon/ogr.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;
using rbpa::Point;
using namespace rbpa::app;

namespace {

/// A format, and how exact GDAL is with it.
struct GdalFormat {
  std::string driver, ending;
};
const GdalFormat formats[] = {{"GPKG", "gpkg"}, {"FlatGeobuf", "fgb"}, {"ESRI Shapefile", "shp"}};

/// Writes a layer of the geometries, as well-known text, by GDAL itself.
void write_layer(GDALDataset& file, const std::string& name, OGRwkbGeometryType type,
                 const std::vector<std::string>& wkt, int epsg) {
  OGRSpatialReference system;
  if (epsg > 0) REQUIRE(system.importFromEPSG(epsg) == OGRERR_NONE);
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRLayer* layer = file.CreateLayer(name.c_str(), epsg > 0 ? &system : nullptr, type, nullptr);
  REQUIRE(layer != nullptr);
  for (const std::string& text : wkt) {
    OGRFeature feature(layer->GetLayerDefn());
    OGRGeometry* geometry = nullptr;
    if (!text.empty()) REQUIRE(OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &geometry) == OGRERR_NONE);
    feature.SetGeometryDirectly(geometry);
    REQUIRE(layer->CreateFeature(&feature) == OGRERR_NONE);
  }
}

GDALDatasetUniquePtr create(const GdalFormat& format, const std::string& path) {
  GDALAllRegister();
  GDALDatasetUniquePtr file(GetGDALDriverManager()
                                ->GetDriverByName(format.driver.c_str())
                                ->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  REQUIRE(file);
  return file;
}

GDALDatasetUniquePtr open(const std::string& path) {
  GDALAllRegister();
  GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  REQUIRE(file);
  return file;
}

constexpr const char* squares = "0.1 0\n1 0\n1 1\n0 1\n3 3\n10 0\n11 0\n11 1\n10 1\n11 1\n90 90\n";

std::vector<Point> ring_of(const OGRLinearRing& ring) {
  std::vector<Point> points;
  for (int i = 0; i + 1 < ring.getNumPoints(); ++i) points.push_back({ring.getX(i), ring.getY(i)});
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace

TEST_SUITE("ogr") {
  TEST_CASE("points of every format are read to the last bit, with their system") {
    std::mt19937_64 random(3);
    std::vector<Point> points;
    while (points.size() < 500) {
      // Exponents beyond those of a float are not tested here, as GDAL keeps bounding boxes.
      const double x = (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5) * 1e6,
                   y = static_cast<double>(random()) / 7;
      points.push_back({x, y});
    }
    for (const GdalFormat& format : formats) {
      CAPTURE(format.driver);
      const Folder folder;
      const std::string path = folder.path("p." + format.ending);
      {
        const GDALDatasetUniquePtr file = create(format, path);
        OGRSpatialReference system;
        REQUIRE(system.importFromEPSG(28992) == OGRERR_NONE);
        OGRLayer* layer = file->CreateLayer("p", &system, wkbPoint, nullptr);
        for (const Point& p : points) {
          OGRFeature feature(layer->GetLayerDefn());
          const OGRPoint geometry(p.x, p.y);
          feature.SetGeometry(&geometry);
          REQUIRE(layer->CreateFeature(&feature) == OGRERR_NONE);
        }
      }
      PointFile read = read_ogr_points(path, std::nullopt, false);
      CHECK(read.crs->text() == "EPSG:28992");
      CHECK_FALSE(read.degrees);
      std::vector<Point> expected = points;
      std::sort(expected.begin(), expected.end());  // a FlatGeobuf is sorted for its index
      std::sort(read.points.begin(), read.points.end());
      CHECK(read.points == expected);
    }
  }

  TEST_CASE("every geometry, degrees, layers, and features without a geometry are read") {
    const Folder folder;
    const std::string path = folder.path("p.gpkg");
    {
      const GDALDatasetUniquePtr file = create(formats[0], path);
      write_layer(*file, "points", wkbUnknown, {"POINT (5 52)", "", "MULTIPOINT (6 53, 7 54)", "POINT EMPTY"}, 4326);
      write_layer(
          *file, "shapes", wkbUnknown,
          {"LINESTRING (0 0, 1 0)", "POLYGON ((0 0, 1 0, 1 1, 0 0), (2 2, 3 2, 2 2))",
           "MULTIPOLYGON (((4 4, 5 4, 5 5, 4 4)))", "GEOMETRYCOLLECTION (POINT (9 9), LINESTRING (8 8, 7 7, 8 8))"},
          0);
      write_layer(*file, "curves", wkbUnknown, {"CIRCULARSTRING (0 0, 1 1, 2 0)"}, 0);
    }
    const PointFile points = read_ogr_points(path, "points", false);
    CHECK(points.points == std::vector<Point>{{5, 52}, {6, 53}, {7, 54}});  // x is the longitude, whatever EPSG says
    CHECK(points.degrees);
    CHECK(points.crs->is_wgs84());
    CHECK(points.warnings == std::vector<std::string>{"1 feature without a geometry"});
    const PointFile shapes = read_ogr_points(path, "shapes", true);
    CHECK(shapes.points == std::vector<Point>{{0, 0},
                                              {1, 0},
                                              {0, 0},
                                              {1, 0},
                                              {1, 1},
                                              {2, 2},
                                              {3, 2},
                                              {4, 4},
                                              {5, 4},
                                              {5, 5},
                                              {9, 9},
                                              {8, 8},
                                              {7, 7},
                                              {8, 8}});
    const auto refusal = [&](const std::string& arguments) {
      const Outcome outcome = folder.rbpa("info p.gpkg " + arguments, 3);
      return outcome.err;
    };
    CHECK(refusal("") ==
          "rbpa: p.gpkg: found the layers points, shapes, curves, expected --layer with the name of one\n");
    CHECK(refusal("--layer x") == "rbpa: p.gpkg: found the layers points, shapes, curves, expected one called 'x'\n");
    CHECK(refusal("--layer shapes") ==
          "rbpa: p.gpkg: feature 1: found LINESTRING, expected POINT or MULTIPOINT (--vertices takes the vertices of "
          "lines and polygons)\n");
    CHECK(contains(refusal("--layer curves --vertices"), "(ogr2ogr -nlt CONVERT_TO_LINEAR makes them)"));
    CHECK(folder.rbpa("info p.gpkg --layer points").out.starts_with("points      3\n"));
    CHECK(folder.rbpa("info - --format ogr < p.gpkg").code == 2);
    folder.file("p.xy", corner);
    CHECK(folder.rbpa("info p.xy --layer a").err ==
          "rbpa: --layer: found a format without layers, expected a file that GDAL reads (--format ogr)\n");
  }

  TEST_CASE("triangles have heights and attributes, and a compound system counts by its horizontal part") {
    const Folder folder("p.csv", "x,y,z,g\n0,0,1.5,a\n1,0,2,a\n0,1,-3,a\n5,5,1,b\n6,5,1,b\n5,6,4,b\n");
    REQUIRE(folder
                .rbpa("mesh p.csv --columns x,y --group-by g --alpha 9 --crs EPSG:28992 -q -o t.gpkg -o t.fgb -o t.shp "
                      "-o t.geojson")
                .code == 0);
    const json features = json::parse(folder.content("t.geojson"))["features"];
    for (const GdalFormat& format : formats) {
      CAPTURE(format.driver);
      const GDALDatasetUniquePtr file = open(folder.path("t." + format.ending));
      OGRLayer* layer = file->GetLayer(0);
      CHECK(std::string(layer->GetSpatialRef()->GetAuthorityCode(nullptr)) == "28992");
      std::size_t found = 0;
      for (; const OGRFeatureUniquePtr feature{layer->GetNextFeature()}; ++found) {
        const json& expected = features[static_cast<std::size_t>(feature->GetFieldAsInteger("number") - 1)];
        CHECK(std::string(feature->GetFieldAsString("group")) == expected["properties"]["group"]);
        CHECK(feature->GetFieldAsDouble("area") == expected["properties"]["area"]);
        std::vector<std::array<double, 3>> corners, wanted;
        for (const OGRPoint& p : *feature->GetGeometryRef()->toPolygon()->getExteriorRing())
          corners.push_back({p.getX(), p.getY(), p.getZ()});
        for (const json& p : expected["geometry"]["coordinates"][0]) wanted.push_back({p[0], p[1], p[2]});
        for (auto* ring : {&corners, &wanted}) {
          ring->pop_back();
          std::sort(ring->begin(), ring->end());
        }
        CHECK(corners == wanted);
      }
      CHECK(found == 2);
    }
    // Heights of a layer come back, and so does its system.
    REQUIRE(folder.rbpa("mesh t.gpkg --vertices --alpha 1 -o m.obj -q").code == 0);
    CHECK(contains(folder.content("m.obj"), "v 0 0 1.5\n"));
    write_layer(*create({"GPKG", "gpkg"}, folder.path("c.gpkg")), "points", wkbPoint25D, {"POINT Z (1 2 3)"}, 7415);
    CHECK(contains(folder.rbpa("info c.gpkg").out, "crs         EPSG:28992\n"));
  }

  TEST_CASE("GDAL reads the written geometries to the last bit, the numbers and the system") {
    const Folder folder("p.xy", squares);
    REQUIRE(
        folder
            .rbpa("shape p.xy --alpha 1 --crs EPSG:28992 -o s.gpkg -o s.fgb -o s.shp -o s.geojson --isolated i.fgb -q")
            .code == 0);
    const json features = json::parse(folder.content("s.geojson"))["features"];
    for (const GdalFormat& format : formats) {
      CAPTURE(format.driver);
      const GDALDatasetUniquePtr file = open(folder.path("s." + format.ending));
      OGRLayer* layer = file->GetLayer(0);
      CHECK(std::string(layer->GetSpatialRef()->GetAuthorityCode(nullptr)) == "28992");
      std::map<int, bool> found;
      while (const OGRFeatureUniquePtr feature{layer->GetNextFeature()}) {
        const int number = feature->GetFieldAsInteger("number");
        const json& expected = features[static_cast<std::size_t>(number - 1)];
        for (const char* name : {"holes", "points"})
          CHECK(feature->GetFieldAsInteger(name) == expected["properties"][name].get<int>());
        for (const char* name : {"area", "perimeter"})
          CHECK(feature->GetFieldAsDouble(name) ==
                doctest::Approx(expected["properties"][name].get<double>()).epsilon(1e-14));
        std::vector<Point> ring;
        for (const json& p : expected["geometry"]["coordinates"][0]) ring.push_back({p[0], p[1]});
        ring.pop_back();
        std::sort(ring.begin(), ring.end());
        CHECK(ring_of(*feature->GetGeometryRef()->toPolygon()->getExteriorRing()) == ring);
        found[number] = true;
      }
      CHECK(found.size() == 2);
    }
    CHECK(open(folder.path("s.gpkg"))->GetLayerByName("isolated")->GetFeatureCount() == 2);
    for (const std::string run : {"s.gpkg --layer isolated", "i.fgb"}) {
      const Outcome isolated = folder.rbpa("info " + run);
      CHECK(isolated.out.starts_with(
          "points      2\ndistinct    2\nduplicates  0\ncrs         EPSG:28992\nbox         x 3 .. 90\n"));
    }
    CHECK(folder.rbpa("shape p.xy --alpha 1 --crs EPSG:28992 -o - --output-format fgb -q").out.starts_with("fgb\x03"));
  }

  TEST_CASE("files appear together or not at all, and nothing is left in their place") {
    const Folder folder("p.xy", squares);
    REQUIRE(folder.rbpa("shape p.xy --alpha 1 -o s.shp -q").code == 0);
    CHECK(folder.names() == std::vector<std::string>{"p.xy", "s.dbf", "s.shp", "s.shx"});
    CHECK(folder.rbpa("shape p.xy --alpha 1 --crs EPSG:28992 -o t.shp -o /dev/full --output-format wkt -q").code == 1);
    CHECK_FALSE(folder.has("t.shp"));
    CHECK_FALSE(folder.has("t.prj"));
    folder.file("s.prj", "of other coordinates");
    CHECK(folder.rbpa("shape p.xy --alpha 1 -o s.shp -q").err ==
          "rbpa: s.prj: found an old file, expected none next to s.shp (remove it)\n");
    CHECK(folder.rbpa("shape p.xy --alpha 1 -o s.shp --stats s.dbf").code == 2);
    CHECK(folder.rbpa("shape p.xy --alpha 1 -o - --output-format shp").code == 2);
    CHECK(folder.rbpa("shape p.xy --alpha 1 --isolated i.shp").code == 2);
    const Outcome unknown = folder.rbpa("shape p.xy --alpha 1 --crs EPSG:1025 -o u.gpkg -q", 1);
    CHECK(unknown.err.starts_with("rbpa: cannot write GPKG: --crs EPSG:1025: "));
    CHECK_FALSE(folder.has("u.gpkg"));
  }

  TEST_CASE("an empty shape is a valid file") {
    const Folder folder("p.xy", "0 0\n1 1\n2 2\n");
    for (const GdalFormat& format : formats) {
      CAPTURE(format.driver);
      REQUIRE(folder.rbpa("shape p.xy --alpha 1 -q -o s." + format.ending).code == 0);
      CHECK(open(folder.path("s." + format.ending))
                ->GetLayerByName(format.ending == "shp" ? "s" : "polygons")
                ->GetFeatureCount() == 0);
    }
  }

  TEST_CASE("a GeoPackage without a system is in the undefined Cartesian one, and of degrees in the geographic one") {
    const Folder folder("p.xy", squares);
    folder.file("p.csv", "lon,lat,g\n0,0,a\n1,0,a\n0,1,a\n");
    // Each run, and the number of the system that the standard of GeoPackages demands.
    const std::pair<std::string, int> runs[] = {{"shape p.xy --alpha 1", -1},
                                                {"voronoi p.xy", -1},
                                                {"mesh p.xy --alpha 1", -1},
                                                {"shape p.csv --alpha 9", 0},
                                                {"shape p.csv --group-by g --alpha 9", 0},
                                                {"mesh p.csv --alpha 9", 0},
                                                {"mesh p.xy --alpha 1 --crs EPSG:28992", 28992}};
    for (const auto& [run, number] : runs) {
      CAPTURE(run);
      REQUIRE(folder.rbpa(run + " -o s.gpkg -q").code == 0);
      const GDALDatasetUniquePtr file = open(folder.path("s.gpkg"));
      for (const std::string table : {"gpkg_contents", "gpkg_geometry_columns"}) {
        OGRLayer* const found = file->ExecuteSQL(("SELECT DISTINCT srs_id FROM " + table).c_str(), nullptr, nullptr);
        REQUIRE(found != nullptr);
        CHECK(found->GetFeatureCount() == 1);
        CHECK(OGRFeatureUniquePtr(found->GetNextFeature())->GetFieldAsInteger(0) == number);
        file->ReleaseResultSet(found);
      }
    }
    CHECK(!contains(folder.rbpa("info s.gpkg --vertices").err, "system"));
  }

  TEST_CASE("broken files are refused in a line") {
    const Folder folder("p.xy", squares);
    REQUIRE(folder.rbpa("shape p.xy --alpha 1 -o s.gpkg -o s.fgb -o s.shp -q").code == 0);
    for (const std::string name : {"s.gpkg", "s.fgb", "s.shp"}) {
      const std::string good = folder.content(name);
      for (const std::size_t size :
           {std::size_t{0}, std::size_t{3}, std::size_t{50}, good.size() / 2, good.size() - 20}) {
        CAPTURE(name);
        CAPTURE(size);
        folder.file(name, good.substr(0, size));
        const Outcome outcome =
            folder.rbpa("info " + name + " --vertices" + (name == "s.gpkg" ? " --layer polygons" : ""));
        if (outcome.code == 0) {  // a database may have all it needs before its end
          CHECK(name == "s.gpkg");
          CHECK(outcome.out.starts_with("points      8\n"));
          continue;
        }
        CHECK(outcome.code == 3);
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
        CHECK((contains(outcome.err, ": found ") || contains(outcome.err, ": GDAL cannot read ")));
      }
    }
    CHECK(folder.rbpa("info none.gpkg").code == 3);
  }

  TEST_CASE("each group is a multipolygon with the properties of GeoJSON, whether or not all have one") {
    const std::string table =
        "x,y,name,number\n0,0,wolf,1\n1,0,wolf,1\n0,1,wolf,1\n5,5,lynx,20\n6,5,lynx,20\n5,7,lynx,20\n9,9,lynx,20\n"
        "10,9,lynx,20\n9,10,lynx,20\n";
    for (const GdalFormat& format : formats)
      for (const std::string column : {"name", "number"})
        for (const bool lonely : {false, true}) {
          CAPTURE(format.driver);
          CAPTURE(column);
          CAPTURE(lonely);
          const Folder folder("p.csv", table + (lonely ? "3,3,bear,3\n" : ""));
          const std::string run = "shape p.csv --columns x,y --crs EPSG:28992 --alpha 1.2 --group-by " + column;
          const Outcome outcome = folder.rbpa(run + " -o s." + format.ending + " -o s.geojson", 0);
          CHECK(contains(outcome.err, "s.fgb leaves out 1 group without a polygon: ") ==
                (lonely && format.ending == "fgb"));
          const json features = json::parse(folder.content("s.geojson"))["features"];
          const GDALDatasetUniquePtr file = open(folder.path("s." + format.ending));
          OGRLayer* layer = file->GetLayer(0);
          REQUIRE(layer->GetSpatialRef() != nullptr);
          std::size_t found = 0;
          for (const OGRFeatureUniquePtr& feature : layer) {
            ++found;
            const auto one = std::find_if(features.begin(), features.end(), [&](const json& other) {
              const json& group = other["properties"]["group"];
              return group.is_number() ? group == feature->GetFieldAsDouble("group")
                                       : group == feature->GetFieldAsString("group");
            });
            REQUIRE(one != features.end());
            const json& properties = (*one)["properties"];
            CHECK(properties["points"] == feature->GetFieldAsInteger64("points"));
            CHECK(properties["polygons"] == feature->GetFieldAsInteger64("polygons"));
            CHECK(properties["area"].get<double>() == doctest::Approx(feature->GetFieldAsDouble("area")));
            CHECK(properties["perimeter"].get<double>() == doctest::Approx(feature->GetFieldAsDouble("perimeter")));
            const int alpha = feature->GetFieldIndex("alpha");
            CHECK(properties["alpha"].is_null() == !feature->IsFieldSetAndNotNull(alpha));
            CHECK(properties.value("problem", "") == feature->GetFieldAsString("problem"));
            const OGRGeometry* geometry = feature->GetGeometryRef();
            const json& polygons = (*one)["geometry"]["coordinates"];
            if (polygons.empty()) {
              CHECK((geometry == nullptr || geometry->IsEmpty()));
              continue;
            }
            REQUIRE(geometry != nullptr);
            // A Shapefile calls one polygon or several Polygon.
            const bool is_one = wkbFlatten(geometry->getGeometryType()) == wkbPolygon;
            CHECK(polygons.size() ==
                  (is_one ? 1 : static_cast<std::size_t>(geometry->toMultiPolygon()->getNumGeometries())));
            CHECK(OGR_G_Area(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(geometry))) ==
                  doctest::Approx(properties["area"].get<double>()));
          }
          CHECK(features.size() == (lonely ? 3U : 2U));
          CHECK(found == (lonely && format.ending == "fgb" ? 2U : features.size()));
        }
  }

  TEST_CASE("isolated points have their fields, and polygons and groups their summaries, by OGR's types") {
    const Folder folder("p.csv",
                        "x,y,fid,GEOM,Index,id,label,v\n0,0,1,2,3,9223372036854775807,\"a, b\",0.5\n1,0,4,5,6,1,ü,\n"
                        "0,1,7,8,9,-9223372036854775808,ü,2.5\n50,50,10,11,12,9007199254740993,c,3.5\n");
    const std::string summaries = " --summarize id:max,id:min,label:majority,v:mean --alpha 2 -q ";
    REQUIRE(folder.rbpa("shape p.csv" + summaries + "-o s.gpkg -o s.fgb -o s.shp --isolated i.fgb").code == 0);
    REQUIRE(folder.rbpa("shape p.csv --group-by Index" + summaries + "-o g.gpkg").code == 0);
    for (const std::string path : {"s.gpkg", "i.fgb"}) {
      const GDALDatasetUniquePtr file = open(folder.path(path));
      OGRLayer* layer = path == "s.gpkg" ? file->GetLayerByName("isolated") : file->GetLayer(0);
      const OGRFeatureUniquePtr feature(layer->GetNextFeature());
      REQUIRE(feature);
      CHECK(feature->GetFieldAsInteger64("index") == 3);
      CHECK(feature->GetFieldAsInteger64("Index_2") == 12);
      CHECK(feature->GetFieldAsInteger64("id") == 9007199254740993);
      CHECK(feature->GetFieldDefnRef(feature->GetFieldIndex("id"))->GetType() == OFTInteger64);
      CHECK(feature->GetFieldAsString("label") == std::string("c"));
      CHECK(feature->GetFieldAsDouble("v") == 3.5);
      if (path == "s.gpkg") {
        CHECK(feature->GetFieldAsInteger64("fid_2") == 10);
        CHECK(feature->GetFieldAsInteger64("GEOM_2") == 11);
      }
    }
    for (const std::string path : {"s.gpkg", "s.fgb", "s.shp", "g.gpkg"}) {
      CAPTURE(path);
      const GDALDatasetUniquePtr file = open(folder.path(path));
      const OGRFeatureUniquePtr feature(file->GetLayer(0)->GetNextFeature());
      const int last = feature->GetFieldCount();
      if (path == "g.gpkg") continue;  // a group of one point
      if (path == "s.shp")             // of more than 18 digits: written as they are, and read by GDAL as a real number
        CHECK(feature->GetFieldAsDouble(last - 4) == 0x1p63);
      else
        CHECK(feature->GetFieldAsInteger64(last - 4) == std::numeric_limits<std::int64_t>::max());
      CHECK(feature->GetFieldAsInteger64(last - 3) == std::numeric_limits<std::int64_t>::min());
      CHECK(feature->GetFieldAsString(last - 2) == std::string("ü"));
      CHECK(feature->GetFieldAsDouble(last - 1) == 1.5);
    }
    CHECK(open(folder.path("g.gpkg"))->GetLayer(0)->GetLayerDefn()->GetFieldIndex("v_mean") > 0);
  }
}

TEST_CASE("GDAL's library is loaded for its formats only: a program that is linked to it starts ten times slower") {
  const Folder folder;
  for (const char* program : {RBPA_PROGRAM, MESHTOPO_PROGRAM}) {
    const std::string libraries = folder.run("env", "LD_TRACE_LOADED_OBJECTS=1 " + std::string(program), 0).out;
    CHECK(contains(libraries, "libc.so"));
    CHECK(!contains(libraries, "gdal"));
  }
}
