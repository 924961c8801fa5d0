// Fields where points are listed, as attributes of polygons and of groups, and in conditions: exact, of every type.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "io/utf8.h"
#include "support/las_file.h"
#include "support/program.h"

using namespace apps_test;

namespace {

template <typename T>
std::string bytes_of_number(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// A field of extra bytes: its type and options in LAS, and for each point the bytes and the text of the value.
struct Extra {
  std::string name;
  char type, options;
  std::vector<std::string> bytes, texts;
  double scale = 1, offset = 0;
};

template <typename T>
Extra extra(const std::string& name, char type, std::vector<T> values, std::vector<std::string> texts) {
  Extra made{.name = name, .type = type, .options = 0, .bytes = {}, .texts = std::move(texts)};
  for (const T value : values) made.bytes.push_back(bytes_of_number(value));
  return made;
}

/// All types of numbers, with their extremes, at three points.
std::vector<Extra> all_types() {
  using Int64 = std::numeric_limits<std::int64_t>;
  std::vector<Extra> all = {
      extra<std::uint8_t>("u8", 1, {0, 255, 7}, {"0", "255", "7"}),
      extra<std::int8_t>("i8", 2, {-128, 127, -1}, {"-128", "127", "-1"}),
      extra<std::uint16_t>("u16", 3, {0, 65535, 8}, {"0", "65535", "8"}),
      extra<std::int16_t>("i16", 4, {-32768, 32767, 2}, {"-32768", "32767", "2"}),
      extra<std::uint32_t>("u32", 5, {0, 4294967295, 9}, {"0", "4294967295", "9"}),
      extra<std::int32_t>("i32", 6, {-2147483647 - 1, 2147483647, 3}, {"-2147483648", "2147483647", "3"}),
      extra<std::uint64_t>("u64", 7, {0, ~0ULL, 1ULL << 53U}, {"0", "18446744073709551615", "9007199254740992"}),
      extra<std::int64_t>("i64", 8, {Int64::min(), Int64::max(), -5},
                          {"-9223372036854775808", "9223372036854775807", "-5"}),
      extra<float>("f32", 9, {0.1F, std::numeric_limits<float>::quiet_NaN(), -2.5F}, {"0.1", "", "-2.5"}),
      extra<double>("a \"b\", ü", 10, {1e300, 0.1, std::numeric_limits<double>::quiet_NaN()}, {"1e+300", "0.1", ""}),
      extra<std::uint8_t>("x", 1, {4, 5, 6}, {"4", "5", "6"}),
      extra<std::uint16_t>("scaled", 3, {0, 1, 65535}, {"-10", "-9.5", "32757.5"})};
  all.back().options = 24;
  all.back().scale = 0.5;
  all.back().offset = -10;
  return all;
}

/// A LAS file of the points (0, 0), (1, 0) and (0, 1).
std::string las_with(const std::vector<Extra>& extras) {
  std::string records(192 * extras.size(), '\0');
  std::string rows[3];
  for (std::size_t k = 0; k < extras.size(); ++k) {
    records[192 * k + 2] = extras[k].type;
    records[192 * k + 3] = extras[k].options;
    records.replace(192 * k + 4, extras[k].name.size(), extras[k].name);
    records.replace(192 * k + 112, 8, little(extras[k].scale));
    records.replace(192 * k + 136, 8, little(extras[k].offset));
    for (std::size_t i = 0; i < 3; ++i) rows[i] += extras[k].bytes[i];
  }
  LasFile las{.minor = 4,
              .records = {{"LASF_Spec", 4, records}},
              .points = {{.classification = 2}, {.x = 100, .classification = 6}, {.y = 100, .classification = 6}},
              .extra_bytes = static_cast<unsigned>(rows[0].size())};
  std::string bytes = bytes_of(las);
  const std::size_t row = 20 + rows[0].size(), first = bytes.size() - 3 * row;
  for (std::size_t i = 0; i < 3; ++i) bytes.replace(first + row * i + 20, rows[i].size(), rows[i]);
  return bytes;
}

}  // namespace

TEST_SUITE("listed_fields") {
  TEST_CASE("lists of points have the fields of every type, exactly, under names that are not taken") {
    const Folder folder;
    const std::vector<Extra> extras = all_types();
    folder.file("p.las", las_with(extras));
    std::string chosen;
    for (const Extra& one : extras)
      if (one.name.find(',') == std::string::npos) chosen += (chosen.empty() ? "" : ",") + one.name;
    folder.rbpa("shape p.las --alpha inf -o all.csv -o s.geojson", 0);
    CHECK(contains(folder.content("all.csv"), ",\"a \"\"b\"\", ü\",x_2,scaled\n"));
    CHECK(folder.content("all.csv").starts_with("x,y,polygon,intensity,"));
    folder.rbpa("shape p.las --alpha inf -o p.csv --isolated i.csv --fields " + chosen, 0);
    folder.rbpa("shape p.las --alpha 0.1 --isolated j.csv --fields " + chosen, 0);
    folder.rbpa("shape p.las --alpha 0.1 --isolated j.geojson --fields " + chosen, 0);
    const auto json = nlohmann::json::parse(folder.content("j.geojson"))["features"];
    std::string header, rows[3];
    for (const Extra& one : extras) {
      if (one.name.find(',') != std::string::npos) continue;
      header += "," + (one.name == "x" ? "x_2" : one.name);
      for (std::size_t i = 0; i < 3; ++i) {
        rows[i] += "," + one.texts[i];
        CAPTURE(one.name);
        CHECK(contains(folder.content("j.geojson"),
                       "\"" + one.name + "\":" + (one.texts[i].empty() ? "null" : one.texts[i])));
        if (!one.texts[i].empty()) CHECK(json[i]["properties"][one.name].dump().starts_with(one.texts[i].substr(0, 9)));
      }
    }
    const std::string of_points =
        "x,y,polygon" + header + "\n0,0,1" + rows[0] + "\n1,0,1" + rows[1] + "\n0,1,1" + rows[2] + "\n";
    const std::string isolated =
        "x,y,index" + header + "\n0,0,0" + rows[0] + "\n1,0,1" + rows[1] + "\n0,1,2" + rows[2] + "\n";
    CHECK(folder.content("p.csv") == of_points);
    CHECK(folder.content("i.csv") == "x,y,index" + header + "\n");
    CHECK(folder.content("j.csv") == isolated);
    folder.rbpa("shape p.las --alpha inf -o n.csv --fields none", 0);
    CHECK(folder.content("n.csv") == "x,y,polygon\n0,0,1\n1,0,1\n0,1,1\n");
  }

  TEST_CASE("texts, duplicate names, empty columns and thousands of columns are listed") {
    const Folder folder("p.csv",
                        "x,y,kind,kind,none,id\n0,0,\"a, \"\"b\"\"\",ß,,9223372036854775807\n1,0,,ü,,1\n0,1,c,c,,-2\n");
    folder.rbpa("shape p.csv --alpha inf -o s.csv", 0);
    CHECK(
        folder.content("s.csv") ==
        "x,y,polygon,kind,kind_2,none,id\n0,0,1,\"a, \"\"b\"\"\",ß,,9223372036854775807\n1,0,1,,ü,,1\n0,1,1,c,c,,-2\n");
    std::string header = "x,y", rows[3] = {"0,0", "1,0", "0,1"};
    for (int k = 0; k < 3000; ++k) {
      header += ",c" + std::to_string(k);
      for (std::string& row : rows) row += "," + std::to_string(k);
    }
    folder.file("w.csv", header + "\n" + rows[0] + "\n" + rows[1] + "\n" + rows[2] + "\n");
    folder.rbpa("shape w.csv --alpha inf -o t.csv", 0);
    CHECK(folder.content("t.csv").starts_with("x,y,polygon" + header.substr(3) + "\n0,0,1" + rows[0].substr(3) + "\n"));
  }

  TEST_CASE("numbers of fields are read as they are written, with decimal commas, exponents and signs of other kinds") {
    const Folder folder;
    struct Case {
      std::string table, mean;  // of field h of all points
    };
    const std::string minus = "\xE2\x88\x92";
    const std::vector<Case> cases = {{"x;y;h\n0,5;0,5;3,5\n1,5;0,5;2,5\n0,5;1,5;1,5\n", "2.5"},
                                     {"x;y;h\n0;0;3,5\n1;0;2,5\n0;1;1,5\n", "2.5"},
                                     {"x;y;h\n0;0;3\n1;0,5;2,5\n0;1;2\n", "2.5"},
                                     {"geom;h\nPOINT(0.5 0);3,5\nPOINT(1 0);2,5\nPOINT(0 1);1,5\n", "2.5"},
                                     {"x,y,h\n0,0,1.0D3\n1,0,2.0D3\n0,1,3.0d3\n", "2000"},
                                     {"x,y,h\n0,0," + minus + "1\n1,0," + minus + "2.5\n0,1,-2.5\n", "-2"},
                                     {"x,y,h\n0,0,1.5D3\n1,0,\n0,1,NA\n", "1500"}};
    for (const Case& one : cases) {
      folder.file("t.csv", one.table);
      folder.rbpa("shape t.csv --alpha 3 --summarize h:mean -o g.geojson", 0);
      CHECK(contains(folder.content("g.geojson"), "\"h_mean\":" + one.mean + "}"));
    }
    // Points with decimal points: 1,2 is a text. 1D2 is a label wherever it is.
    folder.file("t.csv", "x;y;h;l\n0.5;0;1,2;1D2\n1.5;0;3,4;2D2\n0.5;1;5,6;3D2\n");
    for (const std::string field : {"h", "l"})
      says(folder, "shape t.csv --alpha 3 --summarize " + field + ":mean -o g.geojson", 3,
           "found texts in field '" + field + "'");
    // The coordinate 2D3 may be a number or an angle.
    folder.file("t.csv", "x,y\n1.5D3,0\n2D3,0\n1.0D3,1.0D3\n");
    says(folder, "shape t.csv --alpha inf -o g.geojson", 3,
         "t.csv:3: found '2D3', expected a number such as 2.0D3, or an angle such as 2d 3'");
  }

  TEST_CASE("radii of groups are read as other fields; one group without a radius is a group with a problem") {
    const Folder folder;
    for (const std::string radius : {"3,5", "3.5", "0,35D1", "3500e-3"}) {
      folder.file("t.csv", "x;y;h;g\n0;0;" + radius + ";1\n1;0;" + radius + ";1\n0;1;" + radius + ";1\n9;9;1;2\n");
      const Outcome outcome = folder.rbpa("shape t.csv --alpha column:h --group-by g -o g.csv", 0);
      CHECK(contains(folder.content("g.csv"), "\n1,3,3.5,0.5,"));
    }
    for (const std::string radius : {"-1", "0", "", "nan", "x"}) {
      folder.file("t.csv", "x,y,h,g\n0,0," + radius + ",a\n1,0," + radius + ",a\n0,1," + radius + ",a\n");
      const Outcome outcome = folder.rbpa("shape t.csv --alpha column:h --group-by g -o g.csv", 0);
      CHECK(contains(outcome.err, "1 group without a polygon: 'a', column 'h' has no radius above 0 for point 0"));
    }
  }

  TEST_CASE("a field without a value in one of several files, and one of two names in different case, are kept") {
    const Folder folder({{"a.csv", "x,y,s\n0,0,\n1,0,\n0,1,\n"}, {"b.csv", "x,y,s\n5,0,oak\n6,0,elm\n5,1,oak\n"}});
    for (const std::string files : {"a.csv b.csv", "b.csv a.csv"}) {
      folder.rbpa("shape " + files + " --group-by-file --alpha 2 --summarize s:majority -o g.geojson", 0);
      CHECK(contains(folder.content("g.geojson"), "\"s_majority\":\"oak\"}"));
    }
    folder.file("c.csv", "x,y,a,A\n0,0,1,2\n1,0,1,2\n0,1,1,2\n");
    for (const auto& [choice, header] : {std::pair("a", "a"), {"A", "A"}, {"a,A", "a,A_2"}}) {
      folder.rbpa(std::string("shape c.csv --alpha 3 -o p.csv --fields ") + choice, 0);
      CHECK(folder.content("p.csv").starts_with(std::string("x,y,polygon,") + header + "\n"));
    }
  }

  TEST_CASE("names and texts that are not UTF-8 are read as Windows-1252, and every file is UTF-8") {
    const Folder folder("t.csv", "x,y,h\xE4he,g\n0,0,1,K\xF6ln\n1,0,2,K\xF6ln\n0,1,3,K\xF6ln\n");
    const std::string o = "\xC3\xB6", euro = "\xE2\x82\xAC";
    folder.rbpa("mesh t.csv --alpha 3 -o t.vtu", 0);
    CHECK(contains(folder.content("t.vtu"), "Name=\"h\xC3\xA4he\""));
    // Each line: a run, its file, and what the file has.
    const std::string shown[][3] = {
        {"shape t.csv --group-by g --alpha 3 -o g.svg", "g.svg", "K" + o + "ln"},
        {"shape t.csv --group-by g --alpha 3 -o g.csv", "g.csv", "\nK" + o + "ln,3,"},
        {"stream t.csv --group-by g --alpha 3 -o g.geojson", "g.geojson", "\"K" + o + "ln\""},
        {"shape t.csv --alpha 3 -o s.csv", "s.csv", "h\xC3\xA4he,g\n0,0,1,1,K" + o + "ln\n"},
        {"shape t.csv --where \"g == 'K" + o + "ln'\" --alpha 3 -o w.csv", "w.csv", "1,0,1,2,K"},
        {"voronoi t.csv --fields g -o v.geojson", "v.geojson", "\"g\":\"K" + o + "ln\""},
        {"shape u.csv --group-by g --alpha 3 -o u.geojson", "u.geojson", "\"5 " + euro + "\""}};
    folder.file("u.csv", "x,y,g\n0,0,5 \x80\n1,0,5 \x80\n0,1,5 \x80\n");
    for (const auto& [run, file, text] : shown) {
      const std::string arguments = run;
      CAPTURE(arguments);
      CHECK(!contains(folder.rbpa(run, 0).err, "UTF-8"));
      CHECK(contains(folder.content(file), text));
      CHECK(rbpa::app::is_utf8(folder.content(file)));
    }
  }

  TEST_CASE("--fields of shape needs a list of points, and fields that are there") {
    const Folder folder("p.csv", "x,y,a\n0,0,1\n1,0,2\n0,1,3\n");
    says(folder, "shape p.csv --alpha 1 -o s.geojson --fields a", 2,
         "--fields requires a list of points in csv or gpkg, or --isolated, which hold fields\n");
    says(folder, "shape p.csv --alpha 1 --isolated s.wkt --fields a", 2, "--fields requires a list of points");
    says(folder, "shape p.csv --alpha 1 -o s.csv --fields b", 3,
         "p.csv: found no field 'b' beside the coordinates, expected one, as --fields requires\n");
    says(folder, "shape p.csv --alpha 1 -o s.csv --group-by a --fields a", 2, "--fields");
    CHECK(!folder.has("s.csv"));
    folder.rbpa("shape p.csv --alpha 1 -o s.geojson --fields none", 0);
    folder.rbpa("shape p.csv --alpha 1 -o s.csv --group-by a --fields none", 0);
  }

  TEST_CASE("conditions and groups read extra bytes of every type, with scale and offset") {
    const Folder folder;
    const std::vector<Extra> extras = all_types();
    folder.file("p.las", las_with(extras));
    const auto selected = [&](const std::string& where) {
      const Outcome outcome = folder.rbpa("info p.las --where '" + where + "'", 0);
      return outcome.out.substr(0, outcome.out.find('\n'));
    };
    for (const Extra& one : extras) {
      if (one.name == "u64" || one.name == "i64" || one.name == "x") continue;
      CAPTURE(one.name);
      for (std::size_t i = 0; i < 3; ++i)
        if (!one.texts[i].empty() && one.name != "f32" && one.name.front() != 'a')
          CHECK(selected("\"" + one.name + "\" == " + one.texts[i]) == "points      1");
    }
    CHECK(selected("f32 == -2.5") == "points      1");
    CHECK(selected("f32 > -3") == "points      2");  // NaN is greater than nothing
    CHECK(selected("F32 < 0 or u8 == 255") == "points      2");
    CHECK(selected("-10 < scaled < 0 and class == 6") == "points      1");
    CHECK(selected("x == 0") == "points      2");  // the coordinate
    says(folder, "info p.las --where 'i64 > 0'", 3,
         "p.las: point 0: found -9223372036854775808, expected an integer up to 2^53");
    says(folder, "info p.las --where 'u64 > 0'", 3, "p.las: point 1: found 18446744073709551615, expected an integer");
    CHECK(contains(folder.rbpa("info p.las --where 'u8 < 9 and u64 >= 0'", 0).err, "--where selects 2 of 3"));
    says(folder, "info p.las --where 'nothing == 1'", 3,
         "p.las: found point format 0 of LAS 1.4 with x, y, z, intensity,");
    says(folder, "info p.las --where 'nothing == 1'", 3, ", scaled, expected one with nothing, as --where requires");
    folder.rbpa("shape p.las --group-by i16 --alpha 1 -q -o g.csv", 0);
    CHECK(contains(folder.content("g.csv"), "\n32767,1,"));
    CHECK(contains(folder.content("g.csv"), "\n-32768,1,"));
    says(folder, "shape p.las --group-by nothing --alpha 1 -q -o h.csv", 3, "as --group-by requires");
  }

  TEST_CASE("meshes of groups keep fields, of one file and of several") {
    const Folder folder({{"a.csv", "x,y,g,n,t,m,only\n0,0,1,5,oak,1,7\n1,0,1,6,elm,2,7\n0,1,1,7,oak,3,7\n"},
                         {"b.csv", "x,y,g,n,t,m\n5,0,2,8,elm,a\n6,0,2,0.5,ash,b\n5,1,2,9,oak,c\n"}});
    folder.rbpa("mesh a.csv --group-by g --alpha inf -o none.ply --fields none", 0);
    CHECK(!contains(folder.content("none.ply"), "property int"));
    folder.rbpa("mesh a.csv --group-by g --alpha inf -o m.ply", 0);
    for (const std::string property : {"int g", "int n", "int t", "int m", "int only"})
      CHECK(contains(folder.content("m.ply"), "property " + property + "\n"));
    CHECK(contains(folder.content("m.ply"), "comment t: 0 = oak, 1 = elm\n"));
    const Outcome both = folder.rbpa("mesh a.csv b.csv --group-by-file --alpha inf -o m.ply --compact", 0);
    const std::string ply = folder.content("m.ply");
    CHECK(contains(ply, "property int g\nproperty double n\nproperty int t\nproperty int m\nelement face"));
    CHECK(contains(ply, "comment m: 0 = 1, 1 = 2, 2 = 3, 3 = a, 4 = b, 5 = c\n"));
    CHECK(contains(ply, "comment t: 0 = oak, 1 = elm, 2 = ash\n"));
    CHECK(contains(both.err, "field 'only' is left out: not all files have it\n"));
    const std::size_t data = ply.find("end_header\n") + 11, row = 3 * 8 + 4 + 8 + 4 + 4;
    const std::vector<double> n = {5, 6, 7, 8, 0.5, 9};
    const std::vector<std::int32_t> g = {1, 1, 1, 2, 2, 2}, t = {0, 1, 0, 1, 2, 0};
    for (std::size_t i = 0; i < 6; ++i) {
      CHECK(ply.substr(data + row * i + 24, 4) == bytes_of_number(g[i]));
      CHECK(ply.substr(data + row * i + 28, 8) == bytes_of_number(n[i]));
      CHECK(ply.substr(data + row * i + 36, 4) == bytes_of_number(t[i]));
    }
    says(folder, "mesh a.csv b.csv --group-by-file --alpha inf -o k.ply --fields only", 3,
         "b.csv: found no field 'only'");
  }

  TEST_CASE("summaries of polygons and groups equal those by brute force, whatever the order of points") {
    const Folder folder;
    std::mt19937 random(5);
    std::vector<std::string> rows;
    std::map<int, std::vector<std::int64_t>> values;
    std::map<int, std::map<std::string, int>> kinds;
    for (int i = 0; i < 400; ++i) {
      const int part = i % 4;
      const std::int64_t value = static_cast<std::int64_t>(random() % 100) - 50;
      const std::string kind(1, static_cast<char>('a' + random() % 3));
      const bool is_missing = random() % 10 == 0;
      rows.push_back(std::to_string(part * 100 + i / 4 % 10) + "," + std::to_string(i / 40) + "," +
                     std::to_string(part) + "," + (is_missing ? "" : std::to_string(value)) + "," + kind + "," +
                     std::to_string(9007199254740993 + part) + "\n");
      if (!is_missing) values[part].push_back(value);
      ++kinds[part][kind];
    }
    for (int turn = 0; turn < 3; ++turn) {
      std::string text = "x,y,part,v,kind,big\n";
      for (const std::string& row : rows) text += row;
      std::shuffle(rows.begin(), rows.end(), random);
      folder.file("p.csv", text);
      const std::string summaries = " --summarize v:mean,v:min,v:max,v:sum,kind:majority,big:max,Part:majority,v:sum";
      folder.rbpa("shape p.csv --columns x,y --alpha 2 -o s.geojson -q" + summaries, 0);
      folder.rbpa("shape p.csv --columns x,y --alpha 2 --group-by part -o g.geojson -o g.csv -q" + summaries, 0);
      CHECK(
          folder.content("g.csv").starts_with("group,points,alpha,area,perimeter,polygons,problem,geometry,v_mean,v_"
                                              "min,v_max,v_sum,kind_majority,big_max,Part_majority\n"));
      for (const std::string file : {"s.geojson", "g.geojson"}) {
        const auto features = nlohmann::json::parse(folder.content(file))["features"];
        REQUIRE(features.size() == 4);
        for (const auto& feature : features) {
          const auto& of = feature["properties"];
          const int part = of["Part_majority"];
          CHECK(of["points"] == 100);
          std::int64_t sum = 0;
          for (const std::int64_t value : values[part]) sum += value;
          CHECK(of["v_min"] == *std::min_element(values[part].begin(), values[part].end()));
          CHECK(of["v_max"] == *std::max_element(values[part].begin(), values[part].end()));
          CHECK(of["v_sum"] == sum);
          CHECK(of["v_mean"] == static_cast<double>(sum) / static_cast<double>(values[part].size()));
          std::string majority = "a";
          for (const auto& [kind, times] : kinds[part])
            if (times > kinds[part][majority]) majority = kind;
          CHECK(of["kind_majority"] == majority);
          CHECK(of["big_max"] == 9007199254740993 + part);
        }
      }
    }
  }

  TEST_CASE("summaries refuse what they cannot compute, and miss what is not there") {
    const Folder folder("p.csv", "x,y,g,kind,v\n0,0,1,a,\n1,0,1,b,\n0,1,1,b,\n9,9,2,c,1\n");
    says(folder, "shape p.csv --alpha 1 -o s.csv --summarize v:mean", 2,
         "--summarize requires -o in a format with attributes: one of geojson, json");
    says(folder, "shape p.csv --alpha 1 -o s.wkt --summarize v:mean", 2,
         "--summarize requires -o in a format with attributes");
    for (const std::string wrong : {"v", "v:", ":mean", "v:median", "v:mean,,v:max", "''"})
      says(folder, "shape p.csv --alpha 1 -o s.geojson --summarize " + wrong, 2,
           "expected FIELD:STATISTIC, several with commas between them; a statistic is min, max, mean, sum or "
           "majority\n");
    says(folder, "shape p.csv --alpha 1 -o s.geojson --summarize w:mean", 3, "p.csv: found no field 'w'");
    says(folder, "shape p.csv --alpha 1 -o s.geojson --isolated i.csv --summarize w:mean", 3,
         "p.csv: found no field 'w' beside the coordinates, expected some of 'g', 'kind' and 'v' (--summarize chooses "
         "them)\n");
    says(folder, "shape p.csv --alpha 1 -o s.geojson --summarize kind:mean", 3,
         "p.csv: found texts in field 'kind', expected numbers, as --summarize kind:mean requires (majority takes "
         "texts)\n");
    CHECK(!folder.has("s.geojson"));
    folder.rbpa(
        "shape p.csv --alpha 1 -o s.geojson --summarize v:mean,v:min,kind:majority --isolated i.csv --fields kind", 0);
    CHECK(contains(folder.content("s.geojson"), "\"v_mean\":null,\"v_min\":null,\"kind_majority\":\"b\"}"));
    CHECK(folder.content("i.csv") == "x,y,index,kind\n9,9,3,c\n");
  }
}
