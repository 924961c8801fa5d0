// Reads the reason for which an operation was refused.
#pragma once

#include <string>

#include "meshops/core/contract.h"

namespace meshops::test {

/// Returns the text of the contract violation that operate() throws; "done" when it throws none.
template <typename Operate>
std::string refusal(Operate operate) {
  try {
    operate();
  } catch (const ContractViolation& violation) {
    return violation.what();
  }
  return "done";
}

}  // namespace meshops::test
