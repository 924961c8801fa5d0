#include "stream/polygon_log.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "stream/sorted_records.h"

namespace rbpa::app {
namespace {

constexpr std::size_t read_ahead = std::size_t{1} << 20U;

/// The sort key of polygons, and of the holes of one polygon: the first two points of a ring (of a polygon, its shell).
struct RingKey {
  Point first, second;
  friend auto operator<=>(const RingKey&, const RingKey&) = default;
};

/// The head of the record of a polygon. After it come the rings that are not in the file of holes: for each, the number
/// of points and the points.
struct PolygonHead {
  std::uint64_t size;   // bytes of the record after the head
  std::uint64_t taken;  // number of holes of the polygon that are in the file of holes
  PolygonFacts facts;
};
static_assert(sizeof(PolygonHead) == 48 && std::is_trivially_copyable_v<PolygonHead>);

/// The head of a record in the file of holes. If points > 0, the points of one hole follow. If points = 0, the key of
/// the polygon follows whose holes carry `name`.
struct HoleHead {
  std::uint64_t points;
  ComponentName name;
};
static_assert(sizeof(HoleHead) == 32 && std::is_trivially_copyable_v<HoleHead>);

/// The sort key of a hole among the holes of all polygons.
struct HoleKey {
  RingKey polygon, hole;
  friend auto operator<=>(const HoleKey&, const HoleKey&) = default;
};

template <typename T>
T taken_from(std::string_view& bytes) {
  T value;
  std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

/// A file of records that is read in order or from any position.
struct RecordFile {
  explicit RecordFile(const std::string& at) : path(at), file(at, ScratchFile::Mode::read) {}
  /// Returns a reader of the file from byte `at`.
  RecordReader reader(std::uint64_t at, std::size_t ahead = long_record) const { return {file, path, at, ahead}; }

  std::string path;
  ScratchFile file;
};

/// Completes `record`, which holds the beginning of a record of `size` bytes, by reading the rest. Reads and drops the
/// rest if size > long_record.
void take_rest(RecordReader& from, std::uint64_t size, std::string& record) {
  const bool all = size <= long_record;
  for (std::uint64_t left = size - record.size(), some = 0; left > 0; left -= some) {
    stop_if_interrupted();
    some = std::min(left, long_record);
    const std::string_view bytes = from.take(some);
    if (all) record += bytes;
  }
}

void require_same(bool is_so, const std::string& path, const char* what, const Scratch& scratch) {
  if (!is_so) begin_anew(path, std::string("other ") + what + " than were written", scratch.folder());
}

/// The holes of the file of holes, sorted by polygon and then by their own key.
class HolesInOrder {
 public:
  HolesInOrder(const RecordLog& log, const Scratch& scratch, RunFiles& runs, std::uint64_t memory)
      : file_(log.path()), sorted_(runs, memory) {
    SortedRecords<ComponentName> names(runs, memory), holes(runs, memory);
    require_same(read(names, holes) == log.state().checksum, log.path(), "holes", scratch);
    names.begin();
    holes.begin();
    for (; !holes.at_end(); holes.next()) {
      while (!names.at_end() && names.key() < holes.key()) names.next();
      require_same(!names.at_end() && names.key() == holes.key(), log.path(), "holes", scratch);
      std::string_view polygon = names.record();
      const auto of = taken_from<RingKey>(polygon);
      if (holes.is_elsewhere())
        sorted_.add_place({of, file_.reader(holes.place()).take<RingKey>()}, holes.place());
      else
        sorted_.add({of, key_of(holes.record())}, holes.record());
    }
    sorted_.begin();
  }

  /// Gives the next hole of `polygon` to `sink` if there is one and its key is below `before`; null sets no limit.
  /// Returns whether a hole was given.
  bool show_next(const RingKey& polygon, const RingKey* before, PolygonSink& sink) {
    if (sorted_.at_end() || sorted_.key().polygon != polygon) return false;
    if (before != nullptr && !(sorted_.key().hole < *before)) return false;
    if (sorted_.is_elsewhere()) {
      const auto size = file_.reader(sorted_.place() - sizeof(HoleHead)).take<HoleHead>().points * sizeof(Point);
      RecordReader reader = file_.reader(sorted_.place());
      show(reader.take(size), sink);
    } else {
      show(sorted_.record(), sink);
    }
    sorted_.next();
    return true;
  }

 private:
  static RingKey key_of(std::string_view points) { return taken_from<RingKey>(points); }

  void show(std::string_view bytes, PolygonSink& sink) {
    ring_.resize(bytes.size() / sizeof(Point));
    std::memcpy(static_cast<void*>(ring_.data()), bytes.data(), bytes.size());
    sink.ring(ring_);
  }

  /// Reads the file into `names` and `holes`; the key of both is the component name. Returns the checksum of the file.
  std::uint32_t read(SortedRecords<ComponentName>& names, SortedRecords<ComponentName>& holes) const {
    RecordReader reader = file_.reader(0, read_ahead);
    std::string record;
    for (std::uint64_t at = 0; !reader.at_end();) {
      const auto head = reader.take<HoleHead>();
      at += sizeof head;
      const std::uint64_t size = head.points == 0 ? sizeof(RingKey) : head.points * sizeof(Point);
      record.clear();
      take_rest(reader, size, record);
      if (head.points == 0)
        names.add(head.name, record);
      else
        record.empty() ? holes.add_place(head.name, at) : holes.add(head.name, record);
      at += size;
    }
    return reader.checksum();
  }

  RecordFile file_;
  SortedRecords<HoleKey> sorted_;
  std::vector<Point> ring_ = {};
};

class PolygonsInOrder {
 public:
  PolygonsInOrder(const RecordLog& log, const Scratch& scratch, RunFiles& runs, std::uint64_t memory)
      : scratch_(scratch), file_(log.path()), sorted_(runs, memory) {
    require_same(read() == log.state().checksum, log.path(), "polygons", scratch);
    sorted_.begin();
  }

  void show(HolesInOrder* holes, PolygonSink& sink) {
    for (; !sorted_.at_end(); sorted_.next()) {
      stop_if_interrupted();
      if (sorted_.is_elsewhere()) {
        RecordReader reader = file_.reader(sorted_.place());
        show_one([&](std::uint64_t size) { return reader.take(size); }, holes, sink);
      } else {
        std::string_view record = sorted_.record();
        const auto take = [&](std::uint64_t size) {
          const std::string_view bytes = record.substr(0, size);
          record.remove_prefix(size);
          return bytes;
        };
        show_one(take, holes, sink);
      }
    }
  }

 private:
  /// Reads the file into sorted_. Returns the checksum of the file.
  std::uint32_t read() {
    RecordReader reader = file_.reader(0, read_ahead);
    std::string record;
    for (std::uint64_t at = 0; !reader.at_end();) {
      constexpr std::size_t ring_size = sizeof(std::uint64_t);  // number of points of the shell, which follows the head
      record = reader.take(sizeof(PolygonHead) + ring_size + sizeof(RingKey));
      std::string_view beginning = record;
      const std::uint64_t size = sizeof(PolygonHead) + taken_from<PolygonHead>(beginning).size;
      beginning.remove_prefix(ring_size);
      const auto key = taken_from<RingKey>(beginning);
      take_rest(reader, size, record);
      size <= long_record ? sorted_.add(key, record) : sorted_.add_place(key, at);
      at += size;
    }
    return reader.checksum();
  }

  /// Gives the current polygon to `sink`. take(size) returns the next `size` bytes of the record of the polygon.
  template <typename Take>
  void show_one(Take take, HolesInOrder* holes, PolygonSink& sink) {
    std::string_view bytes = take(sizeof(PolygonHead));
    const auto head = taken_from<PolygonHead>(bytes);
    sink.begin(head.facts);
    const RingKey polygon = sorted_.key();
    std::uint64_t taken = 0;
    for (std::uint64_t i = 0; i <= head.facts.holes - head.taken; ++i) {
      stop_if_interrupted();
      bytes = take(sizeof(std::uint64_t));
      ring_.resize(taken_from<std::uint64_t>(bytes));
      bytes = take(ring_.size() * sizeof(Point));
      std::memcpy(static_cast<void*>(ring_.data()), bytes.data(), bytes.size());
      const RingKey key = {ring_[0], ring_[1]};
      while (i > 0 && taken < head.taken && holes->show_next(polygon, &key, sink)) ++taken;
      sink.ring(ring_);
    }
    while (taken < head.taken && holes->show_next(polygon, nullptr, sink)) ++taken;
    require_same(taken == head.taken, file_.path, "polygons", scratch_);
    sink.end();
  }

  const Scratch& scratch_;
  RecordFile file_;
  SortedRecords<RingKey> sorted_;
  std::vector<Point> ring_ = {};
};

}  // namespace

Finished take_finished(Partial& partial) {
  // Take holes of at least this number of corners: they take more memory than the record that replaces the hole.
  constexpr std::size_t many_corners = 256;
  std::vector<CornerPolygon> polygons = take_settled(partial);
  return {std::move(polygons), take_holes(partial, many_corners)};
}

PolygonLog::PolygonLog(const Scratch& scratch)
    : scratch_(scratch), polygons_(scratch.polygons()), holes_(scratch.holes()) {}

void PolygonLog::resume(const LogState& state) {
  polygons_.resume(state.polygons);
  holes_.resume(state.holes);
}

void PolygonLog::add(std::span<const CornerPolygon> polygons) {
  const auto append_ring = [&](const CornerRing& ring) {
    polygons_.append(std::uint64_t{ring.size()});
    for (const Corner& corner : ring) polygons_.append(corner.at);
  };
  for (const CornerPolygon& polygon : polygons) {
    std::uint64_t corners = polygon.shell.size();
    for (const CornerRing& hole : polygon.holes) corners += hole.size();
    const std::uint64_t rings = polygon.holes.size() + 1;
    polygons_.append(PolygonHead{rings * sizeof(std::uint64_t) + corners * sizeof(Point),
                                 polygon.taken_holes,
                                 {polygon.area, polygon.perimeter, rings - 1 + polygon.taken_holes, polygon.points}});
    append_ring(polygon.shell);
    for (const CornerRing& hole : polygon.holes) append_ring(hole);
    for (const ComponentName& name : polygon.names) {
      holes_.append(HoleHead{0, name});
      holes_.append(RingKey{polygon.shell[0].at, polygon.shell[1].at});
    }
  }
}

void PolygonLog::add(std::span<const TakenHoles> holes) {
  for (const TakenHoles& taken : holes)
    for (const CornerRing& hole : taken.holes) {
      holes_.append(HoleHead{hole.size(), taken.component});
      for (const Corner& corner : hole) holes_.append(corner.at);
    }
}

LogState PolygonLog::flush() { return {polygons_.flush(), holes_.flush()}; }

void PolygonLog::sorted(std::uint64_t memory, PolygonSink& sink) const {
  if (polygons_.state().bytes > 0) {
    RunFiles runs(scratch_);
    // Divide the memory by three: for names, for holes by name, and for holes by polygon. Afterwards only two sorts are
    // left: of holes by polygon, and of polygons.
    const bool any = holes_.state().bytes > 0;
    std::unique_ptr<HolesInOrder> holes;
    if (any) holes = std::make_unique<HolesInOrder>(holes_, scratch_, runs, memory / 3);
    PolygonsInOrder(polygons_, scratch_, runs, any ? memory / 3 : memory).show(holes.get(), sink);
  }
  sink.finish();
}

}  // namespace rbpa::app
