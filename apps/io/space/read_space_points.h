// What: points of space, with normals and colours where the file has them, from a file of any format we read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/condition.h"
#include "io/formats.h"
#include "io/space/space_points.h"
#include "io/table/columns.h"

namespace rbpa::app {

/// What of a file counts.
struct SpaceChoice {
  /// Of text: x, y, z, or these and the normal's; absent: as the header names them, else the first three, and the three
  /// behind them when there are six.
  std::optional<std::vector<Column>> columns = std::nullopt;
  std::optional<Condition> where = std::nullopt;  ///< of LAS and text: which points count
  bool skip_invalid = false;                      ///< leave out lines of text, and records of LAS, that are no point
};

/// What SpaceChoice::where may name; nothing where points have no fields beside them.
std::optional<FieldNames> fields_of(SpaceFormat format);

/// The points in the order of the file. `path` "-" is standard input; a gzip file is read as what was compressed. Throws
/// BadInput naming the file, the line or the point (counted from 0), what was found and what was expected, and nothing
/// is allocated for what a header only claims; Failure; Cancelled; WrongUsage when two of the columns are one.
SpacePoints read_space_points(const std::string& path, SpaceFormat format, const SpaceChoice& choice = {});

/// The same of the content of a file, which messages call `name`.
SpacePoints space_points_in(std::string_view bytes, const std::string& name, SpaceFormat format,
                            const SpaceChoice& choice = {});

}  // namespace rbpa::app
