// What: compresses LAS files as LASzip does, for tests. The encoder follows the descriptions of the format, not the
//       decoder of apps/io/laz, with which it shares no code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace apps_test {

/// An item of a record, by LASzip's numbers.
struct LazItemSpec {
  unsigned type, size, version;
};

struct LazOptions {
  unsigned compressor = 2;          ///< 1: one stream; 2: chunks; 3: layers
  std::vector<LazItemSpec> items;   ///< types 0, 7 (version 1), 8 (version 1), 9, 10, 11, 12 and 14
  std::vector<std::size_t> chunks;  ///< the numbers of points in chunks; if several sizes, they vary
  bool varies = false;              ///< the table has the numbers
  enum class Table { behind, at_end, none } table = Table::behind;
};

/// Returns the LAZ file for the LAS file `las`, whose points end where their number in the header says.
std::string laz_of(const std::string& las, const LazOptions& options);

}  // namespace apps_test
