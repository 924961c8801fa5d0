// What: saves the progress of a run in a file of its scratch folder, so that another run can resume it.
// Law:  the file is written completely or not at all, and after the files whose state it records.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/crs.h"
#include "rbpa/base/point.h"
#include "stream/request.h"
#include "stream/scratch.h"
#include "stream/tile_file.h"
#include "stream/tile_tree.h"

namespace rbpa::app {

/// An input file, with its size and its time of change when the run began.
struct InputFile {
  std::string path;
  std::uint64_t size = 0;
  std::int64_t changed = 0;  ///< time of the last change, in nanoseconds since 1970
  friend bool operator==(const InputFile&, const InputFile&) = default;
};

/// The request of a run. A run can be resumed only with an equal request.
struct RunKey {
  std::vector<InputFile> inputs = {};
  std::string options = {};  ///< the options that tell how the inputs are read, as text
  double alpha = 0;
  std::uint64_t memory = 0, tile_size = 0;
  bool keep_tiles = false;
  std::vector<std::string> targets = {};

  /// Returns the sum of the sizes of all inputs, in bytes.
  std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const InputFile& file : inputs) sum += file.size;
    return sum;
  }
};

/// Returns the key of a request, with the sizes and times of change of its files. Throws BadInput if a file is missing,
/// or is a pipe, a socket or a device.
RunKey run_key_of(const StreamRequest& request);

/// The extent and coordinate system of all points.
struct PointsFacts {
  Point least = {}, greatest = {};
  std::optional<Crs> crs = std::nullopt;
  bool degrees = false;
};

struct Manifest {
  enum class Pass { count, cut, compute };

  RunKey run_key = {};
  unsigned workers = 1;
  Pass pass = Pass::count;

  // The members below are set from Pass::cut on.
  std::uint64_t points = 0;
  PointsFacts facts = {};
  TileTree tree = {};

  // While tiles are cut, files_done is the number of input files that are done, next_index the number of points in
  // them, and `tiles` has the summaries of the tile files after exactly these points.
  std::size_t files_done = 0;
  std::uint64_t next_index = 0;
  std::vector<TileSummary> tiles = {};  ///< indexed by the number of the tile
};

/// Replaces the manifest in `scratch`, atomically. Throws as ScratchFile does.
void save(const Manifest& manifest, const Scratch& scratch);

/// Loads the manifest of a run. Throws WrongUsage that names one difference if the request of that run is not
/// `run_key`; BadInput if the file is damaged or not a manifest; Failure.
Manifest load_manifest(const Scratch& scratch, const RunKey& run_key);

}  // namespace rbpa::app
