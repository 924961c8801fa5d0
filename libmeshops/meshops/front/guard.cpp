#include "meshops/front/guard.h"

#include "meshops/core/contract.h"

namespace meshops::detail {

void Guard::violated() const {
  require(counts_ != finished, "Front: the front is finished");
  throw ContractViolation("Front: the mesh was changed by others: it has " + describe(ElementCounts::of(mesh_)) +
                          "; expected " + describe(counts_));
}

void Guard::changed_while_called() const {
  throw ContractViolation(
      caller_ == Caller::policy
          ? "Front: the policy changed the front during a call"
          : "Front: the visitor changed the front while it was called, other than activate() and freeze() do");
}

}  // namespace meshops::detail
