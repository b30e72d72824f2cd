#include "app/workbench/compare/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <span>

namespace abrazo::app {
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
    : m_recorded(recorded),
      m_solvers(solvers),
      m_a(std::make_shared<FrameHistory>(bytes_of_a_run)),
      m_b(std::make_shared<FrameHistory>(bytes_of_a_run)) {
  m_state.task = std::move(task);
  m_state.a = m_a;
  m_state.b = m_b;
  for (const auto& [settings, solver] :
       {std::pair(&m_state.task.a, &m_solvers.a), {&m_state.task.b, &m_solvers.b}}) {
    const Status made = *settings ? provide(*solver, m_solvers) : Status(Done{});
    if (!made) fail(made.error().text());
  }
  if (m_state.done) return;
  start(m_state.task.from_s, m_state.task.goes_on ? m_state.task.from_s : m_state.task.to_s);
  if (m_waiting.empty() && !m_state.task.goes_on)
    fail("the inputs of these frames are no longer kept; choose later ones");
}

void ComparisonRun::fail(const std::string& why) {
  m_state.trouble = why;
  m_state.done = true;
}

/// Both solvers go to before the first frame of the range.
void ComparisonRun::start(double from_s, double to_s) {
  auto found = m_recorded.solvable_again(from_s, to_s);
  m_state.is_short = found.is_short;
  m_waiting = {};
  m_solved = 0;
  m_last = nullptr;
  const FrameSnapshotPtr first = found.frames.next();
  if (!first) return;
  if (m_state.task.a) m_solvers.a->go_to(found.run_up, *first);
  if (m_state.task.b) m_solvers.b->go_to(found.run_up, *first);
  m_waiting = std::move(found.frames);
  m_waiting.rewind();
}

/// The frames that the live solver has added.
bool ComparisonRun::findMore() {
  if (!m_last) {
    start(m_state.task.from_s, m_state.task.from_s);
    return !m_waiting.empty();
  }
  auto more = m_recorded.since(m_last->index + 1);
  if (more.empty()) return false;
  const bool is_gapless = more.front()->index == m_last->index + 1;
  if (is_gapless && more.size() <= most_waiting) {
    m_waiting = {nullptr, 0, 0, std::move(more)};
    m_solved = 0;
    return true;
  }
  m_a->clear();
  m_b->clear();
  start(more.back()->time_s, more.back()->time_s);
  return !m_waiting.empty();
}

bool ComparisonRun::advance(std::size_t frames) {
  if (m_state.done) return false;
  const auto began = std::chrono::steady_clock::now();
  if (m_solved == m_waiting.size() && m_state.task.goes_on && !findMore()) return false;
  for (; frames > 0 && m_solved < m_waiting.size(); --frames) {
    const FrameSnapshotPtr recorded = m_waiting.next();
    if (!recorded) {
      m_solved = m_waiting.size();  // the rest cannot be read
      break;
    }
    solve(*recorded);
    m_last = recorded;
    ++m_solved;
  }
  if (!m_state.task.goes_on) {
    m_state.done = m_solved == m_waiting.size();
    m_state.fraction = static_cast<double>(m_solved) / static_cast<double>(m_waiting.size());
  }
  m_state.solve_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return true;
}

void ComparisonRun::solve(const FrameSnapshot& recorded) {
  const auto of_run = [&recorded](const std::optional<Settings>& settings, ReSolver* solver) {
    return slim(settings ? solver->solve(recorded, *settings) : std::make_shared<FrameSnapshot>(recorded));
  };
  m_a->append(of_run(m_state.task.a, m_solvers.a.get()));
  m_b->append(of_run(m_state.task.b, m_solvers.b.get()));
}

std::shared_ptr<const Comparison> ComparisonRun::measured() {
  auto measured = std::make_shared<Comparison>(m_state);
  auto a = m_a->since(0), b = m_b->since(0);
  if (a.empty() || b.empty()) return measured;
  double from_s = std::max(a.front()->time_s, b.front()->time_s);  // one may have lost more of its oldest
  if (m_state.task.goes_on)
    from_s = std::max({from_s, settled_since(a), settled_since(b), a.back()->time_s - longest_window_s});
  const auto is_before = [from_s](const FrameSnapshotPtr& frame) { return frame->time_s < from_s; };
  std::erase_if(a, is_before);
  std::erase_if(b, is_before);
  measured->settings_a = a.back()->settings;
  measured->settings_b = b.back()->settings;
  const auto steps_a = steps_of(a), steps_b = steps_of(b);
  const UserRole role_a = measured->settings_a.user_role, role_b = measured->settings_b.user_role;
  measured->figures_a = measure_run(steps_a, *m_solvers.library, role_a);
  measured->figures_b = measure_run(steps_b, *m_solvers.library, role_b);
  measured->steps = compare_steps(steps_a, role_a, steps_b, role_b);
  return measured;
}

}  // namespace abrazo::app
