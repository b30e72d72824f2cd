#include "core/session/run/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <span>

#include "core/session/frames/frame_in_library.hpp"

namespace abrazo {
namespace {

constexpr double longest_window_s = 10;  ///< that the figures of a live comparison are over
constexpr std::size_t most_waiting =
    600;  ///< frames; a run that is further behind starts again at the live end
constexpr std::size_t bytes_of_a_run = std::size_t{96} << 20;

/// Without what only the scene's mesh needs: a fifth of the memory.
std::shared_ptr<FrameSnapshot> slim(std::shared_ptr<FrameSnapshot> frame) {
  frame->before = nullptr;
  FrameResult& r = frame->result;
  for (auto* values : {&r.edge_weights, &r.edge_residuals_m}) *values = {};
  r.edges = {};
  r.tetrahedra = {};
  r.morph_steps = {};
  return frame;
}

Status provide(std::unique_ptr<ReSolver>& solver, const ComparisonRun::Solvers& solvers) {
  if (solver) return Done{};
  auto made = ReSolver::create(solvers.library, solvers.excluded_takes);
  if (!made) return made.error();
  solver = std::move(made).value();
  return Done{};
}

std::vector<RunStep> steps_of(std::span<const FrameSnapshotPtr> frames) {
  std::vector<RunStep> steps;
  steps.reserve(frames.size());
  for (const FrameSnapshotPtr& frame : frames)
    steps.push_back({&frame->result, frame->time_s, !(frame->elapsed_s > 0)});
  return steps;
}

/// Time from which on the run has had the settings of its last frame.
double settled_since(const std::vector<FrameSnapshotPtr>& frames) {
  double since_s = frames.back()->time_s;
  for (auto frame = frames.rbegin(); frame != frames.rend() && (*frame)->settings == frames.back()->settings;
       ++frame)
    since_s = (*frame)->time_s;
  return since_s;
}

}  // namespace

ComparisonRun::ComparisonRun(ComparisonTask task, const FrameHistory& recorded, Solvers& solvers)
    : recorded_(recorded),
      solvers_(solvers),
      a_(std::make_shared<FrameHistory>(bytes_of_a_run)),
      b_(std::make_shared<FrameHistory>(bytes_of_a_run)) {
  state_.task = std::move(task);
  state_.a = a_;
  state_.b = b_;
  for (const auto& [settings, solver] :
       {std::pair(&state_.task.a, &solvers_.a), {&state_.task.b, &solvers_.b}}) {
    const Status made = *settings ? provide(*solver, solvers_) : Status(Done{});
    if (!made) fail(made.error().text());
  }
  if (state_.done) return;
  start(state_.task.from_s, state_.task.follows_live ? state_.task.from_s : state_.task.to_s);
  if (waiting_.empty() && !state_.task.follows_live && !state_.done)
    fail("the inputs of these frames are no longer kept; choose later ones");
}

void ComparisonRun::fail(const std::string& why) {
  state_.trouble = why;
  state_.done = true;
}

/// Both solvers go to before the first frame of the range.
void ComparisonRun::start(double from_s, double to_s) {
  auto found = recorded_.solvable_again(from_s, to_s);
  state_.is_short = found.is_short;
  waiting_ = {};
  solved_ = 0;
  last_ = nullptr;
  const FrameSnapshotPtr first = found.frames.next();
  if (!first) return;
  // A take that was added or taken away since makes another library.
  const auto is_of_library = [this](const FrameSnapshotPtr& frame) {
    return has_pairs_of(*solvers_.library, *frame);
  };
  if (!is_of_library(first) || !std::ranges::all_of(found.run_up, is_of_library))
    return fail("these frames were solved with another library");
  if (state_.task.a) solvers_.a->go_to(found.run_up, *first);
  if (state_.task.b) solvers_.b->go_to(found.run_up, *first);
  waiting_ = std::move(found.frames);
  waiting_.rewind();
}

/// The frames that the live solver has added.
bool ComparisonRun::find_more() {
  if (!last_) {
    start(state_.task.from_s, state_.task.from_s);
    return !waiting_.empty();
  }
  auto more = recorded_.since(last_->index + 1);
  if (more.empty()) return false;
  const bool is_gapless = more.front()->index == last_->index + 1;
  if (is_gapless && more.size() <= most_waiting) {
    waiting_ = {nullptr, 0, 0, std::move(more)};
    solved_ = 0;
    return true;
  }
  a_->clear();
  b_->clear();
  start(more.back()->time_s, more.back()->time_s);
  return !waiting_.empty();
}

bool ComparisonRun::advance(std::size_t frames) {
  if (state_.done) return false;
  const auto began = std::chrono::steady_clock::now();
  if (solved_ == waiting_.size() && state_.task.follows_live && !find_more()) return false;
  for (; frames > 0 && solved_ < waiting_.size(); --frames) {
    const FrameSnapshotPtr recorded = waiting_.next();
    if (!recorded) {
      state_.unread += waiting_.size() - solved_;
      solved_ = waiting_.size();
      break;
    }
    solve(recorded);
    last_ = recorded;
    ++solved_;
  }
  if (!state_.task.follows_live) {
    state_.done = solved_ == waiting_.size();
    state_.fraction = static_cast<double>(solved_) / static_cast<double>(waiting_.size());
  }
  state_.solve_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return true;
}

void ComparisonRun::solve(const FrameSnapshotPtr& recorded) {
  const auto of_run = [&](const std::optional<Settings>& settings, ReSolver* solver,
                          const std::optional<Decisions>& decisions) {
    // The session may have had another library, for example without a take that was added since.
    return slim(settings ? solver->solve(*recorded, *settings, decisions)
                         : std::make_shared<FrameSnapshot>(*in_library(recorded, solvers_.library)));
  };
  a_->append(of_run(state_.task.a, solvers_.a.get(), std::nullopt));
  b_->append(of_run(state_.task.b, solvers_.b.get(), state_.task.b_decisions));
}

std::shared_ptr<const Comparison> ComparisonRun::measured() {
  auto measured = std::make_shared<Comparison>(state_);
  auto a = a_->since(0), b = b_->since(0);
  if (a.empty() || b.empty()) return measured;
  double from_s = std::max(a.front()->time_s, b.front()->time_s);  // one may have lost more of its oldest
  if (state_.task.follows_live)
    from_s = std::max({from_s, settled_since(a), settled_since(b), a.back()->time_s - longest_window_s});
  const auto is_before = [from_s](const FrameSnapshotPtr& frame) { return frame->time_s < from_s; };
  std::erase_if(a, is_before);
  std::erase_if(b, is_before);
  measured->settings_a = a.back()->settings;
  measured->settings_b = b.back()->settings;
  const auto steps_a = steps_of(a), steps_b = steps_of(b);
  const UserRole role_a = measured->settings_a.user_role, role_b = measured->settings_b.user_role;
  measured->figures_a = measure_run(steps_a, *solvers_.library, role_a);
  measured->figures_b = measure_run(steps_b, *solvers_.library, role_b);
  measured->steps = compare_steps(steps_a, role_a, steps_b, role_b);
  return measured;
}

}  // namespace abrazo
