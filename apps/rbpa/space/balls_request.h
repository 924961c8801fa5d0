// What: parses the command line of `rbpa balls`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/cloud/atom_frames.h"
#include "io/cloud/ball_radii.h"
#include "shared/arguments.h"
#include "shared/run.h"
#include "shared/verbs.h"

namespace rbpa::app {

/// The rows into which atoms are summed up.
enum class AtomGroups { none, residue, chain, column };

struct BallsRequest {
  std::string path;
  Format format;
  AtomChoice choice;
  BallRadii radii;
  double probe;
  AtomGroups groups = AtomGroups::none;
  bool has_frames;  ///< rows have the number of their frame
  std::vector<Target> targets;
  std::optional<Target> contacts;
  RunOptions run;
};

/// Parses the arguments; reads the file of --radii. Throws WrongUsage that names the option; BadInput, Failure.
BallsRequest parse(const BallsArguments& arguments);

}  // namespace rbpa::app
