#include "drawings/canvas.h"

#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <numbers>

namespace figures {
namespace {

/// Returns a number, rounded to tenths of a pixel, as the shortest decimal.
std::string decimal(double value) {
  const long tenths = std::lround(value * 10), size = std::abs(tenths);
  std::string text = tenths < 0 ? "-" : "";
  text += std::to_string(size / 10);
  if (size % 10 != 0) text.append(1, '.').append(std::to_string(size % 10));
  return text;
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string pair(Place p) { return joined({decimal(p.x), " ", decimal(p.y)}); }

/// Returns the path from the position of the pen, which is at the start of the segment, to its end.
std::string draw_to_end(const Segment& s) {
  return s.bend ? joined({"Q", pair(*s.bend), " ", pair(s.to)}) : joined({"L", pair(s.to)});
}

std::string attribute(std::string_view name, std::string_view value) { return joined({" ", name, "=\"", value, "\""}); }

std::string escaped(std::string_view words) {
  std::string text;
  for (const char c : words) {
    if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else if (c == '>')
      text += "&gt;";
    else
      text += c;
  }
  return text;
}

std::string path_of(const std::vector<std::vector<Place>>& rings) {
  std::string path;
  for (const auto& ring : rings) {
    std::string_view step = "M";
    for (const Place p : ring) {
      path += joined({step, pair(p)});
      step = "L";
    }
    path += "Z";
  }
  return path;
}

std::string attributes(const Stroke& stroke) {
  std::string text = attribute("stroke", stroke.color) + attribute("stroke-width", decimal(stroke.width));
  if (stroke.dashed) text += attribute("stroke-dasharray", "5 4");
  return text + " fill=\"none\"/>\n";
}

std::string_view class_of(Lettering lettering) {
  constexpr std::string_view names[] = {"", "i", "c", "s"};
  return names[static_cast<int>(lettering)];
}

}  // namespace

double length(Place p) { return std::sqrt(p.x * p.x + p.y * p.y); }

Place direction(Place p) {
  const double size = length(p);
  return size > 0 ? (1 / size) * p : p;
}

Place polar(double degrees, double radius) {
  const double angle = degrees * std::numbers::pi / 180;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

void Canvas::outline(const std::vector<Segment>& sides, std::string_view fill) {
  if (sides.empty()) return;
  body_ += joined({"<path d=\"M", pair(sides.front().from)});
  for (const Segment& side : sides) body_ += draw_to_end(side);
  body_ += joined({"Z\"", attribute("fill", fill), "/>\n"});
}

void Canvas::region(const std::vector<std::vector<Place>>& rings, std::string_view fill) {
  if (rings.empty()) return;
  body_ += joined({"<path d=\"", path_of(rings), "\"", attribute("fill", fill), " fill-rule=\"evenodd\"/>\n"});
}

void Canvas::closed_lines(const std::vector<std::vector<Place>>& rings, const Stroke& stroke) {
  if (rings.empty()) return;
  body_ += joined({"<path d=\"", path_of(rings), "\"", attributes(stroke)});
}

void Canvas::segment(const Segment& s, const Stroke& stroke) {
  body_ += joined({"<path d=\"M", pair(s.from), draw_to_end(s), "\"", attributes(stroke)});
}

void Canvas::segments(const std::vector<Segment>& all, const Stroke& stroke) {
  if (all.empty()) return;
  std::string path;
  for (const Segment& s : all) path += joined({"M", pair(s.from), draw_to_end(s)});
  body_ += joined({"<path d=\"", path, "\"", attributes(stroke)});
}

void Canvas::head(Place at, Place along, std::string_view color, double size) {
  const Place u = (size / 2) * direction(along), side{-0.8 * u.y, 0.8 * u.x};
  body_ += joined({"<path d=\"M", pair(at + u), "L", pair(at - u + side), "L", pair(at - u - side), "Z\"",
                   attribute("fill", color), "/>\n"});
}

void Canvas::arrow(const Segment& s, const Stroke& stroke, double head_size) {
  const Place along = direction(s.to - s.bend.value_or(s.from));
  segment({s.from, s.to - (head_size / 2) * along, s.bend}, stroke);
  head(s.to - (head_size / 2) * along, along, stroke.color, head_size);
}

void Canvas::dot(Place at, double radius, std::string_view fill) {
  body_ += joined({"<circle", attribute("cx", decimal(at.x)), attribute("cy", decimal(at.y)),
                   attribute("r", decimal(radius)), attribute("fill", fill), "/>\n"});
}

void Canvas::dots(const std::vector<Place>& at, double radius, std::string_view fill) {
  if (at.empty()) return;
  std::string path;
  for (const Place p : at) path += joined({"M", pair(p), "h0"});  // the round ends of a line of no length
  body_ += joined({"<path d=\"", path, "\"", attributes({fill, 2 * radius})});
}

void Canvas::circle(Place center, double radius, const Stroke& stroke) {
  body_ += joined({"<circle", attribute("cx", decimal(center.x)), attribute("cy", decimal(center.y)),
                   attribute("r", decimal(radius)), attributes(stroke)});
}

void Canvas::text(Place at, std::string_view words, Lettering lettering) {
  body_ += "<text";
  if (const auto name = class_of(lettering); !name.empty()) body_ += attribute("class", name);
  body_ += attribute("text-anchor", "middle") + attribute("x", decimal(at.x)) + attribute("y", decimal(at.y)) + ">" +
           escaped(words) + "</text>\n";
}

std::string Canvas::svg(std::string_view title, int width, int height) const {
  const std::string w = std::to_string(width), h = std::to_string(height);
  return joined({"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", w, " ", h, "\" width=\"", w,
                 "\" height=\"", h, "\">\n<title>", escaped(title),
                 "</title>\n"
                 "<style>\n"
                 "text{font:14px \"DejaVu Sans\",Helvetica,Arial,sans-serif;fill:#1b2733}\n"
                 ".i{font-style:italic}.s{font-size:12px;fill:#5b6b7a}\n"
                 ".c{font:13px \"DejaVu Sans Mono\",Menlo,Consolas,monospace}\n"
                 "path{stroke-linecap:round;stroke-linejoin:round}\n"
                 "</style>\n"
                 "<rect width=\"",
                 w, "\" height=\"", h, "\" fill=\"#ffffff\"/>\n", body_, "</svg>\n"});
}

}  // namespace figures
