#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <array>
#include <vector>

#include "widgets/scene/pick/part_table.hpp"

class QLabel;
class QTableView;
class QToolButton;

namespace abrazo::widgets {

class PartTableModel;

/// Figures of the selected joints, edges or tetrahedra of the shown frame, to be sorted and copied. A row
/// that is chosen requests its part as the selection.
class PartTableView : public QWidget {
  Q_OBJECT
 public:
  explicit PartTableView(QWidget* parent = nullptr);
  void setKind(TableOf kind);
  /// While frames follow each other the table changes twice a second, to be readable.
  /// @param before  the frame before, for velocities; may be null
  void showFrame(const FrameSnapshotPtr& frame, const FrameSnapshotPtr& before);
  /// Whether showFrame() would show this frame now.
  bool isDue(const FrameSnapshotPtr& frame) const;
  /// The rows in the order of the view.
  PartTable shown() const;
  /// The rows with tabs between the columns, as the view has them.
  /// The chosen rows, or all if none is, with the heads.
  QString copied() const;
  QTableView& table() { return *m_table; }

 public slots:
  void showSelection(const abrazo::widgets::Selection& selection);

 signals:
  void selectionRequested(const abrazo::widgets::Selection& selection);
  void csvRequested();

 private:
  void fill();
  void chooseRow();
  std::vector<int> chosenRows() const;

  TableOf m_kind = TableOf::Edges;
  Selection m_selection;
  FrameSnapshotPtr m_frame, m_before;
  QElapsedTimer m_sinceFilled;
  bool m_isFilling = false, m_isChoosing = false;
  PartTableModel* m_model;
  QTableView* m_table;
  QLabel* m_count;
  std::array<QToolButton*, 3> m_kinds{};
};

}  // namespace abrazo::widgets
