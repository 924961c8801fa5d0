// What: points of space whose normals are known: on bodies, sheets and nested bodies, by formulas, and scans and models of the collection.
// Law:  a function of the arguments alone, but for the last bits of sines and cosines.
#pragma once

#include <string>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_bench {

struct KnownNormals {
  std::string name;
  std::vector<rbpa::Point3> points = {}, normals = {};  ///< outward, of sheets upward
};

/// Those by formulas. Noise is in spacings, along the normal.
std::vector<KnownNormals> bodies_with_normals();

/// The sets of the further data that have normals; none where there are none.
std::vector<KnownNormals> scans_with_normals();

}  // namespace rbpa_bench
