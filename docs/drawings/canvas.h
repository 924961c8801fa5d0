// What: a drawing as SVG: segments, outlines, dots, arrows and text.
// Law:  the same calls give the same bytes. Positions are multiples of 0.1 pixels, with y downwards.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace figures {

struct Place {
  double x = 0, y = 0;
  friend Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
  friend Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
  friend Place operator*(double s, Place a) { return {s * a.x, s * a.y}; }
  friend bool operator==(Place, Place) = default;
};
double length(Place p);
/// Returns the vector scaled to length 1; the zero vector stays.
Place direction(Place p);
/// Returns the point at an angle in degrees on a circle about the origin.
Place polar(double degrees, double radius);

/// Line from place to place. With `bend` it is a parabola that leaves and arrives in the direction of `bend`.
struct Segment {
  Place from, to;
  std::optional<Place> bend;
  Segment reversed() const { return {to, from, bend}; }
  Place middle() const { return bend ? 0.25 * (from + to) + 0.5 * *bend : 0.5 * (from + to); }
};

/// Colors that are distinct for every kind of color vision, and in gray: blue against orange, dark against light.
namespace color {
constexpr std::string_view text = "#1b2733";
constexpr std::string_view inner = "#7d8b98";
constexpr std::string_view pale = "#d3dbe3";
constexpr std::string_view face = "#dcebf8";
constexpr std::string_view curve = "#1f6fb2";
constexpr std::string_view touched = "#d9730d";
constexpr std::string_view touched_face = "#fadcb9";
}  // namespace color

enum class Lettering { plain, italic, code, small };

struct Stroke {
  std::string_view color = color::inner;
  double width = 1;
  bool dashed = false;
};

class Canvas {
 public:
  void outline(const std::vector<Segment>& sides, std::string_view fill);
  /// Fills the region inside an odd number of the closed polylines.
  void region(const std::vector<std::vector<Place>>& rings, std::string_view fill);
  void closed_lines(const std::vector<std::vector<Place>>& rings, const Stroke& stroke);
  void segment(const Segment& s, const Stroke& stroke);
  /// Draws straight segments as one element.
  void segments(const std::vector<Segment>& all, const Stroke& stroke);
  /// Draws an arrow head: a triangle of `size` pixels whose middle is at a place.
  void head(Place at, Place along, std::string_view color, double size);
  /// Draws a line that ends in a head.
  void arrow(const Segment& s, const Stroke& stroke, double head_size);
  void dot(Place at, double radius, std::string_view fill);
  /// Draws dots as one element.
  void dots(const std::vector<Place>& at, double radius, std::string_view fill);
  /// Draws a circle and leaves its inside as it is.
  void circle(Place center, double radius, const Stroke& stroke);
  /// Writes text whose base line has its middle at a place.
  void text(Place at, std::string_view words, Lettering lettering);

  /// Returns the whole file for an image of the given size.
  std::string svg(std::string_view title, int width, int height) const;

 private:
  std::string body_;
};

}  // namespace figures
