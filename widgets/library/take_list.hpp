#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_history.hpp"
#include "widgets/common/palette.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace abrazo::widgets {

class TakeDelegate;
class TakeFilter;
class TakeModel;
class TakeView;

/// The library browser: takes with moves, roles and use, for browsing, playing, use as input and exclusion.
/// Decides nothing itself.
class TakeList : public QWidget {
  Q_OBJECT
 public:
  explicit TakeList(QWidget* parent = nullptr);
  /// Also resets the counts of use.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  QSize sizeHint() const override { return {262, 320}; }

  int selectedTake() const;
  bool isPlaying() const { return m_playing.isActive(); }
  TakeModel& model() { return *m_model; }
  TakeView& view() { return *m_view; }
  QString coverageText() const;

 public slots:
  /// The take of the shown frame's source; -1 = none.
  void setCurrentTake(int take) { setSource(take, 0); }
  void setSource(int take, int frame);
  /// Selects a take; -1 = none.
  void setSelectedTake(int take);
  /// Selects a take and marks a frame.
  void showPlace(int take, int frame);
  void setVetoedTakes(const std::set<std::string>& takes);
  /// The take that plays the user and is therefore excluded; empty = none.
  void setUsersTake(const std::string& take);
  /// The belief of the shown frame; does not scroll.
  void setBelief(const abrazo::FrameIntent& intent);
  /// Reads the new frames of the session.
  void refresh(const abrazo::FrameHistory& history);
  /// All frames are others: those of a clip that was solved again.
  void showOtherFrames();
  /// Typical distance of the library's pairs [m]; none = unknown.
  void setTypicalDistance(std::optional<double> distance_m);

  // Apply to the selected take; without one, to the take of the shown frame's source.
  void togglePlay();
  void stop();
  void dance();
  void toggleVeto();
  void goToSource();
  void find();

 signals:
  /// Requests to show a recorded pair; -1 = none.
  /// @param in_motion it continues the previous one as recorded
  void recordedShown(int pair, bool in_motion);
  void danceRequested(int take);
  void vetoRequested(int take);
  void annotateRequested(int take);
  /// Requests to show how the file of a performer was read. @param second  performer B
  void readingRequested(int take, bool second);

 private:
  QWidget* makeHead();
  QWidget* makeFoot();
  void connectParts();
  void look(int take, int frame);
  void lookAway();
  void playOn();
  void showFoot();
  void showMenu(int take, const QPoint& at);
  int wanted() const;

  TakeModel* m_model;
  TakeFilter* m_filter;
  TakeView* m_view;
  TakeDelegate* m_delegate;
  QLineEdit* m_find = nullptr;
  QComboBox* m_order = nullptr;
  QLabel *m_empty = nullptr, *m_coverage = nullptr;
  QToolButton *m_play = nullptr, *m_dance = nullptr, *m_veto = nullptr;
  Palette m_palette;
  std::optional<double> m_typical_m;
  QTimer m_playing;
  QElapsedTimer m_sinceStart;
  int m_playedTake = -1, m_playedFrom = 0, m_shownPair = -1;
};

}  // namespace abrazo::widgets
