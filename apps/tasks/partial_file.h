// What: the file of a partial: what some tiles of a run contribute together, and where their polygons and triangles are.
// Law:  what is read is what was written, or BadInput.
// Cost: that of what is open between the tiles, and some words a tile. The format is in docs/tasks.md.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/partial.h"
#include "tasks/run_facts.h"

namespace rbpa::app {

/// What does not go through merges: finished polygons and holes as the log has them (stream/polygon_log.h), and triangles
/// as .npy.
struct SideFile {
  enum class Kind { polygons, holes, triangles };
  Kind kind = Kind::polygons;
  std::string path = {};
  std::uint64_t items = 0;  ///< triangles; else 0
  std::uint64_t bytes = 0;
  std::uint32_t checksum = 0;  ///< CRC-32
};

/// Numbers, as ascending ranges [first, last] that do not touch.
class TileSet {
 public:
  using Range = std::pair<std::uint32_t, std::uint32_t>;
  TileSet() = default;
  explicit TileSet(std::uint32_t tile) : ranges_{{tile, tile}} {}
  /// Of ranges in any order that have no tile in common.
  explicit TileSet(std::vector<Range> ranges);

  const std::vector<Range>& ranges() const { return ranges_; }
  std::uint64_t size() const;
  bool contains(std::uint32_t tile) const;
  /// Below `count`; requires that there is one.
  std::uint32_t first_missing() const;

 private:
  std::vector<Range> ranges_;
};

/// A tile that is in both, or none.
std::optional<std::uint32_t> common(const TileSet& a, const TileSet& b);
TileSet operator+(const TileSet& a, const TileSet& b);

struct PartialFile {
  RunFacts run = {};
  TileSet tiles = {};
  std::vector<SideFile> files = {};
  Partial partial = {};
};

/// "half.polygons" and "half.holes" beside the partial "half.partial".
std::vector<std::string> side_paths(const std::string& path);

/// Adds the partial, and its finished polygons, which are removed from it, in files beside it.
void add_partial(OutputSet& outputs, const std::string& path, PartialFile partial);

/// Throws BadInput.
PartialFile read_partial(const std::string& path);

/// Calls take(bytes) with all of the file, some at a time. Throws BadInput when it was changed since it was written; Cancelled.
void for_each_piece(const SideFile& file, const std::function<void(std::string_view bytes)>& take);

/// A file that is written, and its facts in the end. There is no file where nothing is written.
class SideOutput {
 public:
  SideOutput(OutputSet& outputs, SideFile::Kind kind, const std::string& path);
  void write(std::string_view bytes);
  SideFile finish(std::uint64_t items);

 private:
  OutputSet& outputs_;
  OutputFile* file_ = nullptr;
  SideFile about_;
};

}  // namespace rbpa::app
