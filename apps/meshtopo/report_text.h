// What: the report of meshtopo for people.
#pragma once

#include <cstddef>
#include <string>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// One number a line; pieces of surface when there are several; defects of topology and of geometry, and what repair
/// did, each up to `most` of them
/// and how many more there are.
std::string report_text(const Findings& findings, std::size_t most);

}  // namespace rbpa::app
