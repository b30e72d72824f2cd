#include "app/workbench/library/library_feed.hpp"

#include <algorithm>
#include <utility>

#include "app/workbench/base/job.hpp"
#include "app/workbench/library/library_desk.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

constexpr int settle_ms = 120;

bool same(const std::vector<RoleInterval>& a, const std::vector<RoleInterval>& b) {
  return std::ranges::equal(a, b, [](const RoleInterval& x, const RoleInterval& y) {
    return x.start == y.start && x.end == y.end && x.active == y.active;
  });
}

bool same(const std::vector<LabelInterval>& a, const std::vector<LabelInterval>& b) {
  return std::ranges::equal(a, b, [](const LabelInterval& x, const LabelInterval& y) {
    return x.start == y.start && x.end == y.end && x.label == y.label && x.detail == y.detail &&
           x.confidence == y.confidence;
  });
}

bool same(const TakeAnnotation& a, const TakeAnnotation& b) {
  return same(a.roles, b.roles) && same(a.labels, b.labels);
}

const LibraryTake* take_named(const MotionLibrary& library, const std::string& name) {
  const int found = library.find_take(name);
  return found < 0 ? nullptr : &library.takes()[static_cast<std::size_t>(found)];
}

Result<PreparedSolver> annotated(Material material, const std::map<std::string, TakeAnnotation>& takes,
                                 const Settings& settings) {
  for (const auto& [take, annotation] : takes) {
    auto next = with_annotation(*material.library, take, annotation);
    if (!next) return next.error();
    material.library = std::make_shared<const MotionLibrary>(std::move(next).value());
  }
  return prepare_solver(std::move(material), settings);
}

/// Decisions that name pairs, numbered as in the other library.
widgets::Steering carried(widgets::Steering steering, const MotionLibrary& from, const MotionLibrary& to) {
  const auto there = [&](int pair) { return same_pair(from, pair, to); };
  if (steering.pinned && there(*steering.pinned) < 0) steering.pinned.reset();
  if (steering.pinned) steering.pinned = there(*steering.pinned);
  std::set<int> pairs;
  for (const int pair : steering.vetoes.pairs)
    if (there(pair) >= 0) pairs.insert(there(pair));
  steering.vetoes.pairs.clear();
  for (const int pair : pairs) steering.vetoes.pairs.insert(pair);
  return steering;
}

}  // namespace

LibraryFeed::LibraryFeed(MainWindow& window) : QObject(&window), m_window(window) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(settle_ms);
  connect(&m_soon, &QTimer::timeout, this, &LibraryFeed::begin);
  connect(&window, &MainWindow::sessionEnding, this, &LibraryFeed::forget);
}

LibraryFeed::~LibraryFeed() = default;

void LibraryFeed::forget() {
  m_soon.stop();
  m_wanted.clear();
  m_working.clear();
  Job::retire(std::move(m_job), this);
}

void LibraryFeed::put(const std::string& take, const Annotations& annotations) {
  if (!m_window.session()) return;
  const LibraryTake* known = take_named(*m_window.session()->material().library, take);
  if (!known) return;
  const auto said = take_annotation(annotations, known->fps, known->frames);
  if (!said)
    return m_window.messages().showError(QString::fromStdString(said.error().text()) +
                                         "; the library keeps the roles it has until then");
  const auto waiting = m_wanted.find(take), working = m_working.find(take);
  const TakeAnnotation in_library{known->roles, known->labels};
  const TakeAnnotation& last = waiting != m_wanted.end()    ? waiting->second
                               : working != m_working.end() ? working->second
                                                            : in_library;
  if (same(last, *said)) return;
  m_wanted[take] = *said;
  m_soon.start();
}

void LibraryFeed::begin() {
  if (!m_window.session() || m_wanted.empty()) return;
  // What the job before did not finish is included: the newest of each take.
  for (auto& [take, annotation] : m_working) m_wanted.emplace(take, annotation);
  m_working = std::move(m_wanted);
  m_wanted.clear();
  Job::retire(std::move(m_job), this);
  m_job = std::make_unique<Job>([this, material = m_window.session()->material(), takes = m_working,
                                 settings = m_window.settings().settings()](const Progress&) -> Job::Finish {
    auto prepared = annotated(material, takes, settings);
    if (!prepared)
      return [this, why = prepared.error().text()] {
        m_working.clear();
        m_window.messages().showError(QString::fromStdString(why));
      };
    auto ready = std::make_shared<PreparedSolver>(std::move(prepared).value());
    return [this, ready, base = material.library] {
      m_window.session()->material().library == base ? show(std::move(*ready)) : beginAgain();
    };
  });
}

/// The library got a take meanwhile, say, which is not in what was made.
void LibraryFeed::beginAgain() {
  for (auto& [take, annotation] : std::exchange(m_working, {})) m_wanted.emplace(take, annotation);
  begin();
}

void LibraryFeed::show(PreparedSolver prepared) {
  const auto before = m_window.session()->material().library;
  const auto library = prepared.material.library;
  m_working.clear();
  m_window.session()->replaceSolver(std::move(prepared));
  m_window.ticker().setLibrary(library);
  m_window.scene().setLibrary(library);
  const auto steering = carried(m_window.candidates().steering(), *before, *library);
  m_window.candidates().setLibrary(library);
  m_window.candidates().showSteering(steering);  // the solver carries it over, too
  m_window.timeline().extendLibrary(library);
  const int take = m_window.takes().selectedTake();
  m_window.takes().setLibrary(library);
  if (take >= 0) m_window.takes().setSelectedTake(take);
  if (auto* of_library = m_window.findChild<LibraryDesk*>()) of_library->onSession();
  m_window.status().setLibrary(library->pair_count());
  if (auto* browser = m_window.findChild<LibraryDesk*>()) browser->onSession();
  emit fed();
}

}  // namespace abrazo::app
