#include "picture/coverage.h"

#include <algorithm>
#include <cmath>

namespace rbpa::app {

AreaCoverage::AreaCoverage(int width, int height)
    : width_(static_cast<std::size_t>(width)),
      height_(static_cast<std::size_t>(height)),
      stride_(width_ + 2),  // the columns right of the canvas are written but never read
      change_(stride_ * height_) {}

void AreaCoverage::add_piece(const Pixel& from, const Pixel& to) {
  if (from.y == to.y) return;
  const double sign = from.y < to.y ? 1 : -1;
  const Pixel& top = from.y < to.y ? from : to;
  const Pixel& bottom = from.y < to.y ? to : from;
  const double slope = (bottom.x - top.x) / (bottom.y - top.y);
  const double last_x = static_cast<double>(width_);
  const auto x_at = [&](double y) { return std::clamp(top.x + (y - top.y) * slope, 0.0, last_x); };
  double y = std::max(top.y, 0.0);
  const double y_end = std::min(bottom.y, static_cast<double>(height_));
  double x = x_at(y);
  while (y < y_end) {
    step_();
    const double row = std::floor(y);
    const double y_next = std::min(row + 1, y_end);
    const double x_next = y_next == bottom.y ? std::clamp(bottom.x, 0.0, last_x) : x_at(y_next);
    add_row(change_.data() + static_cast<std::size_t>(row) * stride_, sign * (y_next - y), x, x_next);
    y = y_next;
    x = x_next;
  }
}

void AreaCoverage::add_row(float* row, double rise, double x_from, double x_to) {
  const double left = std::min(x_from, x_to), right = std::max(x_from, x_to);
  const auto add = [row](std::size_t i, double value) { row[i] += static_cast<float>(value); };
  const auto first = static_cast<std::size_t>(left);
  const auto last = static_cast<std::size_t>(right);
  if (first == last) {  // the piece covers a part of one pixel and all pixels right of it
    const double inside = static_cast<double>(first) + 1 - (left + right) / 2;
    add(first, rise * inside);
    add(first + 1, rise * (1 - inside));
    return;
  }
  // Sum over several pixels: the area right of the piece grows quadratically in the first and the last pixel, and
  // linearly in between.
  const double per_pixel = rise / (right - left);
  const double in_first = static_cast<double>(first) + 1 - left, in_last = right - static_cast<double>(last);
  double total = 0, before = 0;
  step_((last - first) / 8);
  for (std::size_t i = first; i <= last; ++i) {
    double area = 0;  // covered area of pixel i
    if (i == first) {
      area = per_pixel * in_first * in_first / 2;
    } else if (i < last) {
      area = per_pixel * (in_first + static_cast<double>(i - first) - 0.5);
    } else {
      area = rise - per_pixel * in_last * in_last / 2;
    }
    add(i, area - before);
    before = area;
    total = area;
  }
  add(last + 1, rise - total);
}

std::vector<float> AreaCoverage::take() {
  std::vector<float> covered(width_ * height_);
  for (std::size_t y = 0; y < height_; ++y) {
    double sum = 0;
    step_(width_);
    for (std::size_t x = 0; x < width_; ++x) {
      sum += static_cast<double>(change_[y * stride_ + x]);
      covered[y * width_ + x] = static_cast<float>(std::min(std::abs(sum), 1.0));
    }
  }
  change_ = {};
  return covered;
}

LineCoverage::LineCoverage(int width, int height)
    : width_(width), height_(height), covered_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void LineCoverage::add_line(const Pixel& from, const Pixel& to, double line_width) {
  const double strength = std::min(line_width, 1.0);
  const double reach = std::max(line_width, 1.0) / 2 + 0.5;  // distance from the line at which coverage is 0
  const double dx = to.x - from.x, dy = to.y - from.y, length2 = dx * dx + dy * dy;
  const auto inside = [](double value, int size) { return static_cast<int>(std::clamp<double>(value, 0, size)); };
  const int y_end = inside(std::ceil(std::max(from.y, to.y) + reach), height_);
  for (int y = inside(std::floor(std::min(from.y, to.y) - reach), height_); y < y_end; ++y) {
    // Find the part of the line near this row, from t0 to t1, which limits the columns.
    const double row = y + 0.5;
    double t0 = 0, t1 = 1;
    if (dy != 0) {
      const double a = (row - reach - from.y) / dy, b = (row + reach - from.y) / dy;
      t0 = std::clamp(std::min(a, b), 0.0, 1.0);
      t1 = std::clamp(std::max(a, b), 0.0, 1.0);
    }
    const double xa = from.x + t0 * dx, xb = from.x + t1 * dx;
    const int x_end = inside(std::ceil(std::max(xa, xb) + reach), width_);
    const int x_begin = inside(std::floor(std::min(xa, xb) - reach), width_);
    step_(1 + static_cast<std::size_t>(std::max(x_end - x_begin, 0)) / 4);
    for (int x = x_begin; x < x_end; ++x) {
      const double px = x + 0.5 - from.x, py = row - from.y;
      const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0;
      const double qx = px - t * dx, qy = py - t * dy, distance2 = qx * qx + qy * qy;
      if (distance2 >= reach * reach) continue;
      const double covered = strength * std::min(1.0, reach - std::sqrt(distance2));
      float& value =
          covered_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
      value = std::max(value, static_cast<float>(covered));
    }
  }
}

}  // namespace rbpa::app
