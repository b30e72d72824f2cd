#pragma once

#include <optional>

#include "core/motion/body/body.hpp"

namespace abrazo {

/// The user's body: given, or measured from poses. Starts with one pose; every further one of the first
/// seconds has the same weight, so that a bad first pose is averaged out.
class UserMeasure {
 public:
  static constexpr double measured_s = 3;

  UserMeasure() = default;
  explicit UserMeasure(const std::optional<Body>& given) : body_(given), is_given_(given.has_value()) {}

  const std::optional<Body>& body() const { return body_; }

  /// @param elapsed_s since the previous pose
  /// @return whether `body` has changed
  bool look_at(const Pose& user, double elapsed_s);

  // State, for serialisation.
  UserMeasure(const std::optional<Body>& body, bool is_given, double seen_s, int seen)
      : body_(body), is_given_(is_given), seen_s_(seen_s), seen_(seen) {}
  bool is_given() const { return is_given_; }
  double seen_s() const { return seen_s_; }
  int seen() const { return seen_; }

 private:
  std::optional<Body> body_;
  bool is_given_ = false;
  double seen_s_ = 0;
  int seen_ = 0;  ///< number of poses averaged in `body_`
};

}  // namespace abrazo
