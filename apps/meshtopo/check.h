// What: the properties that a mesh is to have, as --check names them, and whether it has them.
// Law:  every property is read off the report and the list of defects: what the report says decides, and nothing else.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshtopo/findings.h"

namespace rbpa::app {

/// Of "closed,genus=0": two. Throws WrongUsage that lists the properties there are.
std::vector<Check> parse_checks(const std::string& list);

CheckResult evaluate(const Check& check, const Examined& mesh);

/// "found 1 boundary curve, expected none", of a check that does not hold.
std::string failure_of(const CheckResult& result);

}  // namespace rbpa::app
