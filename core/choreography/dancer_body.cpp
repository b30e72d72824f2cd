#include "core/choreography/dancer_body.hpp"

#include <numeric>

namespace abrazo {
namespace {

DancerBody scaled(DancerBody body, double height_m) {
  const double scale = height_m / body.height;
  body.height = height_m;
  for (Vec3* offset : {&body.left_hip, &body.left_shoulder}) *offset *= scale;
  for (double* length : {&body.thigh, &body.shank, &body.ankle_above_toe_base, &body.ankle_behind_toe_base,
                         &body.toes, &body.toe_rest_height, &body.upper_arm, &body.forearm, &body.hand})
    *length *= scale;
  for (double& length : body.spine) length *= scale;
  for (double& length : body.neck) length *= scale;
  return body;
}

DancerBody proportioned(DancerBody body, const PerformerOptions& performer) {
  const auto sum = [](const auto& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); };
  const double trunk = sum(body.spine) + sum(body.neck), longer = (performer.leg_scale - 1) * body.leg();
  for (double* length : {&body.thigh, &body.shank}) *length *= performer.leg_scale;
  for (double* length : {&body.upper_arm, &body.forearm, &body.hand}) *length *= performer.arm_scale;
  for (double& length : body.spine) length *= 1 - longer / trunk;
  for (double& length : body.neck) length *= 1 - longer / trunk;
  return body;
}

}  // namespace

DancerBody leader_body(double height_m) {
  return scaled({.height = 1.80,
                 .left_hip = {0.086, -0.098, 0.018},
                 .thigh = 0.418,
                 .shank = 0.420,
                 .ankle_above_toe_base = 0.056,
                 .ankle_behind_toe_base = 0.090,
                 .toes = 0.052,
                 .toe_rest_height = 0.040,
                 .spine = {0.118, 0.118, 0.118},
                 .neck = {0.096, 0.096, 0.098},
                 .left_shoulder = {0.212, 0.052, 0.020},
                 .upper_arm = 0.285,
                 .forearm = 0.265,
                 .hand = 0.080},
                height_m);
}

DancerBody follower_body(double height_m) {
  return scaled({.height = 1.66,
                 .left_hip = {0.087, -0.091, 0.020},
                 .thigh = 0.376,
                 .shank = 0.385,
                 .ankle_above_toe_base = 0.062,
                 .ankle_behind_toe_base = 0.074,
                 .toes = 0.046,
                 .toe_rest_height = 0.040,
                 .spine = {0.111, 0.111, 0.111},
                 .neck = {0.091, 0.091, 0.093},
                 .left_shoulder = {0.192, 0.050, 0.016},
                 .upper_arm = 0.264,
                 .forearm = 0.240,
                 .hand = 0.072},
                height_m);
}

DancerBody leader_body(const PerformerOptions& performer) {
  check_performer(performer, "the performer");
  return proportioned(leader_body(performer.height_m), performer);
}

DancerBody follower_body(const PerformerOptions& performer) {
  check_performer(performer, "the performer");
  return proportioned(follower_body(performer.height_m), performer);
}

}  // namespace abrazo
