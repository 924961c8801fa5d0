// What: runs work in several threads.
// Law:  the result depends on how work is divided, never on the number of threads or their order. With RBPA_SERIAL
//       there is one thread, and no oneTBB.
#pragma once

#ifndef RBPA_SERIAL
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <optional>

#ifndef RBPA_SERIAL
#include "rbpa/base/parallel/plain_threads.h"
#endif

namespace rbpa {

/// The number of threads that may work on a task, the calling one included.
#ifdef RBPA_SERIAL
class Threads {
 public:
  explicit Threads(unsigned = 1) {}
  static constexpr std::size_t count() { return 1; }
};
#else
class Threads {
 public:
  /// Uses `count` threads, but at most the number of processors; 0 = all processors.
  explicit Threads(unsigned count = 1) {
    const auto processors = static_cast<unsigned>(tbb::info::default_concurrency());
    count_ = count == 0 ? processors : std::min(count, processors);
  }

  std::size_t count() const { return count_; }

  /// Calls run() in an arena of this number of threads. Throws its exceptions.
  template <typename Run>
  void execute(Run run) {
    if (!arena_) arena_.emplace(static_cast<int>(count_));
    arena_->execute(run);
  }

 private:
  unsigned count_;
  std::optional<tbb::task_arena> arena_;  // absent for one thread
};
#endif

/// Calls visit(i) for each i below `count`, in any order and thread. Rethrows an exception of any call.
template <typename Visit>
void for_each_index(Threads& threads, std::size_t count, Visit visit) {
  if (threads.count() == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) visit(i);
    return;
  }
#if defined(RBPA_PLAIN_THREADS)
  plain_threads::for_each_index(threads.count(), count, visit);
#elif !defined(RBPA_SERIAL)
  threads.execute([&] { tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { visit(i); }); });
#endif
}

/// Calls visit(first, last) for parts of the range from 0 to `size` of at most `part`, in any order and thread.
template <typename Visit>
void for_each_part(Threads& threads, std::size_t size, std::size_t part, Visit visit) {
  for_each_index(threads, (size + part - 1) / part,
                 [&](std::size_t i) { visit(i * part, std::min(i * part + part, size)); });
}

}  // namespace rbpa
