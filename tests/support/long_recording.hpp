#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/session/frames/frame_store.hpp"

namespace abrazo::test {

/// The frames [0, count) of a recording, made when they are asked for, and evenly thinned as those of a file.
class LongRecording : public FrameStore {
 public:
  /// @param make  the frame of an index; times ascend
  LongRecording(std::uint64_t count, std::function<std::shared_ptr<FrameSnapshot>(std::uint64_t)> make)
      : count_(count), make_(std::move(make)) {}

  Span span() const override { return {frame(0)->time_s, frame(count_ - 1)->time_s, 0, count_ - 1, count_}; }
  FrameSnapshotPtr at(double time_s) const override {
    const std::uint64_t after = first_after(time_s);
    return after > 0 ? frame(after - 1) : nullptr;
  }
  FrameSnapshotPtr frame(std::uint64_t index) const override {
    if (index >= count_) return nullptr;
    auto made = make_(index);
    made->index = index;
    return made;
  }
  std::vector<FrameSnapshotPtr> range(double from_s, double to_s, std::size_t most) const override {
    const std::uint64_t end = first_after(to_s);
    std::uint64_t first = first_after(from_s);
    while (first > 0 && frame(first - 1)->time_s >= from_s) --first;
    return end > first ? between(first, end - 1, most) : std::vector<FrameSnapshotPtr>();
  }
  std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                        std::size_t most) const override {
    const std::uint64_t count = last - first + 1;
    std::vector<FrameSnapshotPtr> found;
    if (count <= most)
      for (std::uint64_t i = first; i <= last; ++i) found.push_back(frame(i));
    else
      for (std::uint64_t i = 0; i < most; ++i) found.push_back(frame(first + i * (count - 1) / (most - 1)));
    return found;
  }
  std::optional<std::uint64_t> state_before(std::uint64_t) const override { return std::nullopt; }

 private:
  std::uint64_t first_after(double time_s) const {
    std::uint64_t low = 0, high = count_;
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      frame(middle)->time_s <= time_s ? low = middle + 1 : high = middle;
    }
    return low;
  }

  std::uint64_t count_;
  std::function<std::shared_ptr<FrameSnapshot>(std::uint64_t)> make_;
};

}  // namespace abrazo::test
