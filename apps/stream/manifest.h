// What: how far a run has come, in a file of its scratch, so that another can go on with it.
// Law:  the file is written as a whole or not at all, and its entries about other files are correct.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
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

/// A file of the input as it was when the run began.
struct InputFile {
  std::string path;
  std::uint64_t size = 0;
  std::int64_t changed = 0;  ///< nanoseconds
  friend bool operator==(const InputFile&, const InputFile&) = default;
};

/// What must be the same when a run goes on.
struct RunKey {
  std::vector<InputFile> inputs = {};
  std::string options = {};  ///< how they are read
  double alpha = 0;
  std::uint64_t memory = 0, tile_size = 0;
  bool keep_tiles = false, tasks = false;
  std::vector<std::string> targets = {};

  /// Of all inputs.
  std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const InputFile& file : inputs) sum += file.size;
    return sum;
  }
};

/// The run_key of a request, by the files that are there. Throws BadInput when one is not.
RunKey run_key_of(const StreamRequest& request);

/// What is known of all points.
struct PointsFacts {
  Point least = {}, greatest = {};
  std::optional<Crs> crs = std::nullopt;
  bool degrees = false;
};

/// Adds them to an object of JSON, and reads them there; the second throws what the library of JSON throws.
void add_facts(nlohmann::ordered_json& json, const PointsFacts& facts);
void read_facts(const nlohmann::ordered_json& json, PointsFacts& facts);

struct Manifest {
  enum class Pass { count, cut, compute };

  RunKey run_key = {};
  unsigned workers = 1;
  Pass pass = Pass::count;

  // Filled in from `cut` on.
  std::uint64_t points = 0;
  PointsFacts facts = {};
  TileTree tree = {};

  // While tiles are cut: files that are done, and the index behind their points. Then `tiles` are the files so far.
  std::size_t files_done = 0;
  std::uint64_t next_index = 0;
  std::vector<TileSummary> tiles = {};  ///< by their numbers
};

/// A number that runs share only when they have the same request and input files and the same tiles.
std::uint64_t id_of(const Manifest& manifest);

void save(const Manifest& manifest, const Scratch& scratch);

/// The manifest of a run with the same request. Throws WrongUsage that names the difference, BadInput when it is no
/// manifest.
Manifest load_manifest(const Scratch& scratch, const RunKey& run_key);

}  // namespace rbpa::app
