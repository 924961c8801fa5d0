// PCD with DATA binary_compressed: the points of the uncompressed file; damaged files and false claims are refused.
#include <doctest/doctest.h>

#include <cstring>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/las_file.h"
#include "support/lzf.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using namespace rbpa::app;
using rbpa::Point3;

namespace {

std::string head(const std::string& kind, std::size_t points, const std::string& gap = " _") {
  const bool has_gap = !gap.empty();
  return "VERSION 0.7\nFIELDS x" + gap + " y z rgb normal_x normal_y normal_z tag\nSIZE 4" + (has_gap ? " 1" : "") +
         " 8 4 4 4 4 4 2\nTYPE F" + (has_gap ? " U" : "") + " F F U F F F U\nCOUNT 1" + (has_gap ? " 3" : "") +
         " 1 1 1 1 1 1 2\nWIDTH " + std::to_string(points) + "\nHEIGHT 1\nPOINTS " + std::to_string(points) +
         "\nDATA " + kind + "\n";
}

template <typename T>
std::string raw(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// Returns the fields of point i without the gap.
std::vector<std::string> fields(std::size_t i) {
  const auto t = static_cast<float>(i);
  return {raw(t / 7), raw(static_cast<double>(i) / 3),
          raw(-t),    raw(static_cast<std::uint32_t>(i * 2654435761U)),
          raw(t),     raw(1.F),
          raw(0.F),   raw(static_cast<std::uint16_t>(i)) + std::string(2, '\7')};
}

std::string binary(std::size_t points) {
  std::string bytes = head("binary", points);
  for (std::size_t i = 0; i < points; ++i) {
    const std::vector<std::string> all = fields(i);
    for (std::size_t k = 0; k < all.size(); ++k) bytes += all[k] + (k == 0 ? "gap" : "");
  }
  return bytes;
}

/// Returns the values field by field.
std::string by_fields(std::size_t points) {
  std::vector<std::string> columns(8);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k] += fields(i)[k];
  std::string bytes;
  for (const std::string& column : columns) bytes += column;
  return bytes;
}

std::string with_sizes(const std::string& compressed, std::size_t decompressed) {
  return little(compressed.size(), 4) + little(decompressed, 4) + compressed;
}

std::string compressed(std::size_t points, const std::string& gap = " _") {
  const std::string bytes = by_fields(points);
  return head("binary_compressed", points, gap) + with_sizes(lzf_literals(bytes), bytes.size());
}

SpacePoints read(const std::string& bytes, const CloudRequest& request = {}) {
  return space_points_in(bytes, "p", Format::pcd, request);
}

std::string refusal(const std::string& bytes) {
  return rbpa_test::refusal_of<BadInput>([&] { read(bytes); });
}

/// Three points with x, y and z of 4 bytes.
std::string three(const std::string& data, const std::string& points = "POINTS 3") {
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n" + points + "\nDATA binary_compressed\n" + data;
}

}  // namespace

TEST_SUITE("compressed pcd") {
  TEST_CASE("compressed points are those of the uncompressed file, with and without gaps between fields") {
    for (const std::size_t count : {1U, 2U, 5U, 4095U, 4096U, 4097U, 10000U}) {
      CAPTURE(count);
      const SpacePoints expected = read(binary(count));
      REQUIRE(expected.points.size() == count);
      for (const std::string gap : {" _", ""}) {
        const SpacePoints file = read(compressed(count, gap));
        CHECK(file.points == expected.points);
        CHECK(file.normals == expected.normals);
        CHECK(file.colors == expected.colors);
        CHECK(file.warnings.empty());
      }
    }
    CHECK(read(compressed(2)).points[1] == Point3{static_cast<double>(1.F / 7), 1. / 3, -1});
  }

  TEST_CASE("--where selects by fields, also by those of several numbers") {
    const CloudRequest request{.where = Condition("x > 700 and z < -9995", names_of_properties())};
    const SpacePoints of_binary = read(binary(10000), request), file = read(compressed(10000), request);
    CHECK(file.points.size() == 4);
    CHECK(file.points == of_binary.points);
    CHECK(file.warnings == of_binary.warnings);
  }

  TEST_CASE("bytes after the data are ignored, and a file may have no points") {
    const std::string bytes = compressed(3);
    CHECK(read(bytes + "anything").points == read(bytes).points);
    CHECK(read(three(with_sizes("", 0), "POINTS 0")).points.empty());
    CHECK(read(three(with_sizes("x", 0), "POINTS 0")).points.empty());
  }

  TEST_CASE("copies are decompressed, near and far, short and long") {
    // z is 264 bytes of x and y again, over and over.
    std::string bytes;
    for (std::size_t i = 0; i < 66; ++i) bytes += raw(static_cast<float>(i));
    std::string compressed = lzf_literals(bytes), all = bytes;
    for (int k = 0; k < 2; ++k) {
      compressed += lzf_copy(264, 264);
      all += bytes;
    }
    const SpacePoints file = read(three(with_sizes(compressed, all.size()), "POINTS 66"));
    REQUIRE(file.points.size() == 66);
    for (std::size_t i = 0; i < 66; ++i)
      CHECK(file.points[i] == Point3{static_cast<double>(i), static_cast<double>(i), static_cast<double>(i)});
    CHECK(read(three(with_sizes(lzf_repeated('\0', 36), 36))).points == std::vector<Point3>(3));
    const std::string many = lzf_repeated('\0', 12 * 22000);
    CHECK(many.size() < 12 * 22000 / 87);  // as short as it can be
    CHECK(read(three(with_sizes(many, 12 * std::size_t{22000}), "POINTS 22000")).points == std::vector<Point3>(22000));
  }

  TEST_CASE("a file cut anywhere is refused, and the message has the place") {
    const std::string whole = compressed(5);
    const std::size_t header = head("binary_compressed", 5).size();
    for (std::size_t size = 1; size < whole.size(); ++size) {
      const std::string message = refusal(whole.substr(0, size));
      CAPTURE(size);
      CHECK(message.starts_with("p"));
      CHECK(contains(message, "found "));
      CHECK(contains(message, "expected "));
      if (size >= header && size < header + 8)
        CHECK(message ==
              "p: found " + counted(size - header, "byte") +
                  " of data, expected at least 8, the compressed and the decompressed size (copy the file again)");
      if (size >= header + 8)
        CHECK(message == "p: found " + counted(size - header - 8, "byte") + " of compressed data, expected " +
                             std::to_string(whole.size() - header - 8) + " as the compressed size after line 9 says");
    }
  }

  TEST_CASE("a file with any byte changed is read or refused, and nothing is read beyond it") {
    const std::string whole = compressed(4);
    std::size_t refused = 0;
    for (std::size_t i = head("binary_compressed", 4).size(); i < whole.size(); ++i)
      for (const int change : {1, 0x20, 0x80, 0xff}) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ change);
        const std::string message = refusal(damaged);
        if (message.empty()) continue;
        ++refused;
        CHECK(message.starts_with("p: "));
      }
    CHECK(refused > 30);
  }

  TEST_CASE("damaged data, and sizes that do not match the points, are refused") {
    const std::string zeros = lzf_repeated('\0', 36);
    CHECK(refusal(three(with_sizes(zeros, 35))) ==
          "p: found a decompressed size of 35 bytes, expected 3 points as line 4 says, with 12 bytes each");
    CHECK(refusal(three(with_sizes(lzf_repeated('\0', 35), 36))) ==
          "p: after line 5: found data that decompress to 35 bytes, expected 36 bytes of points (copy the file again, "
          "or save it as DATA binary)");
    CHECK(refusal(three(with_sizes(lzf_repeated('\0', 37), 36))) ==
          "p: after line 5: found compressed data that are damaged, expected 36 bytes of points (copy the file again, "
          "or save it as DATA binary)");
    CHECK(refusal(three(with_sizes(lzf_copy(36, 1), 36))) ==
          "p: after line 5: found compressed data that are damaged, expected 36 bytes of points (copy the file again, "
          "or save it as DATA binary)");  // of nothing before it
    CHECK(refusal(three(with_sizes(zeros.substr(0, zeros.size() - 1), 36))).starts_with("p: after line 5: found "));
    CHECK(refusal(three(with_sizes("", 36))) ==
          "p: after line 5: found 0 bytes of compressed data, expected 1 or more for 36 bytes decompressed");
    CHECK(refusal(three(with_sizes(lzf_repeated('\xff', 36), 36))) ==
          "p: point 0: found '-nan', expected a finite number (--skip-invalid leaves out such points)");
    CHECK(refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA binary_squeezed\n") ==
          "p:5: found 'DATA binary_squeezed', expected ascii, binary or binary_compressed");
  }

  TEST_CASE("nothing is allocated for claimed sizes only") {
    const std::string most = "1152921504606846976";  // 2^60
    const std::vector<std::string> counts = {"POINTS " + most, "WIDTH " + most + "\nHEIGHT 1",
                                             "WIDTH 1073741824\nHEIGHT 1073741824"};
    for (const std::string& points : counts) {
      const std::string message = refusal(three(with_sizes("xxxx", 0xffffffffU), points));
      CHECK(message.starts_with("p: found a decompressed size of 4294967295 bytes, expected "));
    }
    // The largest number of points that the sizes allow, with 4 bytes of data.
    CHECK(refusal(three(with_sizes("xxxx", 12 * std::size_t{357913941}), "POINTS 357913941")) ==
          "p: after line 5: found 4 bytes of compressed data, expected 48806447 or more for 4294967292 bytes "
          "decompressed");
  }
}
