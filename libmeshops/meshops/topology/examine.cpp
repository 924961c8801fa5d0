#include "meshops/topology/examine.h"

#include "meshops/topology/soup_anatomy.h"

namespace meshops {

Examination examine(const PolygonSoup& soup, const GoOn& go_on) {
  detail::SoupAnatomy anatomy(soup, go_on);
  TopologyReport report = detail::report_of(anatomy, go_on);
  return {std::move(report), detail::defects_of(anatomy, go_on)};
}

}  // namespace meshops
