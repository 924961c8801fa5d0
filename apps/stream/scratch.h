// What: manages the folder in which a run stores the data that do not fit into memory.
// Law:  only one run uses the folder at a time. Files in the folder that do not belong to a run are never changed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "stream/request.h"

namespace rbpa::app {

class Scratch {
 public:
  /// Opens or makes the folder of --scratch. Without --scratch, removes folders of killed runs beside the first target,
  /// and makes a new folder there. Throws WrongUsage if the folder contains other files, or a run that request.resume
  /// does not allow to continue; Failure if the folder cannot be made or another run uses it.
  explicit Scratch(const StreamRequest& request);
  /// Removes the folder unless --scratch names it: a run in a named folder can be resumed.
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
  /// Return the file with the points of all groups; the file of the points of one group, and the folder of its run.
  std::string groups() const { return folder_ + "/groups"; }
  std::string group_points() const { return folder_ + "/group.f64xy"; }
  std::string group_folder() const { return folder_ + "/group"; }
  const std::string& folder() const { return folder_; }
  /// Returns whether the folder contained the manifest of an earlier run when it was opened.
  bool has_run() const { return has_run_; }

  /// Removes the files of a finished run; `keep_tiles` keeps tiles and manifest. Ignores errors.
  void clear(bool keep_tiles);
  /// Removes the files of the computing pass, except progress.json. Ignores errors.
  void clear_rows() const;

 private:
  bool make(const StreamRequest& request);  // returns false if another run removes or locks the folder
  void clear_leftovers() const;
  bool make_marked() const;
  void remove_own() noexcept;

  std::string folder_;
  bool is_asked_for_, is_new_ = false, has_run_ = false;
  int lock_ = -1;
  std::unique_ptr<char[]> reserve_;  // freed first when the folder is removed, in case memory has run out
};

}  // namespace rbpa::app
