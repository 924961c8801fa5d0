// What: how many point records of a LAS file are to be read: as its header says, and as the file has room for.
// Law:  the number of records is only to be had from settle(), which refuses or remarks where the two differ.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rbpa::app {

class LasCount {
 public:
  LasCount() = default;
  /// `claimed` by the header; `room` for so many whole records of `length` bytes there is.
  LasCount(std::size_t claimed, std::size_t room, std::size_t length)
      : claimed_(claimed), room_(room), length_(length) {}

  /// How many there are to read. Throws BadInput when the header counts more points than the file has whole records, or
  /// fewer. With `skip_invalid` it is the smaller of the two, but all records where the header counts none, as an
  /// interrupted writer leaves it; `remarks` lists what was left out or counted.
  std::size_t settle(bool skip_invalid, const std::string& name, std::vector<std::string>& remarks) const;

  /// Of a file whose end is not known yet: how many to look for, and for how many the header leaves room.
  std::size_t sought(bool skip_invalid) const { return takes_all(skip_invalid) ? room_ : claimed_; }
  std::size_t room() const { return room_; }
  /// The same file when its end was found behind so many whole records.
  LasCount with_room(std::size_t room) const { return {claimed_, room, length_}; }

 private:
  bool takes_all(bool skip_invalid) const { return claimed_ == 0 && skip_invalid; }

  std::size_t claimed_ = 0, room_ = 0, length_ = 0;
};

}  // namespace rbpa::app
