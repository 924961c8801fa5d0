// What: the folder in which a run keeps what does not fit into memory.
// Law:  one run at a time; what is in it that is not of a run is never touched.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "stream/request.h"

namespace rbpa::app {

class Scratch {
 public:
  /// The requested folder, or a new one beside the first target; then folders of killed runs there are removed first.
  /// Throws WrongUsage when the folder has something else in it, or a run to be resumed where that was not requested;
  /// Failure when it cannot be made or another run is in it.
  explicit Scratch(const StreamRequest& request);
  /// Removes what cannot be resumed: everything, in a folder that was not requested.
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string manifest() const { return folder_ + "/manifest.json"; }
  std::string progress() const { return folder_ + "/progress.json"; }
  std::string tile(std::uint32_t number) const;
  std::string rows(std::size_t bucket) const;
  std::string partials(std::uint64_t generation) const;
  std::string polygons() const { return folder_ + "/polygons"; }
  std::string holes() const { return folder_ + "/holes"; }
  std::string sorted_run(std::size_t number) const;
  const std::string& folder() const { return folder_; }
  /// Whether the files of an earlier run are there.
  bool has_run() const { return has_run_; }

  /// The run is done: all goes, or all but the tiles.
  void clear(bool keep_tiles);
  /// The files of a pass go.
  void clear_rows() const;

 private:
  bool make(const StreamRequest& request);  // false: another took it away
  void clear_leftovers() const;
  bool make_marked() const;
  void remove_own() noexcept;

  std::string folder_;
  bool is_asked_for_, is_new_ = false, has_run_ = false;
  int lock_ = -1;
  std::unique_ptr<char[]> reserve_;  // to remove the folder where memory has run out
};

}  // namespace rbpa::app
