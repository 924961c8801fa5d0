// What: the points of a file as blocks of columns: x and y, or x, y, z, normals and colors. One reader for each format.
// Law:  all blocks of a file together are its points in its order, whether it is in memory or read as it goes. Coordinates and
//       normals are finite. Who reads selects what to make of the columns (read_points.h, read_space_points.h,
//       point_blocks.h).
// Cost: one pass over the file; only columns that are wanted are made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/claim.h"
#include "io/bytes/content.h"
#include "io/bytes/scalar.h"
#include "io/formats.h"
#include "io/point_file.h"
#include "io/text/columns.h"
#include "io/text/condition.h"

namespace rbpa::app {

/// The choice about atoms of water in the file of a molecule.
enum class Waters {
  counted,   ///< they are atoms as all others
  noted,     ///< the same, and a remark says how many
  left_out,  ///< where the condition does not name residues
};

/// What is wanted of a file.
struct CloudRequest {
  bool in_space = false;  ///< x, y, z, normals and colors; else x and y, and whether heights differ
  /// Of a table: x, y, or geometries, or x, y, z, or these and the normal's. Absent: as its header names them, else the
  /// first.
  std::optional<std::vector<Column>> columns = std::nullopt;
  std::optional<Condition> where = std::nullopt;  ///< which points count, by fields beside them
  bool heights = false;                           ///< in the plane: z as well, where there is one
  bool skip_invalid = false;                      ///< leave out lines of text, and records of LAS, that are no point
  bool vertices = false;                          ///< those of lines and polygons in a column of geometries
  Waters waters = Waters::noted;
  bool last_are_normals = false;  ///< columns 4 to 6 of a table that nothing names, whatever is in them
};

/// Points in a row. Columns that a cloud does not have are empty.
struct CloudBlock {
  static constexpr std::size_t x = 0, y = 1, z = 2, normal = 3, color = 6, columns = 9;
  std::size_t count = 0;
  std::array<std::vector<double>, columns> column = {};
  std::vector<double> heights = {};  ///< as CloudRequest::heights has it: of each point, NaN where it has none
  std::vector<std::vector<double>> fields = {};  ///< of the columns() of CloudRequest::where
  /// Of each point among all of the file, where some of these may be left out: records of LAS, vertices, atoms, lines of a table behind
  /// its header, of which one that is left out counts as a point. Else none.
  std::vector<std::uint64_t> index = {};
};

/// Points that a reader makes at a time: few enough that their columns stay in the cache.
constexpr std::size_t points_at_once = 4096;

/// What a channel of a color is of.
enum class Channels {
  bytes,  ///< 0 to 255
  unit,   ///< 0 to 1
  wide    ///< 0 to 65535
};

/// The box that a file says its points repeat in.
struct UnitCell {
  std::optional<std::array<double, 3>> sides = std::nullopt;  ///< along x, y and z, where all its angles are right
  std::string fault =
      {};  ///< why there are none: "CRYST1 with angles of 90, 90 and 120 degrees"; empty where none is named
};

/// What a file says about its points; whole at the end.
struct CloudFacts {
  PointFile file = {};  ///< without the points
  UnitCell cell = {};
  std::size_t expected = 0;                       ///< points at most, as far as that is known
  bool normals = false;                           ///< the block has them
  std::optional<Channels> colors = std::nullopt;  ///< of the columns of colors; nothing where there are none
  bool last_are_colors = false;         ///< what was taken for normals: the columns of the block are red, green, blue
  bool last_have_no_direction = false;  ///< read again with last_are_normals: a line is to be refused
};

class Cloud {
 public:
  Cloud() = default;
  virtual ~Cloud() = default;
  Cloud(const Cloud&) = delete;
  Cloud& operator=(const Cloud&) = delete;

  /// Replaces `block` by the next points, at least one; false at the end. Throws BadInput naming the line or the point, what
  /// was found and what was expected; Failure; Cancelled.
  virtual bool next(CloudBlock& block) = 0;
  /// Adds what there is to remark on all points, once there are no more. Throws BadInput.
  virtual void finish() {}
  /// Of the file, so far.
  virtual std::uint64_t bytes_read() const { return 0; }

  CloudFacts& facts() { return facts_; }

 protected:
  CloudFacts facts_ = {};
};

/// Before the fields of a block are appended: `columns` of them, empty.
void clear_fields(CloudBlock& block, std::size_t columns);

/// Appends those of one point.
void append_fields(std::span<const double> values, CloudBlock& block);

/// Appends those of a block behind those of other blocks.
void append_fields(const CloudBlock& block, std::vector<std::vector<double>>& fields);

/// Likewise for the indices. Throws BadInput for one beyond 32 bits.
void append_index(const CloudBlock& block, std::vector<std::uint32_t>& index);

/// Without any where each is its place.
std::vector<std::uint32_t> unless_identity(std::vector<std::uint32_t> index);

/// How points of a format are read.
struct CloudFormat {
  Format format;
  /// Throws BadInput, and WrongUsage when two columns turn out to be one.
  std::unique_ptr<Cloud> (*open)(Content content, const CloudRequest& request);
  double (*claim)(std::string_view first, const std::string& name) = nullptr;  ///< Claim::size
  FieldNames (*fields)() = nullptr;  ///< what CloudRequest::where may name; null where points have nothing beside them
  bool streams = false;              ///< reads a file as it goes; else it has to be in memory
};

/// Null where points of the format are no columns, as geometries and pixels are not.
const CloudFormat* cloud_format(Format format);

/// What `--where` may name; nothing where points of the format have no fields beside them.
std::optional<FieldNames> fields_of(Format format);

/// What a packed file of the format says of its size, of points or of a mesh.
Claim claim_of(Format format, bool skip_invalid = false);

/// Throws BadInput unless all coordinates and normals are finite; the block's first point is point `first` of its file.
void require_finite(const CloudBlock& block, std::size_t first, const std::string& name);

/// Throws BadInput: doubles do not have that integer, or not its neighbors.
[[noreturn]] void refuse_integer(const std::string& where, const std::string& integer);

/// The number of the given type at `at`, which place(), a text, names. Throws BadInput for an integer beyond 2^53.
template <typename Place>
double load_exactly(Scalar type, const char* at, std::endian order, const Place& place) {
  return with_type(type, [&](auto value) {
    value = load<decltype(value)>(at, order);
    if (!is_exact_in_double(value)) refuse_integer(place(), std::to_string(value));
    return static_cast<double>(value);
  });
}

/// Replaces `column` by `count` numbers: the first at `at`, each `stride` bytes behind the one before. Throws BadInput
/// for an integer beyond 2^53; the column's first number is of point `first` of its file.
void load_column(std::vector<double>& column, Scalar type, const char* at, std::size_t stride, std::size_t count,
                 std::endian order, std::size_t first, const std::string& name);

/// Keeps those points of a block of which the condition is true, and requires that these are finite. `fields`: a column of each
/// field of the condition.
void select_points(Selection& selection, CloudBlock& block, std::span<const std::vector<double>> fields,
                   std::size_t first, const std::string& name);

}  // namespace rbpa::app
