// What: the command line of `meshtopo`, from text to meaning.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

/// As given.
struct TopologyArguments {
  std::optional<std::string> mesh;
  std::optional<std::string> format;
  bool json = false;
  std::optional<std::string> output;
  std::optional<std::string> output_format;
  bool repair = false;
  std::string repaired;  ///< OUT of --repair; empty where it has none, and -o names the file
  std::optional<std::string> generators;
  std::string max_defects = "20";
  bool quiet = false;
};

/// A file to write; of a report as text or as json.
struct TopologyTarget {
  std::string path;  ///< "-" is standard output
  Format format;
};

/// What a run reads and writes.
struct TopologyPlan {
  MeshSource source;
  std::size_t max_defects;
  bool quiet;  ///< no progress
  std::optional<TopologyTarget> report = std::nullopt;
  std::optional<TopologyTarget> repaired = std::nullopt;
  std::optional<TopologyTarget> generators = std::nullopt;

  std::vector<std::string> outputs() const;  ///< of all three, in the order of writing
};

/// Throws WrongUsage naming the value.
TopologyPlan plan(TopologyArguments arguments);

}  // namespace rbpa::app
