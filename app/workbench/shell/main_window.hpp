#pragma once

#include <QMainWindow>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/document/document.hpp"
#include "app/workbench/shell/frame_ticker.hpp"
#include "app/workbench/shell/window_layout.hpp"
#include "core/opening/open_files.hpp"
#include "widgets/common/palette.hpp"

class QDockWidget;
class QHBoxLayout;
class QMenu;

namespace abrazo::widgets {
class CandidateTable;
class MessageBar;
class NoticeColumn;
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
class WorkSplit;

/// Layout and wiring of the parts. Every user action is in the `_actions.cpp` of its feature.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(UserSettings& remembered);
  ~MainWindow() override;

  /// Runs on a worker and then replaces the session. @param make called on the worker
  using MakeMaterial = std::function<Result<Material>(const Progress&)>;
  /// When the user is asked about work that the present session would lose. Saving changes a session file, so
  /// for one it is before reading. Other files are read first: of one that cannot be opened, or has a
  /// question of its own, nothing is lost yet.
  enum class AsksToLeave { BeforeReading, BeforeStart, Asked };
  /// Asks whether the present session may end. @return false if it stays, or something else is opened or
  /// closed meanwhile
  bool isLeft();
  /// @param files source files, for the list of recent files
  /// @return false if the present session stays, because the user was asked at once
  bool openMaterial(MakeMaterial make, const QStringList& files = {},
                    AsksToLeave asks = AsksToLeave::BeforeReading);
  /// @param said  how to read their motion; none = by the rule for similar files, otherwise as found
  void openFiles(const QStringList& files, const std::optional<MotionReading>& said = std::nullopt);
  void openDemo();
  /// Whether clips are played in a loop in real time, as if they were performed, in sessions that begin from
  /// now on.
  void setPlaysAsLive(bool on) { m_playsAsLive = on; }
  bool playsAsLive() const { return m_playsAsLive; }
  /// Whether a stream is wanted: sessions that begin are its own, unless the user asks for a clip.
  void setWantsStream(bool on) { m_wantsStream = on; }
  /// The question about missing data of a session; empty: it is not asked.
  void setLocateMissing(LocateMissing ask) { m_locate = std::move(ask); }
  /// Adds the files to the recent ones.
  void noteOpened(const QStringList& files) { emit filesOpened(files); }
  /// Requests to show a take of the library, or the session ("").
  void requestSubject(const QString& subject) { emit subjectRequested(subject); }
  /// Shows an error, and reports it to an unattended run.
  void fail(const QString& message);

  void setTheme(widgets::Theme theme);
  const widgets::Palette& colours() const { return *m_palette; }
  /// Gives a widget the colours, now and with every change.
  template <typename Widget>
  void colour(Widget* widget) {
    widget->setColours(*m_palette);
    connect(this, &MainWindow::coloursChanged, widget, &Widget::setColours);
  }

  /// A panel beside or below the scene, with an entry under View > Panels. Adds it hidden unless `shown`;
  /// `colour` gives the content its colours.
  /// @param id stable id in saved layouts
  /// @param content its SectionHeader of this title, if a direct child, becomes the panel's header
  QDockWidget* addPanel(const QString& id, const QString& title, QWidget* content, Qt::DockWidgetArea area,
                        bool shown);
  PanelArea& panels() const { return *m_panels; }
  QMenu& panelMenu() { return *m_panelMenu; }
  /// Shows or hides the panels at one side, regardless of the window's size.
  void showLeft(bool on);
  void showRight(bool on);

  /// A bar over the scene, below its buttons.
  void addBelowMessages(QWidget* bar);
  /// One with buttons, which messages that come or go do not move.
  void addAboveMessages(QWidget* bar);
  /// Left of the scene.
  void addBesideScene(QWidget* page);
  QWidget* besideScene() const { return m_besideScene; }  ///< may be null
  WindowLayout layoutOfPanels() const;
  bool setLayoutOfPanels(const WindowLayout& layout);
  void resetLayout();
  /// For all lanes of the timeline, up to half of the window.
  void makeRoomForLanes();

  FrameTicker& ticker() { return m_ticker; }
  /// The document; views listen to it.
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
  void coloursChanged(const abrazo::widgets::Palette& palette);
  void failed(const QString& message);
  /// More than one motion was opened, so the user must choose their use. May include videos.
  void motionsOffered(const QStringList& files);
  /// No joint map fits this motion, so the user must assign joints.
  void mappingOffered(const QStringList& files, const std::shared_ptr<const abrazo::NamedMotion>& motion);
  /// The motion among these files is ambiguous: the user must confirm or change how it is read.
  void importOffered(const QStringList& files);
  void subjectRequested(const QString& subject);
  /// Label files for the shown subject.
  void labelsOffered(const QStringList& files);
  /// Reference videos were opened, perhaps with other files.
  void videosOffered(const QStringList& files);
  void filesOpened(const QStringList& files);
  /// The session is about to end, for another one or with the window. Receivers may refuse.
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
  void start(PreparedSolver prepared);
  InputUse useOf(const Material& material) const;
  void endSession();

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
  WorkSplit* m_split = nullptr;
  PanelArea* m_panels = nullptr;
  widgets::NoticeColumn* m_notices = nullptr;
  QHBoxLayout* m_sceneRow = nullptr;
  QWidget* m_besideScene = nullptr;
  QMenu* m_panelMenu = nullptr;
  DropHint* m_dropHint = nullptr;
  QTimer m_statusTimer;
  bool m_playsAsLive = false, m_wantsStream = false;
  bool m_isStopping = false;  ///< closes as soon as no work runs

  FrameTicker m_ticker;
  std::unique_ptr<Document> m_document;  // declared after the ticker that reads its session: see the
                                         // destructor
  LocateMissing m_locate;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
