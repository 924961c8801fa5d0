// All kinds of bad input: the exit code, the whole message, and no output.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "support/gdal_endings.h"
#include "support/npy_file.h"
#include "support/program.h"

using namespace apps_test;

namespace {

void refuses_text(const std::string& content, const std::string& message) {
  CAPTURE(content);
  const Folder folder("p.xy", content);
  refuses(folder, "mesh p.xy --alpha 1 -o m.off", 3, message);
}

std::string doubles(std::initializer_list<double> values) {
  std::string bytes(values.size() * sizeof(double), '\0');
  if (!bytes.empty()) std::memcpy(bytes.data(), std::data(values), bytes.size());
  return bytes;
}

const std::string ply_header =
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\nend_header\n";

}  // namespace

TEST_SUITE("bad input") {
  TEST_CASE("a missing file is refused") {
    refuses(Folder(), "mesh none.xy --alpha 1 -o m.off", 3, "none.xy: found no such file, expected a file of points");
  }

  TEST_CASE("an empty file is refused") { refuses_text("", "p.xy: found an empty file, expected points"); }

  TEST_CASE("a line that is not numbers is named by file, line and text") {
    refuses_text("0 0\n1 0\n# a comment\n2 abc\n", "p.xy:4: found 'abc', expected a number" + skipping_hint);
    refuses_text("0 0\n1 0x\n", "p.xy:2: found '0x', expected a number" + skipping_hint);
  }

  TEST_CASE("text in the first columns of a wider table is refused with a hint at --columns") {
    const Folder folder("p.csv", "name,a,b\nBerlin,13.4,52.5\n");
    refuses(folder, "mesh p.csv --alpha 1 -o m.off", 3,
            "p.csv:1: found 'name,a,b', expected known names of coordinates, such as x and y (--columns a,b chooses "
            "columns)");
    folder.file("p.csv", "Berlin,13.4,52.5\n");
    refuses(folder, "mesh p.csv --alpha 1 -o m.off", 3,
            "p.csv:1: found 'Berlin', expected a number (--columns X,Y chooses other columns)");
    folder.file("p.csv", "name,lon,lat\nBerlin,13.4,52.5\nBonn,east,50.7\n");
    refuses(folder, "mesh p.csv --columns lon,lat --alpha 1 -o m.off", 3,
            "p.csv:3: found 'east', expected a number" + skipping_hint);
  }

  TEST_CASE("NaN and infinity are refused") {
    refuses_text("0 0\nnan 1\n", "p.xy:2: found 'nan', expected a finite number" + skipping_hint);
    refuses_text("0 0\n1 -inf\n", "p.xy:2: found '-inf', expected a finite number" + skipping_hint);
  }

  TEST_CASE("a number beyond every double is refused") {
    const Folder folder("p.xy", "0 0\n1e999 1\n");
    says(folder, "mesh p.xy --alpha 1 -o m.off", 3, "p.xy:2: found '1e999', expected ");
  }

  TEST_CASE("a wrong number of columns is refused") {
    refuses_text("0 0\n1 2 3\n", "p.xy:2: found 3 columns ('1 2 3'), expected 2 as in line 1" + skipping_hint);
    refuses_text("0 0\n1\n", "p.xy:2: found 1 column ('1'), expected 2 as in line 1" + skipping_hint);
  }

  TEST_CASE("a missing column is refused") {
    const Folder folder("p.csv", "lon,lat\n1,2\n");
    says(folder, "mesh p.csv --columns lon,height --alpha 1 -o m.off", 3, "'height'");
  }

  TEST_CASE("a truncated binary file is refused") {
    const Folder folder(
        "p.npy", npy_file("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }", doubles({0, 0, 1, 0, 0})));
    Outcome outcome = folder.rbpa("mesh p.npy --alpha 1 -o m.off", 3);
    CHECK(contains(outcome.err, "p.npy: found 40 bytes of data, expected 3 rows of 16 bytes as the header says"));
    folder.file("p.ply", ply_header + doubles({0, 0, 1, 0, 0}));
    outcome = folder.rbpa("mesh p.ply --alpha 1 -o m.off", 3);
    CHECK(contains(outcome.err, "p.ply: found 40 bytes of data, expected 3 vertex elements as line 3 says"));
    folder.file("p.f64xy", doubles({0, 0, 1}));
    CHECK(folder.rbpa("mesh p.f64xy --alpha 1 -o m.off").code == 3);
    CHECK_FALSE(folder.has("m.off"));
  }

  TEST_CASE("text after the points and faces that a header counts is refused, and faces that are missing") {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string pcd =
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n";
    const std::string points = "0 0 1\n1 0 1\n0 1 1\n";
    struct Case {
      std::string name, head, faces, before_end;
      bool is_mesh;
    };
    for (const auto& [name, head, faces, before_end, is_mesh] :
         std::initializer_list<Case>{{"p.off", "OFF\n3 0 0\n", "", "0 face lines as line 2 says", true},
                                     {"f.off", "OFF\n3 1 0\n", "3 0 1 2\n", "1 face line as line 2 says", true},
                                     {"p.ply", ply, "3 0 1 2\n", "1 face element as line 7 says", true},
                                     {"p.pcd", pcd, "", "3 points as line 9 says", false}}) {
      const std::string file = name;
      CAPTURE(file);
      const Folder folder(name, head + points + faces + "# a comment\n\n");
      CHECK(folder.rbpa("surface --radius 2 -o s.off " + name).code == 0);
      folder.file(name, head + points + faces + "5 5 1\n");
      const std::string line = std::to_string(std::count(head.begin(), head.end(), '\n') + 4 + (faces.empty() ? 0 : 1));
      const std::string found = name + ":" + line + ": found '5 5 1', expected the end of the file after " + before_end;
      CHECK(contains(folder.rbpa("surface --radius 2 -o s.off " + name).err, found));
      if (!is_mesh) continue;  // the plane does not read PCD
      CHECK(contains(folder.rbpa("info " + name).err, found));
      CHECK(contains(folder.meshtopo(name + " -q").err, found));
      if (faces.empty()) continue;
      folder.file(name, head + points);
      for (const std::string verb : {"info ", "surface --radius 2 -o s.off "})
        CHECK(folder.rbpa(verb + name).code == 3);
    }
  }

  TEST_CASE("a header that claims more points than the file holds is refused before memory is allocated") {
    const Folder folder;
    folder.file("p.npy",
                npy_file("{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999, 2), }", doubles({0, 0})));
    folder.file("p.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 99999999999999\nproperty double x\n"
                "property double y\nend_header\n" +
                    doubles({0, 0}));
    folder.file("p.off", "OFF\n99999999999999 0 0\n0 0 0\n");
    for (const char* name : {"p.npy", "p.ply", "p.off"}) {
      CAPTURE(name);
      says(folder, std::string("mesh ") + name + " --alpha 1 -o m.off", 3, "99999999999999");
      CHECK_FALSE(folder.has("m.off"));
    }
  }

  TEST_CASE("NaN in a binary file is refused with the number of the point") {
    const Folder folder("p.f64xy", doubles({0, 0, 1, __builtin_nan("")}));
    const Outcome outcome = folder.rbpa("mesh p.f64xy --alpha 1 -o m.off", 3);
    CHECK(contains(outcome.err, "nan"));
    CHECK(contains(outcome.err, "point 1"));
  }
}

TEST_SUITE("wrong usage") {
  TEST_CASE("an alpha that is not a radius is refused") {
    const Folder folder("p.xy", corner);
    for (const std::string alpha : {"0", "-1", "nan", "-inf", "abc", "1x"})
      refuses(
          folder, "mesh p.xy -o m.off --alpha=" + alpha, 2,
          "--alpha: found '" + alpha + "', expected a radius (a number > 0, or inf), auto, min, plateau or plateau:K");
  }

  TEST_CASE("common mistakes of a command line are refused with the way out") {
    struct Mistake {
      std::string arguments, found, way;
    };
    const Folder folder({{"p.csv", "x,y,sp\n0,0,a\n1,0,a\n0,1,b\n"}, {"p.dat", corner}, {"p", corner}});
    const std::string shape = "shape p.csv --alpha 1 ";
    for (const Mistake& mistake : std::initializer_list<Mistake>{
             {"", "found no verb, expected one of mesh, alpha, shape", "(see rbpa --help)"},
             {shape + "-o", "--output: found no value, expected OUT", "(see rbpa shape --help)"},
             {"shape p.csv --alpha", "--alpha: found no value, expected R|", "(see rbpa shape --help)"},
             {"shape p.csv --alpha 2,5 -o s.wkt", "--alpha: found '2,5', expected a radius", ", with a decimal point"},
             {"surface p.csv -o s.ply", "--radius is required: auto, or a radius, about 1 to 4 times",
              "between neighbors (see rbpa surface --help)"},
             {"solid p.csv -o s.vtu", "--alpha is required: a radius", ", auto or plateau (see rbpa solid --help)"},
             {"stream p.csv -o s.wkt", "--alpha is required: a finite radius", " (see rbpa stream --help)"},
             {"discs p.csv -o s.wkt", "--radius is required: a radius", "column:NAME (see rbpa discs --help)"},
             {"report p.csv", "--output is required: a name such as page.html", "(see rbpa report --help)"},
             {shape + "--columns x,y --columns 1,2", "--columns: found 2 values, expected one", " --help)"},
             {"balls p.csv --pockets p.csv --pockets p.pml", "--pockets: found 2 values, expected one", " --help)"},
             {"balls p.csv --top 3", "found '--top', expected an option of rbpa balls (see rbpa balls --help)", ""},
             {"balls p.csv -o r.json", "r.json: found the ending 'json', expected csv, or --output-format", ""},
             {"balls p.csv -o - --contacts -", "standard output: found twice among the files to write, expected once",
              ""},
             {"solid p.csv --alpha 1 --boundary -", "--boundary: found standard output, expected a file: one of", ""},
             {"balls p.csv --radii 1.7", "1.7: found no such file", "column:NAME (--radius-default 1.7)"},
             {"balls md.xtc", "md.xtc: found the ending 'xtc'",
              "(gmx trjconv -f md.xtc -s topol.tpr -o frames.pdb; Python: MDAnalysis)"},
             {"balls md.dcd", "md.dcd: found the ending 'dcd'", "(MDAnalysis in Python writes it as .pdb)"},
             {"solid p.csv --alpha 1 --voids v.pml", "--voids: found the ending 'pml', expected one of obj, ",
              "(rbpa balls --voids writes .pml)"},
             {"grid p.csv --cell 1 -o d.tif", "d.tif: found the ending 'tif'",
              "(write d.asc, then gdal_translate d.asc d.tif)"},
             {"mesh p.csv --alpha inf -o m.ply --segments b.geojson",
              "b.geojson: found no such file, expected a file of lines", ""},
             {shape + "-o s.geojson --summarize z:mean",
              "p.csv: found 'z', a coordinate, in place of a field, expected one", ", as --summarize requires"},
             {shape + "-o s.csv --fields x", "p.csv: found 'x', a coordinate, in place of a field, expected ", ""},
             {"shape . --alpha 1 -o s.wkt", ".: found a folder, expected a file", ""},
             {"shape p.dat --alpha 1 -o s.wkt", "p.dat: found the ending 'dat'",
              "or --format (--format txt if it is a table)"},
             {"solid p --alpha 1 -o s.ply", "p: found the ending ''", "or --format (--format txt if it is a table)"},
             {"shape https://x.org/p.csv --alpha 1 -o s.wkt", "https://x.org/p.csv: found an address",
              "(download it first: curl -LO https://x.org/p.csv)"},
             {"shape https://x.org/p --alpha 1 -o s.wkt", "https://x.org/p: found the ending",
              "(download it first: curl -LO https://x.org/p)"},
             {shape + "-o s.gpx", "s.gpx: found the ending 'gpx'", "(write s.geojson, then ogr2ogr s.gpx s.geojson)"},
             {shape + "s.geojson", "POINTS: found 2 files, the last 's.geojson', expected one",
              "(-o OUT names a file to write; a list such as X,Y has no blanks)"},
             {shape + "-o s.wkt --columns x, y", "POINTS: found 2 files, the last 'y'",
              "a list such as X,Y has no blanks)"},
             {shape + "-o s.wkt --where 'sp = a'", "p.csv:1: found 'x,y,sp', expected a header with a column 'a'",
              " (texts are in quotes: == \"a\")"},
             {shape + "-o s.wkt --columns 2", "p.csv:2: found '0', expected a geometry",
              "(--columns X,Y takes two columns)"}}) {
      CAPTURE(mistake.arguments);
      const Outcome outcome = folder.rbpa(mistake.arguments);
      CAPTURE(outcome.err);
      CHECK(outcome.code >= 2);
      CHECK(outcome.err.starts_with("rbpa: " + mistake.found));
      CHECK(outcome.err.ends_with(mistake.way + "\n"));
      CHECK(folder.names().size() == 3);
    }
  }

  TEST_CASE("a missing alpha, a missing verb and an unknown option are refused") {
    const Folder folder("p.xy", corner);
    CHECK(folder.rbpa("mesh p.xy -o m.off").code == 2);
    CHECK(folder.rbpa("").code == 2);
    CHECK(folder.rbpa("info p.xy --stats -").code == 2);
    refuses(folder, "mehs p.xy --alpha 1 -o m.off", 2,
            "found 'mehs', expected one of mesh, alpha, shape, discs, voronoi, grid, fill, surface, solid, balls, "
            "stream, info, report (see rbpa --help)");
    for (const std::string before : {"", "--alpha 1 "})  // with and without required options
      refuses(folder, "mesh p.xy " + before + "-o m.off --alhpa 2", 2,
              "found '--alhpa', expected an option of rbpa mesh (is it --alpha? see rbpa mesh --help)");
    refuses(folder, "shape p.xy --alpha 1 --out s.wkt", 2,
            "found '--out', expected an option of rbpa shape (is it --output? see rbpa shape --help)");
    CHECK(contains(folder.rbpa("shap p.xy").err, "(is it shape? see rbpa --help)"));
    for (const std::string verb : {"shape p.xy q.xy --alpha 1 -o s.wkt", "mesh p.xy q.xy --alpha 1 -o s.ply"})
      refuses(folder, verb, 2,
              "POINTS: found 2 files, the last 'q.xy', expected one, or --group-by-file (each is a group), or "
              "--group-by COLUMN (-o OUT names a file to write; a list such as X,Y has no blanks)");
    refuses(folder, "surface p.xy q.xy --radius 1 -o s.ply", 2,
            "found 'q.xy', expected no more arguments of rbpa surface (see rbpa surface --help)");
  }

  TEST_CASE("an empty name is refused") {
    const Folder folder("p.xy", corner);
    refuses(folder, "mesh '' --alpha 1 -o m.off", 2, "POINTS: found an empty name, expected a path or -");
    refuses(folder, "mesh p.xy --alpha 1 -o ''", 2, "-o: found an empty name, expected a path or -");
    refuses(folder, "mesh p.xy --alpha 1 -o m.off --stats ''", 2,
            "-o, or another option with a file to write: found an empty name, expected a path");
  }

  TEST_CASE("a numeric value with other characters or out of range is refused") {
    const Folder folder("p.xy", corner);
    const std::string far = "99999999999999999999";
    for (const std::string value : {far.c_str(), "0", "-1", "+3", "1e3", "1.5", "0x10", "2x", " 3", "3 ", "", "nan"}) {
      CAPTURE(value);
      const auto refuses_value = [&](const std::string& run, const std::string& option, const std::string& expected) {
        refuses(folder, run + " " + option + " '" + value + "'", 2,
                option + ": found '" + value + "', expected a whole number " + expected);
      };
      refuses_value("mesh p.xy --alpha auto -o m.off", "--components", "from 1");
      refuses_value("shape p.xy --alpha auto -o m.wkt", "--components", "from 1");
      refuses_value("alpha p.xy", "--components", "from 1");
      refuses_value("mesh p.xy --alpha 1 -o m.off --method hrbpa", "--leaf-capacity", "of points from 1");
      refuses_value("mesh p.xy --alpha 1 -o m.png", "--width", "of pixels from 64 to 8192");
      refuses_value("shape p.xy --alpha 1 -o m.png", "--width", "of pixels from 64 to 8192");
      refuses_value("mesh p.xy --alpha 1 -o m.off", "--threads", "from 1 to 1024");
      if (value == "0") continue;
      CHECK(folder.meshtopo("m.off --max-defects '" + value + "'").err ==
            "meshtopo: --max-defects: found '" + value + "', expected a whole number from 0\n");
    }
  }

  TEST_CASE("--columns takes exactly two columns") {
    const Folder folder({{"p.xy", corner}, {"p.csv", "lon,lat\n0,0\n1,0\n0,1\n"}});
    const auto refuses_columns = [&](const std::string& columns, const std::string& found) {
      refuses(folder, "mesh p.csv --alpha 1 -o m.off --columns '" + columns + "'", 2,
              "--columns: found '" + found + "', the same column twice, expected two columns");
    };
    refuses_columns("1,1", "1,1");
    refuses_columns("1,01", "1,01");
    refuses_columns("lon,lon", "lon,lon");
    refuses_columns("lon,LON", "lon");  // found in the header only
    refuses_columns("1,lon", "lon");
    refuses(folder, "info p.csv --columns 'lon;lat'", 2,
            "--columns: found 'lon;lat', expected X,Y, with a comma between two columns");
    CHECK(folder.rbpa("mesh p.csv --alpha 1 -o m.off --columns ' lat , lon ' -q").code == 0);
    for (const std::string number : {"0", "-1", "1.5", "1e0", "99999999999999999999", "1e999"})
      refuses(folder, "info p.xy --columns=2," + number, 2,
              "--columns: found '" + number + "', expected a column number from 1 or a column name");
  }

  TEST_CASE("a value for a switch, and an option without one, are refused") {
    const Folder folder("p.xy", corner);
    for (const std::string run : {"mesh p.xy --alpha 1 -o m.off --compact=7", "info p.xy --quiet=false",
                                  "alpha p.xy --json=abc", "info p.xy --format xy --format xy",
                                  "mesh p.xy --alpha 1 --alpha 1 -o m.off", "mesh p.xy -o m.off --alpha"}) {
      CAPTURE(run);
      const Outcome outcome = folder.rbpa(run, 2);
      CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    }
    CHECK(folder.meshtopo("m.off --json=2").code == 2);
    CHECK(folder.names().size() == 1);
  }

  TEST_CASE("a missing GDAL is named for endings that GDAL would write or read, and for these alone") {
    const Folder folder("p.xy", corner);
    const std::string none = rbpa::app::has_gdal() ? "" : "(this build has no GDAL: ";
    for (const auto& row : std::initializer_list<std::pair<std::string, std::string>>{
             {"shape p.xy --alpha 1 -o s.gpkg", none + "write s.geojson, then ogr2ogr s.gpkg s.geojson)\n"},
             {"mesh p.xy --alpha 1 -o s.shp", none + "write s.geojson, then ogr2ogr s.shp s.geojson)\n"},
             {"shape s.fgb --alpha 1 -o s.wkt", none + "ogr2ogr -f GeoJSON points.geojson s.fgb)\n"},
             {"shape p.xy --alpha 1 -o s.gpx", "(write s.geojson, then ogr2ogr s.gpx s.geojson)\n"},
             {"grid p.xy --contours 1 -o s.gpkg", "(write s.geojson, then ogr2ogr s.gpkg s.geojson)\n"}}) {
      const std::string arguments = row.first, advice = row.second;
      CAPTURE(arguments);
      const bool is_read_or_written = rbpa::app::has_gdal() && advice.front() != '(';
      if (!is_read_or_written) CHECK(folder.rbpa(arguments).err.ends_with(" " + advice));
    }
  }

  TEST_CASE("an unknown ending is refused with a list of the known ones") {
    const Folder folder({{"p.xy", corner}, {"p.foo", corner}});
    refuses(folder, "mesh p.xy --alpha 1 -o m.foo", 2,
            "m.foo: found the ending 'foo', expected one of off, ply, obj, npy, vtu, geojson, json, svg, png" +
                gdal_endings() + ", or --output-format");
    says(folder, "mesh p.foo --alpha 1 -o m.off", 2, "npy");
  }

  TEST_CASE("one file under two names is refused, also if it does not exist yet") {
    const Folder folder("p.xy", corner);
    refuses(folder, "mesh p.xy --alpha 1 -o m.off -o ./m.off", 2,
            "./m.off: found twice among the files to write, expected once");
  }

  TEST_CASE("help and version exit with 0") {
    const Folder folder;
    CHECK(folder.rbpa("--help").code == 0);
    CHECK(contains(folder.rbpa("mesh --help").out, "Examples:"));
    CHECK(folder.rbpa("--version").out == "rbpa " RBPA_VERSION "\n");
    CHECK(folder.meshtopo("--version").out == "meshtopo " RBPA_VERSION "\n");
  }
}

TEST_SUITE("failure while running") {
  TEST_CASE("a full disk is reported") {
    const Folder folder("p.xy", corner);
    refuses(folder, "mesh p.xy --alpha 1 -o /dev/full --output-format off", 1,
            "/dev/full: cannot write: No space left on device");
  }

  TEST_CASE("an unwritable output is reported") {
    const Folder folder("p.xy", corner);
    refuses(folder, "mesh p.xy --alpha 1 -o none/m.off", 1,
            "none/m.off: found no folder 'none', expected one to write to");
  }

  TEST_CASE("a folder as output, and a missing folder, are found before anything is read") {
    const Folder folder;
    std::filesystem::create_directory(folder.path("d.off"));
    refuses(folder, "mesh p.xy --alpha 1 -o d.off", 1, "d.off: found a folder, expected a file to write");
    refuses(folder, "shape p.xy --alpha 1 -o s.wkt --stats a/b/s.json", 1,
            "a/b/s.json: found no folder 'a/b', expected one to write to");
  }

  TEST_CASE("one output that fails keeps the others away and leaves what was there") {
    const Folder folder({{"p.xy", corner}, {"m.off", "old"}});
    CHECK(folder.rbpa("mesh p.xy --alpha 1 -o m.off -o /dev/full --output-format ply").code == 1);
    CHECK(folder.content("m.off") == "old");
    CHECK(folder.names().size() == 2);
  }
}
