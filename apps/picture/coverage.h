// What: computes the share of each pixel that a shape covers, from 0 to 1.
// How:  areas are exact for each pixel (signed trapezoids, summed along rows), so that shapes with a common edge leave
//       no seam. A pixel of several lines has the largest of their coverages, so that crossings are not darker. Drawing
//       and take() throw Cancelled after a signal, which they look for within a shape too, as one line may cross a
//       large canvas.
// Cost: linear in the pixels that the outlines touch, and one pass over the canvas.
#pragma once

#include <cstddef>
#include <vector>

#include "io/interrupt.h"
#include "picture/scene.h"

namespace rbpa::app {

/// The coverage of the inside of closed outlines. Requires: the outlines do not overlap, and lie within the canvas.
class AreaCoverage {
 public:
  AreaCoverage(int width, int height);
  /// Adds a straight piece of an outline. Requires: all pieces of an outline run around it in one direction.
  void add_piece(const Pixel& from, const Pixel& to);
  /// Returns the coverage of each pixel, by rows, and releases the memory. Requires: the last call, and the only one.
  std::vector<float> take();

 private:
  void add_row(float* row, double rise, double x_from, double x_to);

  std::size_t width_;
  std::size_t height_;
  std::size_t stride_;
  std::vector<float> change_;
  InterruptibleSteps step_;
};

/// The coverage of lines with round ends, and of dots. A line narrower than a pixel is drawn one pixel wide, with a
/// coverage of at most its width.
class LineCoverage {
 public:
  LineCoverage(int width, int height);
  void add_line(const Pixel& from, const Pixel& to, double line_width);
  void add_dot(const Pixel& center, double radius) { add_line(center, center, 2 * radius); }
  const std::vector<float>& values() const { return covered_; }

 private:
  int width_;
  int height_;
  std::vector<float> covered_;
  InterruptibleSteps step_;
};

}  // namespace rbpa::app
