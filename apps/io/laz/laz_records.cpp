#include "io/laz/laz_records.h"

#include <algorithm>
#include <functional>
#include <thread>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/laz/item_models.h"
#include "rbpa/base/join_in_order.h"

namespace rbpa::app {
namespace {

constexpr std::size_t piece_bytes = std::size_t{8} << 20U;  // most bytes of the records of a piece
constexpr std::size_t batch_bytes = 4 * piece_bytes;        // limit for several chunks that are decoded together
constexpr std::size_t window_points = 16384;                // points in a piece of a chunk whose size is not known
constexpr std::size_t most_growth = 8;  // most bytes of a compressed record for each byte of the record

std::string byte_of(const Content& content, std::uint64_t at) {
  return content.name() + ": byte " + std::to_string(at);
}

/// Throws BadInput for a file that promises more than 500 times its size, the limit of gzip files (input_bytes.h).
void require_ratio(const Content& content, std::size_t begin, std::size_t length, std::size_t points) {
  constexpr std::size_t always = std::size_t{64} << 20U, greatest_ratio = 500;
  const std::size_t size = content.size() - std::min(begin, content.size());
  if (content.is_compressed() || points <= always / length || points / greatest_ratio <= size / length) return;
  bad_input(byte_of(content, begin), counted(points, "point") + " in " + counted(size, "byte"),
            "points of at most 500 times as many bytes (laszip decompresses the file)");
}

/// Returns the number of 8 bytes at `at`.
std::uint64_t word_at(const Content& content, std::uint64_t at) {
  Content words = content.again();
  words.skip(at);
  const std::string_view bytes = words.ahead(8);
  if (bytes.size() < 8) bad_input(byte_of(content, at), "the end of the file", "the place of the table of chunks");
  return load_little<std::uint64_t>(bytes.data());
}

/// Returns the chunks of a file whose points begin at `begin`, with the place of the table of chunks; nothing if the
/// compressor was interrupted before it wrote a table. Together the chunks have `points` points and fit into the file.
/// Throws BadInput if the table is wrong.
std::optional<std::vector<LazChunk>> read_chunk_table(const Content& content, std::size_t begin,
                                                      const LazFormat& format, std::size_t points) {
  constexpr auto at_end = static_cast<std::uint64_t>(-1);  // the compressor could not go back in its output
  std::uint64_t place = word_at(content, begin);
  if (place == at_end && !content.is_compressed()) place = word_at(content, content.size() - 8);
  if (place == at_end || place == begin) return std::nullopt;
  const std::uint64_t version_and_count = place < begin + 8 || place > content.size() ? 1 : word_at(content, place);
  const std::string where = byte_of(content, place), all = counted(points, "point");
  if (version_and_count % (std::uint64_t{1} << 32U) != 0)
    bad_input(byte_of(content, begin), "byte " + std::to_string(place) + " as the place of a table of chunks",
              "a table of version 0 behind the points");
  const std::size_t count = version_and_count >> 32U, room = place - begin - 8;
  const bool varies = format.chunk_size == LazFormat::varying;
  Content table = content.again();
  table.skip(place + 8);
  constexpr std::size_t most_for_number = 8;  // bytes
  const std::string_view bytes = table.ahead(4 + 2 * most_for_number * std::min(count, room / format.length));
  std::vector<LazChunk> chunks;
  std::size_t left = points, left_bytes = room;
  if (count > 0) try {
      ArithmeticDecoder decoder(bytes);
      IntegerDecoder<32> numbers(2);
      for (LazChunk last{0, 0}; chunks.size() < count; chunks.push_back(last)) {
        last.points = varies ? numbers.decode(decoder, static_cast<std::uint32_t>(last.points), 0)
                             : std::min<std::size_t>(format.chunk_size, left);
        last.size = numbers.decode(decoder, static_cast<std::uint32_t>(last.size), 1);
        const bool is_empty = last.points == 0 && varies;  // some compressors write empty chunks
        if ((!is_empty && (last.points == 0 || last.size < format.length)) || last.points > left ||
            last.size > left_bytes)
          bad_input(where,
                    "a chunk of " + counted(last.points, "point") + " in " + counted(last.size, "byte") + " after " +
                        counted(chunks.size(), "chunk"),
                    "chunks of " + all + " in " + counted(room, "byte"));
        left -= last.points;
        left_bytes -= last.size;
      }
    } catch (const BadStream& fault) {
      bad_input(where, fault.found + " after " + counted(chunks.size(), "chunk"), counted(count, "chunk"));
    }
  if (left > 0) bad_input(where, counted(count, "chunk") + " without " + std::to_string(left) + " of the points", all);
  return chunks;
}

}  // namespace

LazRecords::LazRecords(const Content& content, std::size_t begin, LazFormat format, std::size_t points,
                       LazChoice choice)
    : content_(content.again()),
      format_(std::move(format)),
      choice_(std::move(choice)),
      left_(points),
      place_(begin),
      threads_(choice_.threads > 0 ? choice_.threads : std::max(std::thread::hardware_concurrency(), 1U)) {
  require_ratio(content, begin, format_.length, points);
  if (format_.has_chunks && points > 0) {
    try {
      table_ = read_chunk_table(content, begin, format_, points);
    } catch (const BadInput&) {
      if (!choice_.skip_invalid) throw;  // else read on without the table
    }
    place_ += 8;
    if (is_windowed() && format_.chunk_size == LazFormat::varying)
      bad_input(byte_of(content, begin), "chunks of various sizes without a table", "one behind them");
  }
  if (choice_.nodes) choose_chunks();
  content_.skip(place_);
  if (threads_ > 1 && table_ && table_->size() > 1)
    batches_ = std::make_unique<ReadAhead<Batch>>(1, [this](Batch& batch) { return make(batch); });
}

void LazRecords::choose_chunks() {
  if (!table_) bad_input(byte_of(content_, place_), "no table of chunks", "one behind the points, as COPC has");
  is_wanted_.resize(table_->size());
  left_ = 0;
  std::uint64_t place = place_;
  std::size_t k = 0;  // chunk
  for (const LazNode& node : *choice_.nodes) {
    while (k < table_->size() && place < node.begin) place += (*table_)[k++].size;
    if (k == table_->size() || place != node.begin || (*table_)[k].size != node.size ||
        (*table_)[k].points != node.points || is_wanted_[k])
      bad_input(byte_of(content_, node.entry),
                "a node of " + counted(node.points, "point") + " in " + counted(node.size, "byte") + " from byte " +
                    std::to_string(node.begin) + " on",
                "a chunk of the table, once (without --bounds and --resolution the hierarchy is not read)");
    is_wanted_[k] = true;
    left_ += node.points;
  }
}

std::uint64_t LazRecords::place_of(const char* at) const {
  for (std::size_t i = 0; i < in_use_; ++i) {
    const std::string_view bytes = slots_[i].bytes;
    if (!slots_[i].copy.empty() && !std::less<>()(at, bytes.data()) && !std::less<>()(bytes.data() + bytes.size(), at))
      return slots_[i].place + static_cast<std::uint64_t>(at - bytes.data());
  }
  return place_ + static_cast<std::uint64_t>(at - window_.data());
}

std::string_view LazRecords::ahead() {
  while (piece_ == batch_.pieces.size() || skipped_ == batch_.pieces[piece_].records.size()) {
    skipped_ = 0;
    if (piece_ < batch_.pieces.size() && ++piece_ < batch_.pieces.size()) continue;
    Batch next;
    if (!(batches_ ? batches_->next(next) : make(next))) return {};
    batch_ = std::move(next);
    piece_ = 0;
  }
  const std::vector<char>& records = batch_.pieces[piece_].records;
  return {records.data() + skipped_, records.size() - skipped_};
}

bool LazRecords::make(Batch& batch) {
  if (in_use_ == 0 && (ended_ || left_ == 0)) return false;
  stop_if_interrupted();
  try {
    if (in_use_ == 0) begin_chunks();
    if (is_windowed()) {
      Slot& slot = slots_.front();
      const std::size_t count = std::min(slot.left, most_at_once()) + 1;
      slot.bytes = window_ = content_.ahead(count * format_.length * most_growth);
      if (slot.left < slot.points) slot.decoder->move_to(window_);
    }
    join_in_order(
        threads_, in_use_, [&](std::size_t i) { return decode(slots_[i]); }, [](std::size_t) { return true; },
        [&](std::size_t, Piece piece) {
          batch.pieces.push_back(std::move(piece));
          if (batch.pieces.back().fault) throw *batch.pieces.back().fault;
        });
    const bool all_decoded = slots_.front().left == 0;  // if there are several chunks, each is decoded whole
    const std::size_t size = is_windowed() ? static_cast<std::size_t>(slots_.front().decoder->at() - window_.data())
                             : all_decoded ? window_.size()
                                           : 0;
    content_.skip(size);
    place_ += size;
    if (all_decoded) in_use_ = 0;
  } catch (const BadStream& fault) {
    const std::string where = byte_of(content_, place_of(fault.at));
    if (!choice_.skip_invalid) bad_input(where, fault.found, fault.expected);
    batch.fault = where + ": found " + fault.found;
    ended_ = true;
    in_use_ = 0;
  }
  batch.bytes_read = content_.bytes_read();
  return true;
}

void LazRecords::begin_chunks() {
  if (table_) {
    for (std::size_t bytes = 0; next_chunk_ < table_->size() && in_use_ < threads_; ++next_chunk_) {
      const LazChunk& chunk = (*table_)[next_chunk_];
      const bool is_wanted = is_wanted_.empty() || is_wanted_[next_chunk_];
      const std::size_t more = is_wanted ? chunk.points * format_.length : 0;
      if (in_use_ > 0 && (std::max(more, bytes) > piece_bytes || bytes + more > batch_bytes)) break;
      bytes += more;
      if (is_wanted) {
        const std::string_view found = require_ahead(chunk.size);
        begin(chunk.points, {});
        Slot& slot = slots_[in_use_ - 1];
        slot.copy.assign(found.begin(), found.end());  // as the view ends with the next require_ahead()
        slot.bytes = {slot.copy.data(), slot.copy.size()};
      } else {
        first_ += chunk.points;
      }
      content_.skip(chunk.size);
      place_ += chunk.size;
    }
    window_ = {};
  } else if (format_.is_layered) {
    window_ = require_ahead(format_.head());
    const LazChunk chunk = layered_chunk(format_, window_);
    if (chunk.points == 0 || chunk.points > left_)
      throw BadStream{window_.data() + format_.length, "a chunk of " + counted(chunk.points, "point"),
                      "from 1 to " + std::to_string(left_) + " of them"};
    window_ = require_ahead(chunk.size);
    begin(chunk.points, window_);
  } else {
    begin(std::min<std::size_t>(left_, format_.chunk_size), {});
  }
}

std::string_view LazRecords::require_ahead(std::uint64_t size) {
  window_ = content_.ahead(size);
  if (window_.size() >= size) return window_.substr(0, size);
  throw BadStream{window_.data() + window_.size(), "the end of the file", "more compressed points"};
}

void LazRecords::begin(std::size_t points, std::string_view bytes) {
  if (in_use_ == slots_.size()) slots_.push_back({.decoder = std::make_unique<ChunkDecoder>(format_, choice_.wanted)});
  Slot& slot = slots_[in_use_++];
  slot.bytes = bytes;
  slot.copy.clear();
  slot.place = place_;
  slot.first = first_;
  slot.points = slot.left = points;
  left_ -= points;
  first_ += points;
}

std::size_t LazRecords::most_at_once() const {
  const std::size_t most = piece_bytes / format_.length;
  return is_windowed() ? std::min(most, window_points) : most;
}

LazRecords::Piece LazRecords::decode(Slot& slot) const {
  const std::size_t length = format_.length, count = std::min(slot.left, most_at_once());
  Piece piece{.first = slot.first + slot.points - slot.left};
  piece.records.resize(count * length);
  std::size_t done = 0;
  try {
    if (slot.left == slot.points && count > 0) slot.decoder->begin(slot.bytes, slot.points);
    for (; done < count; ++done) slot.decoder->next(piece.records.data() + done * length);
  } catch (const BadStream& fault) {
    piece.fault = fault;
    piece.records.resize(done * length);
  }
  slot.left -= done;
  return piece;
}

}  // namespace rbpa::app
