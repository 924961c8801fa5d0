// What: adds the files that GDAL makes to the output files of a run.
#pragma once

#include <vector>

#include "io/polygon/ogr.h"
#include "shared/run.h"

namespace rbpa::app {

/// Adds `files`, which GDAL has made for a target, to the files of the run. Throws Failure if an old file of the
/// target, such as a .prj, would remain next to the new files; as Run::add() does.
void add_ogr(Run& run, const Target& target, const std::vector<OgrFile>& files);

}  // namespace rbpa::app
