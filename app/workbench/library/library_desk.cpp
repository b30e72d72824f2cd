#include "app/workbench/library/library_desk.hpp"

#include <algorithm>

#include "app/workbench/base/job.hpp"
#include "app/workbench/document/open_video.hpp"
#include "app/workbench/library/library_build.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/library/store/neighbour_distance.hpp"
#include "core/session/frames/decision_edits.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {

LibraryDesk::LibraryDesk(MainWindow& window) : QObject(&window), m_window(window) {
  connectBrowser();
  connect(&window.document(), &Document::began, this, &LibraryDesk::onSession);
  connect(&window.document(), &Document::libraryReplaced, this, &LibraryDesk::onSession);
  connect(&window.document(), &Document::ending, this, [this] { m_window.takes().stop(); });
  connect(&window.ticker(), &FrameTicker::panelsDue, this, &LibraryDesk::onPanels);
  connect(&window, &MainWindow::motionsOffered, this, &LibraryDesk::offer);
  connect(&window, &MainWindow::coloursChanged, this, [this](const widgets::Palette& palette) {
    if (m_build) m_build->setColours(palette);
  });
}

LibraryDesk::~LibraryDesk() = default;

void LibraryDesk::connectBrowser() {
  using widgets::TakeList;
  connect(&m_window.takes(), &TakeList::recordedShown, this, &LibraryDesk::showRecorded);
  connect(&m_window.takes(), &TakeList::danceRequested, this, &LibraryDesk::danceWith);
  connect(&m_window.takes(), &TakeList::vetoRequested, this, &LibraryDesk::toggleVeto);
  // Updated with each picture of the scene, unlike the marks, because its motion is the information.
  connect(&m_window.ticker(), &FrameTicker::frameReady, this,
          [this](const FrameSnapshotPtr& frame) { m_window.takes().setBelief(frame->result.intent); });
  connect(&m_window.candidates(), &widgets::CandidateTable::jumpRequested, &m_window.takes(),
          &TakeList::showPlace);
}

void LibraryDesk::onSession() {
  const Material& material = m_window.session()->material();
  const auto& excluded = material.excluded_takes;
  const bool from_library =
      material.library->find_take(material.input.name) >= 0 &&
      (material.library->takes().size() == 1 ||
       std::find(excluded.begin(), excluded.end(), material.input.name) != excluded.end());
  m_window.takes().setUsersTake(from_library ? material.input.name : "");
  if (m_measured.lock() != material.library) measure(material.library);
}

/// On a worker: a large library takes a good part of a second.
void LibraryDesk::measure(const std::shared_ptr<const MotionLibrary>& library) {
  m_measured = library;
  Job::retire(std::move(m_measuring), this);
  m_measuring = std::make_unique<Job>([this, library](const Progress& progress) -> Job::Finish {
    constexpr int samples = 400;
    const auto distance = typical_neighbour_distance(*library, samples, progress);
    return [this, distance] { m_window.takes().setTypicalDistance(distance); };
  });
}

void LibraryDesk::onPanels() {
  LiveSession* session = m_window.session();
  if (!session) return;
  widgets::TakeList& takes = m_window.takes();
  takes.refresh(session->engine().history());
  const auto& shown = m_window.ticker().shown();
  const int pair = shown ? selected_pair(*shown, session->material().library) : -1;
  if (pair < 0) return takes.setSource(-1, 0);
  const PairSource& source = session->material().library->source(pair);
  takes.setSource(static_cast<int>(source.take), static_cast<int>(source.frame));
}

/// A browsed pair is placed at the user; a played one continues from its start.
void LibraryDesk::showRecorded(int pair, bool in_motion) {
  const auto& shown = m_window.ticker().shown();
  if (pair < 0 || !shown || !m_window.session()) return m_window.scene().showRecorded(std::nullopt);
  const MotionLibrary& library = *m_window.session()->material().library;
  if (!in_motion)
    m_ghost.begin(library, pair, shown->result.query_root, shown->settings.user_role == UserRole::Passive);
  m_window.scene().showRecorded(m_ghost.at(library, pair));
}

void LibraryDesk::danceWith(int take) {
  if (!m_window.session()) return;
  m_window.openMaterial([open = m_window.session()->material(), take](const Progress&) -> Result<Material> {
    return asked_dance(open, take);
  });
}

void LibraryDesk::toggleVeto(int take) {
  if (!m_window.session()) return;
  const MotionLibrary& library = *m_window.session()->material().library;
  const std::string& name = library.takes()[static_cast<std::size_t>(take)].name;
  const Decisions& now = m_window.document().decisions();
  m_window.document().change(
      with_take_toggled(now, name, library),
      (now.vetoes.takes.contains(name) ? "use of take " : "veto of take ") + QString::fromStdString(name));
}

void LibraryDesk::offer(const QStringList& files) {
  if (!m_build) {
    m_build = new LibraryBuild(&m_window, m_window.colours());
    m_build->setJointMaps(m_window.remembered().jointMapFolder());
    connect(m_build, &LibraryBuild::userChosen, this,
            [this](const QStringList& chosen) { m_window.openFiles(chosen + m_videos); });
    const auto end = [this] {
      m_videos.clear();
      m_build->deleteLater();
      m_build = nullptr;
    };
    connect(m_build, &LibraryBuild::givenUp, this, end);
    connect(m_build, &LibraryBuild::startOver, this, [this, end] {
      end();
      offer({});
    });
    connect(m_build, &LibraryBuild::built, this, [this, end](const Material& material, bool& is_taken) {
      is_taken = m_window.isLeft();
      if (!is_taken) return;
      m_window.openMaterial([material](const Progress&) -> Result<Material> { return material; }, m_videos,
                            MainWindow::AsksToLeave::Asked);
      if (!material.library_file.empty())
        m_window.noteOpened({QString::fromStdString(material.library_file)});
      end();
    });
    connect(m_build, &LibraryBuild::userChosen, this, end);
  }
  QStringList others;
  for (const QString& file : files) (is_video_file(file) ? m_videos : others) << file;
  m_build->offer(others);
}

}  // namespace abrazo::app
