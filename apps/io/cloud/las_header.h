// What: the public header block of a LAS file, versions 1.0 to 1.4: how many points there are, where, and in which system.
// Law:  the number of records is only to be had from LasCount::settle(), which refuses or remarks where the header and the
//       file differ; records it counts lie within the file.
// Source: ASPRS, LAS specification 1.4 R15, and those before it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/claim.h"
#include "io/bytes/scalar.h"
#include "io/crs.h"

namespace rbpa::app {

class LasCount {
 public:
  LasCount() = default;
  /// `claimed` by the header; `room` for so many whole records of `length` bytes there is.
  LasCount(std::size_t claimed, std::size_t room, std::size_t length)
      : claimed_(claimed), room_(room), length_(length) {}

  /// How many there are to read. Throws BadInput when the header counts more points than the file has whole records, or
  /// fewer. With `skip_invalid` it is the smaller of the two, but all records where the header counts none, as an
  /// interrupted writer leaves it; `remarks` lists what was left out or counted.
  std::size_t settle(bool skip_invalid, const std::string& name, std::vector<std::string>& remarks) const;

  /// Of a file whose end is not known yet: how many to look for, and for how many the header leaves room.
  std::size_t sought(bool skip_invalid) const { return takes_all(skip_invalid) ? room_ : claimed_; }
  std::size_t room() const { return room_; }
  /// The same file when its end was found behind so many whole records.
  LasCount with_room(std::size_t room) const { return {claimed_, room, length_}; }

 private:
  bool takes_all(bool skip_invalid) const { return claimed_ == 0 && skip_invalid; }

  std::size_t claimed_ = 0, room_ = 0, length_ = 0;
};

/// A value of a LAS file, which is little-endian.
template <typename T>
T las_value(const char* at) {
  return load<T>(at, std::endian::little);
}

struct LasHeader {
  unsigned minor;   ///< of version 1.minor
  unsigned format;  ///< of point records, 0 to 10
  std::size_t size;
  std::size_t records;                           ///< variable length records, which begin behind the header
  LasCount count;                                ///< of points, as it says and up to what follows them
  std::size_t length;                            ///< of a point record, with whatever follows the fields of its format
  std::size_t begin;                             ///< of the first
  std::size_t extended_begin, extended_records;  ///< variable length records behind the points, from 1.4 on
  std::size_t waveforms;                         ///< where such a record with waveforms begins, from 1.3 on; 0: nowhere
  std::array<double, 3> scale, offset;
};

/// Of a file of `size` bytes of which `bytes` are the first: its header, or all before its points and two more. Throws BadInput
/// when they are no LAS file that can be read, naming what is wrong.
LasHeader read_las_header(std::string_view bytes, std::size_t size, const std::string& name);

/// A Claim: the points, and the records behind them that the header speaks of. Those say how long they are.
double claimed_las_size(std::string_view first, const std::string& name);

/// Throws BadInput when the scale or the offset of x, y or z (0, 1, 2) gives no coordinates. read_las_header() has looked
/// at x and y; the height matters where it is requested.
void require_las_axis(const LasHeader& header, std::size_t axis, const std::string& name);

struct LasCrs {
  std::optional<Crs> crs = std::nullopt;  ///< by its EPSG code
  std::string remark = {};                ///< why there is none although the file has one
};

/// That of well-known text, else of GeoTIFF keys. `before`: the file up to its points at least; `behind`: from its extended
/// records on. Records that claim more than there is end the search: they are about the points, and none of them.
LasCrs las_crs(std::string_view before, std::string_view behind, const LasHeader& header);

}  // namespace rbpa::app
