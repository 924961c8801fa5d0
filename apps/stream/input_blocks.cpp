#include "stream/input_blocks.h"

#include <memory>
#include <utility>

#include "io/cloud/point_blocks.h"

namespace rbpa::app {
namespace {

constexpr std::size_t most_waiting = 4;

}  // namespace

InputBlocks::InputBlocks(std::span<const PointSource> sources, std::size_t first_file, std::uint64_t first)
    : sources_(sources), first_file_(first_file), next_index_(first), thread_([this] { run(); }) {}

InputBlocks::~InputBlocks() {
  const std::lock_guard lock(mutex_);
  unwanted_ = true;
  changed_.notify_all();
}

void InputBlocks::run() {
  std::exception_ptr failure;
  try {
    for (std::size_t file = first_file_; file < sources_.size(); ++file) read(file);
  } catch (...) {
    failure = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  failure_ = failure;
  ended_ = true;
  changed_.notify_all();
}

void InputBlocks::read(std::size_t file) {
  const std::unique_ptr<PointBlocks> blocks = open_point_blocks(sources_[file]);
  const std::uint64_t before = bytes_read_;
  while (true) {
    InputBlock block{.first = next_index_, .file = file};
    const bool more = blocks->next(block.points);
    bytes_read_ = before + blocks->bytes_read();
    next_index_ += block.points.size();
    if (!more) {
      block.ends_file = true;
      block.about = blocks->about();
    }
    if (!put(std::move(block)) || !more) return;
  }
}

bool InputBlocks::put(InputBlock block) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return blocks_.size() < most_waiting || unwanted_; });
  if (unwanted_) return false;
  blocks_.push_back(std::move(block));
  changed_.notify_all();
  return true;
}

bool InputBlocks::next(InputBlock& block) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !blocks_.empty() || ended_; });
  if (!blocks_.empty()) {
    block = std::move(blocks_.front());
    blocks_.pop_front();
    changed_.notify_all();
    return true;
  }
  if (failure_) std::rethrow_exception(failure_);
  return false;
}

}  // namespace rbpa::app
