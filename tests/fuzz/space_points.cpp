// Readers of points of space: any bytes are points, all finite, with a normal and a colour of each or of none, or refused in
// a sentence of one line. The first byte is the format and the options; the rest is the file.
#include <algorithm>
#include <string>

#include "fuzz/sentence.h"
#include "fuzz/target.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"

namespace {

using namespace rbpa::app;

constexpr Format formats[] = {Format::text, Format::ply, Format::off, Format::obj,  Format::pcd,
                              Format::npy,  Format::las, Format::pts, Format::xyzn, Format::xyzrgb};

CloudRequest choice_of(std::size_t selector) {
  CloudRequest choice;
  if (selector % 4 == 1) choice.columns = parse_space_columns("3,1,2");
  if (selector % 4 == 2) choice.columns = parse_space_columns("x,y,z,nx,ny,nz");
  if (selector % 4 == 3) choice.where = Condition("z > 1 or classification == 2", names_of_las_fields());
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
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    is_sound(
        space_points_in(bytes, "FILE", formats[data[0] % std::size(formats)], choice_of(data[0] / std::size(formats))));
  } catch (const BadInput& refusal) {
    fuzz::is_a_sentence(refusal.what());
  } catch (const WrongUsage& refusal) {
    fuzz::is_a_sentence(refusal.what());
  }
  return 0;
}
