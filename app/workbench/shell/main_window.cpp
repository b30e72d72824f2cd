#include "app/workbench/shell/main_window.hpp"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include "app/workbench/base/job.hpp"
#include "app/workbench/shell/document_views.hpp"
#include "app/workbench/shell/drop_hint.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "app/workbench/shell/work_split.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/panel/notice_column.hpp"
#include "widgets/scene/panel/scene_tree.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

constexpr int status_interval_ms = 500;
constexpr QSize smallest_window(640, 400);  // panels give way before: see plan_panels

void as_panel(QWidget* box) {
  box->setObjectName("panel");
  box->setAttribute(Qt::WA_StyledBackground);
}

QWidget* ruled(QWidget* parent) {
  auto* line = new QFrame(parent);
  line->setFixedHeight(1);
  line->setObjectName("rule");
  return line;
}

QStringList local_files(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  return files;
}

}  // namespace

MainWindow::MainWindow(UserSettings& remembered)
    : m_remembered(remembered),
      m_palette(&widgets::palette_of(widgets::Theme::Dark)),
      m_document(std::make_unique<Document>()) {
  setWindowTitle("Abrazo");
  setAcceptDrops(true);
  setMinimumSize(smallest_window);
  resize(1600, 1000);
  m_panelMenu = new QMenu("Panels", this);
  m_panels = new PanelArea;
  m_panels->setCentralWidget(makeCentre());
  makePanels();
  QWidget* timeline = makeTimeline();
  m_split = new WorkSplit(m_panels, timeline, m_timeline, this);
  setCentralWidget(m_split);
  connect(m_panels, &PanelArea::arranged, this, &MainWindow::panelsArranged);
  m_dropHint = new DropHint(this);
  m_status = new StatusFigures(this);
  statusBar()->addWidget(m_status, 1);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->setContentsMargins(0, 0, 0, 0);
  wireViews();
  wireTransport();
}

MainWindow::~MainWindow() {
  m_job.reset();
  endSession();
  // Whoever follows the focus is whole as long as it moves; a visible dialog would move it while they are
  // destroyed.
  for (QWidget* each : findChildren<QWidget*>())
    if (each->isWindow()) each->hide();
  hide();
}

QWidget* MainWindow::makeCentre() {
  auto* box = new QWidget(m_panels);
  as_panel(box);
  m_messages = new widgets::MessageBar(box);
  Job::tellFailures([to = QPointer(m_messages)](const QString& failure) {
    if (to) to->showError(failure);
  });
  m_selection = new widgets::SelectionModel(this);
  m_scene = new widgets::SceneView(box);
  m_sceneRow = widgets::row_in(box, {}, 0);
  m_sceneRow->addWidget(m_scene, 1);
  m_notices = new widgets::NoticeColumn(box);
  m_notices->add(m_messages);
  connect(m_scene, &widgets::SceneView::arranged, m_notices,
          [this] { m_notices->setRoom(m_scene->noticeRoom().translated(m_scene->pos())); });
  return box;
}

void MainWindow::makePanels() {
  m_tree = new widgets::SceneTree;
  m_takes = new widgets::TakeList;
  m_candidates = new widgets::CandidateTable;
  m_settings = new widgets::SettingsPanel;
  m_plots = new widgets::PlotPanel;
  addPanel("scene", "Scene", m_tree, Qt::LeftDockWidgetArea, true);
  addPanel("library", "Library", m_takes, Qt::LeftDockWidgetArea, true);
  addPanel("candidates", "Candidates", m_candidates, Qt::RightDockWidgetArea, true);
  addPanel("settings", "Settings", m_settings, Qt::RightDockWidgetArea, true);
  addPanel("plots", "Plots", m_plots, Qt::BottomDockWidgetArea, true);
}

QWidget* MainWindow::makeTimeline() {
  auto* box = new QWidget(this);
  as_panel(box);
  auto* column = widgets::column_in(box, {}, 0);
  m_transport = new widgets::TransportBar(box);
  m_transport->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  m_timeline = new widgets::TimelineView(box);
  column->addWidget(m_transport);
  column->addWidget(ruled(box));
  column->addWidget(m_timeline, 1);
  return box;
}

QDockWidget* MainWindow::addPanel(const QString& id, const QString& title, QWidget* content,
                                  Qt::DockWidgetArea area, bool shown) {
  QDockWidget* panel = m_panels->add(id, title, content, area, shown);
  m_panels->setColours(*m_palette);
  auto* action = new QAction(title + " panel", this);
  action->setCheckable(true);
  action->setChecked(shown);
  connect(action, &QAction::triggered, m_panels, [this, id](bool on) { m_panels->want(id, on); });
  connect(m_panels, &PanelArea::wantedChanged, action, [action, id](const QString& changed, bool on) {
    if (changed == id) action->setChecked(on);
  });
  m_panelMenu->addAction(action);
  addAction(action);
  return panel;
}

void MainWindow::addBelowMessages(QWidget* bar) {
  m_notices->add(bar);
}

void MainWindow::addAboveMessages(QWidget* bar) {
  m_notices->addFirst(bar);
}

void MainWindow::addBesideScene(QWidget* page) {
  m_besideScene = page;
  m_sceneRow->insertWidget(0, page);
}

WindowLayout MainWindow::layoutOfPanels() const {
  WindowLayout layout = m_panels->state();
  layout.timeline_height = m_split->chosenHeight();
  return layout;
}

bool MainWindow::setLayoutOfPanels(const WindowLayout& layout) {
  if (!m_panels->setState(layout)) return false;
  m_split->choose(layout.timeline_height);
  return true;
}

void MainWindow::resetLayout() {
  m_panels->reset();
  m_split->choose({});
}

void MainWindow::makeRoomForLanes() {
  m_split->makeRoomForLanes();
}

void MainWindow::showLeft(bool on) {
  m_panels->wantSide(Qt::LeftDockWidgetArea, on);
}

void MainWindow::showRight(bool on) {
  m_panels->wantSide(Qt::RightDockWidgetArea, on);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  m_panels->arrangeFor(size());
  QMainWindow::resizeEvent(event);
}

void MainWindow::wireViews() {
  using namespace widgets;
  connect(&m_ticker, &FrameTicker::frameReady, m_scene, &SceneView::showFrame);
  connect(&m_ticker, &FrameTicker::frameReady, m_candidates, &CandidateTable::showFrame);
  connect(&m_ticker, &FrameTicker::panelsDue, this, &MainWindow::showPanels);
  connect(m_selection, &SelectionModel::selectionChanged, &m_ticker, &FrameTicker::askForPanels);
  connect(m_plots, &PlotPanel::unfinished, &m_ticker, &FrameTicker::askForPanels);
  connect(m_timeline, &TimelineView::unfinished, &m_ticker, &FrameTicker::askForPanels);
  connect(m_candidates, &CandidateTable::candidateHovered, m_scene, &SceneView::showCandidate);
  connect(m_tree, &SceneTree::visibilityRequested, m_scene, &SceneView::setVisibility);
  connect(m_scene, &SceneView::visibilityChanged, m_tree, &SceneTree::setVisibility);
  connect(m_scene, &SceneView::countsChanged, m_tree, &SceneTree::setCounts);
  show_document(*this);
  connect(m_messages, &MessageBar::cancelRequested, this, [this] {
    if (m_job) m_job->cancel();
  });
  connect(&m_statusTimer, &QTimer::timeout, this, [this] {
    if (!session()) return;
    m_status->showHeld(session()->engine().is_held());
    m_status->refresh(session()->engine().history(), m_scene->renderedFrames(),
                      session()->engine().clip_progress());
  });
  m_statusTimer.start(status_interval_ms);
}

void MainWindow::wireTransport() {
  using namespace widgets;
  connect(m_transport, &TransportBar::toggleRequested, &m_ticker, &FrameTicker::toggle);
  connect(m_transport, &TransportBar::stepRequested, &m_ticker, &FrameTicker::step);
  connect(m_transport, &TransportBar::startRequested, &m_ticker, &FrameTicker::goToStart);
  connect(m_transport, &TransportBar::followRequested, &m_ticker, &FrameTicker::follow);
  connect(m_transport, &TransportBar::speedRequested, &m_ticker, &FrameTicker::setSpeed);
  connect(m_transport, &TransportBar::loopRequested, &m_ticker, &FrameTicker::setLoop);
  connect(m_timeline, &TimelineView::seekRequested, &m_ticker, &FrameTicker::seek);
  connect(m_plots, &PlotPanel::seekRequested, &m_ticker, &FrameTicker::seek);
}

void MainWindow::showPanels() {
  if (!session()) return;
  m_timeline->refresh(session()->history(), m_ticker.playback());
  m_plots->refresh(session()->history(), m_ticker.playback(), m_ticker.shown());
  m_candidates->showPath(session()->history(), m_ticker.playback().cursor_s);
  const auto& shown = m_ticker.shown();
  const std::shared_ptr<const MotionLibrary>& library = session()->material().library;
  const int pair = shown ? selected_pair(*shown, library) : -1;
  m_takes->setCurrentTake(pair < 0 ? -1 : static_cast<int>(library->source(pair).take));
}

void MainWindow::setTheme(widgets::Theme theme) {
  m_palette = &widgets::palette_of(theme);
  const widgets::Palette& p = *m_palette;
  widgets::apply_theme(*qApp, p);
  m_panels->setColours(p);
  m_scene->setColours(p);
  m_plots->setColours(p);
  m_messages->setColours(p);
  m_tree->setColours(p);
  m_takes->setColours(p);
  m_candidates->setColours(p);
  m_settings->setColours(p);
  m_transport->setColours(p);
  m_timeline->setColours(p);
  m_status->setColours(p);
  emit coloursChanged(p);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QStringList files = local_files(*event->mimeData());
  if (files.isEmpty()) return;
  event->acceptProposedAction();
  m_dropHint->showFor(files, *m_palette);
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
  m_dropHint->hide();
}

void MainWindow::dropEvent(QDropEvent* event) {
  m_dropHint->hide();
  const QStringList files = local_files(*event->mimeData());
  if (!files.isEmpty()) openFiles(files);
}

}  // namespace abrazo::app
