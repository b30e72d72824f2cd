#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/checksum.hpp"
#include "core/base/result.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// A frame as a row of the table `frames`. The one list of columns for writing, reading and the checksum.
struct FrameRow {
  using Blob = std::vector<std::uint8_t>;
  using Time = std::optional<double>;

  std::int64_t frame = 0;
  double time_s = 0;
  double elapsed_s = -1;
  std::optional<std::int64_t> input;  ///< id
  std::int64_t input_frame = -1;
  std::optional<std::int64_t> library;  ///< id
  Blob user, query, query_root, active, passive, candidates, collisions, state;
  std::int64_t selected = -1;
  std::optional<std::int64_t> pair;
  bool source_changed = false;
  std::string status, message;
  FrameEnergy energy;
  FrameResidual residual;
  std::int64_t foot_locks = 0;  ///< bits: active left, active right, passive left, passive right
  StepTiming timing;
  Time arrived_s, assembled_s, taken_s, solved_s, sent_s;
  double input_rate_hz = 0;
  std::int64_t dropped_inputs = 0;

  /// Calls `column(name, type, value)` for every column in order except the checksum, which comes last.
  template <typename Row, typename Column>
  static void each(Row& r, Column&& column) {
    column("frame", "INTEGER PRIMARY KEY", r.frame);
    column("time_s", "REAL NOT NULL", r.time_s);
    column("elapsed_s", "REAL", r.elapsed_s);
    column("input", "INTEGER REFERENCES inputs", r.input);
    column("input_frame", "INTEGER", r.input_frame);
    column("library", "INTEGER REFERENCES libraries", r.library);
    column("status", "TEXT", r.status);
    column("message", "TEXT", r.message);
    column("selected", "INTEGER", r.selected);
    column("pair", "INTEGER", r.pair);
    column("source_changed", "INTEGER", r.source_changed);
    column("energy_deformation", "REAL", r.energy.deformation);
    column("energy_velocity", "REAL", r.energy.velocity);
    column("energy_constraint", "REAL", r.energy.constraint);
    column("bone_length_max", "REAL", r.residual.bone_length_max);
    column("foot_lock_max_m", "REAL", r.residual.foot_lock_max_m);
    column("penetration_max_m", "REAL", r.residual.penetration_max_m);
    column("excess_penetration_max_m", "REAL", r.residual.excess_penetration_max_m);
    column("morph_rms_m", "REAL", r.residual.morph_rms_m);
    column("foot_locks", "INTEGER", r.foot_locks);
    column("retarget_us", "REAL", r.timing.retarget_us);
    column("select_us", "REAL", r.timing.select_us);
    column("mesh_us", "REAL", r.timing.mesh_us);
    column("solve_us", "REAL", r.timing.solve_us);
    column("total_us", "REAL", r.timing.total_us);
    column("arrived_s", "REAL", r.arrived_s);
    column("assembled_s", "REAL", r.assembled_s);
    column("taken_s", "REAL", r.taken_s);
    column("solved_s", "REAL", r.solved_s);
    column("sent_s", "REAL", r.sent_s);
    column("input_rate_hz", "REAL", r.input_rate_hz);
    column("dropped_inputs", "INTEGER", r.dropped_inputs);
    column("user", "BLOB", r.user);
    column("query", "BLOB", r.query);
    column("query_root", "BLOB", r.query_root);
    column("active", "BLOB", r.active);
    column("passive", "BLOB", r.passive);
    column("candidates", "BLOB", r.candidates);
    column("collisions", "BLOB", r.collisions);
    column("state", "BLOB", r.state);
  }
};

/// @param offset_s  session clock + this = time in the file
FrameRow row_of(const FrameSnapshot& frame, std::uint64_t file_index, double offset_s);
/// Leaves settings, decisions and members that need the library at their defaults. An Error if the columns
/// contradict each other.
Result<std::shared_ptr<FrameSnapshot>> frame_of(const FrameRow& row);

/// "frame, time_s, ...", without the checksum.
const std::string& frame_columns();
/// Column definitions for CREATE TABLE, with the checksum.
std::string frame_column_definitions();
/// "INSERT INTO frames ..." with one parameter per column, the checksum last.
std::string frame_insert();

/// Binds a row. The row must live until the statement has run.
void bind_row(SessionStatement& statement, const FrameRow& row);
/// Reads a row from a SELECT of frame_columns() and checksum. An Error if the checksum does not match.
Result<FrameRow> read_row(const SessionStatement& statement);

/// A pose as a blob: float64 [25][3], little-endian.
std::vector<std::uint8_t> pose_bytes(const Pose& pose);
/// @return whether the number of bytes is that of a pose
bool read_pose(std::span<const std::uint8_t> bytes, Pose& pose);

}  // namespace abrazo
