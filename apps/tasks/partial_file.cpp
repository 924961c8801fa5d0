#include "tasks/partial_file.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "io/failure.h"
#include "io/interrupt.h"
#include "rbpa/base/error.h"
#include "rbpa/partial_bytes.h"
#include "stream/polygon_log.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The first words of a file, before the checksum of the rest of the line in eight digits, and that.
constexpr std::string_view beginning = "RBPA partial 1 ";
constexpr std::size_t checksum_digits = 8;

std::string hexadecimal(std::uint32_t value) {
  char text[checksum_digits + 1];
  std::snprintf(text, sizeof text, "%08x", value);
  return text;
}

fs::path folder_of(const std::string& path) { return fs::absolute(path).lexically_normal().parent_path(); }

[[noreturn]] void damaged(const std::string& path) {
  bad_input(path, "a file that was cut off or changed", "a partial of rbpa tile or rbpa merge; run its task again");
}

/// By their numbers.
constexpr std::string_view kinds[] = {"polygons", "holes", "triangles"};
constexpr std::size_t kinds_beside = 2;

std::string_view name_of(SideFile::Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }

Json json_of(const SideFile& file, const fs::path& folder) {
  return {name_of(file.kind), json_text(fs::absolute(file.path).lexically_normal().lexically_relative(folder).string()),
          file.items, file.bytes, file.checksum};
}

SideFile side_file_of(const Json& json, const fs::path& folder) {
  const auto kind = std::find(std::begin(kinds), std::end(kinds), json.at(0).get<std::string>());
  if (kind == std::end(kinds)) bad_input(json.dump(), "a file of another kind", "polygons, holes or triangles");
  return {static_cast<SideFile::Kind>(kind - std::begin(kinds)),
          (folder / bytes_of_json_text(json.at(1).get<std::string>())).lexically_normal().string(), json.at(2),
          json.at(3), json.at(4)};
}

}  // namespace

TileSet::TileSet(std::vector<Range> ranges) {
  std::sort(ranges.begin(), ranges.end());
  for (const Range& range : ranges) {
    if (!ranges_.empty() && ranges_.back().second + 1 == range.first)
      ranges_.back().second = range.second;
    else
      ranges_.push_back(range);
  }
}

std::uint64_t TileSet::size() const {
  std::uint64_t size = 0;
  for (const auto& [first, last] : ranges_) size += std::uint64_t{last} - first + 1;
  return size;
}

bool TileSet::contains(std::uint32_t tile) const {
  const auto after = std::upper_bound(ranges_.begin(), ranges_.end(), tile,
                                      [](std::uint32_t value, const Range& range) { return value < range.first; });
  return after != ranges_.begin() && tile <= std::prev(after)->second;
}

std::uint32_t TileSet::first_missing() const {
  return ranges_.empty() || ranges_[0].first > 0 ? 0 : ranges_[0].second + 1;
}

std::optional<std::uint32_t> common(const TileSet& a, const TileSet& b) {
  for (const TileSet::Range& range : a.ranges())
    if (b.contains(range.first)) return range.first;
  for (const TileSet::Range& range : b.ranges())
    if (a.contains(range.first)) return range.first;
  return std::nullopt;
}

TileSet operator+(const TileSet& a, const TileSet& b) {
  std::vector<TileSet::Range> ranges = a.ranges();
  ranges.insert(ranges.end(), b.ranges().begin(), b.ranges().end());
  return TileSet(std::move(ranges));
}

std::vector<std::string> side_paths(const std::string& path) {
  std::vector<std::string> paths;
  for (const std::string_view kind : std::span(kinds).first(kinds_beside))
    paths.push_back(fs::path(path).replace_extension(kind).string());
  return paths;
}

void add_partial(OutputSet& outputs, const std::string& path, PartialFile partial) {
  const Finished finished = take_finished(partial.partial);
  const std::vector<std::string> paths = side_paths(path);
  SideOutput polygons(outputs, SideFile::Kind::polygons, paths[0]), holes(outputs, SideFile::Kind::holes, paths[1]);
  const auto put = [&](std::string_view bytes) { polygons.write(bytes); };
  const auto put_hole = [&](std::string_view bytes) { holes.write(bytes); };
  for (const CornerPolygon& polygon : finished.polygons) {
    stop_if_interrupted();
    put_record(polygon, put, put_hole);
  }
  for (const TakenHoles& taken : finished.holes) put_record(taken, put_hole);
  for (SideOutput* file : {&polygons, &holes})
    if (const SideFile about = file->finish(0); about.bytes > 0) partial.files.push_back(about);
  const fs::path folder = folder_of(path);
  std::vector<Json> files;
  for (const SideFile& file : partial.files) files.push_back(json_of(file, folder));
  std::sort(files.begin(), files.end());
  const std::string head =
      Json({{"run", json_of(partial.run)}, {"tiles", partial.tiles.ranges()}, {"files", files}}).dump() + "\n";
  OutputFile& file = outputs.add(path);  // the last to get its name: where it exists, the others do
  file.write(std::string(beginning) + hexadecimal(checksum_of(head)) + " " + head);
  const std::vector<std::uint8_t> bytes = to_bytes(partial.partial);
  file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  file.finish();
}

PartialFile read_partial(const std::string& path) {
  const std::string expected = "a partial of rbpa tile or rbpa merge";
  if (access(path.c_str(), F_OK) != 0) bad_input(path, "no such file", expected);
  const std::string content = scratch_content(path);
  std::string_view left = content;
  if (!left.starts_with(beginning))
    bad_input(path, left.empty() ? "an empty file" : "a file of another kind", expected);
  left.remove_prefix(beginning.size());
  const std::size_t end = left.find('\n');
  if (end == std::string_view::npos || end < checksum_digits) damaged(path);
  const std::string_view head = left.substr(checksum_digits + 1, end - checksum_digits);
  if (left.substr(0, checksum_digits + 1) != hexadecimal(checksum_of(head)) + " ") damaged(path);
  left.remove_prefix(end + 1);
  try {
    const Json json = Json::parse(head);
    const fs::path folder = folder_of(path);
    PartialFile file{.run = run_facts_of(json.at("run")),
                     .tiles = TileSet(json.at("tiles").get<std::vector<TileSet::Range>>())};
    for (const Json& side : json.at("files")) file.files.push_back(side_file_of(side, folder));
    file.partial = partial_from_bytes({reinterpret_cast<const std::uint8_t*>(left.data()), left.size()});
    return file;
  } catch (const nlohmann::json::exception&) {
    damaged(path);
  } catch (const InvalidInput& error) {
    throw BadInput(path + ": " + error.what() + "; run its task again");
  }
}

void for_each_piece(const SideFile& file, const std::function<void(std::string_view bytes)>& take) {
  const std::string expected = std::string("the ") +
                               (file.kind == SideFile::Kind::polygons ? "polygons" : "triangles") +
                               " that a task has written beside its partial; remove both and run the task again";
  if (access(file.path.c_str(), F_OK) != 0) bad_input(file.path, "no such file", expected);
  ScratchFile bytes(file.path, ScratchFile::Mode::read);
  if (bytes.size() != file.bytes)
    bad_input(file.path, "a file of " + std::to_string(bytes.size()) + " bytes", expected);
  std::string piece(std::size_t{3} << 18U, '\0');
  std::uint32_t checksum = 0;
  for (std::uint64_t at = 0; at < file.bytes;) {
    stop_if_interrupted();
    const std::size_t size = bytes.read_at(at, piece.data(), piece.size());
    if (size == 0) bad_input(file.path, "a file that was cut off", expected);
    checksum = checksum_of(std::string_view(piece).substr(0, size), checksum);
    take(std::string_view(piece).substr(0, size));
    at += size;
  }
  if (checksum != file.checksum) bad_input(file.path, "a file that was changed", expected);
}

SideOutput::SideOutput(OutputSet& outputs, SideFile::Kind kind, const std::string& path)
    : outputs_(outputs), about_{.kind = kind, .path = path} {}

void SideOutput::write(std::string_view bytes) {
  if (file_ == nullptr) file_ = &outputs_.add(about_.path);
  file_->write(bytes);
  about_.bytes += bytes.size();
  about_.checksum = checksum_of(bytes, about_.checksum);
}

SideFile SideOutput::finish(std::uint64_t items) {
  if (file_ != nullptr) file_->finish();
  about_.items = items;
  return about_;
}

}  // namespace rbpa::app
