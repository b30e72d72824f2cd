#pragma once

#include <QMainWindow>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/document/document.hpp"
#include "app/workbench/shell/frame_ticker.hpp"
#include "app/workbench/shell/window_layout.hpp"
#include "core/opening/file_kinds.hpp"
#include "widgets/common/palette.hpp"

class QDockWidget;
class QHBoxLayout;
class QMenu;
class QSplitter;

namespace abrazo::widgets {
class CandidateTable;
class MessageBar;
class PlotPanel;
class SceneTree;
class SceneView;
class SelectionModel;
class SettingsPanel;
class TakeList;
class TimelineView;
class TransportBar;
}  // namespace abrazo::widgets

namespace abrazo::app {

class DropHint;
class Job;
class PanelArea;
class StatusFigures;

/// Where the parts stand and how they are wired. Every user action lives in the `_actions.cpp` of its
/// feature.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(UserSettings& remembered);
  ~MainWindow() override;

  /// Runs on a worker and then replaces the session. @param make  called off this thread
  using MakeMaterial = std::function<Result<Material>(const Progress&)>;
  /// @param files  it is read from, for the list of recent files
  void openMaterial(MakeMaterial make, const QStringList& files = {});
  void openFiles(const QStringList& files);
  void openDemo();
  /// Among the recent ones from now on.
  void noteOpened(const QStringList& files) { emit filesOpened(files); }
  /// A take of the library by name in place of the session, or the session again ("").
  void requestSubject(const QString& subject) { emit subjectRequested(subject); }
  /// Shown, and told to whoever started the program unattended.
  void fail(const QString& message);

  void setTheme(widgets::Theme theme);
  const widgets::Palette& colours() const { return *m_palette; }
  QMenu* menu(const QString& title);

  /// A panel beside or below the scene, with an entry under View > Panels. Adds it hidden unless `shown`;
  /// give the content its colours now and with every coloursChanged.
  /// @param id  names it in saved layouts and stays the same between versions
  /// @param content  whose own SectionHeader of this title, if a direct child, becomes the panel's head
  QDockWidget* addPanel(const QString& id, const QString& title, QWidget* content, Qt::DockWidgetArea area,
                        bool shown);
  PanelArea& panels() const { return *m_panels; }
  QMenu& panelMenu() { return *m_panelMenu; }
  /// Shows or hides the panel at the left or right, whatever the size of the window.
  void showLeft(bool on);
  void showRight(bool on);

  /// Between the message bar and the timeline, left of the scene.
  void addBesideScene(QWidget* page);
  QWidget* besideScene() const { return m_besideScene; }  ///< null where nothing was added
  WindowLayout layoutOfPanels() const;
  bool setLayoutOfPanels(const WindowLayout& layout);
  void resetLayout();

  FrameTicker& ticker() { return m_ticker; }
  /// What is worked on: who shows a part of it listens there.
  Document& document() const { return *m_document; }
  QUndoStack& undoStack() { return m_document->undoStack(); }
  UserSettings& remembered() const { return m_remembered; }
  LiveSession* session() const { return m_document->session(); }
  widgets::SceneView& scene() const { return *m_scene; }
  widgets::SceneTree& sceneTree() { return *m_tree; }
  /// The one selection of scene, scene tree, candidates and plots.
  widgets::SelectionModel& selection() { return *m_selection; }
  widgets::SettingsPanel& settings() { return *m_settings; }
  widgets::CandidateTable& candidates() { return *m_candidates; }
  widgets::TakeList& takes() { return *m_takes; }
  widgets::PlotPanel& plots() { return *m_plots; }
  widgets::TimelineView& timeline() const { return *m_timeline; }
  widgets::TransportBar& transport() const { return *m_transport; }
  widgets::MessageBar& messages() { return *m_messages; }
  StatusFigures& status() const { return *m_status; }

 signals:
  void sessionStarted();
  /// The last moment to let go of what belongs to session().
  void sessionEnding();
  void coloursChanged(const abrazo::widgets::Palette& palette);
  void failed(const QString& message);
  /// More than one motion is to be opened: a person says what they are for. Videos may be among them.
  void motionsOffered(const QStringList& files);
  /// Nobody knows which points of this motion are which joints: a person says so.
  void mappingOffered(const QStringList& files, const std::shared_ptr<const abrazo::NamedMotion>& motion);
  void subjectRequested(const QString& subject);
  /// Files of labels alone, for what is shown.
  void labelsOffered(const QStringList& files);
  /// Reference videos are to be opened, beside what else is.
  void videosOffered(const QStringList& files);
  void filesOpened(const QStringList& files);
  /// A session file is to be opened, among these; whoever opens it himself says so.
  void sessionOffered(const std::vector<abrazo::FileToOpen>& files, bool& taken);
  /// The session is to end, for another one or with the window. Who wants it to stay says so.
  void leaving(bool& allowed);
  void closing();
  void panelsArranged(const abrazo::app::PanelPlan& plan);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeCentre();
  void makePanels();
  QWidget* makeTimeline();
  void wireViews();
  void wireTransport();
  void showPanels();
  void start(const std::shared_ptr<PreparedSolver>& prepared);
  void offerOnceOpen(const QStringList& videos, const QStringList& files);

  UserSettings& m_remembered;
  const widgets::Palette* m_palette;

  widgets::SelectionModel* m_selection = nullptr;
  widgets::SceneView* m_scene = nullptr;
  widgets::PlotPanel* m_plots = nullptr;
  widgets::MessageBar* m_messages = nullptr;
  widgets::SceneTree* m_tree = nullptr;
  widgets::TakeList* m_takes = nullptr;
  widgets::CandidateTable* m_candidates = nullptr;
  widgets::SettingsPanel* m_settings = nullptr;
  widgets::TransportBar* m_transport = nullptr;
  widgets::TimelineView* m_timeline = nullptr;
  StatusFigures* m_status = nullptr;
  QSplitter* m_split = nullptr;  ///< panels above, timeline below
  PanelArea* m_panels = nullptr;
  QHBoxLayout* m_sceneRow = nullptr;
  QWidget* m_besideScene = nullptr;
  QMenu* m_panelMenu = nullptr;
  DropHint* m_dropHint = nullptr;
  QTimer m_statusTimer;

  FrameTicker m_ticker;
  std::unique_ptr<Document> m_document;  // after the ticker that reads its session: see the destructor
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
