#include "rbpa/plane/partial_bytes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "plane/partial/cuts.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/partial/crc64.h"
#include "rbpa/plane/partial/state.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/pictures.h"
#include "support/refusal_of.h"

using namespace rbpa_test;
using rbpa::Partial;

TEST_SUITE_BEGIN("partial");

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes text(const char* letters) { return {letters, letters + std::strlen(letters)}; }

const Picture picture = {"###...........",  //
                         "#.#...........",  //
                         "###...........",  //
                         "..............",  //
                         "...#..........",  //
                         "....##########",  //
                         "....#.########",  //
                         "....##########",  //
                         "..............",  //
                         "......########"};
const rbpa::Region left{-1, -99, 20, 99}, right{20, -99, 99, 99};

Partial part(const rbpa::Region& region) {
  return rbpa::partial(region, given(region, points_of(picture), picture_alpha), picture_alpha);
}

/// The left half of the picture fills every list: chains, rings of open components, a pinch that waits, a held polygon.
Partial with_all_lists() {
  Partial made = part(left);
  const rbpa::PartialState& state = made.state();
  REQUIRE(state.open.size() == 2);
  REQUIRE(state.open[0].rings.size() + state.open[1].rings.size() == 1);
  REQUIRE(state.chains.size() == 2);
  REQUIRE(state.pinches.size() == 1);
  REQUIRE(state.held.size() == 1);
  REQUIRE(state.polygons.size() == 1);
  REQUIRE(state.polygons[0].holes.size() == 1);
  return made;
}

std::string refusal(const Bytes& bytes) {
  return refusal_of<rbpa::InvalidInput>([&] { rbpa::partial_from_bytes(bytes); });
}

void sign(Bytes& bytes) {
  std::uint64_t crc = rbpa::crc64({bytes.data(), bytes.size() - 8});
  for (std::size_t i = 0; i < 8; ++i) bytes[bytes.size() - 8 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
}

void set_word(Bytes& bytes, std::size_t at, std::uint64_t value) {
  for (std::size_t i = 0; i < 8; ++i) bytes[8 * at + i] = static_cast<std::uint8_t>(value >> 8 * i);
}

}  // namespace

TEST_CASE("the checksum is that of the XZ format") {
  CHECK(rbpa::crc64(text("123456789")) == 0x995D'C9BB'DF19'39FA);
  CHECK(rbpa::crc64(text("")) == 0);
  CHECK(rbpa::crc64(text("This is a test of the emergency broadcast system.")) == 0x27DB'187F'C15B'BC72);
}

TEST_CASE("bytes preserve everything, and writing again gives the same bytes") {
  Partial without_holes = with_all_lists();
  CHECK(rbpa::take_holes(without_holes).size() == 1);
  for (const Partial& partial : {Partial(), with_all_lists(), without_holes}) {
    const Bytes bytes = rbpa::to_bytes(partial);
    const Partial read = rbpa::partial_from_bytes(bytes);
    CHECK(rbpa::to_bytes(read) == bytes);
    CHECK(read.alpha() == partial.alpha());
    CHECK(read.counts() == partial.counts());
    CHECK(read.rim() == partial.rim());
  }
}

TEST_CASE("a change of the format is noticed") {
  const Points square{{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}};
  const rbpa::Region region{-9, -9, 2, 9};
  const Bytes bytes = rbpa::to_bytes(rbpa::partial(region, given(region, square, 1.0), 1));
  CHECK(std::equal(bytes.begin(), bytes.begin() + 8, "RBPAPART"));
  CHECK(bytes.size() == 520);
  CHECK(rbpa::crc64({bytes.data(), bytes.size() - 8}) == 5'268'788'840'152'528'991U);
}

TEST_CASE("bytes that are truncated or have one bit changed are refused") {
  const Bytes bytes = rbpa::to_bytes(with_all_lists());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    REQUIRE(refusal({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}) != "");
  Bytes longer = bytes;
  longer.resize(longer.size() + 8);
  CHECK(refusal(longer).find("as its header says") != std::string::npos);
  Random random(2);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    Bytes changed = bytes;
    changed[at] = static_cast<std::uint8_t>(changed[at] ^ 1U << random.below(8));
    REQUIRE(refusal(changed) != "");
  }
}

TEST_CASE("a refusal names the problem") {
  const Bytes bytes = rbpa::to_bytes(with_all_lists());
  CHECK(refusal({}).find("RBPAPART") != std::string::npos);
  CHECK(refusal(Bytes(100, 7)).find("100 bytes that do not begin with RBPAPART") != std::string::npos);
  Bytes other = bytes;
  other[8] = 2;
  CHECK(refusal(other).find("version 2, expected 1") != std::string::npos);
  other = bytes;
  other[300] ^= 1U;
  CHECK(refusal(other).find("checksum") != std::string::npos);
  const auto with = [&](std::size_t word, double value) {
    Bytes changed = bytes;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, 8);
    set_word(changed, word, bits);
    sign(changed);
    return refusal(changed);
  };
  for (const double alpha : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    CHECK(with(3, alpha).find("a finite radius") != std::string::npos);
  CHECK(with(3, 0.0).find("an empty state without regions") != std::string::npos);
}

TEST_CASE(
    "bytes with a valid checksum are refused, or read and written again unchanged, and take no more memory than "
    "bytes") {
  Partial any = with_all_lists();
  SUBCASE("") {}
  SUBCASE("with holes taken") { CHECK(rbpa::take_holes(any).size() == 1); }
  const Bytes bytes = rbpa::to_bytes(any);
  const std::size_t words = bytes.size() / 8;
  Random random(3);
  const Partial rest = part(right);
  int refused = 0, read = 0, merged = 0;
  for (int run = 0; run < trials(20'000); ++run) {
    Bytes changed = bytes;
    for (int change = random.integer(1, 3); change > 0; --change) {
      const std::size_t at = 3 + random.below(words - 4);
      const std::uint64_t values[] = {
          0, 1, 2, 3, 0xffffffff, ~std::uint64_t{0}, random.below(1000), random.bits(), 0x7ff0000000000000};
      if (random.chance(0.3)) {
        const std::size_t from = 3 + random.below(words - 4);
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(8 * from), 8,
                    changed.begin() + static_cast<std::ptrdiff_t>(8 * at));
      } else {
        set_word(changed, at, values[random.below(std::size(values))]);
      }
    }
    sign(changed);
    try {
      const Partial made = rbpa::partial_from_bytes(changed);
      REQUIRE(rbpa::to_bytes(made) == changed);
      ++read;
      // Bytes that can be read can be merged, or are refused by merge().
      Partial with = made;
      rbpa::merge(std::move(with), Partial(rest));
      ++merged;
    } catch (const rbpa::InvalidInput&) {
      ++refused;
    }
  }
  CHECK(refused > 1000);
  CHECK(read > 1000);
  CHECK(merged > 1000);
  CHECK(merged < read);
}

TEST_SUITE_END();
