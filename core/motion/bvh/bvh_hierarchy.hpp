#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/line_reader.hpp"
#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// One value of a motion row: 0, 1, 2 translate along x, y, z; 3, 4, 5 rotate about them.
using BvhChannel = int;

/// A joint or an end site of a BVH file.
struct BvhNode {
  std::string name;  ///< unique within its root; an end site is "<parent>_End"
  int parent = -1;   ///< index into the nodes; -1 for a ROOT
  bool is_end_site = false;
  bool has_offset = false;
  Vec3 offset = Vec3::Zero();
  std::vector<BvhChannel> channels;  ///< in the order of the values in a row; any number
};

struct BvhHierarchy {
  std::vector<BvhNode> nodes;  ///< parents before children; each ROOT is followed by its descendants
  std::size_t values_per_row = 0;
  std::vector<ImportWarning> warnings;
};

/// Reads up to and including the line MOTION.
Result<BvhHierarchy> parse_bvh_hierarchy(LineReader& lines, std::string_view where);

}  // namespace abrazo
