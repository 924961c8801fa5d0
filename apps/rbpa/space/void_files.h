// What: finds the radii at which the voids of a solid close and are filled, and its pockets, which become voids only at
//       larger radii; writes voids and pockets as a table, as JSON, or as closed surfaces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/persistence/void_tree.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/voids.h"
#include "rbpa/space/surface/surface.h"
#include "shared/arguments.h"
#include "space/point_names.h"

namespace rbpa::app {

struct VoidLife {
  double closes = 0, filled = 0;  ///< the void exists for closes ≤ alpha < filled
  std::size_t depth = 0;          ///< number of times that a larger void splits before this void exists
};

struct Pocket {
  VoidLife life = {};
  double volume = 0;    ///< volume of the void at the radius at which it closes
  Triangle mouth = {};  ///< numbers of the corners of the triangle that closes the pocket
};

class VoidLives {
 public:
  /// Keeps references to `delaunay`, the triangulation of all points, and to `radii`, the circumradii of its
  /// tetrahedra. Throws Cancelled after a signal.
  VoidLives(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii, ComplexKind walls,
            unsigned threads);

  /// Returns the life of each of `voids`, in their order. Requires: `boundary` and `voids` belong to the solid at
  /// radius `alpha`, with the `walls` of the constructor.
  std::vector<VoidLife> of(double alpha, const Surface& boundary, std::span<const SolidVoid> voids) const;
  /// Returns the pockets of the solid at radius `alpha`, in descending order of volume.
  std::vector<Pocket> pockets(double alpha) const;

 private:
  VoidLife life(std::uint32_t node) const;

  const Solid& delaunay_;
  std::span<const double> radii_;
  VoidTree tree_;
};

/// Returns an object: the volume of the void between the points and, if known, outside of the balls; area, islands,
/// box, points and, if the input names points, atoms.
nlohmann::ordered_json json_of(const SolidVoid& hollow, const PointNames& names);

/// Writes the voids in their order.
/// CSV:  a line for each void: number,volume_between_points,volume_outside_balls (only for the full complex),area,
///       islands,points (their number) and the box; with `lives` also closes,filled,depth.
/// JSON: a list of the values of CSV without the number. `points` and `triangles` are input indices; `atoms` are the
///       names of the points, if the input has names.
/// OBJ:  a group void_1, void_2 … with its own vertices for each void; where a void touches itself, there is a vertex
///       for each side. Triangles face outward from the void, as if the void were a body.
/// Requires: `voids` are the voids of a solid with this boundary; `lives` is nullopt or has a life for each void;
///           `format` is one of Use::voids.
void write_voids(OutputFile& file, Format format, const PointNames& names, const Surface& boundary,
                 std::span<const SolidVoid> voids, ComplexKind walls,
                 const std::optional<std::vector<VoidLife>>& lives = {});

/// Return or write the first columns of a table of voids, number and volumes: volume_columns() the header,
/// write_volumes() a row, json_of_volumes() an object without the number.
std::string volume_columns(ComplexKind walls);
void write_volumes(OutputFile& file, std::uint64_t number, double between_points, std::optional<double> outside_balls);
nlohmann::ordered_json json_of_volumes(double between_points, std::optional<double> outside_balls);

/// Writes the pockets in their order.
/// CSV:  number,volume_between_points,closes,filled,depth,mouth_a,mouth_b,mouth_c; also serial_a,serial_b,serial_c if
///       the input has the column serial.
/// JSON: a list of the values of CSV without the number, with `mouth_atoms` if the input names points.
/// Requires: `format` is csv or json.
void write_pockets(OutputFile& file, Format format, const PointNames& names, std::span<const Pocket> pockets);

}  // namespace rbpa::app
