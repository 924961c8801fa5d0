// A file written in pieces: its content, and full disks.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "support/program.h"

using apps_test::Folder;
using rbpa::app::OutputFile;

TEST_SUITE("output file") {
  TEST_CASE("pieces of every size, put in every way, arrive whole and in order") {
    const Folder folder;
    std::string expected;
    std::mt19937_64 random(5);
    {
      OutputFile file(folder.path("f"));
      for (unsigned i = 0; i < 3000; ++i) {
        const bool large = i % 500 == 499;  // than the buffer
        const std::size_t size = large ? (1U << 20U) + random() % 3000000 : random() % OutputFile::max_room;
        std::string piece(size, static_cast<char>('a' + i % 26));
        switch (large ? i / 500 % 2 : random() % 3) {
          case 0:
            file.write(piece);
            break;
          case 1: {
            std::vector<std::uint32_t> values(size / 4, 0x64636261U + i);
            file.write_binary(std::span<const std::uint32_t>(values));
            piece.clear();
            for (const std::uint32_t value : values)
              for (const unsigned shift : {0U, 8U, 16U, 24U}) piece += static_cast<char>(value >> shift & 0xFFU);
            break;
          }
          default:
            file.written(std::copy(piece.begin(), piece.end(), file.room(size)));
        }
        expected += piece;
      }
      file.finish();
      CHECK_FALSE(folder.has("f"));
      file.publish();
    }
    CHECK(folder.content("f") == expected);
  }

  TEST_CASE("a full disk is reported by whichever way of writing meets it") {
    const std::string much(3U << 20U, 'x');
    const auto message = [](const auto& write) {
      OutputFile file("/dev/full");
      try {
        write(file);
        return std::string();
      } catch (const rbpa::app::Failure& failure) {
        return std::string(failure.what());
      }
    };
    const std::string full = "/dev/full: cannot write: No space left on device";
    CHECK(message([&](OutputFile& file) { file.write(much); }) == full);
    CHECK(message([&](OutputFile& file) {
            for (int i = 0; i < 1000; ++i) file.written(file.room(4000) + 4000);
          }) == full);
    CHECK(message([&](OutputFile& file) {
            for (int i = 0; i < 1000000; ++i) file.write_number(0.1);
          }) == full);
    CHECK(message([&](OutputFile& file) {
            file.write("x");
            file.finish();
          }) == full);
  }
}
