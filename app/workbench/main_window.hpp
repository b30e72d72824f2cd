#pragma once

#include <QMainWindow>
#include <QUndoStack>
#include <memory>

#include "app/workbench/frame_ticker.hpp"
#include "app/workbench/live_session.hpp"
#include "app/workbench/panel_plan.hpp"
#include "app/workbench/user_settings.hpp"
#include "widgets/common/palette.hpp"

class QDockWidget;
class QMenu;

namespace abrazo::widgets {
class CandidateTable;
class MessageBar;
class PlotPanel;
class SceneTree;
class SceneView;
class SectionHeader;
class SettingsPanel;
class TakeList;
class TimelineView;
class TransportBar;
}  // namespace abrazo::widgets

namespace abrazo::app {

class Job;
class StatusFigures;

/// Where the parts stand and how they are wired. Every user action lives in a file of its own under actions/.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(UserSettings& remembered);
  ~MainWindow() override;

  /// Runs on a worker and then replaces the session. @param make  called off this thread
  using MakeMaterial = std::function<Result<Material>(const Progress&)>;
  void openMaterial(MakeMaterial make);
  void openFiles(const QStringList& files);
  void openDemo();
  void startWith(const Settings& settings);

  void setTheme(widgets::Theme theme);
  const widgets::Palette& colours() const { return *m_palette; }
  QMenu* menu(const QString& title);
  /// Shows or hides the panel at the left or right, whatever the size of the window.
  void showLeft(bool on);
  void showRight(bool on);

  FrameTicker& ticker() { return m_ticker; }
  QUndoStack& undoStack() { return m_undo; }
  UserSettings& remembered() { return m_remembered; }
  LiveSession* session() { return m_session.get(); }
  widgets::SceneView& scene() { return *m_scene; }
  widgets::SettingsPanel& settings() { return *m_settings; }
  widgets::CandidateTable& candidates() { return *m_candidates; }
  widgets::TakeList& takes() { return *m_takes; }
  widgets::PlotPanel& plots() { return *m_plots; }
  widgets::TimelineView& timeline() { return *m_timeline; }
  widgets::TransportBar& transport() { return *m_transport; }
  widgets::MessageBar& messages() { return *m_messages; }

 signals:
  void sessionStarted();
  void failed(const QString& message);
  void panelsArranged(const abrazo::app::PanelPlan& plan);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeCentre();
  QWidget* makeLeft();
  QWidget* makeRight();
  QWidget* makeBottom();
  QDockWidget* dock(Qt::DockWidgetArea area, QWidget* content, const QString& name);
  void arrangePanels();
  void wireViews();
  void wireTransport();
  void showPanels();
  void start(const std::shared_ptr<PreparedSolver>& prepared);
  void showFailure(const QString& message);

  UserSettings& m_remembered;
  const widgets::Palette* m_palette;
  QUndoStack m_undo;

  widgets::SceneView* m_scene = nullptr;
  widgets::PlotPanel* m_plots = nullptr;
  widgets::MessageBar* m_messages = nullptr;
  widgets::SceneTree* m_tree = nullptr;
  widgets::SectionHeader *m_sceneHead = nullptr, *m_libraryHead = nullptr;
  widgets::TakeList* m_takes = nullptr;
  widgets::CandidateTable* m_candidates = nullptr;
  widgets::SettingsPanel* m_settings = nullptr;
  widgets::TransportBar* m_transport = nullptr;
  widgets::TimelineView* m_timeline = nullptr;
  StatusFigures* m_status = nullptr;
  QDockWidget *m_left = nullptr, *m_right = nullptr;
  PanelWishes m_wishes;
  QTimer m_statusTimer;

  FrameTicker m_ticker;
  std::unique_ptr<LiveSession> m_session;  // after the ticker that reads it: see the destructor
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
