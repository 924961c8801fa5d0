// What: the points of contests: even and uneven sets, and traps in which a search or a predicate can get slow.
// Law:  a set is a function of the number of points alone; seeds are fixed.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "support/triangle.h"

namespace rbpa_bench {

/// Kind of point set, of mean spacing 1 if it is even.
struct Workload {
  std::string name;
  std::function<rbpa_test::Points(std::size_t count)> make;  ///< returns about `count` points
};

extern const Workload uniform;
extern const Workload jittered;  ///< a grid whose points are moved by up to 0.45 of its pitch in either direction
extern const Workload grid;
extern const Workload clusters;  ///< a hundred Gaussian clusters of equal number whose widths span three decades
extern const Workload kuzmin;    ///< a heavy center: density falls with the third power of the distance
extern const Workload lidar;     ///< scan lines at map coordinates, quantized to a hundredth
extern const Workload decades;   ///< spacing grows with the distance from the center, from 1 to 1000

/// Traps; round ones have radius 1.
extern const Workload circle;               ///< rounded: cocircular except for the last bits
extern const Workload circle_line_cluster;  ///< a third on a circle, on a line across it, in a square of side 10⁻¹²
extern const Workload curves;               ///< along a parabola, a cubic and a rational circle
extern const Workload concentric;           ///< ten circles around one center

/// Returns the mean distance of neighbors along `curves`.
double spacing_along_curves(const rbpa_test::Points& points);

/// Returns a hundred Gaussian clusters of equal size whose widths span `width_decades` decades.
rbpa_test::Points gaussian_clusters(std::size_t count, double width_decades);

/// Returns points of which half lie twice as dense as the others, as in figure 9 of the paper.
rbpa_test::Points two_level_sampling(std::size_t count);

}  // namespace rbpa_bench
