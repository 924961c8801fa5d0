#include "tasks/run_facts.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/failure.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* format = "run of rbpa stream --tasks";
constexpr int version = 1;

}  // namespace

RunFacts facts_of(const Manifest& manifest) {
  char id[17];
  std::snprintf(id, sizeof id, "%016llx", static_cast<unsigned long long>(id_of(manifest)));
  return {.id = id,
          .alpha = manifest.run_key.alpha,
          .points = manifest.points,
          .tiles = manifest.tiles.size(),
          .of_points = manifest.facts};
}

Json json_of(const RunFacts& run) {
  Json json = {{"id", run.id}, {"alpha", run.alpha}, {"points", run.points}, {"tiles", run.tiles}};
  add_facts(json, run.of_points);
  return json;
}

RunFacts run_facts_of(const Json& json) {
  RunFacts run{.id = json.at("id"), .alpha = json.at("alpha"), .points = json.at("points"), .tiles = json.at("tiles")};
  read_facts(json, run.of_points);
  return run;
}

void save(const RunFacts& run, const std::string& path) {
  replace_checked(path, Json({{"format", format}, {"version", version}, {"run", json_of(run)}}).dump());
}

RunFacts load_run_facts(const std::string& path) {
  const std::string text = checked_content(path);
  const std::string expected = "the one that rbpa stream --tasks writes beside the folder of the tiles";
  if (text.empty()) bad_input(path, "no file, or an empty one", expected);
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != format) bad_input(path, "a file of another kind", expected);
    if (json.at("version") != version) bad_input(path, "version " + json.at("version").dump(), std::to_string(version));
    return run_facts_of(json.at("run"));
  } catch (const nlohmann::json::exception& error) {
    bad_input(path, "a file that was changed (" + shown(error.what()) + ")", expected);
  }
}

}  // namespace rbpa::app
