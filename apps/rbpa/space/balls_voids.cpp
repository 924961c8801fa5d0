#include "space/balls_voids.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "io/interrupt.h"
#include "rbpa/space/balls/regular_triangulation.h"
#include "space/void_files.h"

namespace rbpa::app {

BallVoids voids_of(const MeasuredAtoms& frame, double probe, bool pockets, MaxThreads threads) {
  std::vector<Point3> centers;
  std::vector<double> radii;
  for (std::size_t i = 0; i < frame.rows.size(); ++i) {
    centers.push_back(frame.rows[i].center);
    radii.push_back(frame.radii[i] + probe);
  }
  const auto progress = [](const Progress&) { return !interrupted(); };
  return ball_voids(centers, radii, regular_triangulation(centers, radii, {.threads = threads, .progress = progress}),
                    {.pockets = pockets, .threads = threads, .progress = progress});
}

void begin_voids(OutputFile& file, bool has_frames, bool of_pockets) {
  file.write_all(has_frames ? "frame," : "", volume_columns(ComplexKind::full), ",area,x,y,z,radius_max,",
                 of_pockets ? "mouths,mouth_area,mouth_radius_max," : "", "points\n");
}

void write_voids(OutputFile& file, bool has_frames, bool of_pockets, const MeasuredAtoms& frame,
                 std::span<const BallVoid> voids) {
  std::uint64_t number = 0;
  for (const BallVoid& hollow : voids) {
    stop_if_interrupted();
    if (has_frames) file.write_all(std::uint64_t{frame.number}, ",");
    write_volumes(file, ++number, hollow.volume_of_tetrahedra, hollow.volume);
    file.write_all(",", hollow.area, ",", hollow.center.x, ",", hollow.center.y, ",", hollow.center.z, ",",
                   hollow.radius);
    if (of_pockets) {
      double area = 0, radius = 0;
      for (const BallMouth& mouth : hollow.mouths) {
        area += mouth.area;
        radius = std::max(radius, mouth.radius);
      }
      file.write_all(",", hollow.mouths.size(), ",", area, ",", radius);
    }
    const char* before = ",\"";
    for (const LiningBall& lining : hollow.balls) {
      file.write_all(before, std::uint64_t{frame.rows[lining.ball].index});
      before = " ";
    }
    file.write("\"\n");
  }
}

}  // namespace rbpa::app
