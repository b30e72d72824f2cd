#include "app/workbench/library/library_feed.hpp"

#include <utility>

#include "app/workbench/base/job.hpp"
#include "app/workbench/library/library_desk.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::text;

constexpr int settle_ms = 120;

Result<PreparedSolver> annotated(Material material, const LibraryUpdates::Takes& takes,
                                 const Settings& settings) {
  auto library = with_updates(material.library, takes);
  if (!library) return library.error();
  material.library = std::move(*library);
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
  m_updates.forget();
  Job::retire(std::move(m_job), this);
}

void LibraryFeed::put(const std::string& take, const Annotations& annotations) {
  if (!m_window.session()) return;
  const auto waits = m_updates.put(*m_window.session()->material().library, take, annotations);
  if (!waits)
    return m_window.messages().showError(text(waits.error().text()) +
                                         "; the library keeps the roles it has until then");
  if (*waits) m_soon.start();
}

void LibraryFeed::begin() {
  if (!m_window.session() || m_updates.is_idle()) return;
  Job::retire(std::move(m_job), this);
  m_job = std::make_unique<Job>([this, material = m_window.session()->material(), takes = m_updates.begin(),
                                 settings = m_window.settings().settings()](const Progress&) -> Job::Finish {
    auto prepared = annotated(material, takes, settings);
    if (!prepared)
      return [this, why = prepared.error().text()] {
        m_updates.end();
        m_window.messages().showError(text(why));
      };
    auto ready = std::make_shared<PreparedSolver>(std::move(prepared).value());
    return [this, ready, base = material.library] {
      // The library got a take meanwhile, say, which is not in what was made.
      m_window.session()->material().library == base ? show(std::move(*ready)) : begin();
    };
  });
}

void LibraryFeed::show(PreparedSolver prepared) {
  const auto before = m_window.session()->material().library;
  const auto library = prepared.material.library;
  m_updates.end();
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
  m_window.status().setLibrary(library->pair_count());
  if (auto* browser = m_window.findChild<LibraryDesk*>()) browser->onSession();
  emit fed();
}

}  // namespace abrazo::app
