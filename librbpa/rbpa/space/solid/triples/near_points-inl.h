// What: gathers the points near a point v, those after v in the order of sites first, in single and double precision.
//       Compiled once for each kind of vector unit: Highway's toggle is the include guard.
#if defined(RBPA_SPACE_TRIPLES_NEAR_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_TRIPLES_NEAR_POINTS_INL_H_
#undef RBPA_SPACE_TRIPLES_NEAR_POINTS_INL_H_
#else
#define RBPA_SPACE_TRIPLES_NEAR_POINTS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/space/cells/cells.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Singles = hn::CappedTag<float, 16>;
using SingleNumbers = hn::RebindToSigned<Singles>;
using Doubles = hn::CappedTag<double, 8>;
using DoubleNumbers = hn::RebindToSigned<Doubles>;
inline constexpr std::size_t single_lanes = hn::MaxLanes(Singles()), double_lanes = hn::MaxLanes(Doubles());

/// The sites in the cells around a cell, in ascending order. Arrays are readable up to one register beyond their ends.
class Block {
 public:
  explicit Block(double alpha) : inverse_(1 / alpha) {}

  void gather(const Cells& cells, Cells::Around& around, std::size_t cell) {
    count_ = 0;
    const Site first_of_cell = cells.first_in(cell);
    const Point3* const points = cells.sites().data();
    const Point3 origin = points[first_of_cell];
    around.for_each_run<1>(cell, [&](Site first, Site last) {
      const std::size_t count = last - first;
      if (first <= first_of_cell && first_of_cell < last) own_ = count_ + (first_of_cell - first);
      reserve(count_ + count);
      float *const to_x = &x[count_], *const to_y = &y[count_], *const to_z = &z[count_];
      Site* const to_site = &sites[count_];
      for (std::size_t i = 0; i < count; ++i) {
        // Coordinates are in units of alpha, relative to the first point of the cell. They are below 8 for points near
        // a point of the cell, with an error of at most 2⁻²¹.
        const Point3& p = points[first + i];
        to_x[i] = static_cast<float>((p.x - origin.x) * inverse_);
        to_y[i] = static_cast<float>((p.y - origin.y) * inverse_);
        to_z[i] = static_cast<float>((p.z - origin.z) * inverse_);
        to_site[i] = first + static_cast<Site>(i);
      }
      count_ += count;
    });
  }
  std::size_t size() const { return count_; }
  /// Returns the position in the block of the first site of the central cell.
  std::size_t own() const { return own_; }

  std::vector<float> x, y, z;
  std::vector<Site> sites;

 private:
  void reserve(std::size_t count) {
    if (count + single_lanes <= x.size()) return;
    const std::size_t size = 2 * count + single_lanes;
    for (auto* const values : {&x, &y, &z}) values->resize(size);
    sites.resize(size);
  }

  double inverse_;
  std::size_t count_ = 0, own_ = 0;
};

/// The points within 2 alpha of a point v, and possibly a few others, relative to v. Points after v in the order of
/// sites come first, then those before v, each in this order. Arrays are readable up to one register beyond their ends.
class NearPoints {
 public:
  explicit NearPoints(double alpha) : inverse_(1 / alpha) {}

  /// Gathers the points near v, the point at position `at` of the block.
  HWY_INLINE void gather(const Block& block, std::size_t at, std::span<const Point3> points) {
    reserve(block.size());
    after_ = list(block, at, at + 1, block.size(), 0);
    count_ = list(block, at, 0, at, after_);
    const Doubles d;
    const hn::Rebind<std::uint32_t, Doubles> du;
    const DoubleNumbers dn;
    const hn::Rebind<float, Doubles> few;
    const Point3& v = points[block.sites[at]];
    static_assert(sizeof(Point3) == 3 * sizeof(double));
    const double* const coordinates = &points.data()->x;
    const auto scale = hn::Set(d, inverse_), vx = hn::Set(d, v.x), vy = hn::Set(d, v.y), vz = hn::Set(d, v.z);
    for (std::size_t i = count_; i < count_ + double_lanes; ++i) sites[i] = 0;
    for (std::size_t i = 0; i < count_; i += double_lanes) {
      const auto number = hn::BitCast(dn, hn::PromoteTo(hn::RebindToUnsigned<Doubles>(), hn::LoadU(du, &sites[i])));
      const auto from = hn::Add(number, hn::Add(number, number));
      const auto px = hn::Sub(hn::GatherIndex(d, coordinates, from), vx);
      const auto py = hn::Sub(hn::GatherIndex(d, coordinates + 1, from), vy);
      const auto pz = hn::Sub(hn::GatherIndex(d, coordinates + 2, from), vz);
      hn::StoreU(px, d, &dx[i]);
      hn::StoreU(py, d, &dy[i]);
      hn::StoreU(pz, d, &dz[i]);
      const auto sx = hn::DemoteTo(few, hn::Mul(px, scale)), sy = hn::DemoteTo(few, hn::Mul(py, scale)),
                 sz = hn::DemoteTo(few, hn::Mul(pz, scale));
      hn::StoreU(sx, few, &x[i]);
      hn::StoreU(sy, few, &y[i]);
      hn::StoreU(sz, few, &z[i]);
      hn::StoreU(hn::MulAdd(sx, sx, hn::MulAdd(sy, sy, hn::Mul(sz, sz))), few, &square[i]);
    }
  }

  std::size_t size() const { return count_; }
  std::size_t after() const { return after_; }

  std::vector<double> dx, dy, dz;      ///< coordinates of the offsets from v, each rounded once
  std::vector<float> x, y, z, square;  ///< offsets in units of alpha, and their squared lengths
  std::vector<Site> sites;

 private:
  /// Writes the sites at positions from … to − 1 of the block that are near the site at position `at`, after the first
  /// `count` sites. Returns the new number of sites.
  HWY_INLINE std::size_t list(const Block& block, std::size_t at, std::size_t from, std::size_t to, std::size_t count) {
    const Singles d;
    const hn::RebindToUnsigned<Singles> du;
    const auto vx = hn::Set(d, block.x[at]), vy = hn::Set(d, block.y[at]), vz = hn::Set(d, block.z[at]);
    const auto farthest = hn::Set(d, 4 + 0x1p-14f);  // with room for the rounding errors
    const float *const bx = block.x.data(), *const by = block.y.data(), *const bz = block.z.data();
    const Site* const all = block.sites.data();
    Site* const listed = sites.data();
    for (std::size_t i = from; i < to; i += single_lanes) {
      const auto px = hn::Sub(hn::LoadU(d, bx + i), vx), py = hn::Sub(hn::LoadU(d, by + i), vy),
                 pz = hn::Sub(hn::LoadU(d, bz + i), vz);
      auto is_near = hn::Le(hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz))), farthest);
      if (to - i < single_lanes) is_near = hn::And(is_near, hn::FirstN(d, to - i));
      hn::StoreU(hn::Compress(hn::LoadU(du, all + i), hn::RebindMask(du, is_near)), du, listed + count);
      count += hn::CountTrue(d, is_near);
    }
    return count;
  }
  void reserve(std::size_t count) {
    if (count + 2 * single_lanes <= dx.size()) return;
    const std::size_t size = 2 * count + 2 * single_lanes;
    for (auto* const values : {&dx, &dy, &dz}) values->resize(size);
    for (auto* const values : {&x, &y, &z, &square}) values->resize(size);
    sites.resize(size);
  }

  double inverse_;
  std::size_t count_ = 0, after_ = 0;
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
