// What: the sites in the cells around one, and which of them a site need look at.
// Law:  in single precision, rounded to the safe side: what is left out takes nothing away. docs/surface.md, section 5.
// How:  offsets in radii from one of the sites, coordinate by coordinate. Compiled once for each kind of vector unit; no include
//       guard but the compiler's own per kind.
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

#include "rbpa/base/lanes/mask_bits-inl.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/star/reach-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class Surroundings {
 public:
  /// At least the square of two radii, in radii, whatever is rounded.
  static constexpr float whole = 4.0001F;

  /// Replaces what is there by the sites in the cells around one.
  void gather(const Cells& cells, Cells::Around& around, std::size_t cell) {
    const std::span<const Point3> sites = cells.sites();
    origin_ = sites[cells.first_in(cell)];
    inverse_ = 1 / cells.radius();
    count_ = 0;
    around.for_each_run(cell, [&](Site begin, Site end) { append(sites, begin, end); });
    // What is read beyond the end is as far as can be.
    reserve(count_ + lanes);
    std::fill_n(x_.begin() + static_cast<std::ptrdiff_t>(count_), lanes, std::numeric_limits<float>::infinity());
  }

  /// All sites that were gathered.
  std::span<const Site> sites() const { return {site_.data(), count_}; }

  /// The sites at distances whose squares are at most `square`, in radii; v may be among them. The span lasts until the next
  /// call. Returns also how many there are within two radii, about.
  struct Near {
    std::span<const Site> sites;
    std::size_t all;
  };
  Near within(const Point3& v, float square) {
    look_from(v);
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

  /// Calls take(site) for the sites at distances whose squares are above `from` and at most `to`, in radii, of the site that was
  /// looked from last, that may take something away from a region of that reach; it may change meanwhile for a smaller region.
  /// Stops when take() returns false, which is returned.
  template <typename Take>
  bool for_each_reaching(const Reach& reach, float from, float to, Take take) {
    for (std::size_t i = 0; i < count_; i += hn::Lanes(f)) {
      const Seen p = seen(i);
      auto wanted = hn::And(p.square > hn::Set(f, from), p.square <= hn::Set(f, to));
      if (reach.is_told()) {
        auto reached = p.square < hn::Zero(f);
        const auto quarter = hn::Mul(p.square, hn::Set(f, 0.25F));
        for (const Reach::Part& part : reach.parts()) {
          const auto along = hn::MulAdd(p.x, hn::Set(f, part.x),
                                        hn::MulAdd(p.y, hn::Set(f, part.y), hn::Mul(p.z, hn::Set(f, part.z))));
          reached = hn::Or(reached, hn::Add(along, hn::Set(f, part.margin)) > quarter);
        }
        wanted = hn::And(wanted, reached);
      }
      for (std::uint64_t left = bits(wanted); left != 0; left &= left - 1)
        if (!take(site_[i + static_cast<std::size_t>(std::countr_zero(left))])) return false;
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

  void look_from(const Point3& v) {
    from_x_ = static_cast<float>((v.x - origin_.x) * inverse_);
    from_y_ = static_cast<float>((v.y - origin_.y) * inverse_);
    from_z_ = static_cast<float>((v.z - origin_.z) * inverse_);
  }

  /// The same bits whenever it is asked.
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
      // Whole vectors are read and stored: there is room, but for the last sites of all.
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
}  // namespace HWY_NAMESPACE
}  // namespace rbpa::space
HWY_AFTER_NAMESPACE();

#endif
