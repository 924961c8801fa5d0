// What:   restricted ball pivoting as a policy of the advancing-front engine.
// Law:    proposes exactly the triangles of the solid alpha complex.
// Source: Restricted BPA, section 3.2.
#pragma once

#include <array>
#include <optional>

#include "meshops/front/policy.h"
#include "rbpa/pivot/front_pivot.h"
#include "rbpa/seed/seeds.h"

namespace rbpa {

/// `Observer` has a member searched(front), which is called while seeds are searched, and may throw to end the run.
template <typename Real, typename Observer>
class RestrictedBallPivoting {
 public:
  /// Keeps references.
  RestrictedBallPivoting(Seeds<Real>& seeds, const Pivot<Real>& pivot, Observer& observer)
      : seeds_(seeds), pivot_(pivot), observer_(observer) {}

  std::optional<std::array<meshops::Site, 3>> seed(const meshops::Front& front) {
    return seeds_.next(front, [&] { observer_.searched(front); });
  }

  std::optional<meshops::Site> propose(const meshops::Front& front, meshops::Halfedge h) const {
    return pivot_on(pivot_, front, h);
  }

 private:
  Seeds<Real>& seeds_;
  const Pivot<Real>& pivot_;
  Observer& observer_;
};

}  // namespace rbpa
