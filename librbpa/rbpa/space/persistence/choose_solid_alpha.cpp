#include "rbpa/space/persistence/choose_solid_alpha.h"

#include "rbpa/space/solid/solid_radii.h"

namespace rbpa {

ChosenSolidAlpha choose_solid_alpha(const AlphaChoice& choice, std::span<const Point3> points, const Solid& delaunay,
                                    std::span<const double> radii, const GoOn& go_on, unsigned threads) {
  if (choice.rule == AlphaRule::given) return {.alpha = choice.radius};
  if (choice.rule == AlphaRule::least) return {.alpha = min_alpha(delaunay, radii, choice.cover, go_on)};
  if (choice.rule == AlphaRule::automatic) return {.alpha = auto_alpha(delaunay, radii, choice.cover, go_on, threads)};
  ChosenSolidAlpha chosen{.plateaus = solid_plateaus(points, delaunay, radii, go_on, threads)};
  chosen.alpha = alpha_of_rank(choice, chosen.plateaus).value_or(chosen.alpha);
  return chosen;
}

}  // namespace rbpa
