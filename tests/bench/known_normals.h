// What: points in space whose normals are known: on bodies, sheets and nested bodies, by formulas; and scans and models
//       of the collection.
// Law:  a set is a function of the arguments alone, except for the last bits of sines and cosines.
#pragma once

#include <string>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_bench {

struct KnownNormals {
  std::string name;
  std::vector<rbpa::Point3> points = {}, normals = {};  ///< normals point outward, on sheets upward
};

/// Returns the sets by formulas. Noise is in spacings, along the normal.
std::vector<KnownNormals> bodies_with_normals();

/// Returns the sets of the further data that have normals, if there are any.
std::vector<KnownNormals> scans_with_normals();

}  // namespace rbpa_bench
