// The page of `rbpa report` as a file: its numbers, its bytes, and that it makes no request. Its behavior in a browser
// is tested by report/browser.mjs.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

const std::string points = "'" RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy' ";

/// Two right triangles of circumradius 5 and 10, far from each other.
const char* const two_triangles = "0 0\n6 0\n0 8\n100 0\n112 0\n100 16\n0 0\n";

std::string page_of(const Folder& folder, const std::string& arguments) {
  folder.rbpa("report " + arguments + " -o page.html -q", 0);
  return folder.content("page.html");
}

/// Returns the content of the data element of that name.
std::string element(const std::string& page, const std::string& name) {
  const std::string begin = "id=\"data-" + name + "\">";
  const std::size_t at = page.find(begin);
  REQUIRE(at != std::string::npos);
  return page.substr(at + begin.size(), page.find("</script>", at) - at - begin.size());
}

std::string bytes_of(const std::string& page, const std::string& name) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0, bits = 0;
  for (const char c : element(page, name)) {
    if (c == '\n' || c == '=') continue;
    const std::size_t digit = digits.find(c);
    REQUIRE(digit != std::string::npos);
    group = (group << 6U | static_cast<unsigned>(digit)) & 0xFFFFU;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits);
  }
  return bytes;
}

std::vector<double> doubles_of(const std::string& bytes) {
  std::vector<double> values;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t bits = 0;
    for (unsigned byte = 0; byte < 8; ++byte)
      bits |= std::uint64_t{static_cast<std::uint8_t>(bytes[i + byte])} << 8U * byte;
    values.push_back(std::bit_cast<double>(bits));
  }
  return values;
}

std::vector<std::uint64_t> wholes_of(const std::string& bytes) {
  std::vector<std::uint64_t> values;
  std::uint64_t value = 0;
  unsigned shift = 0;
  for (const char c : bytes) {
    value |= std::uint64_t{static_cast<std::uint8_t>(c) & 127U} << shift;
    shift += 7;
    if (static_cast<std::uint8_t>(c) >= 128) continue;
    values.push_back(value);
    value = shift = 0;
  }
  CHECK(shift == 0);
  return values;
}

std::int64_t as_difference(std::uint64_t value) {
  return value % 2 == 0 ? static_cast<std::int64_t>(value / 2) : -static_cast<std::int64_t>(value / 2) - 1;
}

double number_of(const Json& value) {
  return value == "inf" ? std::numeric_limits<double>::infinity() : value.get<double>();
}

/// Returns the text of a page as it is read.
std::string plain(std::string text) {
  for (const auto& [reference, sign] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    text = std::regex_replace(text, std::regex(reference), sign);
  return text;
}

/// Compares the page with `rbpa alpha` for the same points.
void agrees(const std::string& page, const Json& report) {
  const Json facts = Json::parse(element(page, "facts"));
  CHECK(facts["auto"] == report["auto"]);
  CHECK(facts["min"] == report["min"]);
  REQUIRE(facts["plateaus"].size() == report["plateaus"].size());
  for (std::size_t i = 0; i < facts["plateaus"].size(); ++i)
    for (const char* key : {"alpha", "from", "to", "long"})
      CHECK(facts["plateaus"][i][key] == report["plateaus"][i][key]);
  CHECK(facts["recommended"] == report["recommended"]);
  const auto radii = doubles_of(bytes_of(page, "radii")), areas = doubles_of(bytes_of(page, "areas"));
  const auto counts = wholes_of(bytes_of(page, "counts"));
  const Json& critical = report["critical"];
  CHECK(facts["steps"] == critical.size());
  REQUIRE(radii.size() == critical.size());
  REQUIRE(areas.size() == critical.size());
  REQUIRE(counts.size() == 5 * critical.size());
  std::array<std::int64_t, 5> now{};
  bool same = true;
  for (std::size_t i = 0; i < critical.size(); ++i) {
    same = same && radii[i] == number_of(critical[i]["alpha"]) && areas[i] == number_of(critical[i]["area"]);
    std::size_t at = 0;
    for (const char* name : {"triangles", "solid_components", "components", "holes", "covered"}) {
      now[at] += as_difference(counts[5 * i + at]);
      same = same && now[at++] == critical[i][name].get<std::int64_t>();
    }
  }
  CHECK(same);
  CHECK(facts["triangles"] == (critical.empty() ? Json(0) : critical.back()["triangles"]));
  CHECK(wholes_of(bytes_of(page, "triangles")).size() == 3 * facts["triangles"].get<std::size_t>());

  const auto pairs = wholes_of(bytes_of(page, "pairs"));
  REQUIRE(pairs.size() == 3 * report["pairs"].size());
  const std::size_t components = facts["componentPairs"];
  for (std::size_t i = 0; i < report["pairs"].size(); ++i) {
    const Json& pair = report["pairs"][i];
    same = same && pair["dimension"] == (i < components ? 0 : 1) && radii[pairs[3 * i]] == number_of(pair["birth"]);
    same = same && (pairs[3 * i + 1] == 0) == pair["death"].is_null();
    if (pairs[3 * i + 1] > 0) same = same && radii[pairs[3 * i] + pairs[3 * i + 1]] == number_of(pair["death"]);
  }
  CHECK(same);
}

}  // namespace

TEST_SUITE("report") {
  TEST_CASE("the numbers are those of rbpa alpha") {
    const Folder folder;
    for (const char* file : {"shape_hdbscan_clusterable.xy", "rob_delaunator_rs_grid.xy", "geo_usgs_quakes_week.xy",
                             "rob_jts_concavehull_155.xy"}) {
      CAPTURE(std::string(file));
      const std::string from = "'" RBPA_TEST_DATA "/" + std::string(file) + "' ";
      agrees(page_of(folder, from), Json::parse(folder.rbpa("alpha " + from + "--json --persistence -q").out));
    }
    for (const char* text : {two_triangles, corner, "0 0\n1 1\n3 3\n", "7 7\n", "0 0\n5e-324 0\n0 1e-323\n1e308 0\n",
                             "-1e308 0\n0 -5e-324\n1e308 0\n0 -1e308\n"}) {
      CAPTURE(std::string(text));
      folder.file("p.xy", text);
      agrees(page_of(folder, "p.xy"), Json::parse(folder.rbpa("alpha p.xy --json --persistence -q").out));
    }
  }

  TEST_CASE("auto follows --components and --cover") {
    const Folder folder;
    const Json covering = Json::parse(element(page_of(folder, points + "--cover 0.9 --components 3"), "facts"));
    const Json report = Json::parse(folder.rbpa("alpha " + points + "--json -q --cover 0.9 --components 3").out);
    for (const char* rule : {"auto", "min"}) CHECK(covering[rule] == report[rule]);
    CHECK(covering["cover"] == 0.9);
    for (const std::string components : {"1", "3"}) {
      const Json facts = Json::parse(element(page_of(folder, points + "--components " + components), "facts"));
      CHECK(facts["auto"] ==
            Json::parse(folder.rbpa("alpha " + points + "--json -q --components " + components).out)["auto"]);
      CHECK(facts["mostComponents"].dump() == components);
    }
  }

  TEST_CASE("points are the doubles of the input, each once, in lexicographic order") {
    const Folder folder("p.xy", "0.1 -0\n-1e-310 1.7976931348623157e308\n0.1 0\n0.30000000000000004 2\n-1e-310 -7\n");
    const auto found = doubles_of(bytes_of(page_of(folder, "p.xy"), "points"));
    const std::vector<double> expected{-1e-310, -7, -1e-310, 1.7976931348623157e308, 0.1, -0.0, 0.30000000000000004, 2};
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(std::bit_cast<std::uint64_t>(found[i]) == std::bit_cast<std::uint64_t>(expected[i]));
  }

  TEST_CASE("the bytes depend on the points and the name alone, not on their order or on threads") {
    const Folder folder;
    std::vector<std::string> lines;
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i)
      lines.push_back(std::to_string(random() % 200) + " " + std::to_string(random() % 200));
    const auto file = [&] {
      std::string text;
      for (const std::string& line : lines) text += line + "\n";
      folder.file("p.xy", text);
    };
    file();
    const std::string page = page_of(folder, "p.xy");
    CHECK(page == page_of(folder, "p.xy --threads 1"));
    std::shuffle(lines.begin(), lines.end(), random);
    file();
    CHECK(page == page_of(folder, "p.xy"));
    CHECK(page == folder.rbpa("report p.xy -o - -q").out);
  }

  TEST_CASE("the unit is that of the coordinate system, or degrees by the names of columns, or unknown") {
    const Folder folder({{"p.xy", two_triangles}, {"p.csv", "lon,lat\n0,0\n6,0\n0,8\n"}});
    const auto unit = [&](const std::string& arguments) {
      return Json::parse(element(page_of(folder, arguments), "facts"))["unit"];
    };
    CHECK(unit("p.xy").is_null());
    CHECK(unit("p.csv") == "degree");
    for (const auto& [code, expected] :
         std::vector<std::pair<std::string, std::string>>{{"EPSG:28992", "metre"},
                                                          {"EPSG:32632", "metre"},
                                                          {"EPSG:25830", "metre"},
                                                          {"EPSG:3857", "metre"},
                                                          {"EPSG:7415", "metre"},
                                                          {"EPSG:2903", "US survey foot"},
                                                          {"EPSG:2994", "foot"},
                                                          {"EPSG:4326", "degree"},
                                                          {"OGC:CRS84", "degree"}})
      CHECK(unit("p.xy --crs " + code) == expected);
    // Feet of the Gold Coast, links, degrees of a rare system, codes that are not assigned, codes of others.
    for (const char* code : {"EPSG:2136", "EPSG:3139", "EPSG:4120", "EPSG:1500", "ESRI:102003"})
      CHECK(unit("p.xy --crs " + std::string(code)).is_null());
  }

  TEST_CASE("the page has everything in it, and makes no request") {
    const Folder folder("p.xy", two_triangles);
    const std::string page = page_of(folder, "p.xy");
    CHECK(page.starts_with("<!DOCTYPE html>\n"));
    CHECK(page.ends_with("</html>\n"));
    CHECK(contains(page, "content=\"default-src 'none';"));
    // A name space is not a request.
    const std::string without = std::regex_replace(page, std::regex("http://www\\.w3\\.org/2000/svg"), "");
    for (const char* reference :
         {"http:", "https:", "src=", "@import", "url(", "fetch(", "XMLHttpRequest", "<link", "import("})
      CHECK(!contains(without, reference));
    for (const char* mark : {"@TITLE@", "@STYLE@", "@DATA@", "@SCRIPT@"}) CHECK(!contains(page, mark));
  }

  TEST_CASE("a name is shown as text, whatever is in it") {
    const Folder folder;
    for (const std::string name :
         {"<script>alert(1)&<b>.xy", "a\"'b\nc.xy", "\xff\xfe.xy", "--><!--.xy", "\u202e.xy"}) {
      CAPTURE(name);
      folder.file(name, two_triangles);
      std::string quoted = "./" + name;
      for (std::size_t at = 0; (at = quoted.find('\'', at)) != std::string::npos; at += 4)
        quoted.replace(at, 1, "'\\''");
      const std::string page = page_of(folder, "'" + quoted + "'");
      const std::string source = Json::parse(element(page, "facts"))["source"];
      CHECK(source.find('\n') == std::string::npos);
      CHECK(!contains(page, "<script>alert"));
      CHECK(!contains(page, "--><!--"));
      CHECK(element(page, "facts").find('<') == std::string::npos);
      const std::size_t begin = page.find("<title>") + 7;
      const std::string title = page.substr(begin, page.find("</title>") - begin);
      CHECK(title.find_first_of("<>") == std::string::npos);
      CHECK(plain(title) == source);
    }
    CHECK(Json::parse(element(folder.rbpa("report - -o - -q < './--><!--.xy'").out, "facts"))["source"] ==
          "standard input");
  }

  TEST_CASE("points without a triangle make a page, with a message") {
    const Folder folder("line.xy", "0 0\n1 1\n3 3\n");
    const Outcome line = folder.rbpa("report line.xy -o line.html", 0);
    CHECK(line.err ==
          "rbpa: the complex is empty at every alpha: all points are collinear\n"
          "rbpa: 3 points, 0 critical radii -> line.html\n");
    CHECK(folder.has("line.html"));
    folder.file("two.xy", "0 0\n1 1\n0 0\n");
    CHECK(folder.rbpa("report two.xy -o two.html -q").err ==
          "rbpa: the complex is empty at every alpha: fewer than three distinct points\n");
  }

  TEST_CASE("all files of a run appear, or none does") {
    const Folder folder({{"p.xy", corner}, {"p.html", "before"}});
    CHECK(folder.rbpa("report p.xy -o no_folder/p.html --stats s.json").code == 1);
    CHECK(folder.rbpa("report p.xy -o p.html --stats no_folder/s.json").code == 1);
    CHECK(folder.rbpa("report p.xy -o p.html --stats /dev/full").code == 1);
    CHECK(folder.content("p.html") == "before");
    CHECK(folder.names() == std::vector<std::string>{"p.html", "p.xy"});
    const Outcome outcome = folder.rbpa("report p.xy -o p.html --stats s.json", 0);
    CHECK(outcome.err == "rbpa: 3 points, 1 critical radius -> p.html\n");
    CHECK(folder.content("p.html") != "before");
    CHECK(Json::parse(folder.content("s.json"))["distinct"] == 3);
  }

  TEST_CASE("contradicting options are refused before anything is read") {
    const Folder folder;
    for (const auto& [wrong, said] :
         {std::pair<std::string, std::string>{"-o p.pdf", "p.pdf: found the ending 'pdf', expected html"},
          {"-o page", "page: found the ending '', expected html"},
          {"-o ''", "-o: found an empty name, expected a path or -"},
          {"-o p.html --components 0", "--components: found '0'"},
          {"-o p.html --cover 2", "--cover: found '2'"},
          {"-o p.html --alpha 1", "found '--alpha', expected an option of rbpa report"},
          {"-o - --stats -", ""},
          {"", "--output is required"}}) {
      const std::string& arguments = wrong;
      CAPTURE(arguments);
      const Outcome outcome = folder.rbpa("report no_such_file.xy " + wrong, 2);
      CHECK(outcome.out.empty());
      CHECK(contains(outcome.err, said));
      CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    }
    CHECK(folder.rbpa("report no_such_file.xy -o p.html").code == 3);
    folder.file("p.html", corner);
    CHECK(folder.rbpa("report p.html --format xy -o p.html").code == 2);
    CHECK(folder.names() == std::vector<std::string>{"p.html"});
  }

  TEST_CASE("a page of points in space has its data, and makes no request") {
    const Folder folder("octahedron.xyz", "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n");
    const std::string page = page_of(folder, "octahedron.xyz --dimension 3");
    const Json facts = Json::parse(element(page, "facts"));
    CHECK(facts["points"] == 6);
    CHECK(facts["tetrahedra"] == 4);
    CHECK(facts["cover"] == 1);
    CHECK(Json::parse(element(page_of(folder, "octahedron.xyz --dimension 3 --cover 0.9"), "facts"))["cover"] == 0.9);
    CHECK(facts["pairs"] == 14);  // six components, seven tunnels, and the void within
    const std::vector<double> radii = doubles_of(bytes_of(page, "radii"));
    CHECK(radii.size() == facts["steps"]);
    CHECK(std::is_sorted(radii.begin(), radii.end()));
    CHECK(std::count(radii.begin(), radii.end(), 1.0) == 1);
    bool has_void = false;
    for (const Json& one : facts["representatives"]) {
      if (one["dimension"] != 2) continue;
      has_void = true;
      CHECK(one["cells"].size() == 24);
      CHECK(one["volume"].get<double>() == doctest::Approx(4.0 / 3));
    }
    CHECK(has_void);
    for (const char* request : {"src=", "href=\"http", "import(", "fetch("})
      CHECK(!contains(page.substr(0, page.find("<script>")), request));
    folder.file("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    says(folder, "report octahedron.xyz --dimension 4 -o x.html", 2, "--dimension: found '4', expected 2 or 3");
    says(folder, "report octahedron.xyz --dimension 3 --components 2 -o x.html", 2,
         "--components applies only to --dimension 2");
    says(folder, "report octahedron.xyz --dimension 3 -o x.png", 2, "x.png: found the ending 'png', expected html");
    REQUIRE(folder.rbpa("report flat.xyz --dimension 3 -o flat.html -q").code == 0);
    CHECK(contains(folder.content("flat.html"), "0.7071067811865476"));
  }
}
