// The figure of an image is the same set of points for every kind of file, and files that are not images are refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "io/cloud/images.h"
#include "io/cloud/read_points.h"
#include "io/failure.h"
#include "support/image_files.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using rbpa::Point;
using rbpa::app::BadInput;
using rbpa::app::Foreground;
using rbpa::app::Format;
using rbpa::app::PixelRule;

namespace {

std::vector<Point> points_of_png(const std::string& bytes, const PixelRule& rule = {}) {
  return rbpa::app::read_png_points(bytes, "i.png", rule);
}
std::vector<Point> points_of_pgm(const std::string& bytes, const PixelRule& rule = {}) {
  return rbpa::app::read_pgm_points(bytes, "i.pgm", rule);
}

/// Returns random black dots on a white ground with a white border.
Picture dotted(std::uint32_t width, std::uint32_t height) {
  Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 255)};
  std::mt19937_64 random(width * 100 + height);
  for (std::uint32_t y = 1; y + 1 < height; ++y)
    for (std::uint32_t x = 1; x + 1 < width; ++x)
      if (random() % 3 == 0) picture.grey[std::size_t{y} * width + x] = 0;
  return picture;
}

Picture inverse(Picture picture) {
  for (std::uint8_t& grey : picture.grey) grey = static_cast<std::uint8_t>(255 - grey);
  return picture;
}

/// The law itself: where the centers of the pixels with this gray value are.
std::vector<Point> centers(const Picture& picture, std::uint8_t grey) {
  std::vector<Point> points;
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x)
      if (picture.grey[std::size_t{y} * picture.width + x] == grey)
        points.push_back({x + 0.5, picture.height - y - 0.5});
  return points;
}

template <typename Read>
std::string refusal(Read&& read) {
  return rbpa_test::refusal_of<BadInput>(read);
}

std::string refusal_of_pgm(const std::string& bytes) {
  return refusal([&] { points_of_pgm(bytes); });
}

}  // namespace

TEST_SUITE("images") {
  TEST_CASE("y goes up from the lower left corner of the image") {
    // The letter L, whose foot points right.
    const std::vector<Point> expected = {{1.5, 3.5}, {1.5, 2.5}, {1.5, 1.5}, {2.5, 1.5}};
    CHECK(points_of_pgm("P2 4 5 1  1 1 1 1  1 0 1 1  1 0 1 1  1 0 0 1  1 1 1 1") == expected);
  }

  TEST_CASE("every kind of PNG and PGM gives the same figure") {
    for (const auto& size : {std::pair{3U, 3U}, {9U, 4U}, {1U, 5U}, {6U, 1U}, {17U, 23U}}) {
      const Picture picture = dotted(size.first, size.second);
      const std::vector<Point> expected = centers(picture, 0);
      CAPTURE(picture.width);
      for (const bool interlaced : {false, true}) {
        for (const int depth : {1, 2, 4, 8}) {
          CAPTURE(depth);
          CHECK(points_of_png(png(picture, PngKind::grey, depth, interlaced)) == expected);
          CHECK(points_of_png(png(picture, PngKind::palette, depth, interlaced)) == expected);
        }
        for (const int depth : {8, 16})
          for (const PngKind kind :
               {PngKind::grey, PngKind::grey_with_opacity, PngKind::color, PngKind::color_with_opacity})
            CHECK(points_of_png(png(picture, kind, depth, interlaced)) == expected);
      }
      for (const bool as_text : {false, true}) {
        CHECK(points_of_pgm(pgm(picture, as_text)) == expected);
        CHECK(points_of_pgm(pgm(picture, as_text, 257)) == expected);
      }
    }
  }

  TEST_CASE("the figure has the shade that fewer pixels of the border have") {
    const Picture picture = dotted(12, 9);
    CHECK(points_of_pgm(pgm(inverse(picture), false)) == centers(picture, 0));
    // One pixel of the figure at the border does not invert it.
    Picture touching = picture;
    touching.grey[4] = 0;
    CHECK(points_of_pgm(pgm(touching, false)) == centers(touching, 0));
    CHECK(points_of_pgm("P2 2 2 1 0 0 0 0").empty());
    // Each pixel of the border is counted once; if as many are dark as light, the figure is dark.
    CHECK(points_of_pgm("P2 3 3 1  0 1 0  1 1 1  0 1 0").size() == 4);
    CHECK(points_of_pgm("P2 1 5 1  0 1 1 0 0").size() == 2);
    CHECK(points_of_pgm("P2 2 1 1 0 1") == std::vector<Point>{{0.5, 0.5}});
  }

  TEST_CASE("--foreground chooses the pixels, and dark and light together are every pixel once") {
    const Picture picture = dotted(12, 9);
    for (const Picture& either : {picture, inverse(picture)}) {
      const std::string bytes = pgm(either, true);
      CHECK(points_of_pgm(bytes, {Foreground::dark}) == centers(either, 0));
      CHECK(points_of_pgm(bytes, {Foreground::light}) == centers(either, 255));
    }
  }

  TEST_CASE("a transparent pixel is never a point, and on a transparent ground every other is") {
    const Picture picture{
        4, 3, {0, 0, 255, 0, 255, 255, 0, 0, 0, 255, 0, 0}, {0, 0, 0, 0, 0, 255, 128, 0, 0, 127, 0, 0}};
    const Point left{1.5, 1.5}, right{2.5, 1.5};
    for (const int depth : {8, 16})
      for (const PngKind kind : {PngKind::grey_with_opacity, PngKind::color_with_opacity}) {
        const std::string bytes = png(picture, kind, depth);
        CHECK(points_of_png(bytes) == std::vector<Point>{left, right});
        CHECK(points_of_png(bytes, {Foreground::dark}) == std::vector<Point>{right});
        CHECK(points_of_png(bytes, {Foreground::light}) == std::vector<Point>{left});
      }
  }

  TEST_CASE("a transparent color counts as transparent pixels") {
    Picture picture = inverse(dotted(9, 9));
    picture.opacity = picture.grey;
    const std::vector<Point> expected = centers(picture, 255);
    for (const bool interlaced : {false, true}) {
      for (const int depth : {1, 2, 4, 8}) {
        CHECK(points_of_png(png(picture, PngKind::palette, depth, interlaced)) == expected);
        CHECK(points_of_png(png(picture, PngKind::palette, depth, interlaced), {Foreground::dark}).empty());
      }
      for (const int depth : {8, 16})
        for (const PngKind kind : {PngKind::grey, PngKind::color})
          CHECK(points_of_png(png(picture, kind, depth, interlaced), {Foreground::dark}).empty());
    }
  }

  TEST_CASE("a pixel is light from the threshold on") {
    const std::string bytes = "P2 4 1 255 0 127 128 255";
    const auto light = [&](double threshold) { return points_of_pgm(bytes, {Foreground::light, threshold}).size(); };
    CHECK(light(0.5) == 2);
    CHECK(light(128.0 / 255) == 2);
    CHECK(light(0.51) == 1);
    CHECK(light(0.1) == 3);
    CHECK(light(1) == 1);
    // A mask of zeros and ones in bytes.
    CHECK(points_of_pgm("P2 3 3 255 0 0 0 0 1 0 0 0 0", {std::nullopt, 1.0 / 255}) == std::vector<Point>{{1.5, 1.5}});
  }

  TEST_CASE("the horse has the points that others took from its image") {
    const std::string folder = RBPA_TEST_DATA "/";
    auto expected = rbpa::app::read_points({folder + "shape_skimage_horse_fill.xy", Format::text}).points;
    auto points = rbpa::app::read_points({folder + "shape_skimage_horse_fill.png", Format::png}).points;
    for (Point& p : expected) p = {p.x + 0.5, p.y + 0.5};  // theirs are corners
    std::sort(expected.begin(), expected.end());
    std::sort(points.begin(), points.end());
    CHECK(points.size() == 43412);
    CHECK(points == expected);
  }

  TEST_CASE("every verb reads images, by ending and from standard input") {
    const Folder folder;
    const Picture picture = dotted(8, 7);
    folder.file("i.png", png(picture, PngKind::grey, 1));
    folder.file("i.PGM", pgm(picture, false));
    const Outcome of_png = folder.rbpa("mesh i.png --alpha 1 -o - --output-format off -q", 0);
    CHECK(of_png.out.substr(0, 3) == "OFF");
    CHECK(folder.rbpa("mesh i.PGM --alpha 1 -o - --output-format off -q").out == of_png.out);
    CHECK(folder.rbpa("mesh - --format png --alpha 1 -o - --output-format off -q < i.png").out == of_png.out);
    CHECK(folder.rbpa("mesh - --format pgm --alpha 1 -o - --output-format off -q < i.PGM").out == of_png.out);
    CHECK(folder.rbpa("shape i.png --alpha 1 -o o.wkt -o o.png -q").code == 0);
    const auto number = "points      " + std::to_string(centers(picture, 0).size()) + "\n";
    CHECK(folder.rbpa("info i.png").out.find(number) == 0);
    CHECK(folder.rbpa("info i.png --foreground light --threshold 0.3").out.find(number) != 0);
    CHECK(folder.rbpa("alpha i.png --json -q").code == 0);
    // A picture that we wrote is an image like any other.
    CHECK(folder.rbpa("info o.png").code == 0);
  }
}

TEST_SUITE("bad images") {
  TEST_CASE("a PNG file cut anywhere is refused") {
    const std::string whole = png(dotted(9, 9), PngKind::palette, 4, true);
    REQUIRE_NOTHROW(points_of_png(whole));
    for (std::size_t size = 0; size < whole.size(); ++size)
      CHECK_THROWS_AS(points_of_png(whole.substr(0, size)), BadInput);
  }

  TEST_CASE("a PNG file with a flipped bit is read or refused, and nothing else happens") {
    for (const bool interlaced : {false, true}) {
      const std::string whole = png(dotted(9, 9), PngKind::color_with_opacity, 16, interlaced);
      std::size_t refused = 0;
      for (std::size_t i = 0; i < 8 * whole.size(); ++i) {
        std::string broken = whole;
        broken[i / 8] = static_cast<char>(broken[i / 8] ^ (1 << i % 8));
        if (refusal([&] { points_of_png(broken); }) != "") ++refused;
      }
      CHECK(refused > 7 * whole.size());  // checksums find nearly all
    }
  }

  TEST_CASE("a PNG header that claims more than the file can hold is refused") {
    const auto claims = [](std::uint32_t width, std::uint32_t height) {
      return refusal([&] { points_of_png(png_header(width, height)); });
    };
    CHECK(claims(30000, 30000) ==
          "i.png: found a file of 41 bytes, expected at least 109011 for 30000 x 30000 pixels as the header says");
    CHECK(claims(2147483647, 2147483647) ==
          "i.png: found 2147483647 x 2147483647 pixels, expected fewer than 2^30 of them");
    CHECK(claims(50000000, 1) == "i.png: found an image of 50000000 columns, expected at most 1000000");
    CHECK(claims(10, 10) == "i.png: found 'the file ends early', expected a whole PNG image");
  }

  TEST_CASE("an error in a PNG file is one line, and libpng itself prints nothing") {
    const Folder folder;
    std::string broken = png(dotted(9, 9), PngKind::grey, 8);
    broken[50] = static_cast<char>(~broken[50]);
    folder.file("i.png", broken);
    folder.file("j.png", "not a PNG file");
    for (const std::string verb : {"mesh i.png --alpha 1 -o m.off", "shape i.png --alpha 1 -o m.wkt", "info i.png",
                                   "alpha i.png", "info - --format png < i.png"}) {
      const Outcome outcome = folder.rbpa(verb, 3);
      CHECK(outcome.out.empty());
      CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
      CHECK(contains(outcome.err, ", expected a whole PNG image\n"));
    }
    CHECK(folder.rbpa("info j.png").err ==
          "rbpa: j.png: found 'not a PN', expected a PNG image, which begins with '\\x89PNG'\n");
    CHECK(folder.names().size() == 2);
  }

  TEST_CASE("a broken part of a PNG file that has no pixels is skipped silently") {
    const Folder folder;
    const Picture picture = dotted(9, 9);
    std::string bytes = png(picture, PngKind::grey, 8);
    const std::size_t behind_header = 33;
    bytes.insert(behind_header, std::string("\0\0\0\4gAMA\0\0\0\0????", 16));  // no gamma, no checksum
    folder.file("i.png", bytes);
    CHECK(folder.rbpa("info i.png", 0).err.empty());
    CHECK(points_of_png(bytes) == centers(picture, 0));
  }

  TEST_CASE("an error in a PGM file of text is named by its line") {
    CHECK(refusal_of_pgm("P2\n2 2\n255\n0 0\n0 256\n") == "i.pgm:5: found '256', expected a gray value of at most 255");
    CHECK(refusal_of_pgm("P2\n2 2 # size\n255\n0 0\n0 x9\n") ==
          "i.pgm:5: found 'x9', expected a gray value of at most 255");
    CHECK(refusal_of_pgm("P2\n2 2\n255\n000 0\n0\n") ==
          "i.pgm:6: found the end of the file, expected a gray value of at most 255");
    CHECK(refusal_of_pgm("P2\n2 -2\n255\n") == "i.pgm:2: found '-2', expected a height in pixels");
    CHECK(refusal_of_pgm("P2\n2 2\n70000\n") == "i.pgm:3: found '70000', expected a greatest gray value of 1 to 65535");
    CHECK(refusal_of_pgm("P5 2 2 0\n") == "i.pgm:1: found '0', expected a greatest gray value of 1 to 65535");
    CHECK(refusal_of_pgm("P5\n2") == "i.pgm:2: found the end of the file, expected a height in pixels");
  }

  TEST_CASE("a PGM file of another kind, without pixels, with too many, or too short is refused") {
    CHECK(refusal_of_pgm("P6 1 1 255\nabc") ==
          "i.pgm: found 'P6', expected a PGM image, which begins with 'P2' or 'P5'");
    CHECK(refusal_of_pgm("P5 0 4 255\n") == "i.pgm: found 0 x 4 pixels, expected at least 1 x 1");
    CHECK(refusal_of_pgm("P5 4 0 255\n") == "i.pgm: found 4 x 0 pixels, expected at least 1 x 1");
    CHECK(refusal_of_pgm("P5 99999999999 99999999999 255\n") ==
          "i.pgm: found 99999999999 x 99999999999 pixels, expected fewer than 2^30 of them");
    CHECK(refusal_of_pgm("P5 20000 20000 255\nab") ==
          "i.pgm: found 2 bytes of pixels, expected at least 400000000 for 20000 x 20000 pixels as the header says");
    CHECK(refusal_of_pgm("P2 20000 20000 255\n1 2") ==
          "i.pgm: found 4 bytes of pixels, expected at least 800000000 for 20000 x 20000 pixels as the header says");
    CHECK(refusal_of_pgm("P5 1 1 300\n\x02\xFF") ==
          "i.pgm: row 0, column 0: found 767, expected a gray value of at most 300");
    const std::string whole = pgm(dotted(5, 5), false, 257);
    for (std::size_t size = 0; size < whole.size(); ++size)
      CHECK_THROWS_AS(points_of_pgm(whole.substr(0, size)), BadInput);
  }

  TEST_CASE("wrong usage of the options for images is refused") {
    const Folder folder({{"i.pgm", pgm(dotted(5, 5), true)}, {"p.xy", corner}});
    const auto says = [&](const std::string& arguments, const std::string& message) {
      refuses(folder, arguments, 2, message);
    };
    says("info i.pgm --foreground black", "--foreground: found 'black', expected dark or light");
    for (const std::string value : {"0", "1.5", "nan", "x"})
      says("info i.pgm --threshold=" + value,
           "--threshold: found '" + value + "', expected a share of white: a number > 0 and <= 1");
    says("info p.xy --foreground dark", "--foreground: found a format without pixels, expected one of png, pgm");
    says("info p.xy --threshold 0.3", "--threshold: found a format without pixels, expected one of png, pgm");
    says("info i.pgm --columns 1,2", "--columns: found a format with fixed columns, expected text");
  }
}
