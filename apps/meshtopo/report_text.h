// What: the report of meshtopo for people.
#pragma once

#include <cstddef>
#include <string>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// The genus as a number, or why there is none.
std::string genus_text(const meshops::TopologyReport& topology);

/// One number a line; pieces of surface when there are several; defects of topology and of geometry, and what repair
/// did, each up to `most` of them and how many more there are; which checks hold.
std::string report_text(const Findings& findings, std::size_t most);

}  // namespace rbpa::app
