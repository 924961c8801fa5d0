#include "io/cloud/copc.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_set>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/scalar.h"

namespace rbpa::app {
namespace {

/// A cube of the octree: a number on each axis from 0 to 2^level − 1.
struct Key {
  std::int32_t level;
  std::array<std::int32_t, 3> place;

  static constexpr std::int32_t most_levels = 30;
  bool is_valid() const {
    return level >= 0 && level <= most_levels &&
           std::all_of(place.begin(), place.end(), [&](std::int32_t k) { return k >= 0 && k >> level == 0; });
  }
  bool is_in(const Key& cube) const {
    if (level < cube.level) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (place[k] >> (level - cube.level) != cube.place[k]) return false;
    return true;
  }
  std::string text() const {
    std::string text = std::to_string(level);
    for (const std::int32_t k : place) (text += '-') += std::to_string(k);
    return text;
  }
};

struct Page {
  std::uint64_t begin, size;
  Key cube;             // contains all nodes of the page
  std::uint64_t entry;  // the byte that names the page
};

class Search {
 public:
  Search(const Content& content, std::string_view info, const std::array<double, 3>& scale, const PointWindow& window)
      : content_(content), bounds_(window.bounds) {
    constexpr std::size_t size = 160;
    if (info.size() < size)
      bad_input(content.name(), "a record of COPC of " + counted(info.size(), "byte"), std::to_string(size));
    const auto number = [&](std::size_t at) { return load_little<double>(&info[8 * at]); };
    half_ = number(3);
    const double spacing = number(4);
    bool finite = std::isfinite(half_) && half_ > 0 && std::isfinite(spacing) && spacing > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      center_[k] = number(k);
      finite = finite && std::isfinite(center_[k]);
      // The errors by rounding of the cube, and of points at its sides, are far below this margin.
      margin_[k] = std::abs(scale[k]) + 1e-9 * (half_ + std::abs(center_[k]));
    }
    if (!finite)
      bad_input(content.name(),
                "a cube of COPC with the half side " + text_of(half_) + " and the spacing " + text_of(spacing),
                "finite numbers above 0");
    if (window.resolution)
      while (deepest_ < Key::most_levels && std::ldexp(spacing, -deepest_) > *window.resolution) ++deepest_;
    else
      deepest_ = Key::most_levels;
    add_page({load_little<std::uint64_t>(&info[40]), load_little<std::uint64_t>(&info[48]), {0, {0, 0, 0}}, 0});
  }

  std::vector<LazNode> run() {
    for (std::size_t i = 0; i < pages_.size(); ++i) read(Page(pages_[i]));
    std::sort(nodes_.begin(), nodes_.end(), [](const LazNode& a, const LazNode& b) { return a.begin < b.begin; });
    return std::move(nodes_);
  }

 private:
  static constexpr std::size_t entry_size = 32;

  [[noreturn]] void refuse(std::uint64_t at, const std::string& found, const std::string& expected) const {
    bad_input(content_.name() + ": byte " + std::to_string(at), found,
              expected + " (without --bounds and --resolution the hierarchy is not read)");
  }

  void add_page(const Page& page) {
    const std::uint64_t size = content_.size();
    const std::string found =
        "a page of the hierarchy of " + counted(page.size, "byte") + " from byte " + std::to_string(page.begin) + " on";
    if (page.size == 0 || page.size % entry_size != 0 || page.begin > size || page.size > size - page.begin)
      refuse(page.entry, found, "one of entries of 32 bytes that ends within the file, of " + counted(size, "byte"));
    all_ += page.size;
    if (!begins_.insert(page.begin).second || all_ > size) refuse(page.entry, found, "a page that is not in another");
    pages_.push_back(page);
  }

  void read(const Page& page) {
    constexpr std::size_t at_once = 2048 * entry_size;
    Content entries = content_.again();
    entries.skip(page.begin);
    for (std::uint64_t done = 0; done < page.size;) {
      stop_if_interrupted();
      const std::size_t wanted = std::min<std::uint64_t>(at_once, page.size - done);
      const std::string_view bytes = entries.ahead(wanted).substr(0, wanted);
      if (bytes.size() < wanted)
        refuse(page.begin + done, "the end of the file", "a page of the hierarchy of " + counted(page.size, "byte"));
      for (std::size_t at = 0; at < wanted; at += entry_size) take(&bytes[at], page, page.begin + done + at);
      entries.skip(wanted);
      done += wanted;
    }
  }

  void take(const char* entry, const Page& page, std::uint64_t at) {
    const auto number = [&](std::size_t k) { return load_little<std::int32_t>(entry + 4 * k); };
    const Key key{number(0), {number(1), number(2), number(3)}};
    const auto begin = load_little<std::uint64_t>(entry + 16);
    const std::int32_t size = number(6), points = number(7);
    if (!key.is_valid() || !key.is_in(page.cube))
      refuse(at, "a node " + key.text(), "one in the cube " + page.cube.text() + " of its page");
    if (size < 0 || points < -1)
      refuse(at, "a node of " + std::to_string(points) + " points in " + std::to_string(size) + " bytes",
             "numbers from 0 on, or -1 points for a page");
    if (key.level > deepest_ || !meets(key) || points == 0) return;
    if (points < 0)
      add_page({begin, static_cast<std::uint64_t>(size), key, at});
    else
      nodes_.push_back({begin, static_cast<std::uint64_t>(size), static_cast<std::size_t>(points), at});
  }

  bool meets(const Key& key) const {
    if (!bounds_) return true;
    const double side = std::ldexp(half_, 1 - key.level);
    for (std::size_t k = 0; k < 3; ++k) {
      const double least = center_[k] - half_ + side * key.place[k];
      if (least - margin_[k] > bounds_->greatest[k] || least + side + margin_[k] < bounds_->least[k]) return false;
    }
    return true;
  }

  const Content& content_;
  std::optional<PointBox> bounds_;
  std::array<double, 3> center_ = {}, margin_ = {};
  double half_ = 0;
  int deepest_ = 0;  // level
  std::vector<Page> pages_ = {};
  std::unordered_set<std::uint64_t> begins_ = {};  // where pages begin
  std::uint64_t all_ = 0;                          // sum of the sizes of pages, in bytes
  std::vector<LazNode> nodes_ = {};
};

}  // namespace

std::vector<LazNode> find_copc_nodes(const Content& content, std::string_view info, const std::array<double, 3>& scale,
                                     const PointWindow& window) {
  return Search(content, info, scale, window).run();
}

}  // namespace rbpa::app
