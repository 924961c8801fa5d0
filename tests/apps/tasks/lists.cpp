#include "tasks/lists.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "cli/verbs.h"
#include "io/bytes/number.h"

namespace tasks_test {

namespace fs = std::filesystem;

void cut(const apps_test::Folder& folder, double alpha, std::uint64_t tile_size) {
  rbpa::app::StreamArguments stream;
  stream.inputs = {folder.path("p.f64xy")};
  stream.radius.alpha = std::string(std::string_view(rbpa::app::ShortestText(alpha)));
  stream.outputs = {folder.path("t.npy"), folder.path("p.geojson"), folder.path("p.wkt")};
  stream.tile_size = std::to_string(std::max<std::uint64_t>(tile_size, 16));
  stream.stats = folder.path("s.json");
  stream.tasks = folder.path("tasks");
  stream.run.quiet = true;
  rbpa::app::run_stream(stream);
}

std::vector<std::vector<std::string>> lists_in(const std::string& tasks) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(tasks))
    if (entry.path().extension() == ".txt") names.push_back(entry.path());
  std::sort(names.begin(), names.end());
  std::vector<std::vector<std::string>> lists;
  for (const std::string& name : names) {
    std::ifstream file(name);
    lists.emplace_back();
    for (std::string line; std::getline(file, line);) lists.back().push_back(line);
  }
  return lists;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool in_word = false, quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (!quoted && c == ' ') {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (c == '\'')
      quoted = !quoted;
    else
      words.back() += !quoted && c == '\\' ? line[++i] : c;
  }
  return words;
}

void run_line(const std::string& line) {
  const std::vector<std::string> words = words_of(line);
  REQUIRE(words.size() > 3);
  rbpa::app::TileArguments tile;
  rbpa::app::MergeArguments merge;
  merge.quiet = tile.run.quiet = true;
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "-o") {
      tile.outputs.push_back(words[++i]);
      merge.outputs.push_back(words[i]);
    } else if (words[i] == "--threads") {
      tile.run.threads = words[++i];
    } else if (words[i] == "--stats") {
      merge.stats = words[++i];
    } else if (words[i] == "--memory") {
      merge.memory = words[++i];
    } else if (words[i] != "-q") {
      tile.tile = words[i];
      merge.partials.push_back(words[i]);
    }
  }
  if (words[1] == "tile") return rbpa::app::run_tile(tile);
  REQUIRE(words[1] == "merge");
  rbpa::app::run_merge(merge);
}

std::vector<std::string> partials_of_tiles(const std::string& tasks) {
  std::vector<std::string> partials;
  for (const auto& entry : fs::directory_iterator(tasks + "/partials"))
    if (entry.path().extension() == ".partial" && entry.path().filename().string().starts_with("1-"))
      partials.push_back(entry.path());
  std::sort(partials.begin(), partials.end());
  return partials;
}

void merge(const std::vector<std::string>& partials, const std::vector<std::string>& outputs,
           const std::optional<std::string>& stats) {
  rbpa::app::MergeArguments arguments;
  arguments.stats = stats;
  arguments.partials = partials;
  arguments.outputs = outputs;
  arguments.quiet = true;
  rbpa::app::run_merge(arguments);
}

}  // namespace tasks_test
