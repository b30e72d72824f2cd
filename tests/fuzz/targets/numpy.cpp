#include "core/motion/numpy/numpy_reader.hpp"

#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// As it says itself, and by a given order of joints; as the parameters of a body that the same archive
/// holds; then the text of such an order.
ABRAZO_FUZZ_TARGET(numpy)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  (void)abrazo::begins_as_npz(text);
  fuzz::expect_motions(abrazo::read_numpy(text, std::nullopt, "input.npz"));
  fuzz::expect_motions(abrazo::read_numpy(text, abrazo::builtin_joint_orders()[1], "input.npz"));
  fuzz::expect_motions(abrazo::read_numpy(text, std::nullopt, "input.npz", {text, "body.npz"}));
  const auto order = abrazo::parse_joint_order(text, "order.txt");
  if (!fuzz::accepted(order)) return;
  fuzz::expect(!order->points.empty(), "an order has joints");
  if (order->points.size() < 100) (void)fuzz::accepted(abrazo::OrderedPoints::of(*order));
}
