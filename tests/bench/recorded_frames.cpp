#include "tests/bench/recorded_frames.hpp"

#include <algorithm>

#include "core/evaluation/takes/pose_queries.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/bench/recording_pipeline.hpp"

namespace abrazo::bench {

namespace {

constexpr double regularisation = 1e-9;  ///< eps, as in core/synthesis/edit/dual_system.cpp

/// The user's pose at step `step`; frames in between are those nearest in time.
const Pose& user_at(const Clip& user, int step, double rate_hz) {
  const auto frame = static_cast<std::size_t>(step * user.fps / rate_hz + 0.5);
  return user.poses[std::min(frame, user.poses.size() - 1)];
}

std::vector<int> selectable(const BenchData& data) {
  return pairs_without(*data.library, data.excluded.empty() ? std::string() : data.excluded.front(), 0);
}

/// Entries of one column, rows ascending.
void add_column(KktSystem& system, std::vector<std::pair<int, double>>& entries) {
  std::sort(entries.begin(), entries.end());
  for (const auto& [row, value] : entries) {
    if (!system.rows.empty() && static_cast<int>(system.rows.size()) > system.column_starts.back() &&
        system.rows.back() == row) {
      system.values.back() += value;
      continue;
    }
    system.rows.push_back(row);
    system.values.push_back(value);
  }
  system.column_starts.push_back(static_cast<int>(system.rows.size()));
  entries.clear();
}

}  // namespace

RecordedFrames record_frames(const BenchData& data, const Settings& settings, double rate_hz, int frames) {
  RecordingPipeline pipeline(data.library, settings, selectable(data));
  pipeline.set_user_body(body_of(data.user.poses));
  RecordedFrames recorded;
  for (int step = 0; step < frames; ++step) {
    FrameCalls calls;
    RecordingSolver::notes = &calls;
    pipeline.solve(user_at(data.user, step, rate_hz), step == 0 ? 0 : 1 / rate_hz);
    recorded.frames.push_back(std::move(calls));
  }
  RecordingSolver::notes = nullptr;
  return recorded;
}

KktSystem kkt_of(const PosedSystem& posed) {
  const auto count = static_cast<int>(posed.binding.size());
  KktSystem system;
  system.size = KktSystem::unknowns + count;
  system.column_starts.push_back(0);
  std::vector<std::pair<int, double>> entries;
  for (int column = 0; column < KktSystem::unknowns; ++column) {
    const int vertex = column / 3, axis = column % 3;
    for (int other = 0; other < pair_vertex_count; ++other)
      if (posed.energy(other, vertex) != 0)
        entries.emplace_back(3 * other + axis, posed.energy(other, vertex));
    for (int r = 0; r < count; ++r) {
      const ConstraintRow& row = posed.binding[static_cast<std::size_t>(r)];
      for (int i = 0; i < row.count; ++i)
        if (const double value = row.coefficient(i)(axis);
            row.vertices[static_cast<std::size_t>(i)] == vertex && value != 0)
          entries.emplace_back(KktSystem::unknowns + r, value);
    }
    add_column(system, entries);
    system.right.push_back(posed.linear(vertex, axis));
  }
  for (int r = 0; r < count; ++r) {
    const ConstraintRow& row = posed.binding[static_cast<std::size_t>(r)];
    for (int i = 0; i < row.count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (const double value = row.coefficient(i)(axis); value != 0)
          entries.emplace_back(3 * row.vertices[static_cast<std::size_t>(i)] + axis, value);
    entries.emplace_back(KktSystem::unknowns + r, -regularisation);
    add_column(system, entries);
    system.right.push_back(row.target);
  }
  return system;
}

struct WholeSteps::State {
  std::unique_ptr<PartnerSynthesizer> synthesizer;
  const Clip* user;
  double rate_hz;
  int frames, step = 0;
};

WholeSteps::WholeSteps(const BenchData& data, const Settings& settings, double rate_hz, int frames)
    : state_(std::make_unique<State>()) {
  *state_ = {std::move(*PartnerSynthesizer::create(data.library, settings, data.excluded)), &data.user,
             rate_hz, frames};
  state_->synthesizer->set_user_body(body_of(data.user.poses));
}

WholeSteps::~WholeSteps() = default;

void WholeSteps::next() {
  State& s = *state_;
  if (s.step == s.frames) {
    s.step = 0;
    s.synthesizer->reset();
  }
  s.synthesizer->step(user_at(*s.user, s.step, s.rate_hz), Duration(1 / s.rate_hz));
  ++s.step;
}

}  // namespace abrazo::bench
