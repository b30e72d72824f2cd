#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/frames/decision_edits.hpp"
#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/candidates/candidate_order.hpp"
#include "widgets/candidates/candidate_rows.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/selection_model.hpp"

class QGridLayout;
class QLabel;
class QMenu;
class QScrollArea;
class QToolButton;

namespace abrazo::widgets {

class CandidateHeader;
class CandidateList;
class DecisionBar;
class FeatureMap;
class SectionHeader;

/// The k candidates of the shown frame, the reason of the winner, and the user's decisions about them.
/// Decides nothing itself: it requests new decisions as a whole value.
class CandidateTable : public QWidget {
  Q_OBJECT
 public:
  explicit CandidateTable(QWidget* parent = nullptr);
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  /// In display order.
  const std::vector<CandidateRow>& rows() const;
  QString reason() const;
  /// The line below: the likely move, or that the model is still learning.
  const QString& belief() const { return m_beliefWords; }
  /// The requested order. A column that the shown frame's method does not have applies when its method
  /// returns.
  const CandidateOrder& order() const { return m_order; }

  QSize minimumSizeHint() const override;

 public slots:
  void showFrame(const abrazo::FrameSnapshotPtr& frame);
  void showDecisions(const abrazo::Decisions& decisions);
  /// Shows the user's path up to a time in the feature map.
  void showPath(const abrazo::FrameHistory& history, double until_s);
  void sortBy(abrazo::widgets::CandidateColumn column);
  /// Shows the map where there is room below the candidates.
  void showMap(bool on);
  void showSelection(const abrazo::widgets::Selection& selection);
  /// Marks a candidate hovered in another view, index into the frame's; -1 = none.
  void pointAt(int candidate);

  // Apply to the current row; without one, to the winner.
  void togglePin();
  void toggleVeto(abrazo::Reach reach);
  void jump();
  void liftAll();

 signals:
  /// Index into the frame's candidates; -1 = the pointer left.
  void candidateHovered(int candidate);
  /// @param what text for the undo list
  void decisionsRequested(const abrazo::Decisions& next, const QString& what);
  void selectionRequested(const abrazo::widgets::Selection& selection);
  /// A frame of a take of the library.
  void jumpRequested(int take, int frame);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  void connectParts();
  QWidget* makeFoot();
  void showRows();
  void keepRows();
  void arrangeMap();
  void showMethod(SelectionMethod method);
  void showBelief();
  void arrangeFoot(bool has_belief);
  void keepSelectedRow();
  void mark(CandidateRow& row) const;
  const CandidateRow* chosen() const;
  void askPin(const CandidateRow& row);
  void askVeto(Reach reach, const CandidateRow& row);
  void askJump(const CandidateRow& row);
  void showMenu(const CandidateRow& row, const QPoint& at);
  void addSorting(QMenu& menu);

  Selection m_selection;
  std::optional<CandidateRow> m_selectedRow;  ///< its last state as a candidate
  SectionHeader* m_header;
  CandidateHeader* m_columns;
  CandidateList* m_list;
  QScrollArea* m_scroll;
  DecisionBar* m_inForce;
  QLabel* m_reason;
  QLabel* m_belief;
  QToolButton* m_mapButton;
  QGridLayout* m_foot = nullptr;  ///< reason, belief and the map's button
  FeatureMap* m_map;
  std::shared_ptr<const MotionLibrary> m_library;
  FrameSnapshotPtr m_frame;
  std::vector<CandidateRow> m_ranked;  ///< of the shown frame, cheapest first
  Decisions m_decisions;
  CandidateOrder m_order;
  SelectionMethod m_method = SelectionMethod::Paper;  ///< deciding method of the shown frame
  QString m_beliefWords;
  Palette m_palette;
};

}  // namespace abrazo::widgets
