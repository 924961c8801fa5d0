#include "picture/picture.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>

#include "io/text/markup.h"

namespace rbpa::app {
namespace {

/// A position or a step of the pen, in hundredths of a pixel.
struct Step {
  long x, y;
  friend bool operator==(const Step&, const Step&) = default;
};

Step step_of(const Pixel& p) { return {std::lround(p.x * 100), std::lround(p.y * 100)}; }

/// Returns a number of hundredths as the shortest decimal: "12.5" for 1250, "-.07" for −7.
std::string decimal(long hundredths) {
  std::string text = hundredths < 0 ? "-" : "";
  const long size = std::abs(hundredths), whole = size / 100, part = size % 100;
  if (whole != 0 || part == 0) text += std::to_string(whole);
  if (part == 0) return text;
  text += '.';
  text += static_cast<char>('0' + part / 10);
  if (part % 10 != 0) text += static_cast<char>('0' + part % 10);
  return text;
}

/// Writes the data of a path. The pen moves by whole hundredths of a pixel, so that positions do not drift.
class Path {
 public:
  explicit Path(OutputFile& file) : file_(file) {}

  void move_to(const Step& to) {
    file_.write("M");
    write_pair(to);
    at_ = to;
  }
  void line_to(const Step& to) {
    file_.write("l");
    write_pair({to.x - at_.x, to.y - at_.y});
    at_ = to;
  }
  const Step& at() const { return at_; }

 private:
  void write_pair(const Step& pair) {
    const std::string y = decimal(pair.y);
    file_.write(decimal(pair.x));
    if (y.front() != '-') file_.write(" ");
    file_.write(y);
  }

  OutputFile& file_;
  Step at_{0, 0};
};

std::string hex(const Color& color) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned value : {color.red, color.green, color.blue}) {
    text += digits[value >> 4U];
    text += digits[value & 15U];
  }
  return text;
}

void begin_path(OutputFile& file, const std::string& id, const std::string& attributes) {
  file.write("<path id=\"" + id + "\" " + attributes + " d=\"");
}
void end_path(OutputFile& file) { file.write("\"/>\n"); }

std::string stroke(const Color& color, double width) {
  return "fill=\"none\" stroke=\"" + hex(color) + "\" stroke-width=\"" + decimal(std::lround(width * 100)) +
         "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
}

/// Writes curves as a path. With `dots`, a curve smaller than a hundredth of a pixel becomes a dot when stroked.
void write_curves(OutputFile& file, const Scene& scene, std::span<const std::vector<std::uint32_t>> curves, bool dots) {
  Path path(file);
  for (const std::vector<std::uint32_t>& curve : curves) {
    const Step first = step_of(scene.at[curve[0]]);
    bool begun = false;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Step to = step_of(scene.at[curve[i]]);
      if (to == (begun ? path.at() : first)) continue;
      if (!begun) path.move_to(first);
      begun = true;
      path.line_to(to);
    }
    if (!begun && dots) {
      path.move_to(first);
      file.write("h0");
    }
    if (begun) file.write("z");
  }
}

/// Writes a path for each group, with the name and the colors of the group.
void write_groups(OutputFile& file, const Scene& scene) {
  const std::vector<std::size_t>& begin = scene.drawing->groups;
  for (std::size_t g = 0; g + 1 < begin.size(); ++g) {
    const auto [fill, boundary] = group_colors(g);
    begin_path(file, "group-" + std::to_string(g),
               "fill=\"" + hex(fill) + "\" fill-opacity=\"" + decimal(std::lround(group_opacity * 100)) +
                   "\" stroke=\"" + hex(boundary) + "\" stroke-width=\"" +
                   decimal(std::lround(scene.strokes.boundary_width * 100)) + "\" stroke-linejoin=\"round\"");
    write_curves(file, scene, std::span(scene.drawing->curves).subspan(begin[g], begin[g + 1] - begin[g]), true);
    file.write("\"><title>" + markup_escaped(scene.drawing->group_names[g]) + "</title></path>\n");
  }
}

/// Writes edges as a path. With `dots`, an edge smaller than a hundredth of a pixel becomes a dot when stroked.
void write_edges(OutputFile& file, const Scene& scene, std::span<const Edge> edges, bool dots) {
  Path path(file);
  bool begun = false;
  for (const Edge& edge : edges) {
    const Step from = step_of(scene.at[edge[0]]), to = step_of(scene.at[edge[1]]);
    if (from == to && !dots) continue;
    if (!begun || !(from == path.at())) path.move_to(from);
    begun = true;
    if (from == to)
      file.write("h0");
    else
      path.line_to(to);
  }
}

}  // namespace

void write_svg(OutputFile& file, const Scene& scene) {
  const std::string width = std::to_string(scene.width), height = std::to_string(scene.height);
  file.write("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
             "\" viewBox=\"0 0 " + width + " " + height + "\">\n");
  file.write("<rect width=\"100%\" height=\"100%\" fill=\"" + hex(background_color) + "\"/>\n");

  if (!scene.drawing->groups.empty()) {
    write_groups(file, scene);
    file.write("</svg>\n");
    return;
  }
  const std::span<const std::vector<std::uint32_t>> curves = scene.drawing->curves;
  begin_path(file, "solid", "fill=\"" + hex(fill_color) + "\"");
  write_curves(file, scene, curves, false);
  end_path(file);
  begin_path(file, "edges", stroke(edge_color, scene.strokes.edge_width));
  write_edges(file, scene, scene.drawing->inner_edges, false);
  end_path(file);
  begin_path(file, "boundary", stroke(boundary_color, scene.strokes.boundary_width));
  write_curves(file, scene, curves, true);
  end_path(file);
  if (!scene.drawing->dangling.empty()) {
    begin_path(file, "dangling", stroke(boundary_color, scene.strokes.boundary_width));
    write_edges(file, scene, scene.drawing->dangling, true);
    end_path(file);
  }
  begin_path(file, "isolated", stroke(isolated_color, 2 * scene.strokes.dot_radius));
  Path path(file);
  for (const std::uint32_t point : scene.drawing->isolated) {
    path.move_to(step_of(scene.at[point]));
    file.write("h0");
  }
  end_path(file);
  file.write("</svg>\n");
}

}  // namespace rbpa::app
