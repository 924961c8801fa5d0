// What: stores the points of many groups in one file of scratch, and reads those of one group.
// Law:  the points of a group are read in the order in which they were added.
// Cost: each point is written and read once, 16 bytes; memory of the points that wait, and of 16 bytes for each
//       segment: the points of a group among those that waited together.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "rbpa/base/point.h"
#include "stream/record_log.h"

namespace rbpa::app {

class GroupPoints {
 public:
  /// Writes to the file at `path` whenever `most_waiting` points wait.
  GroupPoints(std::string path, std::uint64_t most_waiting) : log_(std::move(path)), most_waiting_(most_waiting) {}

  /// Adds a group without points, and returns its number, from 0.
  std::uint32_t add_group() {
    groups_.emplace_back();
    return static_cast<std::uint32_t>(groups_.size() - 1);
  }
  void add(std::uint32_t group, const Point& p) {
    waiting_.emplace_back(group, p);
    ++groups_[group].points;
    if (waiting_.size() >= most_waiting_) flush();
  }
  /// Writes the waiting points. Throws Failure, Cancelled.
  void flush();

  std::uint64_t size(std::uint32_t group) const { return groups_[group].points; }
  /// Calls visit(points) with the points of a group, some at a time. Requires: flush() after the last add().
  void read(std::uint32_t group, const std::function<void(std::span<const Point>)>& visit) const;

 private:
  struct Segment {
    std::uint64_t begin, points;  // byte in the file; number of points
  };
  struct Stored {
    std::uint64_t points = 0;
    std::vector<Segment> segments = {};
  };

  RecordLog log_;
  std::uint64_t most_waiting_;
  std::vector<std::pair<std::uint32_t, Point>> waiting_ = {};
  std::vector<Stored> groups_ = {};
};

}  // namespace rbpa::app
