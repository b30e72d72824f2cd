#pragma once

#include <limits>

#include "core/stream/receive/pose_source.hpp"

namespace abrazo {

/// A source without poses, for a session before its first stream is opened.
class SilentSource : public PoseSource {
 public:
  std::optional<SourcePose> poll(double) override { return std::nullopt; }
  double next_due_s() const override { return std::numeric_limits<double>::infinity(); }
  double rate_hz() const override { return 0; }
  void set_max_rate(double) override {}
  bool is_over() const override { return true; }
};

}  // namespace abrazo
