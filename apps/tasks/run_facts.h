// What: the facts about a run that each of its tasks needs, in a file of its folder and at the head of each partial.
// Cost: the same for any number of tiles. The format is in docs/tasks.md.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "stream/manifest.h"

namespace rbpa::app {

struct RunFacts {
  std::string id;  ///< that of id_of(), as 16 hexadecimal digits
  double alpha = 0;
  std::uint64_t points = 0, tiles = 0;
  PointsFacts of_points = {};
};

RunFacts facts_of(const Manifest& manifest);

nlohmann::ordered_json json_of(const RunFacts& run);
/// Throws what the library of JSON throws where it is none of these.
RunFacts run_facts_of(const nlohmann::ordered_json& json);

void save(const RunFacts& run, const std::string& path);
/// Throws BadInput.
RunFacts load_run_facts(const std::string& path);

}  // namespace rbpa::app
