// What: the voids of a solid as a file: a table, JSON, or closed surfaces.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/point_names.h"
#include "cli/void_lives.h"
#include "io/bytes/output_file.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"
#include "rbpa/voids.h"

namespace rbpa::app {

/// Throws WrongUsage naming the ending.
Target parse_voids(const std::string& path);

/// Volume between the points, outside of the balls where it is known, area, islands, box and points, with what names these.
nlohmann::ordered_json json_of(const SolidVoid& hollow, const PointNames& names);

/// CSV: number,volume_between_points,volume_outside_balls (of the full complex),area,islands,points and the box, a line
/// for each void, the largest first; with lives, closes,filled,depth. JSON: a list of the same, with the input indices
/// of its points and of the triangles around it, and with `atoms`, what the input calls the points. OBJ: a group void_1, void_2 … of each, with vertices of its own, where
/// it touches itself one for each side of it. Triangles are seen from around the void, as if it were a body.
/// Requires: voids of a solid with this boundary, a life for each or none, and a format of void_formats.
void write_voids(OutputFile& file, Format format, const PointNames& names, const Surface& boundary,
                 std::span<const SolidVoid> voids, VoidWalls walls,
                 const std::optional<std::vector<VoidLife>>& lives = {});

/// The first columns of a table of voids: their number and volumes; and these of one. JSON likewise.
std::string volume_columns(VoidWalls walls);
void write_volumes(OutputFile& file, std::uint64_t number, double between_points, std::optional<double> outside_balls);
nlohmann::ordered_json json_of_volumes(double between_points, std::optional<double> outside_balls);

/// CSV: number,volume_between_points,closes,filled,depth,mouth_a,mouth_b,mouth_c, the largest first, and where points have
/// names serial_a and so on; JSON the same, with `mouth_atoms`. Requires: csv or json.
void write_pockets(OutputFile& file, Format format, const PointNames& names, std::span<const Pocket> pockets);

}  // namespace rbpa::app
