// LAS files built byte by byte by the specification (ASPRS, LAS 1.4 R15, and those before it).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace apps_test {

/// The fields of a point record.
struct LasPoint {
  std::int32_t x = 0, y = 0, z = 0;
  unsigned intensity = 0;
  unsigned return_number = 1, number_of_returns = 1, scan_direction = 0, edge = 0;
  unsigned classification = 0, synthetic = 0, key_point = 0, withheld = 0, overlap = 0, channel = 0;
  int scan_angle = 0;  ///< degrees in formats 0 to 5; units of 0.006 degrees from 6 on
  unsigned user_data = 0, source = 0;
  double time = 0;
  unsigned red = 0, green = 0, blue = 0, infrared = 0;
};

/// A variable length record.
struct LasRecord {
  std::string user;
  unsigned number;
  std::string data;
};

struct LasFile {
  unsigned minor = 2, format = 0;
  double scale[3] = {0.01, 0.01, 0.01}, offset[3] = {0, 0, 0};
  std::vector<LasRecord> records = {}, extended = {};  ///< before and after the points
  std::vector<LasPoint> points = {};
  unsigned extra_bytes = 0;       ///< after the fields of each record
  bool signature_counts = false;  ///< of version 1.0: the offset to point data is that of the signature
};

std::string bytes_of(const LasFile& file);

/// Returns a number as so many bytes, little-endian.
std::string little(std::uint64_t value, unsigned bytes);
std::string little(double value);

}  // namespace apps_test
