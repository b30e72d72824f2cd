#include "widgets/candidates/candidate_table.hpp"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "core/selection/intent_model.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "widgets/candidates/candidate_header.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/decision_bar.hpp"
#include "widgets/candidates/feature_map.hpp"
#include "widgets/candidates/winning_reason.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/scrolled.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

/// "take salsa_02", "all turn": what a veto of that reach is about.
QString subject(Reach reach, const CandidateRow& row) {
  switch (reach) {
    case Reach::Pair:
      return text(row.take) + " " + QString::number(row.frame);
    case Reach::Take:
      return "take " + text(row.take);
    case Reach::Label:
      return row.label.empty() ? QString("all without a label") : "all " + text(row.label).replace('_', ' ');
  }
  return {};
}

/// The library of a file can be opened together with the session; of another the session knows how it was
/// made.
QString way_to_open(const FrameSnapshot& frame) {
  const AbsentLibrary& library = *frame.absent;
  if (frame.library && frame.library->name() == library.name) return ".";
  if (library.file.empty())
    return ". To see its candidates open the session again, and locate the files of the library.";
  const QString file = QFileInfo(text(library.file)).fileName();
  return QString(
             ". To see its candidates open the session and %1 together: File > Open…, both files at once.")
      .arg(file);
}

constexpr const char* map_tip = "The candidates among all pairs of the library, in feature space";
/// Rows that are always in view, and those that are in view before the map has room.
constexpr int least_candidates = 3, candidates_before_map = 8;

/// The key is a hint: the program's own action has it.
QString with_key(const QString& words, const char* key) {
  return words + "\t" + key;
}

}  // namespace

CandidateTable::CandidateTable(QWidget* parent)
    : QWidget(parent),
      m_header(new SectionHeader("Candidates", this)),
      m_columns(new CandidateHeader(this)),
      m_list(new CandidateList(this)),
      m_scroll(new QScrollArea(this)),
      m_inForce(new DecisionBar(this)),
      m_reason(new QLabel(this)),
      m_belief(new QLabel(this)),
      m_mapButton(new QToolButton(this)),
      m_map(new FeatureMap(this)) {
  arrange();
  connectParts();
  setColours(palette_of(Theme::Dark));
}

void CandidateTable::arrange() {
  auto* column = column_in(this, {}, 0);
  scroll_vertically(*m_scroll, m_list);
  m_scroll->setFocusPolicy(Qt::NoFocus);
  keepRows();
  column->addWidget(m_header);
  column->addWidget(m_columns);
  column->addWidget(m_scroll, 8);
  column->addWidget(m_inForce);
  column->addWidget(makeFoot());
  column->addWidget(m_map, 1);
  setFocusProxy(m_list);
}

QWidget* CandidateTable::makeFoot() {
  auto* foot = new QWidget(this);
  m_foot = new QGridLayout(foot);
  m_foot->setContentsMargins(12, 2, 12, 4);
  m_foot->setVerticalSpacing(0);
  m_reason->setObjectName("secondary");
  m_reason->setFont(interface_font(12));
  m_reason->setTextFormat(Qt::PlainText);  // names of libraries are what people typed
  m_reason->setWordWrap(true);
  m_reason->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
  m_mapButton->setObjectName("chip");
  m_mapButton->setText("Map");
  m_mapButton->setFont(interface_font(11));
  m_mapButton->setCheckable(true);
  m_mapButton->setChecked(true);
  m_mapButton->setFocusPolicy(Qt::TabFocus);
  describe(*m_mapButton, "Show the feature-space neighbourhood", map_tip);
  m_belief->setObjectName("secondary");
  m_belief->setFont(interface_font(12));
  m_belief->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // elided, not a reason to be wider
  m_belief->setTextFormat(Qt::PlainText);                             // labels are what people typed
  m_belief->hide();
  m_foot->addWidget(m_reason, 0, 0);
  m_foot->addWidget(m_mapButton, 0, 1, Qt::AlignTop);
  m_foot->addWidget(m_belief, 1, 0);
  m_foot->setColumnStretch(0, 1);
  return foot;
}

void CandidateTable::connectParts() {
  connect(m_list, &CandidateList::candidateHovered, m_map, &FeatureMap::setLinked);
  connect(m_map, &FeatureMap::candidateHovered, m_list, &CandidateList::setLinked);
  connect(m_list, &CandidateList::candidateHovered, this, &CandidateTable::candidateHovered);
  connect(m_map, &FeatureMap::candidateHovered, this, &CandidateTable::candidateHovered);
  connect(m_list, &CandidateList::jumpAsked, this, &CandidateTable::askJump);
  connect(m_list, &CandidateList::jumpToChosenAsked, this, &CandidateTable::jump);
  connect(m_list, &CandidateList::pinClicked, this, &CandidateTable::askPin);
  connect(m_list, &CandidateList::menuAsked, this, &CandidateTable::showMenu);
  connect(m_list, &CandidateList::currentChanged, this, [this](int row) {
    constexpr int height = CandidateList::row_height;
    if (row >= 0) m_scroll->ensureVisible(0, row * height + height / 2, 0, height / 2 + 1);
  });
  connect(m_list, &CandidateList::pairChosen, this, [this](int pair) {
    emit selectionRequested(pair >= 0 ? Selection::candidate(pair) : Selection{});
  });
  connect(m_map, &FeatureMap::candidateClicked, this, [this](int candidate) {
    for (const CandidateRow& row : m_ranked)
      if (row.candidate == candidate) return emit selectionRequested(Selection::candidate(row.pair));
  });
  connect(m_map, &FeatureMap::candidateChosen, this, [this](int candidate) {
    for (const CandidateRow& row : m_ranked)
      if (row.candidate == candidate) return askJump(row);
  });
  connect(m_columns, &CandidateHeader::columnClicked, this, &CandidateTable::sortBy);
  connect(m_inForce, &DecisionBar::lifted, this, [this](const Decision& decision) {
    emit decisionsRequested(decision.without, (decision.kind == Decision::Kind::Pin     ? "let go of "
                                               : decision.kind == Decision::Kind::Meant ? "take back "
                                                                                        : "remove veto of ") +
                                                  text(decision.text));
  });
  connect(m_mapButton, &QToolButton::toggled, this, &CandidateTable::showMap);
}

void CandidateTable::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  m_library = std::move(library);
  m_frame.reset();
  m_ranked.clear();
  m_list->setRows({});
  m_list->setNotice(CandidateList::nothing_yet);
  m_map->setLibrary(m_library);
  m_reason->clear();
  showDecisions(m_decisions);
}

void CandidateTable::setColours(const Palette& palette) {
  m_palette = palette;
  m_header->setColours(palette);
  m_columns->setColours(palette);
  m_list->setColours(palette);
  m_inForce->setColours(palette);
  m_map->setColours(palette);
}

void CandidateTable::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showBelief();
  keepRows();
  arrangeMap();
}

/// Decisions in force take their room from the list, so that the panel needs no more because of them.
void CandidateTable::keepRows() {
  constexpr int row = CandidateList::row_height;
  const int decisions = m_inForce->isVisibleTo(this) ? m_inForce->minimumHeight() : 0;
  m_scroll->setMinimumHeight(std::max(row, least_candidates * row - decisions));
}

/// Without the map: it leaves before the rest is squeezed.
QSize CandidateTable::minimumSizeHint() const {
  QSize least = QWidget::minimumSizeHint();
  if (m_map->isVisibleTo(this)) least.rheight() -= m_map->minimumHeight();
  return least;
}

void CandidateTable::arrangeMap() {
  const int more_rows = (candidates_before_map - least_candidates) * CandidateList::row_height;
  const bool has_room = height() >= minimumSizeHint().height() + more_rows + m_map->minimumHeight();
  m_mapButton->setEnabled(has_room);
  m_mapButton->setToolTip(map_tip + QString(has_room ? "" : "; it needs a taller panel"));
  const bool shows = has_room && m_mapButton->isChecked();
  if (shows == m_map->isVisibleTo(this)) return;
  m_map->setVisible(shows);
  if (shows && m_frame) m_map->setFrame(*m_frame, m_ranked);
}

/// The height is independent of the text, which differs in every frame. The map's button is beside the belief
/// if there is one, because reasons by intent are longer.
void CandidateTable::arrangeFoot(bool has_belief) {
  constexpr int one_line = 24, two_lines = 34, margins = 32;
  const int longest = m_reason->fontMetrics().horizontalAdvance(
      "Continues: #2 costs 0.000 m more, because of the 0.000 m for leaving the shown partner");
  m_reason->setFixedHeight(width() < longest + margins ? two_lines : one_line);
  if (has_belief == m_belief->isVisibleTo(this)) return;
  m_foot->addWidget(m_reason, 0, 0, 1, has_belief ? 2 : 1);
  m_foot->addWidget(m_mapButton, has_belief ? 1 : 0, 1, Qt::AlignTop);
  m_belief->setVisible(has_belief);
}

void CandidateTable::showMethod(SelectionMethod method) {
  if (method == m_method) return;
  m_method = method;
  m_columns->setMethod(method);
}

void CandidateTable::showBelief() {
  const bool is_learning = m_frame && m_frame->is_learning;
  m_beliefWords.clear();
  if (is_learning)
    m_beliefWords = "Learning the library; Eq. 7 selects meanwhile";
  else if (m_frame && m_frame->result.intent.model)
    m_beliefWords = text(likely_moves(m_frame->result.intent.model->labels(), m_frame->result.intent.moves));
  arrangeFoot(is_learning || m_method == SelectionMethod::Intent);
  const int room = width() - 36 - m_mapButton->sizeHint().width();
  m_belief->setText(QFontMetrics(m_belief->font()).elidedText(m_beliefWords, Qt::ElideRight, room));
  m_belief->setToolTip(m_beliefWords == m_belief->text() ? QString() : plain_tip(m_beliefWords));
}

const std::vector<CandidateRow>& CandidateTable::rows() const {
  return m_list->rows();
}
QString CandidateTable::reason() const {
  return m_reason->text();
}

void CandidateTable::showFrame(const FrameSnapshotPtr& frame) {
  if (!frame || !m_library) return;
  m_frame = frame;
  m_ranked = candidate_rows(*frame, *m_library);
  showMethod(deciding_method(frame->result).value_or(m_method));
  const QString absence = text(absence_text(*frame));
  m_list->setNotice(frame->absent ? absence + way_to_open(*frame) : "Nothing selected in this frame");
  showRows();
  m_reason->setText(!frame->absent     ? text(winning_reason(m_ranked, frame->result.intent))
                    : m_ranked.empty() ? ""  // the list says it
                                       : absence);
  showBelief();
}

void CandidateTable::mark(CandidateRow& row) const {
  row.pinned = m_decisions.pinned == row.pair;
  row.vetoed = is_vetoed(m_decisions, row.pair, *m_library);
  row.not_meant = is_not_intended(m_decisions, row.pair, *m_library);
}

void CandidateTable::showRows() {
  for (CandidateRow& row : m_ranked) mark(row);
  if (m_frame && m_map->isVisible()) m_map->setFrame(*m_frame, m_ranked);
  const CandidateOrder order = order_within(m_order, m_method);
  m_columns->setOrder(order);
  std::vector<CandidateRow> shown = m_ranked;
  sort_rows(shown, order);
  m_list->setRows(std::move(shown), order.column);
  keepSelectedRow();
}

void CandidateTable::showDecisions(const Decisions& decisions) {
  m_decisions = decisions;
  m_inForce->setDecisions(m_library ? decisions_in_force(decisions, *m_library) : std::vector<Decision>{});
  keepRows();
  showRows();
}

void CandidateTable::showPath(const FrameHistory& history, double until_s) {
  if (m_map->isVisible()) m_map->setPath(history, until_s);
}

void CandidateTable::sortBy(CandidateColumn column) {
  m_order = order_after_click(order_within(m_order, m_method), column);
  showRows();
}

void CandidateTable::showMap(bool on) {
  m_mapButton->setChecked(on);
  arrangeMap();
  showRows();
}

void CandidateTable::showSelection(const Selection& selection) {
  m_selection = selection;
  const int pair = selection.kind == SelectionKind::Candidate ? selection.pair : -1;
  if (!m_selectedRow || m_selectedRow->pair != pair) m_selectedRow.reset();
  m_list->setCurrentPair(pair);
  keepSelectedRow();
  m_map->setCurrentPair(pair);
}

void CandidateTable::keepSelectedRow() {
  if (m_selection.kind != SelectionKind::Candidate) return m_selectedRow.reset();
  if (const CandidateRow* current = m_list->current()) m_selectedRow = *current;
}

void CandidateTable::pointAt(int candidate) {
  m_list->setLinked(candidate);
  m_map->setLinked(candidate);
}

const CandidateRow* CandidateTable::chosen() const {
  if (const CandidateRow* current = m_list->current()) return current;
  if (m_selectedRow) return &*m_selectedRow;  // selected, though it is no candidate of this frame
  const auto winner =
      std::find_if(rows().begin(), rows().end(), [](const CandidateRow& row) { return row.selected; });
  return winner != rows().end() ? &*winner : nullptr;
}

void CandidateTable::askPin(const CandidateRow& row) {
  const bool lets_go = m_decisions.pinned == row.pair;
  emit decisionsRequested(with_pin_toggled(m_decisions, row.pair),
                          (lets_go ? "let go of " : "use ") + subject(Reach::Pair, row));
}

void CandidateTable::askVeto(Reach reach, const CandidateRow& row) {
  const bool lifts = is_vetoed(m_decisions, reach, row.pair, *m_library);
  emit decisionsRequested(with_veto_toggled(m_decisions, reach, row.pair, *m_library),
                          (lifts ? "remove veto of " : "veto ") + subject(reach, row));
}

void CandidateTable::askJump(const CandidateRow& row) {
  emit jumpRequested(row.take_index, row.frame);
}

void CandidateTable::togglePin() {
  if (const CandidateRow* row = chosen()) return askPin(CandidateRow(*row));
  if (m_decisions.pinned) {  // a frame without candidates must not keep the pin in force
    Decisions next = m_decisions;
    next.pinned.reset();
    emit decisionsRequested(next, "unpin the pair");
  }
}

void CandidateTable::toggleVeto(Reach reach) {
  if (const CandidateRow* row = chosen()) askVeto(reach, CandidateRow(*row));
}

void CandidateTable::jump() {
  if (const CandidateRow* row = chosen()) askJump(CandidateRow(*row));
}

void CandidateTable::liftAll() {
  if (!is_neutral(m_decisions)) emit decisionsRequested({}, "clear pin and vetoes");
}

void CandidateTable::addSorting(QMenu& menu) {
  QMenu* sorting = menu.addMenu("Sort by");
  for (const CandidateColumn column : candidate_columns(m_method)) {
    QAction* action = sorting->addAction(text(column_title(column)));
    action->setCheckable(true);
    action->setChecked(column == order_within(m_order, m_method).column);
    connect(action, &QAction::triggered, this, [this, column] { sortBy(column); });
  }
}

void CandidateTable::showMenu(const CandidateRow& row, const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const bool pinned = m_decisions.pinned == row.pair;
  const auto add = [&](const QString& words, const char* key, auto act) {
    connect(menu->addAction(with_key(words, key)), &QAction::triggered, this, std::move(act));
  };
  add(pinned ? "Unpin this one" : "Use this one", "P", [this, row] { askPin(row); });
  menu->addSeparator();
  const auto veto = [&](Reach reach, const char* key) {
    const bool vetoed = is_vetoed(m_decisions, reach, row.pair, *m_library);
    add((vetoed ? "Remove veto of " : "Veto ") + subject(reach, row), key,
        [this, row, reach] { askVeto(reach, row); });
  };
  veto(Reach::Pair, "V");
  veto(Reach::Take, "Shift+V");
  veto(Reach::Label, "Alt+V");
  menu->addSeparator();
  add("Go to its take and frame", "Return", [this, row] { askJump(row); });
  addSorting(*menu);
  if (!is_neutral(m_decisions)) {
    menu->addSeparator();
    add("Clear pin and vetoes", "Shift+P", [this] { liftAll(); });
  }
  menu->popup(at);
}

}  // namespace abrazo::widgets
