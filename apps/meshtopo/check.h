// What: parses and evaluates the properties that --check requires of a mesh.
// Law:  a property depends only on the topology report and the lists of defects.
#pragma once

#include <string>
#include <vector>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// Parses a comma-separated list of properties: "closed,genus=0" has two. Throws WrongUsage for an unknown property,
/// whose message lists all properties, and for a wrong value.
std::vector<Check> parse_checks(const std::string& list);

/// Returns whether Examined::crossings is required.
bool requires_crossings(const std::vector<Check>& checks);

/// Returns the list of all properties for help and messages: "closed, manifold, oriented, orientable, vertices=N, ...".
std::string known_checks();

/// Returns whether the mesh passes the check, and the texts of the message about it.
CheckResult evaluate(const Check& check, const Examined& mesh);

/// Returns the message for a check that fails: "closed: found 1 boundary curve, expected none".
std::string failure_of(const CheckResult& result);

}  // namespace rbpa::app
