// What: gathers the sites in the cells around a cell, and selects those that can change the free region of a site.
// Law:  single precision, rounded to the safe side: a site that is left out changes nothing.
//       docs/explanation/surfaces.md, section 13.
// How:  offsets from one of the sites, in radii, one array for each coordinate. Compiled once for each kind of vector
//       unit: Highway's toggle is the include guard.
#if defined(RBPA_SPACE_STAR_SURROUNDINGS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_SURROUNDINGS_INL_H_
#undef RBPA_SPACE_STAR_SURROUNDINGS_INL_H_
#else
#define RBPA_SPACE_STAR_SURROUNDINGS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/surface/star/bounding_cones-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class Surroundings {
 public:
  /// The square of two radii, in squared radii, rounded up by more than any error of seen().
  static constexpr float whole = 4.0001F;

  /// Replaces the sites by those in the cells around `cell`.
  void gather(const Cells& cells, Cells::Around& around, std::size_t cell) {
    const std::span<const Point3> sites = cells.sites();
    origin_ = sites[cells.first_in(cell)];
    inverse_ = 1 / cells.radius();
    count_ = 0;
    around.for_each_run(cell, [&](Site begin, Site end) { append(sites, begin, end); });
    // Whole vectors are read: lanes beyond the end are at infinity.
    reserve(count_ + lanes);
    std::fill_n(x_.begin() + static_cast<std::ptrdiff_t>(count_), lanes, std::numeric_limits<float>::infinity());
  }

  /// Returns all sites around the cell.
  std::span<const Site> sites() const { return {site_.data(), count_}; }

  /// The sites near a point, itself included, and the number of all sites within about two radii of it.
  struct Near {
    std::span<const Site> sites;
    std::size_t all;
  };
  /// Returns the sites whose squared distance from v is at most `square`, in squared radii. The result is valid until
  /// the next call.
  Near within(const Point3& v, float square) {
    set_viewpoint(v);
    near_.resize(count_ + lanes);
    std::size_t near = 0, all = 0;
    for (std::size_t i = 0; i < count_; i += hn::Lanes(f)) {
      const auto squares = seen(i).square;
      all += static_cast<std::size_t>(std::popcount(bits(squares <= hn::Set(f, whole))));
      for (std::uint64_t left = bits(squares <= hn::Set(f, square)); left != 0; left &= left - 1)
        near_[near++] = site_[i + static_cast<std::size_t>(std::countr_zero(left))];
    }
    return {{near_.data(), near}, all};
  }

  /// Calls visit(site) for the sites whose squared distance from the v of the last within() is above `from` and at most
  /// `to`, in squared radii, and whose cap may meet a cone of `bound`; visit() may shrink `bound`. Stops and returns
  /// false when visit() returns false.
  template <typename Visit>
  bool for_each_candidate(const BoundingCones& bound, float from, float to, Visit visit) {
    // A vector of at most 16 sites is tested against each cone: lane k is the site i + k, relative to v.
    //
    //   x y z          │ p        │ p'       │ …  at most 16 sites
    //   cone: middle   │ M        │ M        │ …  M · p + margin > p²/4 where p's cap may meet it
    for (std::size_t i = 0; i < count_; i += hn::Lanes(f)) {
      const Seen p = seen(i);
      auto wanted = hn::And(p.square > hn::Set(f, from), p.square <= hn::Set(f, to));
      if (bound.is_bounded()) {
        auto meets = p.square < hn::Zero(f);  // no lane meets a cone yet
        const auto quarter = hn::Mul(p.square, hn::Set(f, 0.25F));
        for (const BoundingCones::Cone& cone : bound.cones()) {
          const auto along = hn::MulAdd(p.x, hn::Set(f, cone.x),
                                        hn::MulAdd(p.y, hn::Set(f, cone.y), hn::Mul(p.z, hn::Set(f, cone.z))));
          meets = hn::Or(meets, hn::Add(along, hn::Set(f, cone.margin)) > quarter);
        }
        wanted = hn::And(wanted, meets);
      }
      for (std::uint64_t left = bits(wanted); left != 0; left &= left - 1)
        if (!visit(site_[i + static_cast<std::size_t>(std::countr_zero(left))])) return false;
    }
    return true;
  }

 private:
  static constexpr hn::CappedTag<float, 16> f{};
  static constexpr std::size_t lanes = 16;
  struct Seen {
    hn::Vec<hn::CappedTag<float, 16> > x, y, z, square;
  };

  static std::uint64_t bits(hn::Mask<hn::CappedTag<float, 16> > mask) {
    return rbpa::HWY_NAMESPACE::bits_of(hn::CappedTag<float, 16>(), mask);
  }

  void set_viewpoint(const Point3& v) {
    from_x_ = static_cast<float>((v.x - origin_.x) * inverse_);
    from_y_ = static_cast<float>((v.y - origin_.y) * inverse_);
    from_z_ = static_cast<float>((v.z - origin_.z) * inverse_);
  }

  /// Returns sites i, i + 1, … relative to v. Each call gives the same bits, so that there is no gap between shells of
  /// squared distances.
  HWY_INLINE Seen seen(std::size_t i) const {
    const auto x = hn::Sub(hn::LoadU(f, &x_[i]), hn::Set(f, from_x_)),
               y = hn::Sub(hn::LoadU(f, &y_[i]), hn::Set(f, from_y_)),
               z = hn::Sub(hn::LoadU(f, &z_[i]), hn::Set(f, from_z_));
    return {x, y, z, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)))};
  }

  void reserve(std::size_t most) {
    if (x_.size() >= most) return;
    for (auto* of : {&x_, &y_, &z_}) of->resize(most + most / 2);
    site_.resize(most + most / 2);
  }

  void append(std::span<const Point3> sites, Site begin, Site end) {
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> single;
    const hn::Rebind<std::uint32_t, decltype(d)> numbers;
    reserve(count_ + (end - begin) + lanes);
    const auto inverse = hn::Set(d, inverse_);
    while (begin < end) {
      const std::size_t at_once = std::min<std::size_t>(hn::Lanes(d), end - begin);
      // Whole vectors are read and stored: reserve() left room, but after the last sites there is nothing to read.
      if (begin + hn::Lanes(d) <= sites.size()) {
        hn::Vec<decltype(d)> x, y, z;
        hn::LoadInterleaved3(d, &sites[begin].x, x, y, z);
        const auto offset = [&](auto of, double origin) {
          return hn::DemoteTo(single, hn::Mul(hn::Sub(of, hn::Set(d, origin)), inverse));
        };
        hn::StoreU(offset(x, origin_.x), single, &x_[count_]);
        hn::StoreU(offset(y, origin_.y), single, &y_[count_]);
        hn::StoreU(offset(z, origin_.z), single, &z_[count_]);
        hn::StoreU(hn::Iota(numbers, begin), numbers, &site_[count_]);
      } else {
        for (std::size_t k = 0; k < at_once; ++k) {
          const Point3& p = sites[begin + k];
          x_[count_ + k] = static_cast<float>((p.x - origin_.x) * inverse_);
          y_[count_ + k] = static_cast<float>((p.y - origin_.y) * inverse_);
          z_[count_ + k] = static_cast<float>((p.z - origin_.z) * inverse_);
          site_[count_ + k] = begin + static_cast<Site>(k);
        }
      }
      count_ += at_once;
      begin += static_cast<Site>(at_once);
    }
  }

  Point3 origin_{};
  double inverse_ = 0;
  float from_x_ = 0, from_y_ = 0, from_z_ = 0;
  std::vector<float> x_, y_, z_;
  std::vector<Site> site_, near_;
  std::size_t count_ = 0;
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
