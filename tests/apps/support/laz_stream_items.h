// What: encoders of the items of a stream: point by point, in one layer.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "support/laz_encoder.h"

namespace apps_test::laz {

class Bytes2 : public Item {
 public:
  Bytes2(const char* first, unsigned size) : last_(first, size), models_(size, Model(256)) {}
  void encode(const char* now, unsigned&) override {
    for (std::size_t i = 0; i < last_.size(); ++i)
      layer(0).symbol(models_[i], (byte(now, i) - byte(last_.data(), i)) & 255U);
    last_.assign(now, last_.size());
  }

 private:
  std::string last_;
  std::vector<Model> models_;
};

class Bytes1 : public Item {
 public:
  Bytes1(const char* first, unsigned size, bool colors) : last_(first, size), colors_(colors), integers_(8, size) {}
  void encode(const char* now, unsigned&) override {
    unsigned bits = 0;
    for (unsigned i = 0; i < last_.size(); ++i) bits |= unsigned{now[i] != last_[i]} << i;
    if (colors_) layer(0).symbol(used_, bits);
    for (unsigned i = 0; i < last_.size(); ++i)
      if (!colors_ || (bits >> i & 1U) != 0)
        integers_.encode(layer(0), static_cast<int>(byte(last_.data(), i)), static_cast<int>(byte(now, i)), i);
    last_.assign(now, last_.size());
  }

 private:
  std::string last_;
  bool colors_;
  Model used_ = Model(64);
  Integers integers_;
};

class Time1 : public Item {
 public:
  explicit Time1(const char* first) : last_(at<std::int64_t>(first, 0)) {}
  void encode(const char* now, unsigned&) override {
    const auto time = at<std::int64_t>(now, 0);
    const auto step = static_cast<std::int64_t>(static_cast<std::uint64_t>(time) - static_cast<std::uint64_t>(last_));
    const bool fits = step == static_cast<std::int32_t>(step);
    const auto short_step = static_cast<std::int32_t>(step);
    last_ = time;
    if (difference_ == 0) {
      layer(0).symbol(kinds_, step == 0 ? 0 : fits ? 1 : 2);
      if (step != 0 && fits) integers_.encode(layer(0), 0, difference_ = short_step, 0);
      if (!fits) layer(0).bits64(static_cast<std::uint64_t>(time));
      return;
    }
    if (step == 0) return layer(0).symbol(multiples_, 511);
    if (!fits) {
      layer(0).symbol(multiples_, 510);
      return layer(0).bits64(static_cast<std::uint64_t>(time));
    }
    const std::int64_t multiple = std::clamp<std::int64_t>(step / difference_, 0, 509);
    const auto symbol = static_cast<unsigned>(multiple);
    layer(0).symbol(multiples_, symbol);
    if (symbol == 1) {
      integers_.encode(layer(0), difference_, short_step, 1);
      difference_ = short_step;
      extremes_ = 0;
    } else if (symbol == 0) {
      integers_.encode(layer(0), difference_ / 4, short_step, 2);
      extreme(short_step);
    } else {
      integers_.encode(layer(0), static_cast<std::int32_t>(symbol * static_cast<std::uint32_t>(difference_)),
                       short_step,
                       symbol < 10   ? 3
                       : symbol < 50 ? 4
                                     : 5);
      if (symbol == 509) extreme(short_step);
    }
  }

 private:
  void extreme(std::int32_t step) {
    if (++extremes_ <= 3) return;
    difference_ = step;
    extremes_ = 0;
  }
  std::int64_t last_;
  std::int32_t difference_ = 0;
  int extremes_ = 0;
  Model kinds_ = Model(3), multiples_ = Model(512);
  Integers integers_ = Integers(32, 6);
};

class Wave13 : public Item {
 public:
  explicit Wave13(const char* first) : last_(first, 29) {}
  void encode(const char* now, unsigned&) override {
    Encoder& to = layer(0);
    to.symbol(index_, byte(now, 0));
    const auto before = at<std::uint64_t>(last_.data(), 1), offset = at<std::uint64_t>(now, 1);
    const auto size = at<std::uint32_t>(last_.data(), 9);
    const auto step = static_cast<std::int64_t>(offset - before);
    const unsigned kind = step == 0 ? 0 : offset == before + size ? 1 : step == static_cast<std::int32_t>(step) ? 2 : 3;
    to.symbol(kinds_[kind_], kind);
    kind_ = kind;
    if (kind == 2) {
      differences_.encode(to, difference_, static_cast<std::int32_t>(step));
      difference_ = static_cast<std::int32_t>(step);
    }
    if (kind == 3) to.bits64(offset);
    const auto next = [&](Integers& integers, std::size_t place, unsigned context) {
      integers.encode(to, at<std::int32_t>(last_.data(), place), at<std::int32_t>(now, place), context);
    };
    next(sizes_, 9, 0);
    next(places_, 13, 0);
    for (unsigned i = 0; i < 3; ++i) next(xyz_, 17 + 4 * i, i);
    last_.assign(now, 29);
  }

 private:
  std::string last_;
  Model index_ = Model(256);
  std::vector<Model> kinds_ = std::vector<Model>(4, Model(4));
  Integers differences_ = Integers(32), sizes_ = Integers(32), places_ = Integers(32), xyz_ = Integers(32, 3);
  std::int32_t difference_ = 0;
  unsigned kind_ = 0;
};

}  // namespace apps_test::laz
