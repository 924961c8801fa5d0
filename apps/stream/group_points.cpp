#include "stream/group_points.h"

#include <algorithm>
#include <cstring>

#include "stream/scratch_file.h"

namespace rbpa::app {

void GroupPoints::flush() {
  std::stable_sort(waiting_.begin(), waiting_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::uint64_t at = log_.state().bytes;
  for (auto first = waiting_.begin(); first != waiting_.end();) {
    auto last = first;
    for (; last != waiting_.end() && last->first == first->first; ++last) log_.append(last->second);
    const auto points = static_cast<std::uint64_t>(last - first);
    groups_[first->first].segments.push_back({at, points});
    at += points * sizeof(Point);
    first = last;
  }
  log_.flush();
  decltype(waiting_)().swap(waiting_);  // returns the memory, which tiles need after the last flush
}

void GroupPoints::read(std::uint32_t group, const std::function<void(std::span<const Point>)>& visit) const {
  constexpr std::uint64_t most = 1U << 16U;
  const ScratchFile file(log_.path(), ScratchFile::Mode::read);
  std::vector<Point> points;
  for (const Segment& segment : groups_[group].segments) {
    RecordReader reader(file, log_.path(), segment.begin, sizeof(Point) * std::min(most, segment.points));
    for (std::uint64_t left = segment.points; left > 0; left -= points.size()) {
      points.resize(std::min(most, left));
      const std::string_view bytes = reader.take(points.size() * sizeof(Point));
      std::memcpy(static_cast<void*>(points.data()), bytes.data(), bytes.size());
      visit(points);
    }
  }
}

}  // namespace rbpa::app
