#include "space/balls_voids.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/interrupt.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/balls/periodic_voids.h"
#include "space/void_files.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

/// The total area and the largest radius of the mouths of a pocket.
struct MouthSizes {
  double area = 0, radius = 0;
  explicit MouthSizes(const BallVoid& pocket) {
    for (const BallMouth& mouth : pocket.mouths) {
      area += mouth.area;
      radius = std::max(radius, mouth.radius);
    }
  }
};

}  // namespace

void find_voids(MeasuredAtoms& frame, std::span<const Point3> centers, double probe, bool pockets, MaxThreads threads) {
  std::vector<double> radii = frame.radii;
  for (double& radius : radii) radius += probe;
  const auto progress = [](const Progress&) { return !interrupted(); };
  if (frame.cell) {
    frame.voids = periodic_ball_voids(centers, radii, *frame.cell, {.threads = threads, .progress = progress});
    return;
  }
  frame.cells = regular_triangulation(centers, radii, {.threads = threads, .progress = progress});
  frame.voids = ball_voids(centers, radii, frame.cells, {.pockets = pockets, .threads = threads, .progress = progress});
}

BallVoidRows::BallVoidRows(OutputFile& file, Format format, bool has_frames, bool has_cells, bool of_pockets)
    : file_(file), format_(format), has_frames_(has_frames), has_cells_(has_cells), of_pockets_(of_pockets) {
  if (format == Format::csv)
    file.write_all(has_frames ? "frame," : "", volume_columns(ComplexKind::full), ",area,x,y,z,radius_max,",
                   has_cells ? "dimension," : "", of_pockets ? "mouths,mouth_area,mouth_radius_max," : "", "points\n");
}

void BallVoidRows::write(const MeasuredAtoms& frame) {
  std::uint64_t number = 0;
  for (const BallVoid& hollow : of_pockets_ ? frame.voids.pockets : frame.voids.voids) {
    stop_if_interrupted();
    ++number;
    const std::string name = (has_frames_ ? "frame_" + std::to_string(frame.number) + "_" : std::string()) +
                             (of_pockets_ ? "pocket_" : "void_") + std::to_string(number);
    if (format_ == Format::csv)
      write_row(frame, hollow, number);
    else if (format_ == Format::json)
      write_json(frame, hollow);
    else if (format_ == Format::obj)
      write_surface(frame, hollow, name);
    else
      write_commands(frame, hollow, name);
    ++size_;
  }
}

void BallVoidRows::finish() {
  if (format_ == Format::json) file_.write(size_ == 0 ? "[]\n" : "\n]\n");
  file_.finish();
}

void BallVoidRows::write_row(const MeasuredAtoms& frame, const BallVoid& hollow, std::uint64_t number) {
  if (has_frames_) file_.write_all(std::uint64_t{frame.number}, ",");
  write_volumes(file_, number, hollow.volume_of_tetrahedra, hollow.volume);
  file_.write_all(",", hollow.area, ",", hollow.center.x, ",", hollow.center.y, ",", hollow.center.z, ",",
                  hollow.radius);
  if (has_cells_) file_.write_all(",", hollow.dimension);
  if (of_pockets_) {
    const MouthSizes mouths(hollow);
    file_.write_all(",", hollow.mouths.size(), ",", mouths.area, ",", mouths.radius);
  }
  const char* before = ",\"";
  for (const LiningBall& lining : hollow.balls) {
    file_.write_all(before, std::uint64_t{frame.rows[lining.ball].index});
    before = " ";
  }
  file_.write("\"\n");
}

void BallVoidRows::write_json(const MeasuredAtoms& frame, const BallVoid& hollow) {
  Json one;
  if (has_frames_) one["frame"] = frame.number;
  one.update(json_of_volumes(hollow.volume_of_tetrahedra, hollow.volume));
  one.update(Json{{"area", hollow.area},
                  {"center", {hollow.center.x, hollow.center.y, hollow.center.z}},
                  {"radius_max", hollow.radius}});
  if (has_cells_) one["dimension"] = hollow.dimension;
  if (of_pockets_) {
    one["mouths"] = Json::array();
    for (const BallMouth& mouth : hollow.mouths)
      one["mouths"].push_back({{"area", mouth.area}, {"perimeter", mouth.perimeter}, {"radius_max", mouth.radius}});
  }
  Json points = Json::array(), areas = Json::array();
  for (const LiningBall& lining : hollow.balls) {
    points.push_back(frame.rows[lining.ball].index);
    areas.push_back(lining.area);
  }
  one["points"] = std::move(points);
  one["areas"] = std::move(areas);
  file_.write(size_ == 0 ? "[\n" : ",\n");
  file_.write(one.dump());
}

void BallVoidRows::write_commands(const MeasuredAtoms& frame, const BallVoid& hollow, const std::string& name) {
  constexpr const char* colors[] = {"orange", "cyan", "magenta", "yellow", "green", "blue"};
  const std::string color = colors[size_ % std::size(colors)];
  const bool is_pymol = format_ == Format::pml;
  file_.write(is_pymol ? "select " + name + ", id " : "name " + name);
  const char* before = is_pymol ? "" : " @@serial_number=";
  for (const LiningBall& lining : hollow.balls) {
    const AtomRow& atom = frame.rows[lining.ball];
    file_.write_all(before, std::isnan(atom.serial) ? static_cast<double>(atom.index + 1) : atom.serial);
    before = is_pymol ? "+" : " @@serial_number=";
  }
  const auto& [x, y, z] = hollow.center;
  if (is_pymol)
    file_.write_all("\ncolor ", color, ", ", name, "\npseudoatom ", name, "_ball, pos=[", x, ",", y, ",", z,
                    "], vdw=", hollow.radius, ", color=", color, "\nshow spheres, ", name, "_ball\n");
  else
    file_.write_all("\ncolor ", name, " ", color, "\nshape sphere center ", x, ",", y, ",", z, " radius ",
                    hollow.radius, " color ", color, " name ", name, "_ball\n");
}

void BallVoidRows::write_surface(const MeasuredAtoms& frame, const BallVoid& hollow, const std::string& name) {
  file_.write("g " + name + "\n");
  const std::vector<Triangle> triangles = boundary_of(hollow, frame.cells);
  std::unordered_map<std::uint32_t, std::uint64_t> vertex;  // number, from 1, of the vertex of each ball
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t ball : triangle) {
      if (!vertex.try_emplace(ball, vertices_ + 1).second) continue;
      ++vertices_;
      const Point3& p = frame.rows[ball].center;
      file_.write_all("v ", p.x, " ", p.y, " ", p.z, "\n");
    }
  for (const auto& [a, b, c] : triangles)
    file_.write_all("f ", vertex.at(a), " ", vertex.at(b), " ", vertex.at(c), "\n");
}

}  // namespace rbpa::app
