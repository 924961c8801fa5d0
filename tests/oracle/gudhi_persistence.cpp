#include "oracle/gudhi_persistence.h"

#include <CGAL/Epeck_d.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <tuple>

namespace rbpa_test {

std::vector<SquaredPair> gudhi_persistence(std::span<const rbpa::Point> points) {
  using Kernel = CGAL::Epeck_d<CGAL::Dimension_tag<2>>;
  using Tree = Gudhi::Simplex_tree<>;
  std::vector<Kernel::Point_d> at;
  for (const rbpa::Point& p : points) at.emplace_back(p.x, p.y);
  Gudhi::alpha_complex::Alpha_complex<Kernel> alpha_complex(at);
  Tree tree;
  alpha_complex.create_complex(tree, std::numeric_limits<double>::infinity(), /*exact=*/true);

  Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp> cohomology(tree);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0);
  std::vector<SquaredPair> pairs;
  for (const auto& [birth, death, field] : cohomology.get_persistent_pairs()) {
    SquaredPair pair{tree.dimension(birth), tree.filtration(birth)};
    if (death != tree.null_simplex()) pair.death = tree.filtration(death);
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace rbpa_test
