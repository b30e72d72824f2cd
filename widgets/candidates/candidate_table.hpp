#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "core/session/frame_snapshot.hpp"
#include "widgets/candidates/candidate_rows.hpp"
#include "widgets/common/palette.hpp"

class QLabel;
class QScrollArea;

namespace abrazo::widgets {

class CandidateList;
class SectionHeader;

/// The k pairs that were considered for the shown frame, cheapest first, and why the winner won.
class CandidateTable : public QWidget {
  Q_OBJECT
 public:
  explicit CandidateTable(QWidget* parent = nullptr);
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  const std::vector<CandidateRow>& rows() const;
  QString reason() const;

 public slots:
  void showFrame(const abrazo::FrameSnapshotPtr& frame);

 signals:
  /// Index into the frame's candidates; -1 when the pointer left.
  void candidateHovered(int candidate);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  SectionHeader* m_header;
  CandidateList* m_list;
  QLabel* m_reason;
  std::shared_ptr<const MotionLibrary> m_library;
};

}  // namespace abrazo::widgets
