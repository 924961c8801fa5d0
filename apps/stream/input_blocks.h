// What: the points of all files of the input, one file behind the other, read ahead of their consumer.
// Law:  the index of a point is its place in the whole input.
// Cost: a few blocks are in memory at a time.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/point_file.h"

namespace rbpa::app {

struct InputBlock {
  std::vector<Point> points = {};
  std::uint64_t first = 0;  ///< index of the first point
  std::size_t file = 0;     ///< of which they are
  bool ends_file = false;   ///< there are no points, and `about` is the file's own information
  PointFile about = {};
};

class InputBlocks {
 public:
  /// From the file `first_file` on, whose first point has the index `first`. The sources must outlive this.
  InputBlocks(std::span<const PointSource> sources, std::size_t first_file, std::uint64_t first);
  ~InputBlocks();
  InputBlocks(const InputBlocks&) = delete;
  InputBlocks& operator=(const InputBlocks&) = delete;

  /// False at the end. Throws as read_points().
  bool next(InputBlock& block);
  /// Of all files together.
  std::uint64_t bytes_read() const { return bytes_read_; }

 private:
  void run();
  void read(std::size_t file);
  bool put(InputBlock block);

  std::span<const PointSource> sources_;
  std::size_t first_file_;
  std::uint64_t next_index_;
  std::atomic<std::uint64_t> bytes_read_ = 0;

  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<InputBlock> blocks_ = {};
  bool ended_ = false, unwanted_ = false;
  std::exception_ptr failure_ = nullptr;
  std::jthread thread_;
};

}  // namespace rbpa::app
