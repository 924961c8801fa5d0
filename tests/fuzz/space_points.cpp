// Readers of points of space: any bytes are either points, all finite, with a normal and a color for each or for none,
// or refused in a sentence of one line. The first byte is the format and the options; the rest is the file.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/read_space_points.h"
#include "io/cloud/readers.h"
#include "io/failure.h"
#include "io/formats.h"

namespace {

using namespace rbpa::app;

bool is_molecule(Format format) { return format == Format::pdb || format == Format::cif; }

/// Returns the formats that the programs list.
std::vector<Format> all_formats() {
  std::vector<Format> formats;
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::string_view rest = space_formats;
  while ((rest = rest.substr(std::min(rest.find_first_of(letters), rest.size()))), !rest.empty()) {
    const std::string_view name = rest.substr(0, rest.find_first_not_of(letters));
    const std::optional<Format> format = find_format(Use::space, name);
    if (format && std::find(formats.begin(), formats.end(), *format) == formats.end()) formats.push_back(*format);
    rest.remove_prefix(name.size());
  }
  return formats;
}

CloudRequest choice_of(Format format, std::size_t selector) {
  CloudRequest choice;
  if (selector % 4 == 1) choice.columns = parse_space_columns("3,1,2");
  if (selector % 4 == 2) choice.columns = parse_space_columns("x,y,z,nx,ny,nz");
  if (selector % 4 == 3)
    choice.where =
        Condition(is_molecule(format) ? "z > 1 or resname == 'LYS' and resseq == 2" : "z > 1 or classification == 2",
                  is_molecule(format) ? names_of_atoms() : names_of_las_fields());
  choice.skip_invalid = selector / 4 % 2 == 1;
  return choice;
}

void is_sound(const SpacePoints& file) {
  const auto all_finite = [](const auto& vectors) {
    return std::all_of(vectors.begin(), vectors.end(), [](const rbpa::Point3& p) { return rbpa::is_finite(p); });
  };
  fuzz::require(all_finite(file.points) && all_finite(file.normals), "points and normals are finite");
  const auto of_each_or_none = [&](const auto& list) { return list.empty() || list.size() == file.points.size(); };
  fuzz::require(of_each_or_none(file.normals) && of_each_or_none(file.colors), "one of each point, or none");
  fuzz::require(std::find(file.normals.begin(), file.normals.end(), rbpa::Point3{}) == file.normals.end(),
                "normals have a direction");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::vector<Format> formats = all_formats();
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  const Format format = formats[data[0] % formats.size()];
  try {
    is_sound(space_points_in(bytes, "FILE", format, choice_of(format, data[0] / formats.size())));
  } catch (const BadInput& refusal) {
    fuzz::is_a_sentence(refusal.what());
  } catch (const WrongUsage& refusal) {
    fuzz::is_a_sentence(refusal.what());
  }
  return 0;
}
