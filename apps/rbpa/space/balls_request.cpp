#include "space/balls_request.h"

#include <utility>

#include "io/bytes/number.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

double parse_length(const std::string& option, const std::string& text) {
  const ParsedNumber number = parse_whole_number(text);
  if (number.fault != NumberFault::none || !(number.value >= 0))
    throw WrongUsage(option + ": found " + in_quotes(text) + ", expected a length, at least 0");
  return number.value;
}

/// Parses --group, and notes the column in `choice`.
AtomGroups parse_groups(const std::string& text, AtomChoice& choice) {
  constexpr std::string_view column = "column:";
  if (text == "residue") return AtomGroups::residue;
  if (text == "chain") return AtomGroups::chain;
  if (!text.starts_with(column) || text.size() == column.size())
    throw WrongUsage("--group: found " + in_quotes(text) + ", expected residue, chain or column:NAME");
  choice.group = text.substr(column.size());
  return AtomGroups::column;
}

Target parse_contacts(const std::string& path) {
  const std::optional<Format> format = find_format(Use::rows, ending(path));
  if (!format)
    throw WrongUsage("--contacts: found the ending " + in_quotes(ending(path)) + ", expected one of " +
                     endings(Use::rows));
  return {path, *format};
}

}  // namespace

BallsRequest parse(const BallsArguments& arguments) {
  AtomChoice choice{.waters = arguments.waters,
                    .ligands = !arguments.no_ligands,
                    .hydrogens = !arguments.no_hydrogens,
                    .alternates = arguments.alternates,
                    .where = arguments.where};
  if (arguments.models) choice.frames = parse_frames("--models", *arguments.models);
  const bool has_frames = choice.frames.all || choice.frames.numbers.size() > 1;
  std::optional<double> otherwise;
  if (arguments.radius_default) otherwise = parse_length("--radius-default", *arguments.radius_default);
  BallsRequest request{.path = arguments.atoms,
                       .format = parse_format(Use::space, arguments.atoms, arguments.format, "ATOMS"),
                       .choice = std::move(choice),
                       .radii = BallRadii(arguments.radii, otherwise),
                       .probe = parse_length("--probe", arguments.probe),
                       .has_frames = has_frames,
                       .targets = {},
                       .contacts = {},
                       .run = parse_run(arguments.run)};
  request.choice.radius = request.radii.column();
  if (arguments.group) request.groups = parse_groups(*arguments.group, request.choice);
  if (arguments.contacts) request.contacts = parse_contacts(*arguments.contacts);
  std::vector<std::string> reports = given({arguments.stats, arguments.contacts});
  if (arguments.json) reports.emplace_back("-");
  // Without any file the summary alone is the result.
  if (!arguments.outputs.empty() || arguments.output_format || !reports.empty())
    request.targets = parse_targets(Use::rows, arguments, arguments.atoms, reports);
  return request;
}

}  // namespace rbpa::app
