// What: the library's two ways to share work among threads, with the standard library alone.
// Why:  for the thread sanitizer. oneTBB is not built with it, so the sanitizer cannot see how oneTBB orders pieces of
//       work, and would report false races.
#pragma once

#include <cstddef>

#include "rbpa/base/join_in_order.h"

#if defined(__SANITIZE_THREAD__)
#define RBPA_PLAIN_THREADS 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RBPA_PLAIN_THREADS 1
#endif
#endif

namespace rbpa::plain_threads {

template <typename Visit>
void for_each_index(std::size_t threads, std::size_t count, Visit& visit) {
  SharedWork shared(count);
  shared.run(threads, [&] {
    for (std::size_t i = shared.take(); i < count; i = shared.take()) visit(i);
  });
}

template <typename Workspace, typename Work, typename Join, typename Finish>
void in_order(std::size_t threads, std::size_t count, Work& work, Join& join, Finish& finish) {
  SharedWork shared(count);
  shared.run(threads, [&] {
    Workspace workspace;
    for (std::size_t i = shared.take(); i < count; i = shared.take()) {
      work(i, workspace);
      if (!shared.wait_for_turn(i)) return;
      join(i, workspace);
      shared.pass_on();
      finish(i, workspace);
    }
  });
}

}  // namespace rbpa::plain_threads
