#include "app/workbench/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFrame>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QSplitter>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include "app/workbench/job.hpp"
#include "app/workbench/status_figures.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/scene_tree.hpp"
#include "widgets/scene/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

constexpr int status_interval_ms = 500;
constexpr QSize smallest_window(640, 400);  // panels give way before: see plan_panels

QVBoxLayout* columnIn(QWidget* box) {
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  box->setObjectName("panel");
  box->setAttribute(Qt::WA_StyledBackground);
  return column;
}

QWidget* ruled(QWidget* parent) {
  auto* line = new QFrame(parent);
  line->setFixedHeight(1);
  line->setObjectName("rule");
  return line;
}

}  // namespace

MainWindow::MainWindow(UserSettings& remembered)
    : m_remembered(remembered), m_palette(&widgets::palette_of(widgets::Theme::Dark)) {
  setWindowTitle("Abrazo");
  setAcceptDrops(true);
  setMinimumSize(smallest_window);
  resize(1600, 1000);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  setCentralWidget(makeCentre());
  m_left = dock(Qt::LeftDockWidgetArea, makeLeft(), "Scene and library");
  m_right = dock(Qt::RightDockWidgetArea, makeRight(), "Candidates and settings");
  dock(Qt::BottomDockWidgetArea, makeBottom(), "Timeline");
  m_status = new StatusFigures(this);
  statusBar()->addWidget(m_status, 1);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->setContentsMargins(0, 0, 0, 0);
  wireViews();
  wireTransport();
}

MainWindow::~MainWindow() {
  m_job.reset();
  m_ticker.setSources(nullptr, nullptr);
  m_undo.clear();  // its commands point at the settings panel
}

QWidget* MainWindow::makeCentre() {
  auto* box = new QWidget(this);
  auto* column = columnIn(box);
  auto* split = new QSplitter(Qt::Vertical, box);
  m_messages = new widgets::MessageBar(box);
  m_scene = new widgets::SceneView(split);
  m_plots = new widgets::PlotPanel(split);
  split->setHandleWidth(1);
  split->setChildrenCollapsible(false);
  split->setStretchFactor(0, 4);
  split->setStretchFactor(1, 1);
  split->setSizes({620, 150});
  column->addWidget(m_messages);
  column->addWidget(split, 1);
  return box;
}

QWidget* MainWindow::makeLeft() {
  auto* box = new QWidget(this);
  auto* column = columnIn(box);
  m_sceneHead = new widgets::SectionHeader("Scene", box);
  m_tree = new widgets::SceneTree(box);
  m_libraryHead = new widgets::SectionHeader("Library", box);
  m_takes = new widgets::TakeList(box);
  auto* scroll = new QScrollArea(box);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(m_takes);
  scroll->viewport()->setAutoFillBackground(false);
  m_takes->setAutoFillBackground(false);
  column->addWidget(m_sceneHead);
  column->addWidget(m_tree);
  column->addWidget(ruled(box));
  column->addWidget(m_libraryHead);
  column->addWidget(scroll, 1);
  return box;
}

QWidget* MainWindow::makeRight() {
  auto* box = new QWidget(this);
  auto* column = columnIn(box);
  auto* split = new QSplitter(Qt::Vertical, box);
  m_candidates = new widgets::CandidateTable(split);
  m_settings = new widgets::SettingsPanel(m_undo, split);
  split->setHandleWidth(1);
  split->setChildrenCollapsible(false);
  split->setSizes({460, 290});
  split->setStretchFactor(0, 2);
  split->setStretchFactor(1, 3);
  column->addWidget(split);
  return box;
}

QWidget* MainWindow::makeBottom() {
  auto* box = new QWidget(this);
  auto* column = columnIn(box);
  m_transport = new widgets::TransportBar(box);
  m_timeline = new widgets::TimelineView(box);
  column->addWidget(m_transport);
  column->addWidget(ruled(box));
  column->addWidget(m_timeline);
  return box;
}

QDockWidget* MainWindow::dock(Qt::DockWidgetArea area, QWidget* content, const QString& name) {
  auto* holder = new QDockWidget(name, this);
  holder->setObjectName(name);
  holder->setFeatures(QDockWidget::NoDockWidgetFeatures);
  holder->setTitleBarWidget(new QWidget(holder));
  holder->setWidget(content);
  addDockWidget(area, holder);
  return holder;
}

void MainWindow::arrangePanels() {
  const PanelPlan plan = plan_panels(size(), m_wishes);
  m_left->widget()->setFixedWidth(plan.left_width);
  m_right->widget()->setFixedWidth(plan.right_width);
  m_left->setVisible(plan.left);
  m_right->setVisible(plan.right);
  m_plots->setVisible(plan.plots);
  emit panelsArranged(plan);
}

void MainWindow::showLeft(bool on) {
  m_wishes.left = on;
  arrangePanels();
}

void MainWindow::showRight(bool on) {
  m_wishes.right = on;
  arrangePanels();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  arrangePanels();
  QMainWindow::resizeEvent(event);
}

void MainWindow::wireViews() {
  using namespace widgets;
  connect(&m_ticker, &FrameTicker::frameReady, m_scene, &SceneView::showFrame);
  connect(&m_ticker, &FrameTicker::frameReady, m_candidates, &CandidateTable::showFrame);
  connect(&m_ticker, &FrameTicker::panelsDue, this, &MainWindow::showPanels);
  connect(m_candidates, &CandidateTable::candidateHovered, m_scene, &SceneView::showCandidate);
  connect(m_tree, &SceneTree::visibilityRequested, m_scene, &SceneView::setVisibility);
  connect(m_scene, &SceneView::visibilityChanged, m_tree, &SceneTree::setVisibility);
  connect(m_scene, &SceneView::countsChanged, m_tree, &SceneTree::setCounts);
  connect(m_settings, &SettingsPanel::commandRequested, this, [this](const Command& command) {
    if (m_session) m_session->push(command);
  });
  connect(m_settings, &SettingsPanel::mistaken, m_messages, &MessageBar::showError);
  connect(m_messages, &MessageBar::cancelRequested, this, [this] {
    if (m_job) m_job->cancel();
  });
  connect(&m_statusTimer, &QTimer::timeout, this, [this] {
    if (m_session) m_status->refresh(m_session->history(), m_scene->renderedFrames());
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
  connect(&m_ticker, &FrameTicker::playbackChanged, m_transport, [this](const Playback& playback) {
    const auto& shown = m_ticker.shown();
    m_transport->showPlayback(playback, shown ? static_cast<long long>(shown->index) : -1);
  });
}

void MainWindow::showPanels() {
  if (!m_session) return;
  m_timeline->refresh(m_session->history(), m_ticker.playback());
  m_plots->refresh(m_session->history(), m_ticker.playback(), m_ticker.shown());
  m_candidates->showPath(m_session->history(), m_ticker.playback().cursor_s);
  const auto& shown = m_ticker.shown();
  const bool has_source = shown && shown->result.selected >= 0;
  const auto selected = has_source ? static_cast<std::size_t>(shown->result.selected) : 0;
  m_takes->setCurrentTake(
      has_source ? static_cast<int>(
                       m_session->material().library->source(shown->result.candidates[selected].pair).take)
                 : -1);
}

void MainWindow::setTheme(widgets::Theme theme) {
  m_palette = &widgets::palette_of(theme);
  const widgets::Palette& p = *m_palette;
  widgets::apply_theme(*qApp, p);
  for (auto* head : {m_sceneHead, m_libraryHead}) head->setColours(p);
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
  setWindowIcon(widgets::program_icon(p.active, p.passive));
}

QMenu* MainWindow::menu(const QString& title) {
  for (QAction* action : menuBar()->actions())
    if (action->text() == title) return action->menu();
  return menuBar()->addMenu(title);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  if (!files.isEmpty()) openFiles(files);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  m_remembered.setGeometry(saveGeometry());
  QMainWindow::closeEvent(event);
}

}  // namespace abrazo::app
