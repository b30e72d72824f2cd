#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/bodies/pair_retargeting.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/metrics/posture.hpp"

namespace abrazo {

/// Bodies for a recorded pair, as ratios of the recorded lengths.
struct BodyVariant {
  struct Ratios {
    double all = 1, arms = 1, legs = 1;
  };
  std::string_view name;
  Ratios active, passive;
  bool has_marks = false;  ///< the goals apply: sizes from 0.85 to 1.15
};
std::span<const BodyVariant> body_variants();
/// A body with these ratios.
Body body_with(const Body& body, const BodyVariant::Ratios& ratios);

/// Method of the transfer to other bodies: ours, offline and live, and three baselines.
enum class BodyMethod { Retargeted, Live, AnglesCopied, PaperMesh, NoMesh };
inline constexpr std::size_t body_method_count = 5;
inline constexpr std::array<std::string_view, body_method_count> body_method_names = {
    "retargeted", "live", "joint angles copied", "mesh of the paper", "no mesh: hands and feet"};
inline constexpr std::array<std::string_view, body_method_count> body_method_keys = {
    "retargeted", "live", "angles_copied", "paper_mesh", "no_mesh"};

/// Joint pairs of different bodies nearer than a distance, in the recording and in the result.
struct ContactScore {
  double precision = 0, recall = 0, f1 = 0;  ///< 0 without contacts
};

/// Figures of one method on one pair of bodies, over all takes. Speeds and accelerations are
/// divided by the body's leg ratio, and then by the recording's. NaN if there was nothing to measure.
struct BodyFigures {
  ContactScore within_15cm, within_25cm;
  double hold_change_mean_m = 0, hold_change_p95_m = 0;  ///< of hands that hold one another in the recording
  double penetration_excess_p99_m = 0;  ///< beyond the overlap of the same capsules of the recorded bodies
  double floor_contact = 0;  ///< share of standing feet within 2 cm of their recorded (scaled) height
  double slide_m_s = 0;      ///< of landed toe bases
  double slide_ratio = 0, speed_p99_ratio = 0, acceleration_p99_ratio = 0;  ///< 1 for the recording
  double bone_error_max = 0;
  std::array<PostureChange, 2> posture;  ///< of active and passive body, means over the frames
  double nearest_only = 0;               ///< share of frames reported as nearest pose; only of ours
};

struct BodyRow {
  std::string bodies;
  bool has_marks = false;
  std::array<BodyFigures, body_method_count> methods;  ///< in the order of BodyMethod
};

struct BodyTable {
  std::vector<BodyRow> rows;
  double recorded_slide_m_s = 0;
  int takes = 0, frames = 0;
};

/// @return an Error "cancelled" if `progress` cancels
Result<BodyTable> measure_bodies(const std::vector<const PairedTake*>& takes, const Progress& progress,
                                 std::span<const BodyVariant> variants = body_variants());

}  // namespace abrazo
