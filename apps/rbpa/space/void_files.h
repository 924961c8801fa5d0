// What: writes the voids of a solid as a table, as JSON, or as closed surfaces.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/voids.h"
#include "rbpa/space/surface/surface.h"
#include "shared/arguments.h"
#include "space/point_names.h"
#include "space/void_lives.h"

namespace rbpa::app {

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
