#include "stream/polygon_log.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "stream/polygon_record.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20U;
/// A longer record stays in the log and is read when it is its turn.
constexpr std::uint64_t most_carried = std::uint64_t{1} << 16U;

/// What decides the order: the first two points of the shell.
struct Key {
  Point first, second;
  friend auto operator<=>(const Key&, const Key&) = default;
};
/// The shell follows the head.
constexpr std::size_t key_begin = sizeof(RecordHead) + sizeof(std::uint64_t);

/// The bytes of a file from somewhere on, with some of them ahead.
class Cursor {
 public:
  Cursor(const ScratchFile& file, const std::string& path, std::uint64_t at, std::size_t ahead = buffer_bytes)
      : file_(file), path_(path), at_(at), end_(file.size()), ahead_(ahead) {}

  bool at_end() const { return at_ == end_ && used_ == buffer_.size(); }
  /// The next bytes, until the next call.
  std::string_view take(std::uint64_t size) {
    if (buffer_.size() - used_ < size) {
      buffer_.erase(0, used_);
      used_ = 0;
      const std::size_t before = buffer_.size();
      if (size - before > end_ - at_) throw Failure(path_ + ": found a file that was cut off, expected polygons");
      buffer_.resize(before + std::min<std::uint64_t>(end_ - at_, std::max<std::uint64_t>(size - before, ahead_)));
      if (file_.read_at(at_, buffer_.data() + before, buffer_.size() - before) < buffer_.size() - before)
        throw Failure(path_ + ": found a file that was cut off, expected polygons");
      at_ += buffer_.size() - before;
    }
    const std::string_view bytes = std::string_view(buffer_).substr(used_, size);
    used_ += size;
    checksum_ = checksum_of(bytes, checksum_);
    return bytes;
  }
  template <typename T>
  T take() {
    T value;
    std::memcpy(static_cast<void*>(&value), take(sizeof value).data(), sizeof value);
    return value;
  }
  std::uint32_t checksum() const { return checksum_; }  ///< of all that was taken

 private:
  const ScratchFile& file_;
  const std::string& path_;
  std::uint64_t at_, end_;  // of the file, behind the buffer
  std::size_t ahead_, used_ = 0;
  std::string buffer_ = {};
  std::uint32_t checksum_ = 0;
};

/// Gives the polygon of the record at `at` to the sink.
void show(const ScratchFile& file, const std::string& path, std::uint64_t at, PolygonSink& sink) {
  Cursor cursor(file, path, at, most_carried);
  const RecordHead head = cursor.take<RecordHead>();
  sink.begin(head.facts);
  std::vector<Point> ring;
  for (std::uint64_t i = 0; i <= head.facts.holes; ++i) {
    stop_if_interrupted();
    ring.resize(cursor.take<std::uint64_t>());
    const std::string_view bytes = cursor.take(ring.size() * sizeof(Point));
    std::memcpy(static_cast<void*>(ring.data()), bytes.data(), bytes.size());
    sink.ring(ring);
  }
  sink.end();
}

/// The same of a record in memory.
void show(std::string_view record, PolygonSink& sink) {
  RecordHead head;
  std::memcpy(static_cast<void*>(&head), record.data(), sizeof head);
  record.remove_prefix(sizeof head);
  sink.begin(head.facts);
  std::vector<Point> ring;
  for (std::uint64_t i = 0; i <= head.facts.holes; ++i) {
    std::uint64_t count = 0;
    std::memcpy(&count, record.data(), sizeof count);
    ring.resize(count);
    std::memcpy(static_cast<void*>(ring.data()), record.data() + sizeof count, count * sizeof(Point));
    record.remove_prefix(sizeof count + count * sizeof(Point));
    sink.ring(ring);
  }
  sink.end();
}

/// A polygon on its way into order: its record, or where that is in the log.
struct Entry {
  Key key;
  std::uint64_t begin;  // in the log, or in the bytes that are carried
  std::uint64_t size;   // of the record that is carried; 0: it is in the log
};

/// As many as fit into memory.
class Run {
 public:
  void carry(const Key& key, std::string_view record) {
    entries_.push_back({key, bytes_.size(), record.size()});
    bytes_ += record;
  }
  void refer(const Key& key, std::uint64_t at) { entries_.push_back({key, at, 0}); }

  bool is_empty() const { return entries_.empty(); }
  std::uint64_t memory() const { return bytes_.size() + entries_.size() * sizeof(Entry); }
  void sort() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  }
  const std::vector<Entry>& entries() const { return entries_; }
  /// Empty where it is not carried.
  std::string_view record(const Entry& entry) const {
    if (entry.size == 0) return {};
    return std::string_view(bytes_).substr(entry.begin, entry.size);
  }
  void clear() {
    entries_.clear();
    bytes_.clear();
  }

 private:
  std::vector<Entry> entries_;
  std::string bytes_;
};

/// Each entry, followed by the record where it is carried.
void write_run(const Run& run, const std::string& path) {
  ScratchFile file(path, ScratchFile::Mode::write);
  std::string bytes;
  for (const Entry& entry : run.entries()) {
    bytes.append(reinterpret_cast<const char*>(&entry), sizeof entry);
    bytes += run.record(entry);
    if (bytes.size() < buffer_bytes) continue;
    file.write(bytes);
    bytes.clear();
  }
  file.write(bytes);
}

/// A run in a file, and where it is.
struct StoredRun {
  StoredRun(const std::string& at, std::size_t ahead)
      : path(at), file(at, ScratchFile::Mode::read), cursor(file, path, 0, ahead) {}

  std::string path;
  ScratchFile file;
  Cursor cursor;
  Entry entry = {};
};

class Order {
 public:
  Order(const Scratch& scratch, std::uint64_t memory)
      : scratch_(scratch), path_(scratch.polygons()), log_(path_, ScratchFile::Mode::read), memory_(memory) {}

  /// Returns the checksum of the log.
  std::uint32_t read() {
    Cursor cursor(log_, path_, 0);
    for (std::uint64_t at = 0; !cursor.at_end();) {
      stop_if_interrupted();
      std::string record(cursor.take(key_begin + sizeof(Key)));
      RecordHead head;
      std::memcpy(static_cast<void*>(&head), record.data(), sizeof head);
      Key key;
      std::memcpy(static_cast<void*>(&key), record.data() + key_begin, sizeof key);
      const bool carried = head.size <= most_carried;
      for (std::uint64_t left = head.size + sizeof head.size - record.size(), some = 0; left > 0; left -= some) {
        some = std::min<std::uint64_t>(left, most_carried);
        const std::string_view bytes = cursor.take(some);
        if (carried) record += bytes;
      }
      if (!run_.is_empty() && run_.memory() > memory_ / 4) keep();
      carried ? run_.carry(key, record) : run_.refer(key, at);
      at += head.size + sizeof head.size;
    }
    return cursor.checksum();
  }

  void show_all(PolygonSink& sink) {
    if (!stored_.empty()) {
      keep();
      run_ = Run();
      return merge(sink);
    }
    run_.sort();
    for (const Entry& entry : run_.entries())
      entry.size == 0 ? show(log_, path_, entry.begin, sink) : show(run_.record(entry), sink);
  }

 private:
  void keep() {
    run_.sort();
    stored_.push_back(scratch_.sorted_polygons(stored_.size()));
    write_run(run_, stored_.back());
    run_.clear();
  }

  void merge(PolygonSink& sink) {
    std::vector<std::unique_ptr<StoredRun>> runs;
    using Head = std::pair<Key, std::size_t>;
    std::priority_queue<Head, std::vector<Head>, std::greater<>> heads;
    const auto advance = [&](std::size_t i) {
      if (runs[i]->cursor.at_end()) return;
      runs[i]->entry = runs[i]->cursor.take<Entry>();
      heads.emplace(runs[i]->entry.key, i);
    };
    const std::size_t ahead = std::clamp<std::uint64_t>(memory_ / stored_.size() / 2, 4096, buffer_bytes);
    for (std::size_t i = 0; i < stored_.size(); ++i) {
      runs.push_back(std::make_unique<StoredRun>(stored_[i], ahead));
      advance(i);
    }
    while (!heads.empty()) {
      stop_if_interrupted();
      const std::size_t i = heads.top().second;
      heads.pop();
      const Entry& entry = runs[i]->entry;
      entry.size == 0 ? show(log_, path_, entry.begin, sink) : show(runs[i]->cursor.take(entry.size), sink);
      advance(i);
    }
  }

  const Scratch& scratch_;
  std::string path_;
  ScratchFile log_;
  std::uint64_t memory_;
  Run run_ = {};
  std::vector<std::string> stored_ = {};
};

}  // namespace

void PolygonLog::resume(const LogState& state) {
  state_ = state;
  ScratchFile file(scratch_.polygons(), ScratchFile::Mode::append);
  if (file.size() < state.bytes)
    throw Failure(scratch_.polygons() + ": found less than was written; remove " + scratch_.folder() +
                  " and begin anew");
  file.cut(state.bytes);
}

void PolygonLog::append(std::string_view bytes) {
  waiting_ += bytes;
  if (waiting_.size() >= buffer_bytes) flush();
}

void PolygonLog::add(std::span<const CornerPolygon> polygons) {
  for (const CornerPolygon& polygon : polygons) put_record(polygon, [this](std::string_view bytes) { append(bytes); });
  state_.polygons += polygons.size();
}

void PolygonLog::add_records(std::string_view bytes, std::uint64_t polygons) {
  append(bytes);
  state_.polygons += polygons;
}

LogState PolygonLog::flush() {
  if (!waiting_.empty()) ScratchFile(scratch_.polygons(), ScratchFile::Mode::append).write(waiting_);
  state_.bytes += waiting_.size();
  state_.checksum = checksum_of(waiting_, state_.checksum);
  waiting_.clear();
  return state_;
}

void PolygonLog::sorted(std::uint64_t memory, PolygonSink& sink) const {
  if (state_.bytes > 0) {
    Order order(scratch_, memory);
    if (order.read() != state_.checksum)
      throw Failure(scratch_.polygons() + ": found other polygons than were written; remove " + scratch_.folder() +
                    " and begin anew");
    order.show_all(sink);
  }
  sink.finish();
}

}  // namespace rbpa::app
