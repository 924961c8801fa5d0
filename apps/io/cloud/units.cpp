#include "io/cloud/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <string>

#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

/// Every `step`-th code from `first` to `last`.
struct Codes {
  std::uint16_t first, last, step = 1;
};

// clang-format off
constexpr Codes us_survey_feet[] = {
    {2155, 2155, 1}, {2194, 2194, 1}, {2204, 2204, 1}, {2225, 2250, 1}, {2254, 2255, 1}, {2257, 2264, 1},
    {2267, 2268, 1}, {2271, 2272, 1}, {2274, 2279, 1}, {2283, 2289, 1}, {2870, 2895, 1}, {2899, 2900, 1},
    {2902, 2908, 1}, {2911, 2912, 1}, {2915, 2920, 1}, {2924, 2930, 1}, {2964, 2968, 1}, {3089, 3091, 2},
    {3102, 3102, 1}, {3363, 3365, 2}, {3404, 3404, 1}, {3417, 3438, 1}, {3441, 3446, 1}, {3451, 3459, 1},
    {3485, 3487, 2}, {3490, 3512, 2}, {3515, 3553, 2}, {3560, 3570, 1}, {3582, 3586, 2}, {3598, 3600, 2},
    {3608, 3632, 2}, {3640, 3642, 2}, {3650, 3654, 2}, {3658, 3664, 2}, {3668, 3674, 2}, {3677, 3677, 1},
    {3680, 3680, 1}, {3683, 3683, 1}, {3686, 3692, 2}, {3696, 3700, 2}, {3728, 3739, 1}, {3753, 3760, 1},
    {3991, 3992, 1}, {4217, 4217, 1}, {4399, 4413, 1}, {4418, 4433, 1}, {4438, 4439, 1}, {4455, 4457, 1},
    {5623, 5625, 1}, {5646, 5646, 1}, {5654, 5655, 1}, {6200, 6202, 1}, {6411, 6413, 2}, {6416, 6438, 2},
    {6441, 6479, 2}, {6484, 6492, 2}, {6501, 6507, 2}, {6510, 6510, 1}, {6517, 6543, 2}, {6549, 6555, 2},
    {6563, 6565, 2}, {6568, 6568, 1}, {6572, 6578, 2}, {6582, 6590, 2}, {6593, 6609, 2}, {6612, 6618, 2},
    {6625, 6627, 1}, {6633, 6633, 1}, {6880, 6880, 1}, {6923, 6925, 2}, {6966, 6966, 1}, {6997, 6997, 1},
    {7057, 7070, 1}, {7128, 7128, 1}, {7132, 7132, 1}, {7258, 7370, 2}, {7587, 7645, 1}, {8035, 8036, 1},
    {8091, 8093, 2}, {8096, 8172, 2}, {8177, 8177, 1}, {8180, 8182, 2}, {8185, 8185, 1}, {8189, 8189, 1},
    {8193, 8193, 1}, {8197, 8197, 1}, {8200, 8210, 2}, {8213, 8213, 1}, {8216, 8216, 1}, {8220, 8220, 1},
    {8224, 8226, 2}, {8380, 8384, 2}, {8387, 8387, 1}, {8518, 8529, 1}, {8531, 8533, 2}, {8534, 8536, 1},
    {8538, 8540, 1}, {9748, 9749, 1}, {26729, 26760, 1}, {26766, 26787, 1}, {26791, 26799, 1}, {26801, 26803, 1},
    {26811, 26813, 1}, {26847, 26870, 1}, {32001, 32003, 1}, {32005, 32031, 1}, {32033, 32058, 1}, {32064, 32067, 1},
    {32074, 32077, 1}, {32099, 32099, 1}, {32164, 32167, 1}, {32664, 32667, 1}};

constexpr Codes feet[] = {
    {2222, 2224, 1}, {2251, 2253, 1}, {2256, 2256, 1}, {2265, 2266, 1}, {2269, 2270, 1}, {2273, 2273, 1},
    {2280, 2282, 1}, {2867, 2869, 1}, {2896, 2898, 1}, {2901, 2901, 1}, {2909, 2910, 1}, {2913, 2914, 1},
    {2921, 2923, 1}, {2992, 2994, 2}, {3080, 3080, 1}, {3359, 3361, 2}, {3479, 3483, 2}, {3588, 3590, 2},
    {3593, 3593, 1}, {3605, 3605, 1}, {3634, 3636, 2}, {3644, 3648, 2}, {3656, 3656, 1}, {3676, 3676, 1},
    {3679, 3679, 1}, {3682, 3682, 1}, {5588, 5588, 1}, {6128, 6129, 1}, {6141, 6141, 1}, {6391, 6391, 1},
    {6405, 6409, 2}, {6494, 6496, 2}, {6499, 6499, 1}, {6515, 6515, 1}, {6545, 6547, 2}, {6557, 6561, 2},
    {6570, 6570, 1}, {6785, 6863, 2}, {6868, 6868, 1}, {6885, 6887, 2}, {7119, 7127, 1}, {8065, 8068, 1},
    {8312, 8348, 2}, {20050, 20050, 1}};
// clang-format on

/// Ranges of codes, first and last, whose assigned codes are all systems in meters or in feet. At most nineteen
/// consecutive codes of a range are not assigned.
// clang-format off
constexpr Codes metres[] = {
    {2000, 2065}, {2067, 2135}, {2137, 2158}, {2161, 2221}, {2290, 2313}, {2315, 2866}, {2931, 3138}, {3141, 3166},
    {3168, 3406}, {3408, 3416}, {3439, 3816}, {3825, 3854}, {3857, 3885}, {3890, 3893}, {3901, 3903}, {3907, 3920},
    {3942, 3997}, {4026, 4026}, {4037, 4038}, {4048, 4051}, {4056, 4071}, {4082, 4100}, {4390, 4437}, {4462, 4462},
    {4467, 4467}, {4471, 4471}, {4474, 4474}, {4484, 4489}, {4491, 4554}, {4559, 4589}, {4647, 4656}, {4766, 4800},
    {4812, 4812}, {4822, 4822}, {4826, 4880}, {5014, 5018}, {5041, 5048}, {5069, 5072}, {5105, 5130}, {5167, 5188},
    {5221, 5225}, {5234, 5235}, {5243, 5243}, {5247, 5247}, {5253, 5259}, {5266, 5316}, {5318, 5321}, {5325, 5331},
    {5337, 5337}, {5343, 5349}, {5355, 5357}, {5361, 5362}, {5367, 5367}, {5382, 5389}, {5396, 5396}, {5456, 5463},
    {5466, 5466}, {5469, 5469}, {5479, 5482}, {5490, 5490}, {5513, 5523}, {5530, 5539}, {5550, 5556}, {5559, 5559},
    {5562, 5583}, {5596, 5596}, {5598, 5598}, {5627, 5627}, {5629, 5680}, {5682, 5700}, {5707, 5708}, {5825, 5825},
    {5832, 5842}, {5844, 5858}, {5875, 5880}, {5887, 5899}, {5921, 5940}, {5945, 5976}, {6050, 6125}, {6145, 6176},
    {6190, 6204}, {6210, 6211}, {6244, 6275}, {6307, 6307}, {6312, 6316}, {6328, 6348}, {6350, 6356}, {6362, 6362},
    {6366, 6637}, {6646, 6646}, {6650, 6665}, {6669, 6692}, {6703, 6703}, {6707, 6738}, {6784, 6879}, {6884, 6886},
    {6893, 6893}, {6915, 6915}, {6922, 6933}, {6956, 6962}, {6984, 6984}, {6991, 7007}, {7074, 7082}, {7109, 7131},
    {7142, 7142}, {7257, 7369}, {7374, 7376}, {7401, 7403}, {7405, 7405}, {7411, 7413}, {7415, 7422}, {7528, 7586},
    {7692, 7696}, {7755, 7787}, {7791, 7795}, {7799, 7805}, {7825, 7831}, {7845, 7878}, {7882, 7883}, {7887, 7887},
    {7899, 7899}, {7954, 7956}, {7991, 7992}, {8013, 8032}, {8044, 8045}, {8058, 8059}, {8082, 8083}, {8088, 8088},
    {8090, 8225}, {8311, 8347}, {8352, 8353}, {8370, 8370}, {8379, 8395}, {8433, 8433}, {8441, 8441}, {8455, 8456},
    {8677, 8682}, {8686, 8687}, {8692, 8693}, {8801, 8815}, {8826, 8840}, {8857, 8859}, {8903, 8903}, {8908, 8910},
    {8912, 8912}, {8950, 8951}, {9039, 9040}, {9141, 9141}, {9149, 9150}, {9154, 9159}, {9191, 9222}, {9249, 9250},
    {9252, 9252}, {9254, 9254}, {9265, 9265}, {9271, 9273}, {9284, 9285}, {9295, 9297}, {9300, 9300}, {9306, 9306},
    {9311, 9311}, {9354, 9360}, {9367, 9368}, {9373, 9377}, {9387, 9388}, {9391, 9391}, {9404, 9407}, {9456, 9457},
    {9473, 9473}, {9476, 9498}, {9674, 9674}, {9678, 9680}, {9697, 9699}, {9709, 9716}, {9741, 9742}, {9761, 9762},
    {9766, 9767}, {9793, 9794}, {9821, 9865}, {9869, 9870}, {9874, 9881}, {9895, 9897}, {9920, 9922}, {9928, 9935},
    {9943, 9947}, {9951, 9953}, {9967, 9968}, {9972, 9973}, {9977, 9978}, {20002, 20032}, {20042, 20042},
    {20047, 20092}, {20135, 20138}, {20248, 20258}, {20348, 20358}, {20436, 20440}, {20499, 20499}, {20538, 20539},
    {20790, 20791}, {20822, 20824}, {20904, 20936}, {21004, 21037}, {21095, 21100}, {21148, 21150}, {21207, 21264},
    {21291, 21364}, {21413, 21423}, {21453, 21500}, {21780, 21782}, {21817, 21818}, {21891, 21899}, {22032, 22033},
    {22091, 22092}, {22171, 22293}, {22307, 22357}, {22391, 22422}, {22462, 22465}, {22521, 22525}, {22607, 22657},
    {22700, 22739}, {22762, 22780}, {22832, 22832}, {22991, 22994}, {23028, 23038}, {23090, 23095}, {23239, 23240},
    {23433, 23433}, {23700, 23700}, {23830, 23894}, {23946, 23948}, {24047, 24048}, {24200, 24200}, {24305, 24313},
    {24342, 24347}, {24375, 24381}, {24383, 24383}, {24500, 24500}, {24547, 24548}, {24600, 24600}, {24718, 24720},
    {24817, 24821}, {24877, 24893}, {25000, 25000}, {25231, 25231}, {25391, 25395}, {25700, 25700}, {25828, 25838},
    {25884, 25884}, {25932, 25932}, {26191, 26195}, {26237, 26237}, {26331, 26332}, {26391, 26393}, {26432, 26432},
    {26591, 26592}, {26632, 26632}, {26692, 26722}, {26814, 26846}, {26891, 26998}, {27037, 27040}, {27120, 27120},
    {27200, 27232}, {27258, 27260}, {27391, 27398}, {27429, 27429}, {27492, 27500}, {27561, 27594}, {27700, 27700},
    {28191, 28193}, {28232, 28232}, {28348, 28358}, {28402, 28432}, {28462, 28492}, {28600, 28600}, {28991, 28992},
    {29100, 29122}, {29168, 29195}, {29220, 29221}, {29333, 29333}, {29635, 29636}, {29700, 29702}, {29738, 29739},
    {29849, 29850}, {29873, 29874}, {29900, 29903}, {30161, 30179}, {30339, 30340}, {30491, 30494}, {30729, 30732},
    {30791, 30800}, {31028, 31028}, {31121, 31121}, {31154, 31171}, {31251, 31300}, {31370, 31370}, {31461, 31469},
    {31528, 31529}, {31600, 31600}, {31700, 31700}, {31838, 31839}, {31900, 31901}, {31965, 32000}, {32061, 32260},
    {32301, 32360}, {32401, 32460}, {32501, 32560}, {32600, 32663}, {32700, 32766}};
// clang-format on

template <typename Table>
bool has(const Table& table, unsigned code) {
  return std::any_of(std::begin(table), std::end(table), [code](const Codes& codes) {
    return code >= codes.first && code <= codes.last && (code - codes.first) % codes.step == 0;
  });
}

constexpr unsigned us_foot = 9003;  // EPSG's code of the US survey foot

}  // namespace

std::optional<unsigned> feet_of_epsg(unsigned code) {
  constexpr unsigned foot = 9002;
  if (has(us_survey_feet, code)) return us_foot;
  if (has(feet, code)) return foot;
  return std::nullopt;
}

std::optional<std::string_view> unit_of(const PointFile& file) {
  if (file.degrees) return "degree";
  if (!file.crs || file.crs->authority != "EPSG") return std::nullopt;
  const auto code = static_cast<unsigned>(parse_count(file.crs->code).value_or(0));
  if (const std::optional<unsigned> foot = feet_of_epsg(code)) return *foot == us_foot ? "US survey foot" : "foot";
  return has(metres, code) ? std::optional<std::string_view>("metre") : std::nullopt;
}

namespace {

template <typename P>
Box box_of(const std::vector<P>& points) {
  Box box;
  for (const P& p : points) box.add({p.x, p.y});
  return box;
}

/// Returns whether the box lies within longitudes of -360 to 360 and latitudes of -90 to 90.
bool may_be_degrees(const Box& box) {
  return box.least.y >= -90 && box.greatest.y <= 90 && box.least.x >= -360 && box.greatest.x <= 360;
}

/// Returns the warning that `box` is not within the range of degrees.
std::string no_degrees(const Box& box) {
  const bool exchanged = may_be_degrees({{box.least.y, box.least.x}, {box.greatest.y, box.greatest.x}});
  return "expected longitudes and latitudes, found numbers up to " +
         text_of(std::max(std::abs(box.least.x), std::abs(box.greatest.x))) + " and " +
         text_of(std::max(std::abs(box.least.y), std::abs(box.greatest.y))) +
         (exchanged ? ": are they exchanged? (in a table --columns takes them in the other order)"
                    : ": are they degrees?");
}

/// Returns whether the points lie on both sides of the antimeridian and within half the globe: some range of more than
/// 180 degrees of longitude between two points has no points.
bool lie_around_antimeridian(const std::vector<Point>& points, const Box& box) {
  if (box.least.x < -180 || box.greatest.x > 180 || box.greatest.x - box.least.x <= 180) return false;
  std::array<bool, 361> taken{};
  for (const Point& p : points) taken[static_cast<std::size_t>(std::floor(p.x + 180))] = true;
  int widest = 0, gap = 0;
  for (const bool degree : taken) {
    gap = degree ? 0 : gap + 1;
    widest = std::max(widest, gap);
  }
  return widest > 180;
}

/// Returns the lengths of degrees of longitude within the box, as shares of the length of a degree of latitude: "0.62",
/// "0.50 to 0.71".
std::string share_of_latitude(const Box& box) {
  constexpr double radians = 0.017453292519943295;
  const bool has_equator = box.least.y <= 0 && box.greatest.y >= 0;
  const double farthest = std::max(std::abs(box.least.y), std::abs(box.greatest.y));
  const double nearest = has_equator ? 0 : std::min(std::abs(box.least.y), std::abs(box.greatest.y));
  char least[16], greatest[16];
  std::snprintf(least, sizeof least, "%.2f", std::abs(std::cos(farthest * radians)));
  std::snprintf(greatest, sizeof greatest, "%.2f", std::cos(nearest * radians));
  const std::string text = least;
  return text == greatest ? text : text + " to " + greatest;
}

/// Returns how to mend degrees: a projection of the points, with the UTM zone of the middle unless the box is wider
/// than two zones.
std::string way_to_project(const Box& box) {
  const std::string way = "; project them first";
  if (box.greatest.x - box.least.x > 12) return way;
  const double middle = std::remainder((box.least.x + box.greatest.x) / 2, 360);
  const int zone = std::clamp(static_cast<int>(std::floor((middle + 180) / 6)) + 1, 1, 60);
  const bool is_south = box.least.y + box.greatest.y < 0;
  return way + ", to UTM zone " + std::to_string(zone) + (is_south ? "S" : "N") +
         " (EPSG:" + std::to_string((is_south ? 32700 : 32600) + zone) + "), for example";
}

}  // namespace

void shift_longitude(std::vector<Point>& points, const std::string& name) {
  for (Point& p : points) {
    if (p.x < -180 || p.x > 360)
      bad_input(name, "x = " + in_quotes(text_of(p.x)),
                "a longitude of -180 to 360 (leave out --shift-longitude if x is not in degrees)");
    if (p.x < 0) p.x += 360;
  }
}

std::string warning_on_degrees(const std::vector<Point3>& points) {
  if (points.empty()) return "";
  const Box box = box_of(points);
  if (!may_be_degrees(box)) return no_degrees(box);
  return "x and y are degrees and z is not, which distorts balls; a degree of longitude is as long as " +
         share_of_latitude(box) + " degrees of latitude there" + way_to_project(box);
}

std::string warning_on_degrees(const Box& box) {
  if (!may_be_degrees(box)) return no_degrees(box);
  return "coordinates are degrees, and so are radii, lengths and areas; a degree of longitude is as long as " +
         share_of_latitude(box) + " degrees of latitude there" + way_to_project(box);
}

void warning_on_degrees(PointFile& file) {
  if (file.points.empty()) return;
  const Box box = box_of(file.points);
  file.warnings.push_back(warning_on_degrees(box));
  if (may_be_degrees(box) && lie_around_antimeridian(file.points, box))
    file.warnings.push_back(
        "points lie on both sides of the antimeridian, longitude 180, and are far apart in the plane "
        "(--shift-longitude adds 360 to longitudes below 0)");
}

}  // namespace rbpa::app
