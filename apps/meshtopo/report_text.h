// What: writes the report of meshtopo as text, for people.
#pragma once

#include <cstddef>
#include <string>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// Returns the genus as text, or the reason why the genus is undefined.
std::string genus_text(const meshops::TopologyReport& topology);

/// Returns the report: one line for each number; a table of the components if there are several; at most `most`
/// components, defects of either kind and repair steps, with the number of the others; changes and result; and for each
/// check whether it holds. Throws Cancelled.
std::string report_text(const Findings& findings, std::size_t most);

}  // namespace rbpa::app
