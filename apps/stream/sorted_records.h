// What: sorts records by their keys, even if only few records fit into memory.
// Cost: if not all records fit, each is written and read once, and once more for each factor of most_merged in the
//       number of sorted files. About `memory` bytes, and the longest record, are in memory.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/interrupt.h"
#include "stream/record_log.h"
#include "stream/scratch.h"

namespace rbpa::app {

/// Makes names for files of sorted records. next() returns a new name in each call.
class RunFiles {
 public:
  explicit RunFiles(const Scratch& scratch) : scratch_(scratch) {}
  std::string next() { return scratch_.sorted_run(number_++); }

 private:
  const Scratch& scratch_;
  std::size_t number_ = 0;
};

/// Sorts records. The caller adds all records, and then calls begin(), which makes the least record current. key() and
/// record() belong to the current record; next() makes the following record current.
template <typename Key>
class SortedRecords {
 public:
  /// Prepares sorting with about `memory` bytes. Keeps a reference to `files`.
  SortedRecords(RunFiles& files, std::uint64_t memory) : files_(files), memory_(memory) {}

  /// Adds a record. Requires: `record` is not empty.
  void add(const Key& key, std::string_view record) {
    make_room();
    entries_.push_back({key, bytes_.size(), record.size()});
    bytes_ += record;
  }
  /// Adds a record that stays in a file of the caller, at byte `place`.
  void add_place(const Key& key, std::uint64_t place) {
    make_room();
    entries_.push_back({key, place, 0});
  }

  /// Sorts the added records. All members throw BadInput if a file is damaged; Failure, Cancelled.
  void begin() {
    if (levels_.empty()) {
      sort();
      return;
    }
    if (!entries_.empty()) keep();
    std::vector<std::string> paths;
    for (const std::vector<std::string>& level : levels_) paths.insert(paths.end(), level.begin(), level.end());
    merge_ = std::make_unique<Merge>(paths, memory_);
  }
  bool at_end() const { return merge_ ? merge_->at_end() : current_ == entries_.size(); }
  /// Returns the key of the current record. Requires: not at_end().
  const Key& key() const { return entry().key; }
  /// Returns whether the current record was added by add_place(); place() returns its place in the file of the caller.
  bool is_elsewhere() const { return entry().size == 0; }
  std::uint64_t place() const { return entry().begin; }
  /// Returns the bytes of the current record, which are valid until next(). Requires: not at_end().
  std::string_view record() const {
    return merge_ ? merge_->record() : std::string_view(bytes_).substr(entry().begin, entry().size);
  }
  void next() { merge_ ? merge_->next() : void(++current_); }

 private:
  static_assert(std::is_trivially_copyable_v<Key>);
  static constexpr std::size_t most_merged = 64;  // the most files of a level; a merge opens all of them

  struct Entry {
    Key key;
    std::uint64_t begin;  // position in bytes_, or place in the file of the caller
    std::uint64_t size;   // 0 if the record was added by add_place()
  };

  /// A file of sorted records. The destructor removes the file.
  struct StoredRun {
    StoredRun(const std::string& at, std::size_t ahead)
        : path(at), file(at, ScratchFile::Mode::read), reader(file, path, 0, ahead) {}
    ~StoredRun() { unlink(path.c_str()); }
    StoredRun(const StoredRun&) = delete;
    StoredRun& operator=(const StoredRun&) = delete;

    std::string path;
    ScratchFile file;
    RecordReader reader;
    Entry entry = {};
  };

  class Merge {
   public:
    Merge(const std::vector<std::string>& paths, std::uint64_t memory) {
      const std::size_t ahead = std::clamp<std::uint64_t>(memory / paths.size() / 2, 4096, std::uint64_t{1} << 20U);
      for (const std::string& path : paths) {
        runs_.push_back(std::make_unique<StoredRun>(path, ahead));
        advance(runs_.size() - 1);
      }
      show();
    }
    bool at_end() const { return heads_.empty(); }
    const Entry& entry() const { return runs_[heads_.top().second]->entry; }
    std::string_view record() const { return record_; }
    void next() {
      stop_if_interrupted();
      const std::size_t i = heads_.top().second;
      heads_.pop();
      advance(i);
      show();
    }

   private:
    void advance(std::size_t i) {
      if (runs_[i]->reader.at_end()) return;
      runs_[i]->entry = runs_[i]->reader.template take<Entry>();
      heads_.emplace(runs_[i]->entry.key, i);
    }
    void show() {
      if (!at_end()) record_ = runs_[heads_.top().second]->reader.take(entry().size);
    }

    using Head = std::pair<Key, std::size_t>;
    std::vector<std::unique_ptr<StoredRun>> runs_ = {};
    std::priority_queue<Head, std::vector<Head>, std::greater<>> heads_ = {};
    std::string_view record_ = {};
  };

  const Entry& entry() const { return merge_ ? merge_->entry() : entries_[current_]; }

  void make_room() {
    if (bytes_.size() + entries_.size() * sizeof(Entry) > memory_ / 4) keep();
  }
  void sort() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  }
  /// Sorts the records in memory, and moves them to a new file of level 0.
  void keep() {
    sort();
    const std::string path = files_.next();
    {
      RecordLog file(path);
      for (const Entry& entry : entries_) {
        file.append(entry);
        if (entry.size > 0) file.append(std::string_view(bytes_).substr(entry.begin, entry.size));
      }
      file.flush();
    }
    entries_ = {};
    bytes_ = {};
    keep(path, 0);
  }
  /// Adds a file to a level. If the level is full afterwards, merges its files into one file of the next level.
  void keep(const std::string& path, std::size_t level) {
    if (levels_.size() == level) levels_.emplace_back();
    levels_[level].push_back(path);
    if (levels_[level].size() < most_merged) return;
    const std::string all = files_.next();
    {
      RecordLog file(all);
      for (Merge merge(levels_[level], memory_); !merge.at_end(); merge.next()) {
        file.append(merge.entry());
        file.append(merge.record());
      }
      file.flush();
    }
    levels_[level].clear();
    keep(all, level + 1);
  }

  RunFiles& files_;
  std::uint64_t memory_;
  std::vector<Entry> entries_ = {};
  std::string bytes_ = {};
  std::size_t current_ = 0;
  std::vector<std::vector<std::string>> levels_ = {};  // paths of the files of each level
  std::unique_ptr<Merge> merge_ = nullptr;
};

}  // namespace rbpa::app
