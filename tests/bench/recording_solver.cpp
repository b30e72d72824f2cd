#include "tests/bench/recording_solver.hpp"

namespace abrazo {

bool RecordingSolver::set_energy(const VertexMatrix& energy) {
  energy_ = energy;
  is_new_ = true;
  stiffened_.clear();
  return ConstrainedSolver::set_energy(energy);
}

void RecordingSolver::relax() {
  stiffened_.clear();
  ConstrainedSolver::relax();
}

void RecordingSolver::stiffen(int a, int b, double c) {
  stiffened_.push_back({a, b, c});
  ConstrainedSolver::stiffen(a, b, c);
}

bool RecordingSolver::solve(const PairPose& linear, std::span<const ConstraintRow> rows,
                            std::vector<char>& active, PairPose& positions) {
  const std::vector<char> before = active;
  const bool done = ConstrainedSolver::solve(linear, rows, active, positions);
  if (done) note(false, linear, rows, before, active, positions);
  return done;
}

bool RecordingSolver::project(const PairPose& from, std::span<const ConstraintRow> rows,
                              std::vector<char>& active, PairPose& positions) {
  const std::vector<char> before = active;
  const bool done = ConstrainedSolver::project(from, rows, active, positions);
  if (done) note(true, from, rows, before, active, positions);
  return done;
}

void RecordingSolver::note(bool projects, const PairPose& linear, std::span<const ConstraintRow> rows,
                           const std::vector<char>& before, const std::vector<char>& after,
                           const PairPose& answer) {
  if (notes == nullptr) return;
  bench::FrameCalls::Call call;
  call.new_energy = is_new_;
  is_new_ = false;
  call.projects = projects;
  call.stiffened = stiffened_;
  call.linear = linear;
  call.rows.assign(rows.begin(), rows.end());
  call.active = before;
  notes->energy = energy_;

  bench::PosedSystem& posed = call.posed;
  posed.energy = energy_;
  for (const bench::FrameCalls::Stiffened& s : stiffened_) {
    posed.energy(s.a, s.a) += s.c;
    posed.energy(s.b, s.b) += s.c;
    posed.energy(s.a, s.b) -= s.c;
    posed.energy(s.b, s.a) -= s.c;
  }
  // The nearest point to `from` in the metric of K minimises with R = K from.
  if (projects)
    posed.linear.noalias() = posed.energy * linear;
  else
    posed.linear = linear;
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (after[r]) posed.binding.push_back(rows[r]);
  posed.answer = answer;
  notes->calls.push_back(std::move(call));
}

}  // namespace abrazo
