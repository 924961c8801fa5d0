// What: the folder in which a run keeps the data that do not fit into memory.
// Law:  only one run uses the folder at a time; files in it that do not belong to a run are never changed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "stream/request.h"

namespace rbpa::app {

class Scratch {
 public:
  /// Opens or makes the requested folder; without a request makes one in the folder of the first target, after removing
  /// folders of killed runs there. Throws WrongUsage if the folder contains other files, or a run and not
  /// request.resume; Failure if it cannot be made or another run uses it.
  explicit Scratch(const StreamRequest& request);
  /// Removes the folder unless it was requested; in a requested folder the run can be resumed.
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
  /// Returns whether the folder had a manifest of an earlier run when it was opened.
  bool has_run() const { return has_run_; }

  /// Removes all files of a finished run, or, with `keep_tiles`, all except the tiles and the manifest. Ignores errors.
  void clear(bool keep_tiles);
  /// Removes the files of the computing pass, except the progress. Ignores errors.
  void clear_rows() const;

 private:
  bool make(const StreamRequest& request);  // returns false if another run removes or locks the folder
  void clear_leftovers() const;
  bool make_marked() const;
  void remove_own() noexcept;

  std::string folder_;
  bool is_asked_for_, is_new_ = false, has_run_ = false;
  int lock_ = -1;
  std::unique_ptr<char[]> reserve_;  // freed, so that the folder can be removed when memory has run out
};

}  // namespace rbpa::app
