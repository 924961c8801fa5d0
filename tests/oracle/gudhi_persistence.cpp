#include "oracle/gudhi_persistence.h"

#include <CGAL/Epeck_d.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <tuple>

namespace rbpa_test {
namespace {

template <int dimension, bool weighted, typename Points>
std::vector<SquaredPair> pairs_of(const Points& points, [[maybe_unused]] std::span<const double> weights = {}) {
  using Kernel = CGAL::Epeck_d<CGAL::Dimension_tag<dimension>>;
  using Complex = Gudhi::alpha_complex::Alpha_complex<Kernel, weighted>;
  using Tree = Gudhi::Simplex_tree<>;
  std::vector<typename Kernel::Point_d> at;
  for (const auto& p : points) {
    if constexpr (dimension == 2)
      at.emplace_back(p.x, p.y);
    else
      at.emplace_back(p.x, p.y, p.z);
  }
  Complex alpha_complex = [&] {
    if constexpr (weighted)
      return Complex(at, std::vector<double>(weights.begin(), weights.end()));
    else
      return Complex(at);
  }();
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

}  // namespace

std::vector<SquaredPair> gudhi_persistence(std::span<const rbpa::Point> points) { return pairs_of<2, false>(points); }
std::vector<SquaredPair> gudhi_persistence(std::span<const rbpa::Point3> points) { return pairs_of<3, false>(points); }
std::vector<SquaredPair> gudhi_persistence(std::span<const rbpa::Point3> points, std::span<const double> weights) {
  return pairs_of<3, true>(points, weights);
}

}  // namespace rbpa_test
