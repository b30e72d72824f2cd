#include "widgets/annotation/annotation_panel.hpp"

#include <QButtonGroup>
#include <QComboBox>
#include <QCompleter>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "widgets/annotation/annotation_rows.hpp"
#include "widgets/annotation/problem_list.hpp"
#include "widgets/annotation/tier_list.hpp"
#include "widgets/annotation/vocabulary_editor.hpp"
#include "widgets/common/chip.hpp"
#include "widgets/common/flow_row.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/common/value_look.hpp"

namespace abrazo::widgets {
namespace {

constexpr int id_role = Qt::UserRole;

/// Completes a label while it is typed. The completion is marked, so that Delete leaves the shorter text.
class LabelDelegate : public QStyledItemDelegate {
 public:
  LabelDelegate(std::function<QStringList()> values, QObject* parent)
      : QStyledItemDelegate(parent), m_values(std::move(values)) {}
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    if (auto* line = qobject_cast<QLineEdit*>(editor)) {
      auto* completer = new QCompleter(m_values(), line);
      completer->setCompletionMode(QCompleter::InlineCompletion);
      completer->setCaseSensitivity(Qt::CaseInsensitive);
      line->setCompleter(completer);
    }
    return editor;
  }

 private:
  std::function<QStringList()> m_values;
};

}  // namespace

AnnotationPanel::AnnotationPanel(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  // A low panel scrolls: it never takes room from panels above and below.
  auto* all = column_in(this);
  m_scroll = new QScrollArea(this);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setWidgetResizable(true);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inside = new QWidget(m_scroll);
  inside->setObjectName("panel");
  m_scroll->setWidget(inside);
  all->addWidget(m_scroll);
  m_column = column_in(inside, {12, 4, 12, 10}, 8);
  m_column->addWidget(makeSubject());
  m_tiers = new TierList(this);
  m_column->addWidget(m_tiers);
  m_column->addWidget(makeConflict());
  m_column->addWidget(makeLists(), 1);
  connectParts();
}

QWidget* AnnotationPanel::makeSubject() {
  auto* box = new QWidget(this);
  auto* row = row_in(box, {}, 6);
  m_subject = new QComboBox(box);
  m_subject->setAccessibleName("What is annotated");
  m_subject->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_back = chip("Back", "Back to the session", box);  // in full the row is wider than a narrow column
  m_back->setAccessibleName("Back to the session");
  row->addWidget(quiet_label("Annotate", box, 12));
  row->addWidget(m_subject, 1);
  row->addWidget(m_back);
  auto* files = chip("Files ▾", "Export labels for ELAN or as a table; import labels from a file", box);
  files->setAccessibleName("Label files");
  files->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(files);
  menu->addAction("Export labels (EAF, CSV, …)…", this, &AnnotationPanel::exportRequested);
  menu->addAction("Import labels…", this, &AnnotationPanel::importRequested);
  files->setMenu(menu);
  row->addWidget(files);
  return box;
}

QWidget* AnnotationPanel::makeConflict() {
  auto* box = new QWidget(this);
  auto* row = new FlowRow(box, 4);
  row->addWidget(quiet_label("Overlapping labels", box, 12));
  m_conflict = new QComboBox(box);
  const std::tuple<const char*, const char*, Conflict> ways[] = {
      {"trim", "Shortens existing labels; removes those that are covered", Conflict::Replace},
      {"push", "Moves existing labels and keeps their durations", Conflict::Push},
      {"refuse", "Draws nothing over existing labels", Conflict::Refuse}};
  for (const auto& [name, tip, way] : ways) {
    m_conflict->addItem(name, static_cast<int>(way));
    m_conflict->setItemData(m_conflict->count() - 1, tip, Qt::ToolTipRole);
  }
  describe(*m_conflict, "Overlapping labels", "What happens to labels under a new one");
  row->addWidget(m_conflict);
  return box;
}

QWidget* AnnotationPanel::makeLists() {
  auto* box = new QWidget(this);
  auto* column = column_in(box, {}, 6);
  auto* row = new FlowRow(nullptr, 4);
  m_lists = new QButtonGroup(this);
  m_stack = new QStackedWidget(box);
  m_table = new QTableWidget(0, 5, box);
  m_table->setAccessibleName("Labels of the active tier");
  m_table->setHorizontalHeaderLabels({"Start", "End", "Label", "Detail", "Confidence"});
  m_table->setToolTip(
      "A click goes there; a double click edits. Times are seconds: 12.5, 1:05.2, or a frame: 750 f");
  make_rows(*m_table, 24);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setHighlightSections(false);
  for (const auto& [where, px] : {std::pair{Start, 98}, {End, 98}, {Value, 112}, {Detail, 70}})
    m_table->setColumnWidth(where, px);
  m_table->setItemDelegateForColumn(Value, new LabelDelegate([this] { return values(); }, m_table));
  m_table->setMinimumHeight(140);
  m_table->setFrameShape(QFrame::NoFrame);
  m_problems = new ProblemList(box);
  m_vocabulary = new VocabularyEditor(box);
  const std::pair<const char*, QWidget*> lists[] = {
      {"Labels", m_table}, {"Vocabulary", m_vocabulary}, {"Problems", m_problems}};
  for (const auto& [name, list] : lists) {
    QToolButton* each = chip(name, {}, box);
    each->setCheckable(true);
    m_lists->addButton(each, m_stack->addWidget(list));
    row->addWidget(each);
  }
  m_coverage = quiet_label({}, box, 12);
  m_lists->button(0)->setChecked(true);
  column->addLayout(row);
  column->addWidget(m_stack, 1);
  column->addWidget(m_coverage);
  return box;
}

void AnnotationPanel::connectParts() {
  connect(m_subject, QOverload<int>::of(&QComboBox::activated), this,
          [this](int at) { emit subjectRequested(m_subject->itemData(at).toString()); });
  connect(m_back, &QToolButton::clicked, this, [this] { emit subjectRequested({}); });
  connect(m_conflict, qOverload<int>(&QComboBox::activated), this,
          [this] { emit conflictRequested(static_cast<Conflict>(m_conflict->currentData().toInt())); });
  connect(m_lists, &QButtonGroup::idClicked, this, &AnnotationPanel::showList);
  connect(m_tiers, &TierList::tierChosen, this, &AnnotationPanel::tierChosen);
  connect(m_tiers, &TierList::changeRequested, this, &AnnotationPanel::changeRequested);
  connect(m_tiers, &TierList::refused, this, &AnnotationPanel::refused);
  connect(m_tiers, &TierList::visibilityRequested, this, &AnnotationPanel::visibilityRequested);
  connect(m_vocabulary, &VocabularyEditor::changeRequested, this, &AnnotationPanel::changeRequested);
  connect(m_vocabulary, &VocabularyEditor::refused, this, &AnnotationPanel::refused);
  connect(m_problems, &ProblemList::changeRequested, this, &AnnotationPanel::changeRequested);
  connect(m_problems, &ProblemList::refused, this, &AnnotationPanel::refused);
  connect(m_problems, &ProblemList::seekRequested, this, &AnnotationPanel::seekRequested);
  connect(m_problems, &ProblemList::problemChosen, this, [this](int tier, int annotation) {
    emit tierChosen(tier);
    emit annotationChosen(annotation);
  });
  connect(m_table, &QTableWidget::itemChanged, this, &AnnotationPanel::edited);
  connect(m_table, &QTableWidget::itemSelectionChanged, this, &AnnotationPanel::chooseRow);
}

/// In a low panel its top would be all that is seen of it.
void AnnotationPanel::showList(int list) {
  m_stack->setCurrentIndex(list);
  const int bottom = m_stack->mapTo(m_scroll->viewport(), QPoint(0, m_stack->height())).y();
  if (bottom <= m_scroll->viewport()->height()) return;
  const QWidget* box = m_stack->parentWidget();
  m_scroll->verticalScrollBar()->setValue(box->mapTo(m_scroll->widget(), QPoint()).y());
}

void AnnotationPanel::addSection(QWidget* section) {
  m_column->addWidget(section);
}

void AnnotationPanel::setColours(const Palette& palette) {
  m_palette = palette;
  m_tiers->setColours(palette);
  m_vocabulary->setColours(palette);
  fillTable();
}

void AnnotationPanel::showSubjects(const QStringList& subjects, const QStringList& absent,
                                   const QString& shown) {
  QStringList texts = QStringList("the session") + subjects;
  for (const QString& take : absent) texts << take + " (not in the library)";
  const QStringList names = QStringList(QString()) + subjects + absent;
  const int at = std::max(0, static_cast<int>(names.indexOf(shown)));
  if (this->subjects() == texts && m_subject->currentIndex() == at) return;
  m_subject->clear();
  for (int i = 0; i < texts.size(); ++i) m_subject->addItem(texts[i], names[i]);
  m_subject->setCurrentIndex(at);
  m_back->setVisible(at > 0);
}

QStringList AnnotationPanel::subjects() const {
  QStringList listed;
  for (int at = 0; at < m_subject->count(); ++at) listed << m_subject->itemText(at);
  return listed;
}

void AnnotationPanel::show(const Shown& shown) {
  m_shown = shown;
  m_tiers->show(shown.annotations, shown.tier, shown.hidden);
  m_vocabulary->show(shown.annotations, shown.tier);
  m_problems->show(shown.annotations, shown.range, shown.fps);
  m_conflict->setCurrentIndex(m_conflict->findData(static_cast<int>(shown.conflict)));
  const int count = m_problems->count();
  m_lists->button(2)->setText(count == 0 ? QString("Problems") : QString("Problems %1").arg(count));
  const AnnotationTier* tier = shown.annotations.tier(shown.tier);
  m_coverage->setText(tier ? text(tier->name) + ": " + text(coverage_text(*tier, shown.range)) : QString());
  fillTable();
}

void AnnotationPanel::fillTable() {
  m_filling = true;
  const AnnotationTier* tier = m_shown.annotations.tier(m_shown.tier);
  m_table->setRowCount(tier ? static_cast<int>(tier->annotations.size()) : 0);
  m_table->clearSelection();
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const Annotation& each = tier->annotations[static_cast<std::size_t>(row)];
    fillRow(row, *tier, each);
    if (each.id != m_shown.annotation) continue;
    m_table->setCurrentCell(row, Value);
    m_table->scrollToItem(m_table->item(row, Value));
  }
  m_filling = false;
}

void AnnotationPanel::fillRow(int row, const AnnotationTier& tier, const Annotation& annotation) {
  const auto time = [this](double time_s) {
    const std::string frame = frame_text(time_s, m_shown.fps);
    return text(seconds_text(time_s)) + (frame.empty() ? QString() : "  " + text(frame) + " f");
  };
  const auto put = [&](Column where, const QString& words) {
    auto* item = new QTableWidgetItem(words);
    item->setData(id_role, annotation.id);
    m_table->setItem(row, where, item);
    return item;
  };
  put(Start, time(annotation.start_s));
  put(End, time(annotation.end_s));
  QPixmap swatch(10, 14);
  swatch.fill(value_colour(m_palette, tier, annotation.value));
  put(Value, value_words(tier, annotation.value))->setIcon(QIcon(swatch));
  put(Detail, text(annotation.detail));
  put(Confidence, text(annotation.confidence));
}

void AnnotationPanel::chooseRow() {
  if (m_filling || m_table->currentRow() < 0) return;
  const int id = m_table->item(m_table->currentRow(), Value)->data(id_role).toInt();
  const Annotation* chosen = m_shown.annotations.find(id);
  if (!chosen) return;
  const double start_s = chosen->start_s;
  emit annotationChosen(id);
  emit seekRequested(start_s);
}

/// In words: those of the vocabulary, then those that only labels have.
QStringList AnnotationPanel::values() const {
  QStringList words;
  const AnnotationTier* tier = m_shown.annotations.tier(m_shown.tier);
  if (!tier) return words;
  for (const VocabularyEntry& entry : tier->vocabulary) words << value_words(*tier, entry.value);
  for (const Annotation& annotation : tier->annotations) words << value_words(*tier, annotation.value);
  words.removeDuplicates();
  return words;
}

/// The vocabulary's value that is shown in these words; else what was typed.
std::string AnnotationPanel::valueOf(const std::string& typed) const {
  const AnnotationTier* tier = m_shown.annotations.tier(m_shown.tier);
  if (!tier) return typed;
  for (const VocabularyEntry& entry : tier->vocabulary)
    if (value_words(*tier, entry.value) == text(typed)) return entry.value;
  return typed;
}

void AnnotationPanel::edited(QTableWidgetItem* item) {
  if (m_filling) return;
  Annotations next = m_shown.annotations;
  const Annotation* known = next.find(item->data(id_role).toInt());
  if (!known) return;
  const Annotation before = *known;
  const std::string typed = item->text().trimmed().toStdString();
  Status done = Done{};
  if (item->column() == Start || item->column() == End) {
    // The present text has both, seconds first.
    const std::string first = item->text().section("  ", 0, 0).toStdString();
    const auto time_s = typed_time(first, m_shown.fps);
    const bool start = item->column() == Start;
    done = !time_s ? Status(Error{"'" + first +
                                      "' is not a time; write seconds (12.5), minutes (1:05.2) or "
                                      "a frame (750 f)",
                                  ""})
                   : next.place(before.id, start ? *time_s : before.start_s, start ? before.end_s : *time_s,
                                m_shown.conflict, m_shown.range);
  } else {
    TierInterval said = before;
    if (item->column() == Value) said.value = valueOf(typed);
    if (item->column() == Detail) said.detail = typed;
    if (item->column() == Confidence) said.confidence = typed;
    done = next.say(before.id, said);
  }
  if (done) return emit changeRequested(next, "edit " + text(before.value).replace('_', ' '));
  fillTable();
  emit refused(text(done.error().text()));
}

}  // namespace abrazo::widgets
