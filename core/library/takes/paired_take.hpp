#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/body/clip.hpp"

namespace abrazo {

/// Which performer leads or attacks: the active role (Role_A of the paper).
enum class ActivePerformer : std::uint8_t { A, B, Unknown };

/// Frames [start, end), 0-based, end exclusive.
struct RoleInterval {
  int start = 0;
  int end = 0;
  ActivePerformer active = ActivePerformer::Unknown;

  bool operator==(const RoleInterval&) const = default;
};

/// A move: frames [start, end), 0-based, end exclusive.
struct LabelInterval {
  int start = 0;
  int end = 0;
  std::string label;
  std::string detail;
  std::string confidence;

  bool operator==(const LabelInterval&) const = default;
};

/// Two performers captured together, frame by frame, with roles and labels.
struct PairedTake {
  std::string name;
  double fps = 60;
  Clip a;
  Clip b;
  std::vector<RoleInterval> roles;    ///< ascending, not overlapping; uncovered frames are Unknown
  std::vector<LabelInterval> labels;  ///< ascending, not overlapping
};

ActivePerformer active_at(const PairedTake& take, int frame);

/// The label of a frame; empty if there is none.
std::string_view label_at(const std::vector<LabelInterval>& labels, int frame);

}  // namespace abrazo
