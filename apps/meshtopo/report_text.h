// What: writes the report of meshtopo as text, for people.
#pragma once

#include <cstddef>
#include <string>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// Returns the genus as text, or the reason why there is none.
std::string genus_text(const meshops::TopologyReport& topology);

/// Returns the report: each number in a line; the components if there are several; topological and geometric defects,
/// and steps of the repair, at most `most` of each and the number of the others; and for each check whether it holds.
std::string report_text(const Findings& findings, std::size_t most);

}  // namespace rbpa::app
