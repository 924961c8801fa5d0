// The picture of `rbpa surface`: its upright axis and its colors.
#include <doctest/doctest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "picture/space_view.h"
#include "support/program.h"

using namespace apps_test;
using rbpa::Point3;
using rbpa::app::SpaceView;
using rbpa::app::view_of;

namespace {

/// Returns the middle of a box, points along each axis from it, and points all over it.
std::vector<Point3> box(double x, double y, double z, double unit = 1) {
  std::vector<Point3> points = {{0, 0, 0}, {unit * x, 0, 0}, {0, unit * y, 0}, {0, 0, unit * z}};
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = -4; k <= 4; ++k) points.push_back({unit * x * i / 4, unit * y * j / 4, unit * z * k / 4});
  return points;
}

/// Returns the axis that goes straight up in the picture: 0 to 2, or 3 for none.
std::size_t upright_in(const std::vector<Point3>& points) {
  const SpaceView view = view_of(points, 400);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double right = view.at[axis + 1][0] - view.at[0][0], down = view.at[axis + 1][1] - view.at[0][1];
    if (down < 0 && std::abs(right) < 1e-6 * -down) return axis;
  }
  return 3;
}

struct Pixels {
  png_image image{};
  std::vector<std::uint8_t> rgb;
};

Pixels pixels_of(const std::string& bytes) {
  Pixels pixels;
  pixels.image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&pixels.image, bytes.data(), bytes.size()) != 0);
  pixels.image.format = PNG_FORMAT_RGB;
  pixels.rgb.resize(PNG_IMAGE_SIZE(pixels.image));
  REQUIRE(png_image_finish_read(&pixels.image, nullptr, pixels.rgb.data(), 0, nullptr) != 0);
  return pixels;
}

/// Returns the color at the middle.
std::array<int, 3> middle_of(const std::string& bytes) {
  const Pixels pixels = pixels_of(bytes);
  const std::size_t at = 3 * (pixels.image.height / 2 * std::size_t{pixels.image.width} + pixels.image.width / 2);
  return {pixels.rgb[at], pixels.rgb[at + 1], pixels.rgb[at + 2]};
}

}  // namespace

TEST_SUITE("surface picture") {
  TEST_CASE("y is upright, or z if y is the direction of view or z is much taller, and its positive end is above") {
    constexpr std::size_t y = 1, z = 2;
    for (const double unit : {1.0, 1e-300, 1e300}) {
      CAPTURE(unit);
      CHECK(upright_in(box(3, 2, 1, unit)) == y);    // looked at along z
      CHECK(upright_in(box(3, 1, 2, unit)) == z);    // along y
      CHECK(upright_in(box(1, 3, 2, unit)) == y);    // along x
      CHECK(upright_in(box(1, 2, 2.5, unit)) == y);  // along x: an animal
      CHECK(upright_in(box(1, 2, 4, unit)) == z);    // along x: a tower
    }
  }

  TEST_CASE("the upright axis stays if the points are turned a little or come in another order") {
    std::mt19937_64 random(1);
    std::vector<Point3> points = box(3, 2, 1);
    const double c = std::cos(0.3), s = std::sin(0.3);
    for (Point3& p : points) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};  // about z: y leans in the coordinates
    const std::vector<Point3> axes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::copy(axes.begin(), axes.end(), points.begin());
    CHECK(upright_in(points) == 1);
    const SpaceView view = view_of(points, 400);
    std::shuffle(points.begin() + 4, points.end(), random);
    CHECK(std::equal(view.at.begin(), view.at.begin() + 4, view_of(points, 400).at.begin()));
  }

  TEST_CASE("triangles have the shaded mean color of their corners from the front, and none from behind") {
    const Folder folder;
    const auto ply = [](const std::string& normal, const std::string& colors) {
      std::string text = "ply\nformat ascii 1.0\nelement vertex 3\n";
      for (const std::string name : {"x", "y", "z", "nx", "ny", "nz"}) text += "property float " + name + "\n";
      for (const std::string name : {"red", "green", "blue"})
        if (!colors.empty()) text += "property uchar " + name + "\n";
      text += "end_header\n";
      const std::array<std::string, 3> corners{"-1 -1 0 ", "1 -1 0 ", "0 1 0 "};
      for (std::size_t i = 0; i < 3; ++i)
        text += corners[i] + normal + " " + (colors.empty() ? std::string() : colors.substr(12 * i, 12)) + "\n";
      return text;
    };
    const auto middle = [&](const std::string& normal, const std::string& colors) {
      folder.file("p.ply", ply(normal, colors));
      CHECK(folder.rbpa("surface p.ply --radius 2 -o p.png --width 300 -q").code == 0);
      return middle_of(folder.content("p.png"));
    };
    const auto plain = middle("0 0 1", ""), behind = middle("0 0 -1", "");
    CHECK(plain[2] > plain[0] + 20);  // blue
    CHECK(behind[2] < behind[0]);     // gray
    const std::string red = "240 000 030 240 000 000 240 000 060 ";
    const auto front = middle("0 0 1", red);
    CHECK(front[0] > 150);
    CHECK(front[1] == 0);
    CHECK(std::abs(front[2] - front[0] / 8.0) < 1.5);  // the mean of 30, 0 and 60 to 240
    CHECK(middle("0 0 -1", red) == behind);
  }

  TEST_CASE("triangles that fill a hole are green") {
    // A flat ring of points: its hole is in the middle of the picture.
    std::string text;
    for (int x = -4; x <= 4; ++x)
      for (int y = -4; y <= 4; ++y)
        if (std::max(std::abs(x), std::abs(y)) >= 2) text += std::to_string(x) + " " + std::to_string(y) + " 0 0 0 1\n";
    const Folder folder("p.xyz", text);
    const auto middle = [&](const std::string& option) {
      CHECK(folder.rbpa("surface p.xyz --radius 1 -o p.png --width 300 -q " + option).code == 0);
      return middle_of(folder.content("p.png"));
    };
    const auto open = middle(""), filled = middle("--fill-holes all");
    CHECK(open[0] > 240);  // the background
    CHECK(filled[1] > filled[0] + 20);
    CHECK(filled[1] > filled[2] + 10);
  }
}
