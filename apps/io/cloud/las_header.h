// What: reads the public header block of a LAS file, versions 1.0 to 1.4: the number and the place of the point
//       records, and the coordinate reference system.
// Law:  the number of point records comes only from LasCount::settle(), which throws BadInput, or warns, if the number
//       differs between the header and the file. All records that settle() counts lie within the file.
// Source: ASPRS, LAS specification 1.4 R15, and the specifications of earlier versions.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/crs.h"
#include "io/scalar.h"

namespace rbpa::app {

class LasCount {
 public:
  LasCount() = default;
  /// `claimed` is the number of points in the header; `room` is the number of whole records of `length` bytes for which
  /// the file has room.
  LasCount(std::size_t claimed, std::size_t room, std::size_t length)
      : claimed_(claimed), room_(room), length_(length) {}

  /// Returns the number of points to read. Throws BadInput that names `name` if the header counts more or fewer points
  /// than the file has whole records. With `skip_invalid` does not throw, but adds a warning, and returns the smaller
  /// number, or the number of records if the header counts 0, as an interrupted writer leaves it.
  std::size_t settle(bool skip_invalid, const std::string& name, std::vector<std::string>& warnings) const;

  /// Return, for a file whose end is not known yet, the number of points to look for, and the number for which there is
  /// room.
  std::size_t sought(bool skip_invalid) const { return takes_all(skip_invalid) ? room_ : claimed_; }
  std::size_t room() const { return room_; }
  /// Returns the count for the same file when its end is found, after `room` whole records.
  LasCount with_room(std::size_t room) const { return {claimed_, room, length_}; }

 private:
  bool takes_all(bool skip_invalid) const { return claimed_ == 0 && skip_invalid; }

  std::size_t claimed_ = 0, room_ = 0, length_ = 0;
};

struct LasHeader {
  unsigned minor;      ///< the version of the file is 1.minor
  unsigned format;     ///< format of point records, 0 to 10
  bool is_compressed;  ///< the points are those of LAZ
  std::size_t size;
  std::size_t records;  ///< number of variable length records, which begin after the header
  LasCount count;  ///< number of points: in the header, and in the room before the next part of the file; for LAZ both
                   ///< are the number in the header
  std::size_t length;  ///< size of a point record in bytes, with extra bytes
  std::size_t begin;   ///< offset of the first point record
  std::size_t extended_begin,
      extended_records;   ///< offset and number of the records after the points, from version 1.4 on
  std::size_t waveforms;  ///< offset of the record with waveforms, from version 1.3 on; 0: none
  std::array<double, 3> scale, offset;
};

/// Reads the header of a file of `size` bytes. Requires: `bytes` are the first of the file, and hold its header; the
/// signature of version 1.0 is recognized only if `bytes` also hold two bytes from the beginning of the points on.
/// Throws BadInput that names the fault if the file cannot be read.
LasHeader read_las_header(std::string_view bytes, std::size_t size, const std::string& name);

/// Throws BadInput if the scale or the offset of x, y or z (axis 0, 1, 2) gives no coordinates. read_las_header()
/// checks x and y; the caller checks z if it is requested.
void require_las_axis(const LasHeader& header, std::size_t axis, const std::string& name);

/// Returns the data of the first record with the number `number` of `user`, such as "copc"; empty if there is none.
/// `before` is the file up to its points at least.
std::string_view las_record(std::string_view before, const LasHeader& header, std::string_view user, unsigned number);
/// Returns the record by which LASzip says how points are compressed.
inline std::string_view laszip_record(std::string_view before, const LasHeader& header) {
  return las_record(before, header, "laszip encoded", 22204);
}

struct LasCrs {
  std::optional<Crs> crs = std::nullopt;  ///< the system; absent if it is not understood
  std::string warning = {};               ///< why the system of the file is not understood; else empty
};

/// Returns the system that well-known text, or else GeoTIFF keys, name. `before` is the file up to its points at least;
/// `behind` is the file from its extended records on. A record that claims more bytes than there are ends the search
/// without an error.
LasCrs las_crs(std::string_view before, std::string_view behind, const LasHeader& header);

}  // namespace rbpa::app
