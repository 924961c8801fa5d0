#include "stream/polygon_log.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20U;

template <typename T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <typename T>
T take(const char*& at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  at += sizeof value;
  return value;
}

/// Behind its size: what is written of it, then for each ring how many points, and these.
void append(std::string& bytes, const CornerPolygon& polygon) {
  const std::size_t begin = bytes.size();
  append(bytes, std::uint64_t{0});
  append(bytes, polygon.area);
  append(bytes, polygon.perimeter);
  append(bytes, polygon.points);
  append(bytes, std::uint64_t{polygon.holes.size() + 1});
  const auto append_ring = [&](const CornerRing& ring) {
    append(bytes, std::uint64_t{ring.size()});
    for (const Corner& corner : ring) append(bytes, corner.at);
  };
  append_ring(polygon.shell);
  for (const CornerRing& hole : polygon.holes) append_ring(hole);
  const std::uint64_t size = bytes.size() - begin - sizeof(std::uint64_t);
  std::memcpy(bytes.data() + begin, &size, sizeof size);
}

PolygonOutline outline_of(std::string_view record) {
  const char* at = record.data();
  PolygonOutline polygon;
  polygon.area = take<double>(at);
  polygon.perimeter = take<double>(at);
  polygon.points = take<std::uint64_t>(at);
  polygon.rings.resize(take<std::uint64_t>(at));
  for (std::vector<Point>& ring : polygon.rings) {
    ring.resize(take<std::uint64_t>(at));
    std::memcpy(ring.data(), at, ring.size() * sizeof(Point));
    at += ring.size() * sizeof(Point);
  }
  return polygon;
}

/// What decides the order: the first two points of the shell.
struct Key {
  Point first, second;
  friend auto operator<=>(const Key&, const Key&) = default;
};
Key key_of(std::string_view record) {
  const char* at = record.data() + 2 * sizeof(double) + 3 * sizeof(std::uint64_t);
  const Point first = take<Point>(at);
  return {first, take<Point>(at)};
}

/// The records of a file one after the other.
class Records {
 public:
  explicit Records(const std::string& path, std::size_t ahead = buffer_bytes)
      : path_(path), file_(path, ScratchFile::Mode::read), left_(file_.size()), ahead_(ahead) {}

  bool next() {
    if (left_ == 0 && at_ == buffer_.size()) return false;
    std::uint64_t size = 0;
    std::memcpy(&size, some(sizeof size).data(), sizeof size);
    record_ = some(size);
    return true;
  }
  std::string_view record() const { return record_; }
  std::uint32_t checksum() const { return checksum_; }

 private:
  std::string_view some(std::uint64_t size) {
    if (buffer_.size() - at_ < size) {
      buffer_.erase(0, at_);
      at_ = 0;
      const std::size_t before = buffer_.size();
      if (size > before + left_) throw Failure(path_ + ": found a file that was cut off, expected polygons");
      buffer_.resize(before + std::min<std::uint64_t>(left_, std::max<std::uint64_t>(size - before, ahead_)));
      const std::size_t count = file_.read(buffer_.data() + before, buffer_.size() - before);
      if (count < buffer_.size() - before) throw Failure(path_ + ": found a file that was cut off, expected polygons");
      left_ -= count;
    }
    const std::string_view bytes = std::string_view(buffer_).substr(at_, size);
    checksum_ = checksum_of(bytes, checksum_);
    at_ += size;
    return bytes;
  }

  std::string path_;
  ScratchFile file_;
  std::uint64_t left_;  // of the file, not in the buffer
  std::size_t ahead_, at_ = 0;
  std::string buffer_ = {};
  std::string_view record_ = {};
  std::uint32_t checksum_ = 0;
};

/// As many records as fit into memory.
class Run {
 public:
  void add(std::string_view record) {
    items_.push_back({key_of(record), bytes_.size(), record.size()});
    bytes_ += record;
  }
  bool is_empty() const { return items_.empty(); }
  std::uint64_t bytes() const { return bytes_.capacity() + items_.capacity() * sizeof(Item); }
  void sort() {
    std::sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) { return a.key < b.key; });
  }
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const Item& item : items_) visit(std::string_view(bytes_).substr(item.begin, item.size));
  }
  void clear() {
    items_.clear();
    bytes_.clear();
  }

 private:
  struct Item {
    Key key;
    std::uint64_t begin, size;
  };
  std::vector<Item> items_;
  std::string bytes_;
};

void write_run(const Run& run, const std::string& path) {
  ScratchFile file(path, ScratchFile::Mode::write);
  std::string bytes;
  run.for_each([&](std::string_view record) {
    append(bytes, std::uint64_t{record.size()});
    bytes += record;
    if (bytes.size() < buffer_bytes) return;
    file.write(bytes);
    bytes.clear();
  });
  file.write(bytes);
}

template <typename Visit>
void merge_runs(const std::vector<std::string>& paths, std::uint64_t memory, Visit visit) {
  std::vector<std::unique_ptr<Records>> runs;
  using Head = std::pair<Key, std::size_t>;
  std::priority_queue<Head, std::vector<Head>, std::greater<>> heads;
  const std::size_t ahead = std::clamp<std::uint64_t>(memory / paths.size() / 2, 4096, buffer_bytes);
  const auto advance = [&](std::size_t i) {
    if (runs[i]->next()) heads.emplace(key_of(runs[i]->record()), i);
  };
  for (std::size_t i = 0; i < paths.size(); ++i) {
    runs.push_back(std::make_unique<Records>(paths[i], ahead));
    advance(i);
  }
  while (!heads.empty()) {
    const std::size_t i = heads.top().second;
    heads.pop();
    visit(runs[i]->record());
    advance(i);
  }
}

}  // namespace

void PolygonLog::resume(const LogState& state) {
  state_ = state;
  ScratchFile file(scratch_.polygons(), ScratchFile::Mode::append);
  if (file.size() < state.bytes)
    throw Failure(scratch_.polygons() + ": found less than was written; remove " + scratch_.folder() +
                  " and begin anew");
  file.cut(state.bytes);
}

void PolygonLog::add(std::span<const CornerPolygon> polygons) {
  for (const CornerPolygon& polygon : polygons) {
    append(waiting_, polygon);
    if (waiting_.size() >= buffer_bytes) flush();
  }
  state_.polygons += polygons.size();
}

LogState PolygonLog::flush() {
  if (!waiting_.empty()) ScratchFile(scratch_.polygons(), ScratchFile::Mode::append).write(waiting_);
  state_.bytes += waiting_.size();
  state_.checksum = checksum_of(waiting_, state_.checksum);
  waiting_.clear();
  return state_;
}

void PolygonLog::sorted(std::uint64_t memory, const std::function<void(const PolygonOutline&)>& visit) const {
  if (state_.bytes == 0) return;
  Records log(scratch_.polygons());
  Run run;
  std::vector<std::string> runs;
  const auto keep = [&] {
    run.sort();
    runs.push_back(scratch_.sorted_polygons(runs.size()));
    write_run(run, runs.back());
    run.clear();
  };
  while (log.next()) {
    stop_if_interrupted();
    if (!run.is_empty() && run.bytes() + 2 * log.record().size() > memory / 2) keep();
    run.add(log.record());
  }
  if (log.checksum() != state_.checksum)
    throw Failure(scratch_.polygons() + ": found other polygons than were written; remove " + scratch_.folder() +
                  " and begin anew");
  const auto show = [&](std::string_view record) {
    stop_if_interrupted();
    visit(outline_of(record));
  };
  if (runs.empty()) {
    run.sort();
    return run.for_each(show);
  }
  keep();
  run = Run();
  merge_runs(runs, memory, show);
}

}  // namespace rbpa::app
