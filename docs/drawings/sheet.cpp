#include "drawings/sheet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace figures {
namespace {

constexpr double margin = 16;          // around the whole figure
constexpr double gap = 36;             // between panels without an arrow
constexpr double heading_height = 26;  // for rows with headings
constexpr double line_height = 17;

struct Box {
  Place low{1e9, 1e9}, high{-1e9, -1e9};
  void add(Place p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

/// Returns the common frame of all panels of a row, so that unchanged parts are seen at the same place.
Box box_of(const std::vector<Panel>& panels) {
  Box box;
  for (const Panel& panel : panels) {
    for (const Place p : panel.drawn.all_places()) box.add(p);
    for (const auto& label : panel.marks.labels) box.add(label.at);
    for (const Place p : panel.extent) box.add(p);
  }
  return box;
}

double width_of_arrow(const Arrow& arrow) {
  const std::size_t letters = std::max({arrow.there.size(), arrow.back.size(), arrow.note.size() * 9 / 10});
  return std::max(120.0, 8.0 * static_cast<double>(letters) + 40);
}

void draw_arrow(Canvas& canvas, Place left, double width, const Arrow& arrow) {
  const Place from = left + Place{14, 0}, to = left + Place{width - 14, 0};
  const double middle = left.x + width / 2;
  const double apart = arrow.back.empty() ? 0 : 5;
  const Stroke stroke{color::text, 1.6};
  canvas.arrow({from - Place{0, apart}, to - Place{0, apart}, {}}, stroke, 10);
  canvas.text({middle, left.y - apart - 9}, arrow.there, Lettering::code);
  if (!arrow.back.empty()) {
    canvas.arrow({to + Place{0, apart}, from + Place{0, apart}, {}}, stroke, 10);
    canvas.text({middle, left.y + apart + 19}, arrow.back, Lettering::code);
  }
  if (!arrow.note.empty()) canvas.text({middle, left.y - apart - 28}, arrow.note, Lettering::small);
}

std::string number(const char* name, long value) { return std::string(name) + " " + std::to_string(value); }

}  // namespace

Panel counted(const DrawnMesh& drawn, const Marks& marks) {
  const auto counts = meshops::count_topology(drawn.mesh);
  const auto is = [](const char* name, std::size_t value) { return number(name, static_cast<long>(value)); };
  return {drawn,
          marks,
          {is("V", counts.vertices) + " · " + is("E", counts.edges) + " · " + is("F", counts.faces),
           is("curves", counts.boundary_curves) + " · " + is("components", counts.components) + " · " +
               number("genus", counts.genus())}};
}

std::string Sheet::svg() const {
  Canvas canvas;
  double y = margin, right = 0;
  for (const Row& row : rows_) {
    const Box box = box_of(row.panels);
    const double inside = scale_ * (box.high.x - box.low.x), height = scale_ * (box.high.y - box.low.y);
    const double width = std::max(inside + 12, least_width_);
    const double between = row.arrow ? width_of_arrow(*row.arrow) : gap;
    std::size_t lines = 0;
    bool headed = false;
    for (const Panel& panel : row.panels) {
      lines = std::max(lines, panel.caption.size());
      headed = headed || !panel.heading.empty();
    }
    if (headed) y += heading_height;
    const double top = y + 8, bottom = top + height;
    double x = margin;
    for (std::size_t i = 0; i < row.panels.size(); ++i) {
      const Panel& panel = row.panels[i];
      const double middle = x + width / 2;
      const Frame frame{{middle - inside / 2 - scale_ * box.low.x, bottom + scale_ * box.low.y}, scale_};
      if (!panel.heading.empty()) canvas.text({middle, top - 20}, panel.heading, Lettering::plain);
      draw(canvas, frame, panel.drawn, panel.marks);
      if (panel.more) panel.more(canvas, frame);
      for (std::size_t line = 0; line < panel.caption.size(); ++line)
        canvas.text({middle, bottom + 30 + line_height * static_cast<double>(line)}, panel.caption[line],
                    Lettering::small);
      x += width;
      if (i + 1 < row.panels.size()) {
        if (row.arrow) draw_arrow(canvas, {x, (top + bottom) / 2}, between, *row.arrow);
        x += between;
      }
    }
    right = std::max(right, x);
    y = bottom + 22 + line_height * static_cast<double>(lines) + 20;
  }
  return canvas.svg(title_, static_cast<int>(std::lround(right + margin)), static_cast<int>(std::lround(y - 8)));
}

void require_same_counts(const DrawnMesh& before, const DrawnMesh& there_and_back) {
  if (meshops::count_topology(before.mesh) != meshops::count_topology(there_and_back.mesh))
    throw std::logic_error("the inverse operator does not give back what was there");
}

}  // namespace figures
