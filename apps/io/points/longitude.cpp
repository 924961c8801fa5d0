#include "io/points/longitude.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

struct Box {
  Point least, greatest;
};

template <typename P>
Box box_of(const std::vector<P>& points) {
  Box box{{points.front().x, points.front().y}, {points.front().x, points.front().y}};
  for (const P& p : points)
    box = {{std::min(box.least.x, p.x), std::min(box.least.y, p.y)},
           {std::max(box.greatest.x, p.x), std::max(box.greatest.y, p.y)}};
  return box;
}

/// Whether half a globe around longitude 180 has all points, and longitude 180 is among them: more than 180 degrees
/// between two of them are without.
bool lie_around_antimeridian(const std::vector<Point>& points, const Box& box) {
  if (box.least.x < -180 || box.greatest.x > 180 || box.greatest.x - box.least.x <= 180) return false;
  std::array<bool, 361> taken{};
  for (const Point& p : points) taken[static_cast<std::size_t>(std::floor(p.x + 180))] = true;
  int widest = 0, gap = 0;
  for (const bool degree : taken) {
    gap = degree ? 0 : gap + 1;
    widest = std::max(widest, gap);
  }
  return widest > 180;
}

/// How long a degree of longitude is from one end of the box to the other, of one of latitude: "0.62", "0.50 to 0.71".
std::string share_of_latitude(const Box& box) {
  constexpr double radians = 0.017453292519943295;
  const bool has_equator = box.least.y <= 0 && box.greatest.y >= 0;
  const double farthest = std::max(std::abs(box.least.y), std::abs(box.greatest.y));
  const double nearest = has_equator ? 0 : std::min(std::abs(box.least.y), std::abs(box.greatest.y));
  char least[16], greatest[16];
  std::snprintf(least, sizeof least, "%.2f", std::abs(std::cos(farthest * radians)));
  std::snprintf(greatest, sizeof greatest, "%.2f", std::cos(nearest * radians));
  const std::string text = least;
  return text == greatest ? text : text + " to " + greatest;
}

}  // namespace

void shift_longitude(PointFile& file, const std::string& name) {
  for (Point& p : file.points) {
    if (p.x < -180 || p.x > 360)
      bad_input(name, "x = " + in_quotes(ShortestText(p.x)), "a longitude of -180 to 360, as --shift-longitude asks");
    if (p.x < 0) p.x += 360;
  }
  file.degrees = true;
}

std::string remark_on_degrees(const std::vector<Point3>& points) {
  if (points.empty()) return "";
  const Box box = box_of(points);
  if (std::abs(box.least.y) > 90 || std::abs(box.greatest.y) > 90 || box.least.x < -360 || box.greatest.x > 360)
    return "longitudes and latitudes are expected: are x and y degrees?";
  return "x and y are degrees and z is none, and a ball is round in neither; a degree of longitude is " +
         share_of_latitude(box) + " of one of latitude there (ogr2ogr -t_srs or pdal translate project them)";
}

void remark_on_degrees(PointFile& file) {
  if (file.points.empty()) return;
  const Box box = box_of(file.points);
  if (std::abs(box.least.y) > 90 || std::abs(box.greatest.y) > 90 || box.least.x < -360 || box.greatest.x > 360) {
    const bool exchanged = box.least.x >= -90 && box.greatest.x <= 90 && box.least.y >= -360 && box.greatest.y <= 360;
    file.remarks.push_back(std::string("longitudes and latitudes are expected, and found up to ") +
                           std::string(ShortestText(std::max(std::abs(box.least.x), std::abs(box.greatest.x)))) +
                           " and " +
                           std::string(ShortestText(std::max(std::abs(box.least.y), std::abs(box.greatest.y)))) +
                           (exchanged ? ": are they exchanged?" : ": are they degrees?"));
    return;
  }
  file.remarks.push_back("coordinates are degrees, and so are alpha, lengths and areas; a degree of longitude is " +
                         share_of_latitude(box) + " of one of latitude there (ogr2ogr -t_srs projects them)");
  if (lie_around_antimeridian(file.points, box))
    file.remarks.push_back(
        "points lie on both sides of the antimeridian, longitude 180, and are far apart in the plane "
        "(--shift-longitude adds 360 to longitudes below 0)");
}

}  // namespace rbpa::app
