// What: the public header block of a LAS file, versions 1.0 to 1.4.
// Law:  LasCount::settle() counts records that lie within the file.
// Source: ASPRS, LAS specification 1.4 R15, and those before it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/claim.h"
#include "io/las/las_count.h"
#include "io/scalar.h"

namespace rbpa::app {

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

/// Throws BadInput when the bytes are no LAS file that can be read, naming what is wrong.
LasHeader read_las_header(std::string_view bytes, const std::string& name);

/// The same of a file of `size` bytes of which `bytes` are the first: its header, or all before its points and two more.
LasHeader read_las_header(std::string_view bytes, std::size_t size, const std::string& name);

/// A Claim: the points, and the records behind them that the header speaks of. Those say how long they are.
double claimed_las_size(std::string_view first, const std::string& name);

/// None where the points that are there are read, whatever the header says.
inline Claim las_claim(bool skip_invalid) {
  return skip_invalid ? Claim() : Claim{claimed_las_size, " (--skip-invalid reads what is there)"};
}

/// Throws BadInput when the scale or the offset of x, y or z (0, 1, 2) gives no coordinates. read_las_header() has looked
/// at x and y; the height matters where it is asked for.
void require_las_axis(const LasHeader& header, std::size_t axis, const std::string& name);

}  // namespace rbpa::app
