// Integers beyond the precision of double are refused in every format, and others are read.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "support/data_folder.h"
#include "support/program.h"

using namespace apps_test;

namespace {

constexpr std::int64_t most = std::int64_t{1} << 53U;

template <typename T>
std::string bytes_of(const std::vector<std::int64_t>& numbers) {
  std::string bytes;
  for (const std::int64_t number : numbers) {
    const T value = static_cast<T>(number);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof raw);
  }
  return bytes;
}

/// Returns three points of three coordinates, with the given first coordinate.
std::vector<std::int64_t> points_from(std::int64_t x) { return {x, 0, 0, 5, 7, 0, 1, 9, 0}; }

std::string text_of(std::int64_t x, const std::string& separator) {
  std::string text;
  const std::vector<std::int64_t> numbers = points_from(x);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += std::to_string(numbers[i]) + (i % 3 == 2 ? std::string("\n") : separator);
  return text;
}

std::string npy(const std::string& type, bool by_columns, const std::string& data) {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + (by_columns ? "True" : "False") + ", 'shape': (3, 3), }";
  header.resize(117, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) + '\0' + header + data;
}

std::string ply(const std::string& format, const std::string& type, const std::string& data) {
  return "ply\nformat " + format + " 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " + type +
         " y\nproperty " + type + " z\nend_header\n" + data;
}

std::string pcd(const std::string& kind, const std::string& type, const std::string& data) {
  return "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE " + type + " " + type + " " + type +
         "\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA " + kind + "\n" + data;
}

struct File {
  std::string name, content;
};

/// Returns files of every format with integers of 8 bytes, and of text.
std::vector<File> files_with(std::int64_t x) {
  const auto numbers = points_from(x);
  std::vector<std::int64_t> columns = {numbers[0], numbers[3], numbers[6], numbers[1], numbers[4],
                                       numbers[7], numbers[2], numbers[5], numbers[8]};
  std::vector<File> files = {{"signed.npy", npy("<i8", false, bytes_of<std::int64_t>(numbers))},
                             {"columns.npy", npy("<i8", true, bytes_of<std::int64_t>(columns))},
                             {"signed.ply", ply("binary_little_endian", "int64", bytes_of<std::int64_t>(numbers))},
                             {"text.ply", ply("ascii", "int64", text_of(x, " "))},
                             {"signed.pcd", pcd("binary", "I", bytes_of<std::int64_t>(numbers))},
                             {"text.pcd", pcd("ascii", "I", text_of(x, " "))},
                             {"text.off", "OFF\n3 1 0\n" + text_of(x, " ") + "3 0 1 2\n"},
                             {"text.csv", "x,y,z\n" + text_of(x, ",")},
                             {"text.xyz", text_of(x, " ")}};
  if (x < 0) return files;
  files.push_back({"unsigned.npy", npy("<u8", false, bytes_of<std::uint64_t>(numbers))});
  files.push_back({"unsigned.ply", ply("binary_little_endian", "uint64", bytes_of<std::uint64_t>(numbers))});
  files.push_back({"unsigned.pcd", pcd("binary", "U", bytes_of<std::uint64_t>(numbers))});
  return files;
}

}  // namespace

TEST_SUITE("integers beyond 2^53") {
  TEST_CASE("large integers are refused by name in every format, with either sign") {
    for (const std::int64_t x :
         {most + 1, -most - 1, std::int64_t{9223372036854775807}, -std::int64_t{1234567890123456789}})
      for (const auto& [name, content] : files_with(x)) {
        const Folder folder;
        const auto& shown_name = name;
        CAPTURE(shown_name);
        CAPTURE(x);
        folder.file(name, content);
        const Outcome outcome = folder.rbpa("surface " + name + " --radius 1 -o o.off -q", 3);
        CHECK(contains(outcome.err, std::to_string(x)));
        CHECK(contains(outcome.err, "2^53"));
        if (name.ends_with(".ply") || name.ends_with(".off")) CHECK(folder.meshtopo(name + " -q").code == 3);
        if (!name.ends_with(".pcd")) CHECK(folder.rbpa("shape " + name + " --alpha inf -o o.wkt -q").code == 3);
      }
  }

  TEST_CASE("large integers are refused in geometries of text") {
    for (const std::int64_t x : {most + 1, -most - 1}) {
      const Folder folder;
      folder.file("p.geojson",
                  "{\"type\": \"MultiPoint\", \"coordinates\": [[" + std::to_string(x) + ", 0], [5, 7], [1, 9]]}");
      folder.file("p.wkt", "MULTIPOINT (" + std::to_string(x) + " 0, 5 7, 1 9)");
      for (const std::string name : {"p.geojson", "p.wkt"}) {
        const Outcome outcome = folder.rbpa("shape " + name + " --alpha inf -o o.wkt -q", 3);
        CAPTURE(name);
        CHECK(contains(outcome.err, "2^53"));
      }
    }
  }

  TEST_CASE("2^53 and less are read, with either sign") {
    for (const std::int64_t x : {most, most - 1, -most, std::int64_t{12}})
      for (const auto& [name, content] : files_with(x)) {
        const Folder folder;
        const auto& shown_name = name;
        CAPTURE(shown_name);
        CAPTURE(x);
        folder.file(name, content);
        CHECK(folder.rbpa("surface " + name + " --radius 1e17 --normals none -o o.off -q").code == 0);
        CHECK(contains(folder.content("o.off"), std::to_string(x) + " 0 0\n"));
      }
  }

  TEST_CASE("large integers in fields of a condition are refused too") {
    const Folder folder;
    folder.file("a.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty int64 x\nproperty int64 y\nproperty "
                "int64 id\nend_header\n" +
                    bytes_of<std::int64_t>({0, 0, most + 1, 1, 0, 2, 0, 1, 3}));
    folder.file("a.csv", "x,y,id\n0,0," + std::to_string(most + 1) + "\n1,0,2\n0,1,3\n");
    for (const std::string name : {"a.ply", "a.csv"}) {
      CAPTURE(name);
      CHECK(folder.rbpa("info " + name + " --where 'id < 1e18'").code == 3);
      CHECK(folder.rbpa("info " + name).code == 0);
    }
  }

  TEST_CASE("files of others are read or refused") {
    for (const std::string name : {"int64_large.npy", "u64big.npy"}) {
      const Folder folder;
      const std::string path = (rbpa_test::bundled_data() / "findings" / "case_npy_beyond_2_53" / name).string();
      CHECK(folder.rbpa("shape " + path + " --alpha inf -o - --output-format wkt -q").code == 3);
    }
  }
}
