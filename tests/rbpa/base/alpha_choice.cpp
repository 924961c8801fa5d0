#include "rbpa/base/alpha_choice.h"

#include <doctest/doctest.h>

#include <string>

#include "rbpa/base/error.h"

using rbpa::AlphaChoice;
using rbpa::AlphaRule;

TEST_SUITE_BEGIN("filtration");

TEST_CASE("a rule is parsed from its name, and has it") {
  CHECK(rbpa::parse_alpha_rule("auto") == AlphaChoice{.rule = AlphaRule::automatic});
  CHECK(rbpa::parse_alpha_rule("min") == AlphaChoice{.rule = AlphaRule::least});
  CHECK(rbpa::parse_alpha_rule("plateau") == AlphaChoice{.rule = AlphaRule::plateau});
  CHECK(rbpa::parse_alpha_rule("plateau:1") == AlphaChoice{.rule = AlphaRule::plateau});
  CHECK(rbpa::parse_alpha_rule("plateau:12") == AlphaChoice{.rule = AlphaRule::plateau, .rank = 12});
  for (const std::string name : {"auto", "min", "plateau", "plateau:2"}) {
    REQUIRE(rbpa::parse_alpha_rule(name));
    CHECK(rbpa::name_of(*rbpa::parse_alpha_rule(name)) == name);
  }
  CHECK(rbpa::name_of({.radius = 2}) == "given");
}

TEST_CASE("a text that names no rule is not parsed") {
  for (const std::string text : {"", "1", "inf", "given", "Auto", "auto ", "automatic", "minimum",
                                 "plateau:", "plateau:0", "plateau:-1", "plateau:+1", "plateau:1.5", "plateau:1 ",
                                 "plateau: 1", "plateau:x", "plateau:99999999999999999999", "plateaus", "column:r"})
    CHECK_MESSAGE(!rbpa::parse_alpha_rule(text), text);
  CHECK(!rbpa::parse_alpha_rule(std::string("auto\0", 5)));
}

TEST_CASE("each rule takes its own options") {
  CHECK(rbpa::takes_cover(AlphaRule::automatic));
  CHECK(rbpa::takes_cover(AlphaRule::least));
  CHECK(!rbpa::takes_cover(AlphaRule::plateau));
  CHECK(!rbpa::takes_cover(AlphaRule::given));
  CHECK(rbpa::takes_components(AlphaRule::automatic));
  CHECK(!rbpa::takes_components(AlphaRule::least));
  CHECK(!rbpa::takes_components(AlphaRule::plateau));
  CHECK(!rbpa::takes_components(AlphaRule::given));
}

TEST_CASE("a rank of 0 is refused, and one above the number of plateaus with that number") {
  const AlphaChoice fourth{.rule = AlphaRule::plateau, .rank = 4};
  CHECK_NOTHROW(rbpa::require_rank(fourth, 4));
  CHECK_THROWS_WITH_AS(rbpa::require_rank({.rule = AlphaRule::plateau, .rank = 0}, 4),
                       "alpha plateau:0: expected a rank of at least 1", rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(rbpa::require_rank(fourth, 3), "alpha plateau:4: there are only 3 plateaus", rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(rbpa::require_rank(fourth, 1), "alpha plateau:4: there is only 1 plateau", rbpa::InvalidInput);
}

TEST_SUITE_END();
