#include "stream/record_log.h"

#include <utility>

#include "io/failure.h"

namespace rbpa::app {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20U;

}  // namespace

void RecordLog::resume(const RecordState& state) {
  state_ = state;
  ScratchFile file(path_, ScratchFile::Mode::append);
  if (file.size() < state.bytes)
    begin_anew(path_, std::to_string(file.size()) + " bytes, expected at least " + std::to_string(state.bytes),
               path_.substr(0, path_.rfind('/')));
  file.cut(state.bytes);
}

void RecordLog::append(std::string_view bytes) {
  waiting_ += bytes;
  if (waiting_.size() >= buffer_bytes) flush();
}

RecordState RecordLog::flush() {
  if (!waiting_.empty()) ScratchFile(path_, ScratchFile::Mode::append).write(waiting_);
  state_.bytes += waiting_.size();
  state_.checksum = checksum_of(waiting_, state_.checksum);
  waiting_.clear();
  return state_;
}

std::string_view RecordReader::take(std::uint64_t size) {
  if (buffer_.size() - used_ < size) {
    buffer_.erase(0, used_);
    used_ = 0;
    const std::size_t before = buffer_.size();
    const auto require = [&](bool is_so) {
      if (!is_so) begin_anew(path_, "a file that ends too early", path_.substr(0, path_.rfind('/')));
    };
    require(size - before <= end_ - at_);
    buffer_.resize(before + std::min<std::uint64_t>(end_ - at_, std::max<std::uint64_t>(size - before, ahead_)));
    require(file_.read_at(at_, buffer_.data() + before, buffer_.size() - before) == buffer_.size() - before);
    at_ += buffer_.size() - before;
  }
  const std::string_view bytes = std::string_view(buffer_).substr(used_, size);
  used_ += size;
  checksum_ = checksum_of(bytes, checksum_);
  return bytes;
}

}  // namespace rbpa::app
