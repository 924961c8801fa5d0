// Gzip files that decompress to more than fits into memory, or to more than data do.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/formats.h"
#include "support/claiming_files.h"
#include "support/gzip.h"
#include "support/image_files.h"
#include "support/mesh_files.h"
#include "support/program.h"

using namespace apps_test;

namespace {

const std::string zeros(1, '\0');
constexpr std::size_t slack = std::size_t{1} << 20U;

/// Returns the message and the exit code of `command` in a limited address space.
Outcome limited(const Folder& folder, const std::string& command, std::size_t mebibytes) {
  return folder.run("/bin/sh", "-c 'ulimit -v " + std::to_string(mebibytes << 10U) + "; " + command + "'");
}

/// The shadow memory of a sanitizer exceeds any limit.
bool can_limit() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  MESSAGE("SKIPPED: sanitizers take memory for themselves");
  return false;
#else
  return true;
#endif
}

const std::size_t limit = rbpa::app::has_gdal() ? 280 : 160;  // mebibytes; the libraries of GDAL take some
constexpr std::size_t more_than_that = std::size_t{192} << 20U;

/// Checks a file for which memory is the limit. `way_out` is the hint at the end of the message.
void check_memory(const Folder& folder, const std::string& command, const std::string& name,
                  const std::string& way_out = "") {
  const Outcome outcome = limited(folder, command, limit);
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, name + ": found more than "));
  CHECK(contains(outcome.err, " MB of decompressed data, expected at most a fifth of the "));
  CHECK(outcome.err.ends_with(" MB of available memory, as reading needs five times the size" + way_out + "\n"));
}

const std::string stream = " (rbpa stream reads tables, .npy, .f64xy, LAS and LAZ a block at a time)";

}  // namespace

TEST_SUITE("gzip bombs") {
  TEST_CASE("bytes behind a whole file are decompressed as far as memory suffices, or to 500 times their size") {
    const Folder folder;
    const auto check = [&](const std::vector<File>& files, const std::string& before, const std::string& behind,
                           const std::string& way_out) {
      for (const auto& [name, content, unused] : files) {
        const std::string path = name + ".gz";
        CAPTURE(path);
        folder.file(path, bomb(content, zeros, more_than_that));
        const Outcome outcome = folder.run("/bin/sh", "-c '" + before + path + behind + "'", 3);
        CHECK(contains(outcome.err, path + ": found "));
        CHECK(
            outcome.err.ends_with(" bytes that decompress to more than 67 MB, expected at most 500 times their size "
                                  "(decompress the file by gunzip if its content is right)\n"));
        if (can_limit()) check_memory(folder, before + path + behind, path, way_out);
      }
    };
    const std::string rbpa = RBPA_PROGRAM, meshtopo = MESHTOPO_PROGRAM;
    check(claiming_points(), rbpa + " info ", "", stream);
    check(claiming_space(), rbpa + " surface ", " --radius 1 -o s.off", "");
    check(claiming_meshes(), meshtopo + " ", "", "");
  }

  TEST_CASE("a file without a header is decompressed as far as memory suffices") {
    if (!can_limit()) return;
    const Folder folder;
    const std::string rbpa = RBPA_PROGRAM, polygon = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n";
    for (const auto& [name, content, behind] : std::vector<File>{{"p.xy", corner},
                                                                 {"p.csv", "x,y\n0,0\n"},
                                                                 {"p.geojson", "{\"type\": "},
                                                                 {"p.wkt", "POINT (1 2)\n"},
                                                                 {"p.f64xy", ""},
                                                                 {"p.png", png_header(2, 2)}}) {
      const std::string& file = name;
      CAPTURE(file);
      const bool is_table = name == "p.xy" || name == "p.csv";
      folder.file(name + ".gz", bomb(content, is_table ? " " : zeros, more_than_that));
      check_memory(folder, rbpa + " info " + name + ".gz", name + ".gz", stream);
      if (name == "p.f64xy") continue;  // numbers may begin like a gzip file: its name has to say that it is one
      check_memory(folder, rbpa + " info - --format " + name.substr(2) + " < " + name + ".gz", "standard input",
                   stream);
    }
    // Each four bytes are a point.
    folder.file("many.xy.gz", bomb("", "0 0\n", more_than_that));
    check_memory(folder, rbpa + " info many.xy.gz", "many.xy.gz", stream);
    for (const auto& [name, content, behind] : std::vector<File>{{"p.xyz", "0 0 0\n"}, {"p.obj", pyramid_obj}}) {
      folder.file(name + ".gz", bomb(content, " ", more_than_that));
      check_memory(folder, rbpa + " surface " + name + ".gz --radius 1 -o s.off", name + ".gz");
    }
    for (const auto& [name, content, behind] :
         std::vector<File>{{"p.obj", pyramid_obj}, {"t.stl", stl_text({{0, 1, 2}})}}) {
      folder.file(name + ".gz", bomb(content, " ", more_than_that));
      check_memory(folder, MESHTOPO_PROGRAM + (" " + name) + ".gz", name + ".gz");
    }
    for (const auto& [name, content, behind] :
         std::vector<File>{{"q.wkt", polygon}, {"q.poly", "4 2 0 0\n"}, {"q.json", "{"}}) {
      folder.file(name + ".gz", bomb(content, " ", more_than_that));
      check_memory(folder, rbpa + " fill " + name + ".gz --size 1 -o s.off", name + ".gz");
    }
    folder.file("q.wkt", polygon);
    folder.file("sizes.gz", bomb("0 0 1\n", "\n", more_than_that));
    check_memory(folder, rbpa + " fill q.wkt --size 1 --size-at sizes.gz -o s.off", "sizes.gz");
  }

  TEST_CASE("zeros named as text are refused after a mebibyte") {
    const Folder folder("z.gz", bomb("", zeros, more_than_that));
    for (const std::string format : {"xyz", "csv", "pts", "obj", "pdb"}) {
      const Outcome outcome = folder.rbpa("surface z.gz --format " + format + " --radius 1 -o s.off", 3);
      CAPTURE(format);
      CHECK(contains(
          outcome.err,
          "z.gz: found a zero byte after 0 bytes of decompressed text, expected text (--format names another format)"));
    }
  }

  TEST_CASE("an invalid or endless header is refused as in a file that is not compressed") {
    const Folder folder;
    const std::string comments(3 * slack, 'x');
    for (const auto& [name, content, behind] : std::vector<File>{{"p.ply", comments},
                                                                 {"c.ply", "ply\ncomment " + comments},
                                                                 {"p.off", comments},
                                                                 {"c.off", "OFF\n#" + comments},
                                                                 {"p.npy", comments},
                                                                 {"p.pgm", comments},
                                                                 {"c.pgm", "P2\n#" + comments},
                                                                 {"p.las", comments}}) {
      const std::string& file = name;
      CAPTURE(file);
      folder.file(name, content);
      folder.file(name + ".gz", compressed(content));
      const std::string command = "info - --format " + name.substr(2) + " < ";
      const Outcome plain = folder.rbpa(command + name), outcome = folder.rbpa(command + name + ".gz", 3);
      CHECK(outcome.err == plain.err);
    }
  }

  TEST_CASE("up to a mebibyte of bytes after the data is ignored, as in a file that is not compressed") {
    const Folder folder;
    for (const auto& [name, content, behind] : claiming_points()) {
      const std::string& file = name;
      CAPTURE(file);
      const std::string more = content + std::string(slack - 1, name == "t.pgm" ? '\n' : '\0');
      folder.file(name, more);
      folder.file(name + ".gz", compressed(more));
      const Outcome plain = folder.rbpa("info " + name), outcome = folder.rbpa("info " + name + ".gz");
      CHECK(outcome.code == plain.code);
      CHECK(outcome.out == plain.out);
    }
  }

  TEST_CASE("whole files of many megabytes are read, with any lists, lines and records") {
    const Folder folder;
    constexpr std::size_t count = 30'000, in_list = 40;
    std::string ascii = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
                        "\nproperty float x\nproperty float y\nelement face " + std::to_string(count) +
                        "\nproperty list int int vertex_indices\nend_header\n";
    std::string binary = ascii, off = "OFF\n" + std::to_string(count) + " " + std::to_string(count) + " 0\n";
    binary.replace(binary.find("ascii"), 5, "binary_little_endian");
    std::string list = std::to_string(in_list), grey = "P2\n1000 1000\n9\n";
    for (std::size_t i = 0; i < in_list; ++i) list += " " + std::to_string(i);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string line = std::to_string(i) + " " + std::to_string(i * i % 1009);
      ascii += line + "\n";
      off += line + "                                 0\n\n# a comment\n";
    }
    binary += std::string(8 * count, '\0');
    for (std::size_t i = 0; i < count; ++i) {
      ascii += list + "\n";
      off += list + "\n";
      binary += little(in_list, 4) + std::string(4 * in_list, '\0');
    }
    for (std::size_t i = 0; i < 1'000'000; ++i) grey += i % 7 == 0 ? " 0\n   " : "9 \t  ";
    const std::vector<File> files = {
        {"a.ply", ascii},
        {"b.ply", binary},
        {"p.off", off},
        {"p.pgm", grey},
        {"p.npy", npy_of_zeros("(1000000, 2)", 2'000'000)},
        {"p.las", las_of(200, {{"user", 1, std::string(5 * slack, 'x')}, {"user", 2, "y"}})}};
    for (const auto& [name, content, behind] : files) {
      const std::string& file = name;
      CAPTURE(file);
      folder.file(name, content);
      folder.file(name + ".gz", compressed(content));
      const Outcome plain = folder.rbpa("info " + name), outcome = folder.rbpa("info " + name + ".gz");
      CHECK(plain.code == 0);
      CHECK(outcome.code == 0);
      CHECK(outcome.out == plain.out);
      // A cut file ends as the uncompressed one does.
      const std::string half = content.substr(0, content.size() - content.size() / 3);
      folder.file(name, half);
      folder.file(name + ".gz", compressed(half));
      const std::string command = "info - --format " + name.substr(2) + " < ";
      CHECK(folder.rbpa(command + name + ".gz").err == folder.rbpa(command + name).err);
    }
  }

  TEST_CASE("a wrong header of LAS is no limit if all whole records are wanted") {
    const Folder folder;
    std::string content = las_of(100'000);
    content.replace(107, 4, little(0, 4));
    content.replace(247, 8, little(0, 8));
    folder.file("p.las.gz", compressed(content));
    CHECK(folder.rbpa("info p.las.gz").code == 3);
    CHECK(folder.rbpa("info p.las.gz --skip-invalid").out.starts_with("points      100000\n"));
  }
}
