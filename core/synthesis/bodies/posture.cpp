#include "core/synthesis/bodies/posture.hpp"

#include <array>
#include <utility>

#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/edit/hold_springs.hpp"

namespace abrazo {

namespace {

using namespace joints;

constexpr std::array<std::pair<int, int>, 6> legs = {{{left_hip, left_ankle},
                                                      {right_hip, right_ankle},
                                                      {left_ankle, left_toe_base},
                                                      {right_ankle, right_toe_base},
                                                      {Root, left_hip},
                                                      {Root, right_hip}}};
constexpr std::array<std::pair<int, int>, 3> trunk = {
    {{Root, LowerNeck}, {Root, left_shoulder}, {Root, right_shoulder}}};

}  // namespace

void add_posture(const PairPose& rebuilt, const PostureWeights& weights, VertexMatrix& energy,
                 PairPose& linear) {
  for (const int first : {0, joint_count}) {
    const auto keep = [&](const auto& vectors, double weight) {
      for (const auto& [from, to] : vectors)
        add_spring(first + from, first + to, weight,
                   (rebuilt.row(first + to) - rebuilt.row(first + from)).transpose(), energy, linear);
    };
    keep(legs, weights.legs);
    keep(trunk, weights.trunk);
  }
}

}  // namespace abrazo
