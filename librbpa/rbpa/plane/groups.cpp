#include "rbpa/plane/groups.h"

#include <mutex>

#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/plane/groups/chunks.h"

namespace rbpa {

Groups groups_of(std::span<const std::uint32_t> labels, std::size_t count) {
  check_number(labels.size());
  Groups groups;
  groups.offsets.assign(count + 1, 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == no_group) continue;
    if (labels[i] >= count)
      throw InvalidInput("point " + std::to_string(i) + " has label " + std::to_string(labels[i]) +
                         ", expected one of " + std::to_string(count) + " groups, numbered from 0");
    ++groups.offsets[labels[i] + 1];
  }
  for (std::size_t g = 0; g < count; ++g) groups.offsets[g + 1] += groups.offsets[g];
  groups.members.resize(groups.offsets.back());
  std::vector<std::uint64_t> next(groups.offsets.begin(), groups.offsets.end() - 1);
  for (std::uint32_t i = 0; i < labels.size(); ++i)
    if (labels[i] != no_group) groups.members[next[labels[i]]++] = i;
  return groups;
}

void check(std::span<const Point> points, const Groups& groups) {
  check_number(points.size());
  const auto refuse = [](const std::string& what) { throw InvalidInput("groups: " + what); };
  if (groups.offsets.empty() || groups.offsets[0] != 0)
    refuse("the first offset is not 0, expected offsets from 0 to the number of members");
  if (groups.offsets.back() != groups.members.size())
    refuse("the last offset is " + std::to_string(groups.offsets.back()) + ", expected " +
           std::to_string(groups.members.size()) + ", the number of members");
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string name = "offset " + std::to_string(g + 1);
    if (groups.offsets[g + 1] < groups.offsets[g])
      refuse(name + " is less than the one before, expected ascending offsets");
    if (groups.offsets[g + 1] > groups.members.size())
      refuse(name + " is " + std::to_string(groups.offsets[g + 1]) + ", expected at most " +
             std::to_string(groups.members.size()) + ", the number of members");
    const std::span<const std::uint32_t> members = groups[g];
    for (std::size_t k = 0; k < members.size(); ++k)
      if (members[k] >= points.size() || (k > 0 && members[k] <= members[k - 1]))
        refuse("found member " + std::to_string(members[k]) + " in group " + std::to_string(g) +
               ", expected indices of points, below " + std::to_string(points.size()) + " and ascending");
  }
}

void for_each_group(std::span<const Point> points, const Groups& groups, const std::function<void(const Group&)>& visit,
                    const GroupOptions& options) {
  check(points, groups);
  const std::vector<Chunk> chunks = chunks_of(groups);
  Threads threads = threads_for(groups.members.size(), options.threads);
  std::mutex mutex;
  std::size_t done = 0;
  for_each_index(threads, chunks.size(), [&](std::size_t c) {
    GroupPoints gathered;
    for (std::size_t g = chunks[c].first; g < chunks[c].last; ++g) visit(gathered.of(points, groups, g));
    if (!options.go_on) return;
    const std::lock_guard lock(mutex);
    done += chunks[c].last - chunks[c].first;
    if (!options.go_on(done)) throw Cancelled();
  });
}

}  // namespace rbpa
