// What: the files that GDAL makes, among those that a run writes.
#pragma once

#include <vector>

#include "cli/run.h"
#include "io/polygon/ogr.h"

namespace rbpa::app {

/// Adds all of GDAL's files of a target, those that GDAL has made. Throws Failure where an old one would be left beside them.
void add_ogr(Run& run, const Target& target, const std::vector<OgrFile>& files);

}  // namespace rbpa::app
