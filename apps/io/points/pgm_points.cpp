#include "io/points/pgm_points.h"

#include <charconv>
#include <limits>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/lines.h"

namespace rbpa::app {
namespace {

/// A text as whole numbers apart by blanks, line ends, and comments from '#' to the end of the line.
class Numbers {
 public:
  Numbers(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  /// The next number, which must lie between `least` and `greatest`; `expected` says so.
  std::size_t take(std::size_t least, std::size_t greatest, const std::string& expected) {
    pass_space();
    std::size_t size = 0;
    while (size < rest_.size() && !is_space(rest_[size]) && rest_[size] != '#') ++size;
    const std::string_view word = rest_.substr(0, size);
    if (word.empty()) bad_input(at_line(name_, line_), "the end of the file", expected);
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + size, value);
    if (error != std::errc() || end != word.data() + size || value < least || value > greatest)
      bad_input(at_line(name_, line_), in_quotes(word), expected);
    rest_.remove_prefix(size);
    return value;
  }
  std::string_view rest() const { return rest_; }
  /// What follows the one blank or line end that must come next.
  std::string_view rest_behind_blank() const {
    if (rest_.empty() || !is_space(rest_.front()))
      bad_input(at_line(name_, line_), rest_.empty() ? "the end of the file" : in_quotes(rest_.substr(0, 1)),
                "a line end behind the header");
    return rest_.substr(1);
  }

 private:
  static bool is_space(char c) { return is_blank(c) || c == '\n' || c == '\v' || c == '\f'; }
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

/// A header, and what follows it.
struct Pgm {
  std::size_t width, height, white;
  std::string_view data;
};

/// `needed` bytes must be left for the pixels.
void require_room(const Pgm& pgm, std::size_t needed, const std::string& name) {
  if (pgm.data.size() < needed)
    bad_input(name, counted(pgm.data.size(), "byte") + " of pixels",
              "at least " + std::to_string(needed) + " for " + std::to_string(pgm.width) + " x " +
                  std::to_string(pgm.height) + " pixels as the header says");
}

void read_text(Shades& image, Numbers& numbers, const Pgm& pgm, double threshold) {
  const std::string expected = "a grey value of at most " + std::to_string(pgm.white);
  for (std::size_t i = 0; i < pgm.width * pgm.height; ++i) {
    if (i % 65536 == 0) stop_if_interrupted();
    const std::size_t grey = numbers.take(0, pgm.white, expected);
    image.pixels.push_back(shade_of(static_cast<double>(grey), static_cast<double>(pgm.white), threshold));
  }
}

void read_bytes(Shades& image, const Pgm& pgm, double threshold, const std::string& name) {
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(pgm.data[i])); };
  for (std::size_t i = 0; i < pgm.width * pgm.height; ++i) {
    if (i % 65536 == 0) stop_if_interrupted();
    const std::size_t grey = pgm.white < 256 ? byte(i) : 256 * byte(2 * i) + byte(2 * i + 1);
    if (grey > pgm.white)
      bad_input(name + ": row " + std::to_string(i / pgm.width) + ", column " + std::to_string(i % pgm.width),
                std::to_string(grey), "a grey value of at most " + std::to_string(pgm.white));
    image.pixels.push_back(shade_of(static_cast<double>(grey), static_cast<double>(pgm.white), threshold));
  }
}

}  // namespace

std::vector<Point> read_pgm_points(std::string_view bytes, const std::string& name, const PixelRule& rule) {
  const std::string_view magic = bytes.substr(0, 2);
  if (magic != "P2" && magic != "P5") bad_input(name, in_quotes(magic), "a PGM image, which begins with 'P2' or 'P5'");
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  Numbers numbers(bytes.substr(2), name);
  Pgm pgm{};
  pgm.width = numbers.take(0, any, "a width in pixels");
  pgm.height = numbers.take(0, any, "a height in pixels");
  pgm.white = numbers.take(1, 65535, "a greatest grey value of 1 to 65535");
  require_image_size(pgm.width, pgm.height, name);
  pgm.data = numbers.rest();
  const std::size_t pixels = pgm.width * pgm.height;

  Shades image{pgm.width, pgm.height};
  if (magic == "P2") {
    require_room(pgm, 2 * pixels, name);  // before each number there is a blank
    image.pixels.reserve(pixels);
    read_text(image, numbers, pgm, rule.threshold);
  } else {
    pgm.data = numbers.rest_behind_blank();
    require_room(pgm, (pgm.white < 256 ? 1 : 2) * pixels, name);
    image.pixels.reserve(pixels);
    read_bytes(image, pgm, rule.threshold, name);
  }
  return foreground_points(image, rule.foreground);
}

}  // namespace rbpa::app
