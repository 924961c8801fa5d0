// Readers of points of space: any bytes are either points, all finite, with a normal and a color for each or for none,
// or refused in a sentence of one line; and all frames of atoms have finite centers and radii of at least 0.
// format_of_input.h says how an input names its format.
#include <algorithm>
#include <optional>

#include "fuzz/format_of_input.h"
#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/cloud/atom_frames.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/formats.h"

namespace {

using namespace rbpa::app;

CloudRequest choice_of(Format format, unsigned options) {
  CloudRequest choice;
  if (options % 4 == 1) choice.columns = parse_space_columns("3,1,2");
  if (options % 4 == 2) choice.columns = parse_space_columns("x,y,z,nx,ny,nz");
  if (options % 4 == 3)
    choice.where = fuzz::condition_of(
        format, {"z > 1 or classification == 2", "z > 1 or resname == 'LYS' and resseq == 2", "z > 1 or not x == 2"});
  choice.skip_invalid = (options & 4U) != 0;
  if ((options & 32U) != 0) choice.window = fuzz::window();
  if ((options & 64U) != 0) choice.keeps.emplace();
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
  fuzz::has_all_values(file.kept, file.points.size());
}

void read_frames(const fuzz::FuzzedFile& file, Format format) {
  AtomFrames frames(file.bytes, "FILE", format, {.frames = {.all = true}, .alternates = (file.options & 16U) != 0});
  for (AtomFrame frame; frames.next(frame);) {
    fuzz::require(!frame.rows.empty(), "a frame has atoms");
    for (const AtomRow& row : frame.rows) {
      fuzz::require(rbpa::is_finite(row.center), "centers are finite");
      fuzz::require(row.radius >= 0 || !frame.has_radii, "radii are at least 0");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::divided({reinterpret_cast<const char*>(data), size});
  const std::optional<Format> format = file ? find_format(Use::space, file->ending) : std::nullopt;
  if (!format) return 0;
  try {
    if ((file->options & 8U) != 0) read_frames(*file, *format);
    is_sound(space_points_in(file->bytes, "FILE", *format, choice_of(*format, file->options)));
  } catch (const BadInput& refusal) {
    fuzz::is_a_sentence(refusal.what());
  } catch (const WrongUsage& refusal) {
    fuzz::is_a_sentence(refusal.what());
  }
  return 0;
}
