// What: the interface of point readers, one for each format: a file becomes blocks of columns x, y, or x, y, z, normals
//       and colors. read_points.h, read_space_points.h and point_blocks.h make points of the columns.
// Law:  the blocks of a file, one after another, have its points in the order of the file, whether the file is in
//       memory or streamed. Coordinates are finite, and so are normals if they are needed.
// Cost: one pass over the file; only requested columns are filled in.
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
#include "io/cloud/point_window.h"
#include "io/formats.h"
#include "io/point_columns.h"
#include "io/point_file.h"
#include "io/scalar.h"
#include "io/text/columns.h"
#include "io/text/condition.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// The treatment of water atoms in the file of a molecule.
enum class Waters {
  counted,   ///< read them like all other atoms
  noted,     ///< read them, and warn how many they are
  left_out,  ///< leave them out, unless the condition names a field of residues
};

/// The data that are requested from a file.
struct CloudRequest {
  bool in_space = false;  ///< read x, y, z, normals and colors; otherwise x and y, and whether heights differ
  /// The columns of a table: of x, y; of geometries; of x, y, z; or, in space, of x, y, z and the normal. Absent: the
  /// columns that the header names, or else the first columns.
  std::optional<std::vector<Column>> columns = std::nullopt;
  std::optional<Condition> where = std::nullopt;  ///< selects points by their fields
  bool heights = false;                           ///< read z also in the plane, if the file has z
  bool skip_invalid = false;                      ///< leave out lines, records and elements that are not points
  bool needs_normals = true;                      ///< normals must be finite, and of another length than 0
  bool vertices = false;                          ///< take the vertices of lines and polygons in a column of geometries
  Waters waters = Waters::noted;
  bool last_are_normals = false;  ///< columns 4 to 6 of an unnamed table are normals, whatever their values
  std::optional<FieldChoice> keeps = std::nullopt;  ///< fields that are kept in PointFacts::kept; absent: none
  PointWindow window = {};                          ///< selects points by their places
  bool scan_counts = false;                         ///< count points of LAS by class and by return in PointFacts::scan
  unsigned threads = 0;  ///< the most threads that decompress points; 0: one for each processor
};

/// Consecutive points of a file, by columns. Columns that the file does not have are empty.
struct CloudBlock {
  static constexpr std::size_t x = 0, y = 1, z = 2, normal = 3, color = 6, columns = 9;
  std::size_t count = 0;
  std::array<std::vector<double>, columns> column = {};
  std::vector<double> heights = {};  ///< one for each point, for CloudRequest::heights; NaN if a point has none
  std::vector<std::vector<double>> fields = {};  ///< a column for each of the columns() of CloudRequest::where
  /// The number, from 0, of each point among all points of the file, if some may be left out; otherwise empty. The
  /// number counts records of LAS, vertices, atoms, or lines of a table after its header, also lines that are left out.
  std::vector<std::uint64_t> index = {};
};

/// The usual greatest number of points in a block: few enough that their columns fit in the cache.
constexpr std::size_t points_at_once = 4096;

/// The range of a channel of a color.
enum class Channels {
  bytes,  ///< 0 to 255
  unit,   ///< 0 to 1
  wide    ///< 0 to 65535
};

/// The three edges of a cell, as vectors.
using CellEdges = std::array<Point3, 3>;

/// The box in which the points of a file repeat.
struct UnitCell {
  std::optional<Point3> sides = std::nullopt;  ///< lengths along x, y and z; absent unless all angles are right
  /// Why `sides` is absent: "CRYST1 with angles of 90, 90 and 120 degrees"; empty if the file names no cell, or `sides`
  /// is present.
  std::string fault = {};
  /// The edges a, b and c of a cell of any angles. From lengths and angles, a is along x and b in the plane of x and y.
  std::optional<CellEdges> edges = std::nullopt;
  std::array<bool, 3> repeats = {true, true, true};  ///< whether the cell repeats along a, b and c
  std::string symmetry = {};  ///< the name of the space group, "P 43 21 2"; empty if the file does not name it

  bool is_there() const { return sides || edges || !fault.empty(); }
};

/// Facts that a file states about its points; complete when all points are read.
struct CloudFacts {
  PointFile file = {};  ///< facts of the file; without points
  UnitCell cell = {};
  std::size_t expected = 0;                       ///< the most points that there can be; 0: not known
  bool normals = false;                           ///< blocks have normals
  std::optional<Channels> colors = std::nullopt;  ///< range of the columns of colors; absent without colors
  bool is_in_window = false;                      ///< the reader itself selects points by CloudRequest::window
  bool last_are_colors = false;                   ///< the columns of the normal contain red, green, blue
  bool last_have_no_direction = false;  ///< the file must be read again with last_are_normals, which refuses a line
};

class Cloud {
 public:
  Cloud() = default;
  virtual ~Cloud() = default;
  Cloud(const Cloud&) = delete;
  Cloud& operator=(const Cloud&) = delete;

  /// Replaces the content of `block` by the next points, at least one; returns false at the end. Throws BadInput that
  /// names the line or point, what was found and what was expected; Failure; Cancelled.
  virtual bool next(CloudBlock& block) = 0;
  /// Completes facts(): warnings about all points, and their number. Call once, after next() has returned false. Throws
  /// BadInput.
  virtual void finish() {}
  /// Returns how many bytes of the file were read until now; 0 from readers that do not count them.
  virtual std::uint64_t bytes_read() const { return 0; }

  virtual CloudFacts& facts() { return facts_; }

 protected:
  CloudFacts facts_ = {};
};

/// Replaces the fields of `block` by `columns` empty columns.
void clear_fields(CloudBlock& block, std::size_t columns);

/// Appends `values`, one for each column, to the fields of `block`.
void append_fields(std::span<const double> values, CloudBlock& block);

/// Appends the fields of `block` to `fields`, the columns of earlier blocks.
void append_fields(const CloudBlock& block, std::vector<std::vector<double>>& fields);

/// Appends the indices of `block` to `index`, those of earlier blocks. Throws BadInput for an index that is not below
/// no_index.
void append_index(const CloudBlock& block, std::vector<std::uint32_t>& index);

/// Returns `index`; empty if index[i] = i for all i.
std::vector<std::uint32_t> unless_identity(std::vector<std::uint32_t> index);

/// Functions and properties of a format: open() makes its reader, a Cloud. A row of format_table names a CloudFormat.
struct CloudFormat {
  /// Opens a file. Throws BadInput; WrongUsage if two requested columns are the same.
  std::unique_ptr<Cloud> (*open)(Content content, const CloudRequest& request);
  FieldNames (*fields)() =
      nullptr;                 ///< returns the rule for names in CloudRequest::where; null if points have no fields
  bool streams = false;        ///< reads a file piece by piece; false: the file has to be in memory
  bool skips_invalid = false;  ///< CloudRequest::skip_invalid has an effect
  bool is_molecule = false;    ///< points are atoms, perhaps with a cell
  bool is_text = false;        ///< a file has no zero bytes
  bool has_signature = true;   ///< false: raw numbers, which are decompressed only if the name ends in .gz
};

/// Returns a Reader of the file, for CloudFormat::open; `more` are arguments of its constructor after the content and
/// the request.
template <typename Reader, auto... more>
std::unique_ptr<Cloud> open_as(Content content, const CloudRequest& request) {
  return std::make_unique<Reader>(std::move(content), request, more...);
}

/// Opens a file, and leaves out points that are not in request.window. Throws as CloudFormat::open(). If the window
/// bounds heights, Cloud::next() of the result also throws BadInput for points without heights.
std::unique_ptr<Cloud> open_cloud(const CloudFormat& format, Content content, const CloudRequest& request);

/// Returns the reader of a format; null for formats without points in columns, such as geometries and pixels.
const CloudFormat* cloud_format(Format format);

/// Returns whether the format has a reader (cloud_format()), and the reader has the property.
bool has(Format format, bool CloudFormat::*property);

/// Returns, for messages, the formats of a use for whose readers fit() is true, and `others`: "las, laz, ply or text".
/// All tables are "text".
std::string readable(Use use, const std::function<bool(const CloudFormat&)>& fit, std::vector<std::string> others = {});

/// Returns the formats that `rbpa stream` reads a block at a time: "tables, .npy, .f64xy, LAS and LAZ".
std::string streamed_formats();

/// Returns the formats of a use whose points have fields, in the form of readable().
std::string with_fields(Use use);

/// Returns the rule for names of properties of PLY and of fields of PCD: any word.
FieldNames names_of_properties();

/// Returns the rule for names of fields in `--where`; nothing if points of the format have no fields.
std::optional<FieldNames> fields_of(Format format);

/// Returns how a file of points or of a mesh is decompressed. Raw numbers, which may begin like a gzip file by chance,
/// are decompressed only if `path` ends in .gz. `way_out` becomes Decompression::way_out.
Decompression decompression_of(Format format, std::string_view path, std::string way_out = "");

/// Throws BadInput that names `where`, for an integer beyond 2^53, from which on doubles do not represent all integers.
[[noreturn]] void refuse_integer(const std::string& where, const std::string& integer);

/// Returns the number of the given type at `at`; place() returns the place of the number as text for messages. Throws
/// BadInput for an integer beyond 2^53.
template <typename Place>
double load_exactly(Scalar type, const char* at, std::endian order, const Place& place) {
  return with_type(type, [&](auto value) {
    value = load<decltype(value)>(at, order);
    if (!is_exact_in_double(value)) refuse_integer(place(), std::to_string(value));
    return static_cast<double>(value);
  });
}

/// Replaces the content of `column` by `count` numbers: the first at `at`, each further one `stride` bytes after the
/// previous. Throws BadInput for an integer beyond 2^53, and names its point; the first number belongs to point `first`
/// of the file.
void load_column(std::vector<double>& column, Scalar type, const char* at, std::size_t stride, std::size_t count,
                 std::endian order, std::size_t first, const std::string& name);

/// Removes the points with kept[i] = 0 from the columns and the heights of `block`, and sets block.count.
void keep_points(CloudBlock& block, const std::vector<std::uint8_t>& kept);

/// Throws BadInput that says that the points of the file `name` have no heights, which a window bounds.
[[noreturn]] void refuse_flat_points(const std::string& name);

/// Returns the warning that a window selects some points: "--bounds selects 3 of 8 points".
std::string warning_on_window(const PointWindow& window, std::size_t selected, std::size_t all);

/// The way out of a refusal of points that are not finite.
inline constexpr std::string_view way_without_such_points = " (--skip-invalid leaves out such points)";

/// Chooses points block by block: those for which a condition is true, and, with CloudRequest::skip_invalid, those that
/// are finite, with normals of another length than 0 if normals are needed.
class PointChoice {
 public:
  explicit PointChoice(const CloudRequest& request);

  bool may_leave_out() const { return selection_ || skips_; }
  /// Removes the other points from `block`. `fields` has a column for each field of the condition; the first point of
  /// `block` is number `first` of the file `name`. Returns whether each given point is chosen; nothing if none may be
  /// left out. Throws BadInput if a chosen point, or the normal of one that is needed, is not finite.
  std::vector<std::uint8_t> operator()(CloudBlock& block, std::span<const std::vector<double>> fields,
                                       std::size_t first, const std::string& name);
  /// Adds warnings about the numbers of selected and of skipped points. Throws BadInput that names the file `name` if
  /// points were skipped, and none is left of those that the condition selects.
  void add_warnings(const std::string& name, std::vector<std::string>& warnings) const;

 private:
  /// Returns what is wrong with point i of the block; empty if nothing is. `point` is its number in the file.
  std::string fault_of(const CloudBlock& block, std::size_t i, std::size_t point, const std::string& name) const;

  std::optional<Selection> selection_;
  bool skips_;
  std::size_t checked_;  // number of columns that must be finite
  std::size_t chosen_ = 0, skipped_ = 0;
  std::string first_skipped_ = {};
};

}  // namespace rbpa::app
