#include "stream/compute_state.h"

#include <unistd.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "io/failure.h"
#include "rbpa/partial_bytes.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;

void write_partials(const std::vector<Partial>& partials, const std::string& path) {
  ScratchFile file(path, ScratchFile::Mode::write);
  for (const Partial& partial : partials) {
    const std::vector<std::uint8_t> bytes = to_bytes(partial);
    const std::uint64_t size = bytes.size();
    file.write({reinterpret_cast<const char*>(&size), sizeof size});
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
}

std::vector<Partial> read_partials(const std::string& path, std::size_t count) {
  const std::string bytes = scratch_content(path);
  std::vector<Partial> partials;
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t size = 0;
    if (bytes.size() - at < sizeof size) throw std::runtime_error("a file that was cut off");
    std::memcpy(&size, bytes.data() + at, sizeof size);
    at += sizeof size;
    if (bytes.size() - at < size) throw std::runtime_error("a file that was cut off");
    partials.push_back(partial_from_bytes({reinterpret_cast<const std::uint8_t*>(bytes.data()) + at, size}));
    at += size;
  }
  return partials;
}

}  // namespace

void save(const ComputeState& state, const Scratch& scratch) {
  write_partials(state.open, scratch.partials(state.generation));
  const Json json = {{"generation", state.generation},
                     {"tiles_done", state.tiles_done},
                     {"points_done", state.points_done},
                     {"open", state.open.size()},
                     {"rows", state.rows.rows},
                     {"sums", state.rows.sums},
                     {"polygons", {state.polygons.polygons.bytes, state.polygons.polygons.checksum}},
                     {"holes", {state.polygons.holes.bytes, state.polygons.holes.checksum}}};
  replace_checked(scratch.progress(), json.dump());
  if (state.generation > 0) unlink(scratch.partials(state.generation - 1).c_str());
}

std::optional<ComputeState> load_state(const Scratch& scratch) {
  const std::string text = checked_content(scratch.progress());
  if (text.empty()) return std::nullopt;
  try {
    const Json json = Json::parse(text);
    ComputeState state{.generation = json.at("generation"),
                       .tiles_done = json.at("tiles_done"),
                       .points_done = json.at("points_done")};
    state.open = read_partials(scratch.partials(state.generation), json.at("open"));
    state.rows = {json.at("rows"), json.at("sums")};
    const auto log = [&](const char* name) { return RecordState{json.at(name).at(0), json.at(name).at(1)}; };
    state.polygons = {log("polygons"), log("holes")};
    return state;
  } catch (const std::exception& error) {
    throw BadInput(scratch.progress() + ": found no progress of rbpa stream (" + std::string(error.what()) +
                   "), expected it; remove " + scratch.folder() + " and begin anew");
  }
}

}  // namespace rbpa::app
