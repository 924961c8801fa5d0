#include "oracle/gudhi_betti.h"

#include <iostream>  // GUDHI's headers use it

#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <vector>

namespace rbpa_test {

std::array<std::size_t, 3> gudhi_betti(std::span<const std::array<std::uint32_t, 4>> tetrahedra) {
  using Tree = Gudhi::Simplex_tree<>;
  Tree tree;
  for (const auto& t : tetrahedra) tree.insert_simplex_and_subfaces(std::vector<int>(t.begin(), t.end()), 0.0);
  tree.initialize_filtration();
  Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp> cohomology(tree);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0);
  std::array<std::size_t, 3> numbers{};
  for (int dimension = 0; dimension < 3; ++dimension)
    numbers[static_cast<std::size_t>(dimension)] = static_cast<std::size_t>(cohomology.betti_number(dimension));
  return numbers;
}

}  // namespace rbpa_test
