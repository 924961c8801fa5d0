// World files: pictures in a named system of coordinates have one, and it places each pixel.
#include <doctest/doctest.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

using namespace apps_test;

namespace {

struct Pixels {
  std::size_t width = 0, height = 0;
  std::vector<unsigned char> rgb = {};

  std::array<unsigned char, 3> at(std::size_t x, std::size_t y) const {
    const std::size_t i = 3 * (y * width + x);
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

Pixels pixels_of(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, path.c_str()) != 0);
  image.format = PNG_FORMAT_RGB;
  Pixels pixels{image.width, image.height, std::vector<unsigned char>(PNG_IMAGE_SIZE(image))};
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr) != 0);
  return pixels;
}

}  // namespace

TEST_SUITE("world files") {
  TEST_CASE("pixels are inside and outside of a rectangle as its corners and the world file say") {
    struct Rectangle {
      double x, y, width, height;
    };
    for (const Rectangle& box : {Rectangle{500'000, 5'600'000, 100, 200}, Rectangle{-3, 7, 0.001, 0.0002},
                                 Rectangle{-1e200, 1e199, 1e199, 3e199}, Rectangle{0, 0, 1, 50}}) {
      CAPTURE(box.x);
      const Folder folder;
      std::ostringstream points;
      points.precision(17);
      for (const auto& [right, top] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}})
        points << box.x + right * box.width << "," << box.y + top * box.height << "\n";
      folder.file("p.csv", points.str());
      REQUIRE(folder.rbpa("shape p.csv --alpha inf -o p.png --width 400 --crs EPSG:25832 -q").code == 0);
      std::istringstream world(folder.content("p.pgw"));
      std::array<double, 6> numbers{};
      for (double& number : numbers) world >> number;
      REQUIRE(!world.fail());
      const double size = numbers[0];
      CHECK(numbers == std::array{size, 0.0, 0.0, -size, numbers[4], numbers[5]});
      const Pixels pixels = pixels_of(folder.path("p.png"));
      std::size_t inside = 0, outside = 0, wrong = 0;
      for (std::size_t i = 0; i < pixels.width; ++i)
        for (std::size_t k = 0; k < pixels.height; ++k) {
          // The distance of the pixel's center from the rectangle in pixels, below 0 inside.
          const double x = (numbers[4] + size * static_cast<double>(i) - box.x) / size,
                       y = (numbers[5] - size * static_cast<double>(k) - box.y) / size;
          const double far = std::max({-x, x - box.width / size, -y, y - box.height / size});
          const bool is_empty = pixels.at(i, k) == pixels.at(0, 0);
          if (std::abs(far) < 2) continue;  // the line
          ++(far < 0 ? inside : outside);
          wrong += is_empty != (far > 0) ? 1U : 0U;
        }
      CHECK(inside > 500);
      CHECK(outside > 1000);
      CHECK(wrong == 0);
    }
  }

  TEST_CASE("pictures of the plane have one, if they are .png and their coordinates have a system") {
    const Folder folder({{"p.csv", "x,y,z,g\n0,0,1,a\n4,0,2,a\n0,4,3,b\n4,5,1,b\n3,1,1,b\n1,1,2,a\n"},
                         {"f.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[0,4],[0,0]]]})"}});
    for (const std::string run :
         {"shape p.csv --columns x,y --alpha inf", "shape p.csv --columns x,y --group-by g --alpha inf",
          "mesh p.csv --columns x,y --alpha inf", "voronoi p.csv --columns x,y", "discs p.csv --columns x,y --radius 1",
          "grid p.csv --contours every:0.5"}) {
      CAPTURE(run);
      CHECK(folder.rbpa(run + " -o s.png -q").code == 0);
      CHECK(folder.names() == std::vector<std::string>{"f.geojson", "p.csv", "s.png"});
      const std::string with = run + " --crs EPSG:25832 -q -o ";
      CHECK(folder.rbpa(with + "s.svg -o s --output-format png").code == 0);
      CHECK(folder.names() == std::vector<std::string>{"f.geojson", "p.csv", "s", "s.png", "s.svg"});
      CHECK(folder.rbpa(with + "s.PNG").code == 0);
      CHECK(folder.names() == std::vector<std::string>{"f.geojson", "p.csv", "s", "s.PGW", "s.PNG", "s.png", "s.svg"});
      folder.run("/bin/sh", "-c 'rm -f s s.*'");
    }
    CHECK(folder.rbpa("fill f.geojson --size 1 -o f.png -q").code == 0);
    CHECK(contains(folder.content("f.pgw"), "\n0\n0\n-"));
    folder.file("one.csv", "1,1\n1,1\n1,1\n");
    CHECK(folder.rbpa("mesh one.csv --alpha 1 -o one.png --crs EPSG:25832 -q").code == 0);
    CHECK(folder.names() == std::vector<std::string>{"f.geojson", "f.pgw", "f.png", "one.csv", "one.png", "p.csv"});
    // The picture may be of other points now.
    const Outcome again = folder.rbpa("mesh p.csv --columns x,y --alpha inf -o f.png", 0);
    CHECK(contains(again.err, "f.pgw: this world file is of an earlier picture"));
    CHECK(again.err.ends_with(" -> f.png\n"));
    const Outcome listed = folder.rbpa("mesh p.csv --columns x,y --alpha inf --crs EPSG:3857 -o f.png -o f.svg");
    CHECK(listed.err.ends_with(" -> f.png, f.svg, f.pgw\n"));
    // Geocentric x and y are no place on a map.
    for (const std::string code : {"3822", "4978", "7789", "20039"})
      CHECK(folder.rbpa("mesh p.csv --columns x,y --alpha inf -q -o g.png --crs EPSG:" + code).code == 0);
    CHECK_FALSE(folder.has("g.pgw"));
    CHECK(folder.rbpa("mesh p.csv --columns x,y --alpha inf -q -o g.png --crs EPSG:4979").code == 0);
    CHECK(folder.has("g.pgw"));
    for (const std::string verb : {"shape", "mesh", "voronoi", "discs", "grid", "fill"})
      CHECK(contains(folder.rbpa(verb + " --help").out, ".pgw"));
  }

  TEST_CASE("a world file replaces neither the points nor another output") {
    const Folder folder;
    const std::string points = "0,0\n4,0\n0,4\n";
    folder.file("in.pgw", points);
    folder.run("/bin/sh", "-c 'ln -s in.pgw l.pgw'");
    for (const std::string name : {"in.png", "l.png"}) {
      says(folder, "mesh in.pgw --format xy --alpha inf --crs EPSG:3857 -o " + name, 2,
           "found the file of points, expected another file to write to");
      CHECK(folder.content("in.pgw") == points);
    }
    folder.file("p.xy", points);
    const Outcome twice = folder.rbpa("mesh p.xy --alpha inf --crs EPSG:3857 -o c.png --stats c.pgw", 2);
    CHECK(contains(twice.err, "found twice among the files to write"));
    folder.run("/bin/sh", "-c 'mkdir d.pgw'");
    refuses(folder, "mesh no.xy --alpha inf --crs EPSG:3857 -o d.png", 1,
            "d.pgw: found a folder, expected a file to write");
  }
}
