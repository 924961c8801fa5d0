// What: processes many items in several threads and joins their results in order.
// Law:  join(i) is called once for each i, ascending, one at a time; its result therefore does not depend on the
//       threads.
// Cost: a few microseconds an item besides the work; one workspace for each item in progress.
#pragma once

#ifndef RBPA_SERIAL
#include <tbb/parallel_pipeline.h>
#endif

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "rbpa/base/parallel/threads.h"

namespace rbpa {

/// Calls for each i below `count` work(i, workspace) in any thread, then join(i, workspace) in the order of i, then
/// finish(i, workspace) in any thread. A workspace belongs to one item at a time and is used again afterwards: the one
/// that was released last comes first, as it is still in a cache. Rethrows an exception of any call; then some of the
/// calls are never made.
template <typename Workspace, typename Work, typename Join, typename Finish>
void in_order(Threads& threads, std::size_t count, Work work, Join join, Finish finish) {
  if (threads.count() == 1 || count <= 1) {
    Workspace workspace;
    for (std::size_t i = 0; i < count; ++i) {
      work(i, workspace);
      join(i, workspace);
      finish(i, workspace);
    }
    return;
  }
#if defined(RBPA_PLAIN_THREADS)
  plain_threads::in_order<Workspace>(threads.count(), count, work, join, finish);
#elif !defined(RBPA_SERIAL)
  struct Item {
    Workspace workspace;
    std::size_t number = 0;
  };
  std::vector<std::unique_ptr<Item> > items;
  std::vector<Item*> idle;
  std::mutex mutex;
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& control) -> Item* {
    if (next == count) {
      control.stop();
      return nullptr;
    }
    const std::lock_guard lock(mutex);
    if (idle.empty()) idle.push_back(items.emplace_back(std::make_unique<Item>()).get());
    Item* const item = idle.back();
    idle.pop_back();
    item->number = next++;
    return item;
  };
  const auto do_work = [&](Item* item) {
    work(item->number, item->workspace);
    return item;
  };
  const auto do_join = [&](Item* item) {
    join(item->number, item->workspace);
    return item;
  };
  const auto do_finish = [&](Item* item) {
    finish(item->number, item->workspace);
    const std::lock_guard lock(mutex);
    idle.push_back(item);
  };
  using tbb::filter_mode;
  threads.execute([&] {
    tbb::parallel_pipeline(3 * threads.count(),
                           tbb::make_filter<void, Item*>(filter_mode::serial_in_order, take) &
                               tbb::make_filter<Item*, Item*>(filter_mode::parallel, do_work) &
                               tbb::make_filter<Item*, Item*>(filter_mode::serial_in_order, do_join) &
                               tbb::make_filter<Item*, void>(filter_mode::parallel, do_finish));
  });
#endif
}

}  // namespace rbpa
