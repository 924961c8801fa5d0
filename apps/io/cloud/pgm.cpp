#include <algorithm>
#include <array>
#include <limits>

#include "io/cloud/images.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/lines.h"
#include "io/text/vertex_lines.h"

namespace rbpa::app {
namespace {

constexpr std::size_t pixel_limit = std::size_t{1} << 30U;  // rbpa() refuses so many points

Shade ground_of(const Shades& image) {
  std::array<std::size_t, 3> count{};
  for (std::size_t row = 0; row < image.height; ++row) {
    const bool is_of_border = row == 0 || row + 1 == image.height;  // only the ends of other rows are on the border
    const std::size_t step = is_of_border ? 1 : std::max<std::size_t>(image.width - 1, 1);
    for (std::size_t column = 0; column < image.width; column += step)
      ++count[static_cast<std::size_t>(image.pixels[row * image.width + column])];
  }
  const auto pixels_of = [&](Shade shade) { return count[static_cast<std::size_t>(shade)]; };
  Shade ground = Shade::clear;
  for (const Shade other : {Shade::light, Shade::dark})
    if (pixels_of(other) > pixels_of(ground)) ground = other;
  return ground;
}

}  // namespace

void require_image_size(std::size_t width, std::size_t height, const std::string& name) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) bad_input(name, size, "at least 1 x 1");
  if (width >= pixel_limit || height >= pixel_limit || width * height >= pixel_limit)
    bad_input(name, size, "fewer than 2^30 of them");
}

std::vector<Point> foreground_points(const Shades& image, const std::optional<Foreground>& foreground) {
  std::array<bool, 3> wanted{false, true, true};
  if (foreground)
    wanted[static_cast<std::size_t>(*foreground == Foreground::dark ? Shade::light : Shade::dark)] = false;
  else
    wanted[static_cast<std::size_t>(ground_of(image))] = false;

  const auto is_wanted = [&](Shade shade) { return wanted[static_cast<std::size_t>(shade)]; };
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(std::count_if(image.pixels.begin(), image.pixels.end(), is_wanted)));
  for (std::size_t row = 0; row < image.height; ++row) {
    stop_if_interrupted();
    for (std::size_t column = 0; column < image.width; ++column)
      if (is_wanted(image.pixels[row * image.width + column]))
        points.push_back({static_cast<double>(column) + 0.5, static_cast<double>(image.height - row) - 0.5});
  }
  return points;
}

namespace {

/// Whole numbers in a text, separated by blanks, line ends, and comments from '#' to the end of the line.
class Numbers {
 public:
  Numbers(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  /// Takes the next number, and returns it. Throws BadInput with `expected` unless the number is from `least` to
  /// `greatest`.
  std::size_t take(std::size_t least, std::size_t greatest, const std::string& expected) {
    const std::string_view word = next_word();
    if (word.empty()) bad_input(at_line(name_, line_), "the end of the file", expected);
    const std::optional<std::size_t> value = parse_count(word);
    if (!value || *value < least || *value > greatest) bad_input(at_line(name_, line_), in_quotes(word), expected);
    rest_.remove_prefix(word.size());
    return *value;
  }
  std::string_view rest() const { return rest_; }
  /// Returns the text after the single blank or line end that comes next. Throws BadInput if none comes.
  std::string_view rest_behind_blank() const {
    if (rest_.empty() || !is_space(rest_.front()))
      bad_input(at_line(name_, line_), rest_.empty() ? "the end of the file" : in_quotes(rest_.substr(0, 1)),
                "a blank or a line end after the header");
    return rest_.substr(1);
  }

 private:
  static bool is_space(char c) { return is_blank(c) || c == '\n' || c == '\v' || c == '\f'; }
  std::string_view next_word() {
    pass_space();
    std::size_t size = 0;
    while (size < rest_.size() && !is_space(rest_[size]) && rest_[size] != '#') ++size;
    return rest_.substr(0, size);
  }
  void pass_space() {
    bool in_comment = false;
    for (; !rest_.empty(); rest_.remove_prefix(1)) {
      const char c = rest_.front();
      if (c == '\n') {
        ++line_;
        in_comment = false;
      } else if (c == '#') {
        in_comment = true;
      } else if (!in_comment && !is_space(c)) {
        return;
      }
    }
  }

  std::string_view rest_;
  std::size_t line_ = 1;
  const std::string& name_;
};

/// A header and the data after it.
struct Pgm {
  bool text;
  std::size_t width, height, white;
  Numbers numbers;  ///< the pixels of a text file
  std::string_view data;

  std::size_t pixels() const { return width * height; }
  /// Returns the size of the pixels in bytes. For text the size is a lower bound: each number has a digit and a blank.
  std::size_t size() const { return (text || white >= 256 ? 2 : 1) * pixels(); }
};

Pgm read_header(std::string_view bytes, const std::string& name) {
  const std::string_view magic = bytes.substr(0, 2);
  if (magic != "P2" && magic != "P5") bad_input(name, in_quotes(magic), "a PGM image, which begins with 'P2' or 'P5'");
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  Numbers numbers(bytes.substr(2), name);
  const std::size_t width = numbers.take(0, any, "a width in pixels");
  const std::size_t height = numbers.take(0, any, "a height in pixels");
  const std::size_t white = numbers.take(1, 65535, "a greatest gray value of 1 to 65535");
  require_image_size(width, height, name);
  const bool text = magic == "P2";
  return {text, width, height, white, numbers, text ? numbers.rest() : numbers.rest_behind_blank()};
}

void require_room(const Pgm& pgm, const std::string& name) {
  if (pgm.data.size() < pgm.size())
    bad_input(name, counted(pgm.data.size(), "byte") + " of pixels",
              "at least " + std::to_string(pgm.size()) + " for " + std::to_string(pgm.width) + " x " +
                  std::to_string(pgm.height) + " pixels as the header says");
}

void read_text(Shades& image, Pgm& pgm, double threshold) {
  const std::string expected = "a gray value of at most " + std::to_string(pgm.white);
  for (std::size_t i = 0; i < pgm.pixels(); ++i) {
    if (i % 65536 == 0) stop_if_interrupted();
    const std::size_t grey = pgm.numbers.take(0, pgm.white, expected);
    image.pixels.push_back(shade_of(static_cast<double>(grey), static_cast<double>(pgm.white), threshold));
  }
}

void read_bytes(Shades& image, const Pgm& pgm, double threshold, const std::string& name) {
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(pgm.data[i])); };
  for (std::size_t i = 0; i < pgm.pixels(); ++i) {
    if (i % 65536 == 0) stop_if_interrupted();
    const std::size_t grey = pgm.white < 256 ? byte(i) : 256 * byte(2 * i) + byte(2 * i + 1);
    if (grey > pgm.white)
      bad_input(name + ": row " + std::to_string(i / pgm.width) + ", column " + std::to_string(i % pgm.width),
                std::to_string(grey), "a gray value of at most " + std::to_string(pgm.white));
    image.pixels.push_back(shade_of(static_cast<double>(grey), static_cast<double>(pgm.white), threshold));
  }
}

}  // namespace

std::vector<Point> read_pgm_points(std::string_view bytes, const std::string& name, const PixelRule& rule) {
  Pgm pgm = read_header(bytes, name);
  require_room(pgm, name);
  Shades image{pgm.width, pgm.height};
  image.pixels.reserve(pgm.pixels());
  if (pgm.text)
    read_text(image, pgm, rule.threshold);
  else
    read_bytes(image, pgm, rule.threshold, name);
  return foreground_points(image, rule.foreground);
}

}  // namespace rbpa::app
