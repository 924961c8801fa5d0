#include "stream/manifest.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr int version = 2;

std::string absolute(const std::string& path) {
  return path == "-" ? path : std::filesystem::absolute(path).lexically_normal().string();
}

Json json_of(const TileTree& tree) {
  Json parts = Json::array();
  for (const TileTree::Part& part : tree.parts())
    parts.push_back({static_cast<int>(part.kind), part.line, part.first, part.second});
  return parts;
}

void require(bool is_so, const char* found) {
  if (!is_so) throw std::runtime_error(found);
}

/// Throws std::runtime_error unless each part except the first has exactly one parent, which precedes it, cuts have a
/// known kind and a finite line, and tiles have different numbers in range.
void require_tree(const std::vector<TileTree::Part>& parts) {
  using Kind = TileTree::Part::Kind;
  require(!parts.empty(), "no tiles");
  std::vector<bool> has_parent(parts.size(), false), is_tile(parts.size() / 2 + 1, false);
  for (std::size_t at = 0; at < parts.size(); ++at) {
    const TileTree::Part& part = parts[at];
    require(at == 0 || has_parent[at], "a part of the plane without a parent");
    if (part.kind == Kind::tile) {
      require(part.first < is_tile.size() && !is_tile[part.first], "a tile number that is too large or repeated");
      is_tile[part.first] = true;
      continue;
    }
    require(part.kind == Kind::cut_x || part.kind == Kind::cut_y, "a cut of an unknown kind");
    require(std::isfinite(part.line), "a cut at a coordinate that is not finite");
    for (const std::uint32_t of : {part.first, part.second}) {
      require(of > at && of < parts.size() && !has_parent[of], "a number of a part that is out of range or repeated");
      has_parent[of] = true;
    }
  }
}

TileTree tree_of(const Json& json) {
  std::vector<TileTree::Part> parts;
  for (const Json& part : json)
    parts.push_back({static_cast<TileTree::Part::Kind>(part.at(0).get<int>()), part.at(1).get<double>(),
                     part.at(2).get<std::uint32_t>(), part.at(3).get<std::uint32_t>()});
  require_tree(parts);
  return TileTree(std::move(parts));
}

Json json_of(const std::vector<TileSummary>& tiles) {
  Json json = Json::array();
  for (const TileSummary& tile : tiles)
    json.push_back({tile.points, tile.owned, tile.bytes, tile.blocks, tile.checksum});
  return json;
}

std::vector<TileSummary> tiles_of(const Json& json) {
  std::vector<TileSummary> tiles;
  for (const Json& tile : json) tiles.push_back({tile.at(0), tile.at(1), tile.at(2), tile.at(3), tile.at(4)});
  return tiles;
}

Json json_of(const RunKey& run_key) {
  Json inputs = Json::array();
  for (const InputFile& file : run_key.inputs)
    inputs.push_back({json_text_of_bytes(file.path), file.size, file.changed});
  Json targets = Json::array();
  for (const std::string& path : run_key.targets) targets.push_back(json_text_of_bytes(path));
  return {{"inputs", inputs},
          {"options", json_text_of_bytes(run_key.options)},
          {"alpha", run_key.alpha},
          {"memory", run_key.memory},
          {"tile_size", run_key.tile_size},
          {"keep_tiles", run_key.keep_tiles},
          {"targets", targets}};
}

void add_facts(Json& json, const PointsFacts& facts) {
  json["box"] = {facts.least.x, facts.least.y, facts.greatest.x, facts.greatest.y};
  json["crs"] = facts.crs ? Json({facts.crs->authority, facts.crs->code, facts.crs->degrees}) : Json();
  json["degrees"] = facts.degrees;
}

void read_facts(const Json& json, PointsFacts& facts) {
  const Json &box = json.at("box"), &crs = json.at("crs");
  facts.least = {box.at(0), box.at(1)};
  facts.greatest = {box.at(2), box.at(3)};
  if (!crs.is_null()) facts.crs = Crs{crs.at(0), crs.at(1), crs.at(2)};
  facts.degrees = json.at("degrees");
}

/// Returns a path of the manifest as a user may write it: relative if the file is in the current folder.
std::string short_path(const Json& path) {
  const std::string text = bytes_of_json_text(path.get<std::string>());
  const std::string here = std::filesystem::current_path().string() + "/";
  return printable(text.starts_with(here) ? text.substr(here.size()) : text);
}

/// Returns a text that gives `key` of json_of(RunKey) the value as on the command line, such as "--keep-tiles".
std::string as_options(const std::string& key, const Json& value) {
  std::string text;
  if (key == "targets") {
    for (const Json& path : value) text += (text.empty() ? "-o " : " -o ") + short_path(path);
    return text.empty() ? "no -o" : shown(text);
  }
  if (key == "inputs") {
    for (const Json& file : value) text += (text.empty() ? "" : " ") + short_path(file.at(0));
    return counted(value.size(), "input") + " (" + shown(text) + ")";
  }
  if (key == "options") {
    text = bytes_of_json_text(value.get<std::string>());
    return text.empty() ? "no option that says how POINTS are read" : shown(text);
  }
  if (key == "tile_size") return value == 0 ? "no --tile-size" : "--tile-size " + value.dump();
  if (key == "keep_tiles") return value == true ? "--keep-tiles" : "no --keep-tiles";
  return "--" + key + " " + value.dump() + (key == "memory" ? " (bytes)" : "");
}

/// Throws WrongUsage that names one difference if `run_key` differs from `before`, the request of the run in `folder`.
void require_same(const Json& before, const RunKey& run_key, const std::string& folder) {
  const Json now = json_of(run_key);
  if (before == now) return;
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    bad_usage("--resume", found,
              expected + ", as the run in " + folder + " has (or remove " + folder + " to start again)");
  };
  const Json &old_inputs = before.at("inputs"), &inputs = now.at("inputs");
  for (std::size_t i = 0; i < std::min(old_inputs.size(), inputs.size()); ++i) {
    if (inputs[i].at(0) != old_inputs[i].at(0))
      refuse("the input " + short_path(inputs[i].at(0)), short_path(old_inputs[i].at(0)));
    if (inputs[i] != old_inputs[i])
      bad_usage("--resume", short_path(inputs[i].at(0)) + ", which has changed since the run in " + folder + " began",
                "the file as it was (or remove " + folder + " to start again)");
  }
  for (const auto& [key, value] : now.items())
    if (before.at(key) != value) refuse(as_options(key, value), as_options(key, before.at(key)));
}

}  // namespace

RunKey run_key_of(const StreamRequest& request) {
  RunKey run_key{.options = request.options,
                 .alpha = request.alpha,
                 .memory = request.memory,
                 .tile_size = request.tile_size.value_or(0),
                 .keep_tiles = request.keep_tiles};
  for (const PointSource& source : request.sources) {
    struct stat status {};
    if (stat(source.path.c_str(), &status) != 0) refuse_to_open(source.path, "a file of points");
    if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))  // folders are refused when they are read
      bad_input(source.path, "a pipe, a socket or a device", "a regular file, as it is read twice");
    constexpr std::int64_t second = 1'000'000'000;
    run_key.inputs.push_back({absolute(source.path), static_cast<std::uint64_t>(status.st_size),
                              status.st_mtim.tv_sec * second + status.st_mtim.tv_nsec});
  }
  for (const StreamTarget& target : request.targets) run_key.targets.push_back(absolute(target.path));
  return run_key;
}

void save(const Manifest& manifest, const Scratch& scratch) {
  Json json = {{"format", "scratch of rbpa stream"},
               {"version", version},
               {"question", json_of(manifest.run_key)},
               {"workers", manifest.workers},
               {"pass", static_cast<int>(manifest.pass)}};
  if (manifest.pass != Manifest::Pass::count) {
    json["points"] = manifest.points;
    add_facts(json, manifest.facts);
    json["tree"] = json_of(manifest.tree);
    json["files_done"] = manifest.files_done;
    json["next_index"] = manifest.next_index;
    json["tiles"] = json_of(manifest.tiles);
  }
  replace_checked(scratch.manifest(), json.dump());
}

Manifest load_manifest(const Scratch& scratch, const RunKey& run_key) {
  const std::string text = checked_content(scratch.manifest());
  try {
    const Json json = Json::parse(text);
    if (json.at("version") != version)
      throw std::runtime_error("version " + json.at("version").dump() + ", not " + std::to_string(version));
    require_same(json.at("question"), run_key, scratch.folder());
    Manifest manifest;
    manifest.run_key = run_key;
    manifest.workers = json.at("workers");
    const int pass = json.at("pass");
    require(0 <= pass && pass <= static_cast<int>(Manifest::Pass::compute), "an unknown pass");
    require(manifest.workers > 0, "no workers");
    manifest.pass = static_cast<Manifest::Pass>(pass);
    if (manifest.pass == Manifest::Pass::count) return manifest;
    manifest.points = json.at("points");
    read_facts(json, manifest.facts);
    manifest.tree = tree_of(json.at("tree"));
    manifest.files_done = json.at("files_done");
    manifest.next_index = json.at("next_index");
    manifest.tiles = tiles_of(json.at("tiles"));
    require(manifest.files_done <= run_key.inputs.size(), "more files than there are");
    require(manifest.next_index <= manifest.points, "next_index above the number of points");
    const bool has_tiles = manifest.pass == Manifest::Pass::compute || manifest.files_done > 0;
    require(manifest.tiles.size() == (has_tiles ? manifest.tree.tiles() : 0), "files of other tiles");
    std::uint64_t owned = 0;
    for (const TileSummary& tile : manifest.tiles) {
      require(tile.owned <= tile.points && tile.owned <= manifest.points - owned,
              "tiles of more points than there are");
      owned += tile.owned;
    }
    require(manifest.pass != Manifest::Pass::compute || owned == manifest.points,
            "tiles of fewer points than there are");
    return manifest;
  } catch (const WrongUsage&) {
    throw;
  } catch (const std::exception& error) {
    begin_anew(scratch.manifest(), "no manifest of rbpa stream (" + std::string(error.what()) + "), expected one",
               scratch.folder());
  }
}

}  // namespace rbpa::app
