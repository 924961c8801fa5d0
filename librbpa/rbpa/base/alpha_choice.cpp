#include "rbpa/base/alpha_choice.h"

#include <charconv>
#include <system_error>

#include "rbpa/base/error.h"

namespace rbpa {

std::optional<AlphaChoice> parse_alpha_rule(std::string_view text) {
  if (text == "auto") return AlphaChoice{.rule = AlphaRule::automatic};
  if (text == "min") return AlphaChoice{.rule = AlphaRule::least};
  AlphaChoice choice{.rule = AlphaRule::plateau};
  if (text == "plateau") return choice;
  constexpr std::string_view ranked = "plateau:";
  if (!text.starts_with(ranked)) return std::nullopt;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + ranked.size(), last, choice.rank);
  if (error != std::errc() || end != last || choice.rank == 0) return std::nullopt;
  return choice;
}

std::string name_of(const AlphaChoice& choice) {
  switch (choice.rule) {
    case AlphaRule::automatic:
      return "auto";
    case AlphaRule::least:
      return "min";
    case AlphaRule::plateau:
      return choice.rank == 1 ? "plateau" : "plateau:" + std::to_string(choice.rank);
    case AlphaRule::given:
      break;
  }
  return "given";
}

void require_rank(const AlphaChoice& choice, std::size_t plateaus) {
  if (choice.rank == 0) throw InvalidInput("alpha " + name_of(choice) + ": expected a rank of at least 1");
  if (choice.rank <= plateaus) return;
  throw InvalidInput(
      "alpha " + name_of(choice) +
      (plateaus == 1 ? ": there is only 1 plateau" : ": there are only " + std::to_string(plateaus) + " plateaus"));
}

}  // namespace rbpa
