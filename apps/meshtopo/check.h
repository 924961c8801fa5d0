// What: parses and evaluates the properties that --check requires of a mesh.
// Law:  properties follow from the report and the list of defects alone.
#pragma once

#include <string>
#include <vector>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// Parses a comma-separated list of properties: "closed,genus=0" has two. Throws WrongUsage that lists the known
/// properties.
std::vector<Check> parse_checks(const std::string& list);

/// Returns the properties for help and messages: "closed, manifold, oriented, orientable, vertices=N, ...".
std::string known_checks();

/// Returns whether the mesh passes the check, and the texts for a message.
CheckResult evaluate(const Check& check, const Examined& mesh);

/// Returns the message for a check that does not hold: "closed: found 1 boundary curve, expected none".
std::string failure_of(const CheckResult& result);

}  // namespace rbpa::app
