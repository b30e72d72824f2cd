#include "widgets/candidates/candidate_table.hpp"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "widgets/candidates/candidate_list.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

CandidateTable::CandidateTable(QWidget* parent)
    : QWidget(parent),
      m_header(new SectionHeader("Candidates", this)),
      m_list(new CandidateList(this)),
      m_reason(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(m_list);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->viewport()->setAutoFillBackground(false);
  m_list->setAutoFillBackground(false);
  scroll->setMinimumHeight(4 * CandidateList::row_height);
  m_reason->setObjectName("secondary");
  m_reason->setFont(interface_font(12));
  m_reason->setContentsMargins(12, 4, 12, 8);
  m_reason->setWordWrap(true);
  m_reason->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  column->addWidget(m_header);
  column->addWidget(scroll, 1);
  column->addWidget(m_reason);
  connect(m_list, &CandidateList::candidateHovered, this, &CandidateTable::candidateHovered);
  setColours(palette_of(Theme::Dark));
}

void CandidateTable::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  m_library = std::move(library);
  m_list->setRows({});
  m_reason->clear();
}

void CandidateTable::setColours(const Palette& palette) {
  m_header->setColours(palette);
  m_header->setKeys(
      {{"pose", palette.user}, {"temporal leader", palette.active, "leader"}, {"follower", palette.passive}});
  m_list->setColours(palette);
}

void CandidateTable::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr int one_line = 30, two_lines = 46, narrow = 370;
  m_reason->setFixedHeight(width() < narrow ? two_lines : one_line);
}

const std::vector<CandidateRow>& CandidateTable::rows() const {
  return m_list->rows();
}
QString CandidateTable::reason() const {
  return m_reason->text();
}

void CandidateTable::showFrame(const FrameSnapshotPtr& frame) {
  if (!frame || !m_library) return;
  auto rows = candidate_rows(*frame, *m_library);
  m_reason->setText(QString::fromStdString(winning_reason(rows)));
  m_list->setRows(std::move(rows));
}

}  // namespace abrazo::widgets
