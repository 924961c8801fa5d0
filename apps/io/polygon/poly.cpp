#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/polygon/read_polygons.h"
#include "io/text/lines.h"
#include "rbpa/base/error.h"
#include "rbpa/fill/polygons_of_rings.h"

namespace rbpa::app {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

class PolyReader {
 public:
  PolyReader(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  PolygonFile read() {
    PolygonFile file;
    read_vertices(file.vertices.points);
    const std::vector<Ring> rings = read_rings();
    const std::vector<Point> in_holes = read_hole_points();
    try {
      file.polygons = polygons_of_rings(file.vertices.points, rings, in_holes, until_interrupted());
    } catch (const InvalidInput& e) {
      throw BadInput(name_ + ": " + e.what());
    }
    file.end_geometry(0, 0);
    file.features = 1;
    return file;
  }

 private:
  void next_line(const std::string& expected) {
    if (!lines_.next_with_content()) refuse("the end of the file", expected);
    rest_ = lines_.line().substr(0, lines_.line().find('#'));
  }
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    bad_input(at_line(name_, lines_.number()), found, expected);
  }
  double number(const std::string& what) {
    const std::string_view word = take_word(rest_);
    if (word.empty()) refuse("the end of the line", what);
    const ParsedNumber parsed = parse_written_number(word);
    if (parsed.fault != NumberFault::none) refuse(in_quotes(word), what + ": " + expected_instead(parsed.fault));
    return parsed.value;
  }
  std::size_t whole(const std::string& what, std::size_t greatest) {
    std::string_view ahead = rest_;
    const std::string_view word = take_word(ahead);
    const double value = number(what);
    if (!(value >= 0 && value <= static_cast<double>(greatest)) || value != std::floor(value))
      refuse(in_quotes(word), what + ": a whole number from 0 to " + std::to_string(greatest));
    return static_cast<std::size_t>(value);
  }
  /// Reads the number of `what`. Throws BadInput if the number exceeds that of the bytes after the line.
  std::size_t count(const std::string& what) {
    next_line(what);
    return whole(what, lines_.rest().size());
  }

  void read_vertices(std::vector<Point>& points) {
    const std::size_t vertices = count("the number of vertices");
    if (vertices == 0) refuse("0 vertices, which means that they are in a .node file", "the vertices in this file");
    if (const std::size_t dimension = whole("the dimension", 3); dimension != 2)
      refuse("dimension " + std::to_string(dimension), "2");
    for (std::size_t i = 0; i < vertices; ++i) {
      next_line("a vertex: its number, x and y");
      const std::size_t number_of = whole("the number of a vertex", vertices);
      if (i == 0) first_ = number_of;
      if (first_ > 1 || number_of != first_ + i)
        refuse("vertex " + std::to_string(number_of),
               i == 0 ? "0 or 1 for the first" : "vertex " + std::to_string(first_ + i));
      const double x = number("x of a vertex");
      points.push_back({x, number("y of a vertex")});
    }
    ends_.resize(vertices, {none, none});
  }

  std::vector<Ring> read_rings() {
    const std::size_t segments = count("the number of segments");
    for (std::size_t i = 0; i < segments; ++i) {
      next_line("a segment: its number and two vertices");
      number("the number of a segment");
      const std::size_t a = vertex(), b = vertex();
      if (a == b) refuse("a segment from a vertex to itself", "two vertices");
      join(a, b);
      join(b, a);
    }
    for (std::size_t v = 0; v < ends_.size(); ++v)
      if (ends_[v][0] != none && ends_[v][1] == none)
        bad_input(name_, "one segment at vertex " + std::to_string(first_ + v),
                  "two or none, as segments must form closed rings");
    std::vector<bool> seen(ends_.size(), false);
    std::vector<Ring> rings;
    for (std::uint32_t v = 0; v < ends_.size(); ++v) {
      if (seen[v] || ends_[v][0] == none) continue;
      Ring& ring = rings.emplace_back();
      std::uint32_t before = ends_[v][1];
      for (std::uint32_t at = v; !seen[at];) {
        seen[at] = true;
        ring.points.push_back(at);
        const std::uint32_t next = ends_[at][0] == before ? ends_[at][1] : ends_[at][0];
        before = at;
        at = next;
      }
    }
    return rings;
  }
  std::size_t vertex() {
    const std::size_t number_of = whole("a vertex", first_ + ends_.size() - 1);
    if (number_of < first_) refuse("vertex 0", "a number from 1, the number of the first vertex");
    return number_of - first_;
  }
  void join(std::size_t v, std::size_t other) {
    auto& [first, second] = ends_[v];
    if (first == none)
      first = static_cast<std::uint32_t>(other);
    else if (second == none)
      second = static_cast<std::uint32_t>(other);
    else
      refuse("a third segment at vertex " + std::to_string(first_ + v),
             "two, as segments must form closed rings (remove segments inside of polygons)");
  }

  std::vector<Point> read_hole_points() {
    std::vector<Point> points(count("the number of holes"));
    for (Point& p : points) {
      next_line("a hole: its number, x and y");
      number("the number of a hole");
      p.x = number("x of a point in a hole");
      p.y = number("y of a point in a hole");
    }
    return points;
  }

  Lines lines_;
  const std::string& name_;
  std::string_view rest_ = {};                           // rest of the current line
  std::size_t first_ = 0;                                // the number of the first vertex
  std::vector<std::array<std::uint32_t, 2>> ends_ = {};  // the other ends of the two segments at each vertex
};

}  // namespace

PolygonFile read_poly_polygons(std::string_view text, const std::string& name) { return PolyReader(text, name).read(); }

}  // namespace rbpa::app
