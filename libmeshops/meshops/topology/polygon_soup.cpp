#include "meshops/topology/polygon_soup.h"

#include <algorithm>
#include <functional>
#include <string>

#include "meshops/core/contract.h"

namespace meshops {
namespace {

[[noreturn]] void refuse(const PolygonSoup& soup, std::size_t at, const std::string& expected) {
  throw ContractViolation("PolygonSoup: begin[" + std::to_string(at) + "] is " + std::to_string(soup.begin[at]) +
                          "; expected " + expected);
}

}  // namespace

void require_parted(const PolygonSoup& soup) {
  const auto& begin = soup.begin;
  require(!begin.empty(), "PolygonSoup: begin is empty; expected 0, and then the end of each face");
  if (begin.front() != 0) refuse(soup, 0, "0");
  if (const auto drop = std::adjacent_find(begin.begin(), begin.end(), std::greater<>()); drop != begin.end()) {
    const auto at = static_cast<std::size_t>(drop - begin.begin());
    refuse(soup, at + 1, "no less than begin[" + std::to_string(at) + "], which is " + std::to_string(*drop));
  }
  if (begin.back() != soup.corners.size())
    refuse(soup, begin.size() - 1, std::to_string(soup.corners.size()) + ", the number of corners, as it is the last");
}

}  // namespace meshops
