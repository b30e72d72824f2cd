#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/positions.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// Order of the joints in an array of positions without names.
struct JointOrder {
  std::string name;                 ///< "lafan22", or the name of its file
  std::vector<std::string> points;  ///< unique
};

/// "abrazo25" (the 25 joints), "lafan22", "smplx22", "smplh52", "smplhmodel52", "mocap53".
const std::vector<JointOrder>& builtin_joint_orders();

bool is_builtin_joint_order(std::string_view name);

/// A built-in one by its name, or a file: one name a line, or a JSON list of names.
Result<JointOrder> find_joint_order(const std::string& name_or_file);

/// @param where  the file, for messages
Result<JointOrder> parse_joint_order(std::string_view text, std::string_view where);

/// Of the built-in ones: "abrazo25, lafan22, ...".
std::string joint_order_names();

/// Computes the points of an order from the 25 joints: the inverse of the joint map that reads them. A point
/// that the map uses as a joint is exactly that joint; collar bones and fingers, which are not among the 25,
/// are placed between neck and shoulder and in line with the hand.
class OrderedPoints {
 public:
  /// @return an Error that names the points that cannot be computed
  static Result<OrderedPoints> of(const JointOrder& order);

  /// P x 3, in the space of the pose.
  Positions positions_of(const Pose& pose) const;

 private:
  std::vector<std::vector<std::pair<int, double>>> terms_;  ///< per point: joint, weight
};

}  // namespace abrazo
