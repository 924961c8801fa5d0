// What: the interface of point readers, one for each format: a file becomes blocks of columns x, y, or x, y, z, normals
//       and colors. read_points.h, read_space_points.h and point_blocks.h make points of the columns.
// Law:  the blocks of a file in their order are its points in its order, whether the file is in memory or streamed.
//       Coordinates and normals are finite.
// Cost: one pass over the file; only requested columns are filled.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/content.h"
#include "io/bytes/input_bytes.h"
#include "io/bytes/scalar.h"
#include "io/formats.h"
#include "io/point_file.h"
#include "io/text/columns.h"
#include "io/text/condition.h"

namespace rbpa::app {

/// The treatment of water atoms in the file of a molecule.
enum class Waters {
  counted,   ///< read them like all other atoms
  noted,     ///< read them, and warn how many they are
  left_out,  ///< leave them out, unless the condition names residues
};

/// The data that are requested from a file.
struct CloudRequest {
  bool in_space = false;  ///< read x, y, z, normals and colors; otherwise x and y, and whether heights differ
  /// The columns of a table: of x, y; of geometries; of x, y, z; or of x, y, z and the normal. Absent: those that the
  /// header names, or the first ones.
  std::optional<std::vector<Column>> columns = std::nullopt;
  std::optional<Condition> where = std::nullopt;  ///< selects points by their fields
  bool heights = false;                           ///< in the plane: also read z, if there is one
  bool skip_invalid = false;                      ///< leave out lines of text, and records of LAS, that are not points
  bool vertices = false;                          ///< take the vertices of lines and polygons in a column of geometries
  Waters waters = Waters::noted;
  bool last_are_normals = false;  ///< columns 4 to 6 of an unnamed table are normals, whatever their values
};

/// Consecutive points of a file, by columns. Columns that the file does not have are empty.
struct CloudBlock {
  static constexpr std::size_t x = 0, y = 1, z = 2, normal = 3, color = 6, columns = 9;
  std::size_t count = 0;
  std::array<std::vector<double>, columns> column = {};
  std::vector<double> heights = {};              ///< one per point for CloudRequest::heights; NaN for a point without
  std::vector<std::vector<double>> fields = {};  ///< the values of the columns() of CloudRequest::where
  /// The number of each point among all of the file, if some may be left out: among records of LAS, vertices, atoms, or
  /// lines of a table after its header, where a line that is left out counts as a point. Otherwise empty.
  std::vector<std::uint64_t> index = {};
};

/// The number of points in a block: few enough that their columns stay in the cache.
constexpr std::size_t points_at_once = 4096;

/// The range of a channel of a color.
enum class Channels {
  bytes,  ///< 0 to 255
  unit,   ///< 0 to 1
  wide    ///< 0 to 65535
};

/// The box in which the points of a file repeat.
struct UnitCell {
  std::optional<std::array<double, 3>> sides = std::nullopt;  ///< lengths along x, y and z, if all angles are right
  /// Why there are no sides: "CRYST1 with angles of 90, 90 and 120 degrees"; empty if the file names no cell.
  std::string fault = {};
};

/// Facts that a file states about its points; complete when all points are read.
struct CloudFacts {
  PointFile file = {};  ///< without the points
  UnitCell cell = {};
  std::size_t expected = 0;                       ///< greatest number of points, if known
  bool normals = false;                           ///< whether blocks have normals
  std::optional<Channels> colors = std::nullopt;  ///< range of the columns of colors; absent without colors
  bool last_are_colors = false;                   ///< the columns that were taken for normals are red, green, blue
  bool last_have_no_direction = false;  ///< the file must be read again with last_are_normals, which refuses a line
};

class Cloud {
 public:
  Cloud() = default;
  virtual ~Cloud() = default;
  Cloud(const Cloud&) = delete;
  Cloud& operator=(const Cloud&) = delete;

  /// Replaces `block` by the next points, at least one; returns false at the end. Throws BadInput with the line or
  /// point, what was found and what was expected; Failure; Cancelled.
  virtual bool next(CloudBlock& block) = 0;
  /// Adds warnings about all points. Call after the last block. Throws BadInput.
  virtual void finish() {}
  /// Returns how many bytes of the file have been read so far.
  virtual std::uint64_t bytes_read() const { return 0; }

  CloudFacts& facts() { return facts_; }

 protected:
  CloudFacts facts_ = {};
};

/// Makes `columns` empty fields in the block.
void clear_fields(CloudBlock& block, std::size_t columns);

/// Appends the fields of one point to a block.
void append_fields(std::span<const double> values, CloudBlock& block);

/// Appends the fields of a block to those of earlier blocks.
void append_fields(const CloudBlock& block, std::vector<std::vector<double>>& fields);

/// Appends the indices of a block to those of earlier blocks. Throws BadInput for an index from no_index on.
void append_index(const CloudBlock& block, std::vector<std::uint32_t>& index);

/// Returns `index`, or nothing if index[i] = i for all i.
std::vector<std::uint32_t> unless_identity(std::vector<std::uint32_t> index);

/// The reader of a format, which a row of format_table names.
struct CloudFormat {
  /// Opens a file. Throws BadInput, and WrongUsage if two requested columns are one.
  std::unique_ptr<Cloud> (*open)(Content content, const CloudRequest& request);
  FieldNames (*fields)() = nullptr;  ///< fields that CloudRequest::where may name; null if points have no fields
  bool streams = false;              ///< reads a file piece by piece; otherwise it has to be in memory
  bool skips_invalid = false;        ///< CloudRequest::skip_invalid has a meaning
  bool is_molecule = false;          ///< points are atoms, perhaps with a cell
  bool is_text = false;              ///< has no zero bytes
  bool has_signature = true;         ///< false: raw numbers, which are decompressed only if the name ends in .gz
};

/// Opens a file by the class that reads it, for CloudFormat::open; `more` follow the content and the request.
template <typename Reader, auto... more>
std::unique_ptr<Cloud> open_as(Content content, const CloudRequest& request) {
  return std::make_unique<Reader>(std::move(content), request, more...);
}

/// Returns the reader of a format; null for geometries and pixels, which are not columns.
const CloudFormat* cloud_format(Format format);

/// Returns whether the format has points, and its reader has the property.
bool has(Format format, bool CloudFormat::*property);

/// Returns the formats of a use whose readers are `fit`, and `others`, for messages: "las, ply or text". All tables
/// are "text".
std::string readable(Use use, const std::function<bool(const CloudFormat&)>& fit, std::vector<std::string> others = {});

/// Returns the formats that `rbpa stream` reads a block at a time: "tables, .npy, .f64xy and LAS".
std::string streamed_formats();

/// Returns the formats of a use whose points have fields, and `others`, as readable().
std::string with_fields(Use use, std::vector<std::string> others = {});

/// Returns the rule for number properties of PLY and fields of PCD: any name.
FieldNames names_of_properties();

/// Returns the fields that `--where` may name; nothing if points of the format have no fields.
std::optional<FieldNames> fields_of(Format format);

/// Returns how a file of points or of a mesh is decompressed: raw numbers, which may begin like a gzip file by chance,
/// only if the name says so.
Decompression decompression_of(Format format, std::string_view path, std::string way_out = "");

/// Throws BadInput unless all coordinates and normals are finite; the block's first point is point `first` of its file.
void require_finite(const CloudBlock& block, std::size_t first, const std::string& name);

/// Throws BadInput: the integer is beyond 2^53, so that doubles do not represent it or its neighbors.
[[noreturn]] void refuse_integer(const std::string& where, const std::string& integer);

/// Returns the number of the given type at `at`; place() returns its place as text for messages. Throws BadInput for an
/// integer beyond 2^53.
template <typename Place>
double load_exactly(Scalar type, const char* at, std::endian order, const Place& place) {
  return with_type(type, [&](auto value) {
    value = load<decltype(value)>(at, order);
    if (!is_exact_in_double(value)) refuse_integer(place(), std::to_string(value));
    return static_cast<double>(value);
  });
}

/// Replaces `column` by `count` numbers: the first at `at`, each `stride` bytes after the one before. Throws BadInput
/// for an integer beyond 2^53, naming its point: the first number is that of point `first` of the file.
void load_column(std::vector<double>& column, Scalar type, const char* at, std::size_t stride, std::size_t count,
                 std::endian order, std::size_t first, const std::string& name);

/// Keeps the points of a block for which the condition is true. `fields` has a column for each field of the condition;
/// the block's first point is point `first` of its file. Throws BadInput if a kept point is not finite.
void select_points(Selection& selection, CloudBlock& block, std::span<const std::vector<double>> fields,
                   std::size_t first, const std::string& name);

}  // namespace rbpa::app
