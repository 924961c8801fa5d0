// What: processes many items in several threads, and joins their results in the order of the items.
// Law:  join(i) is called once for each i, ascending, one call at a time, so the joined result does not depend on the
//       threads.
// Cost: a few microseconds an item in addition to the work; one workspace for each item in progress.
#pragma once

#include <cstddef>
#include <memory>

#include "rbpa/base/parallel/threads.h"

namespace rbpa {

/// Calls, for each i below `count`, work(i, workspace) in any thread, then join(i, workspace) in the order of i, then
/// finish(i, workspace) in any thread. A workspace belongs to one item at a time, and is reused while it is still in a
/// cache. Rethrows an exception of a call; then some of the calls are never made.
template <typename Workspace, typename Work, typename Join, typename Finish>
void in_order(Threads& threads, std::size_t count, Work work, Join join, Finish finish) {
  if (threads.count() > 1 && count > 1) {
    const auto at = [](void* workspace) -> Workspace& { return *static_cast<Workspace*>(workspace); };
    threads.share_in_order(
        count, [] { return std::shared_ptr<void>(std::make_shared<Workspace>()); },
        [&](std::size_t i, void* workspace) { work(i, at(workspace)); },
        [&](std::size_t i, void* workspace) { join(i, at(workspace)); },
        [&](std::size_t i, void* workspace) { finish(i, at(workspace)); });
    return;
  }
  Workspace workspace;
  for (std::size_t i = 0; i < count; ++i) {
    work(i, workspace);
    join(i, workspace);
    finish(i, workspace);
  }
}

}  // namespace rbpa
