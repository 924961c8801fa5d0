// What: writes JSON to a file part by part: Ctrl-C is noticed in between, and the whole text is never in memory.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/bytes/output_file.h"

namespace rbpa::app {

/// An adapter that passes the output of nlohmann's serializer to `file`, to which the adapter keeps a reference.
class JsonToFile : public nlohmann::detail::output_adapter_protocol<char> {
 public:
  explicit JsonToFile(OutputFile& file) : file_(file) {}
  void write_character(char character) override { file_.write({&character, 1}); }
  void write_characters(const char* characters, std::size_t length) override { file_.write({characters, length}); }

 private:
  OutputFile& file_;
};

/// Writes the text of json.dump(indent) and a line end. Throws as OutputFile::write(), and nlohmann's type_error if a
/// text in `json` is not UTF-8.
inline void write_json(OutputFile& file, const nlohmann::ordered_json& json, unsigned indent) {
  nlohmann::detail::serializer<nlohmann::ordered_json> serializer(std::make_shared<JsonToFile>(file), ' ');
  serializer.dump(json, true, false, indent);
  file.write("\n");
}

}  // namespace rbpa::app
