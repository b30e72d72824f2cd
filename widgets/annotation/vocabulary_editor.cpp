#include "widgets/annotation/vocabulary_editor.hpp"

#include <QColorDialog>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "widgets/common/chip.hpp"
#include "widgets/common/flow_row.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/common/value_look.hpp"

namespace abrazo::widgets {
namespace {

/// The next digit that no value has yet; 0 when all nine are taken.
char free_key(const std::vector<VocabularyEntry>& vocabulary) {
  for (char key = '1'; key <= '9'; ++key)
    if (std::none_of(vocabulary.begin(), vocabulary.end(),
                     [key](const VocabularyEntry& entry) { return entry.key == key; }))
      return key;
  return 0;
}

}  // namespace

VocabularyEditor::VocabularyEditor(QWidget* parent)
    : QWidget(parent), m_palette(palette_of(Theme::Dark)), m_table(new QTableWidget(0, 4, this)) {
  auto* column = column_in(this, {}, 4);
  m_table->setAccessibleName("Vocabulary");
  m_table->setHorizontalHeaderLabels({"Key", "", "Value", "Description"});
  make_rows(*m_table, 24);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setHighlightSections(false);
  m_table->setColumnWidth(Key, 38);
  m_table->setColumnWidth(Colour, 28);
  m_table->setColumnWidth(Value, 120);
  m_table->setFrameShape(QFrame::NoFrame);
  m_hint = quiet_label({}, this, 11);
  m_hint->setWordWrap(true);
  auto* buttons = new QWidget(this);
  auto* row = new FlowRow(buttons, 4);
  auto* more = chip("+ Value", "Add a value", this);
  m_used = chip("+ Used", "Add the values that labels of this tier have, and the vocabulary has not", this);
  m_remove = chip("Remove", "Remove the value; labels that have it stay", this);
  m_up = chip("↑", "Move the value up", this);
  m_down = chip("↓", "Move the value down", this);
  for (QToolButton* each : {more, m_used, m_remove, m_up, m_down}) row->addWidget(each);
  // Above the table, which is taller than what is seen of a low panel.
  column->addWidget(buttons);
  column->addWidget(m_hint);
  column->addWidget(m_table, 1);
  connect(more, &QToolButton::clicked, this, &VocabularyEditor::add);
  connect(m_used, &QToolButton::clicked, this, &VocabularyEditor::addUsed);
  connect(m_remove, &QToolButton::clicked, this, &VocabularyEditor::remove);
  connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
  connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
  connect(m_table, &QTableWidget::itemChanged, this, &VocabularyEditor::edited);
  connect(m_table, &QTableWidget::cellDoubleClicked, this, [this](int at, int where) {
    if (where == Colour) chooseColour(at);
  });
}

void VocabularyEditor::setColours(const Palette& palette) {
  m_palette = palette;
  fill();
}

void VocabularyEditor::show(const Annotations& annotations, int tier) {
  const AnnotationTier* before = m_annotations.tier(m_tier);
  const AnnotationTier* now = annotations.tier(tier);
  const bool same = before && now && m_tier == tier && before->vocabulary == now->vocabulary;
  m_annotations = annotations;
  m_tier = tier;
  if (!same) fill();
  m_used->setEnabled(!usedOnly().empty());
}

std::vector<std::string> VocabularyEditor::usedOnly() const {
  std::vector<std::string> used;
  const AnnotationTier* tier = m_annotations.tier(m_tier);
  if (!tier) return used;
  for (const Annotation& label : tier->annotations)
    if (!label.value.empty() && std::ranges::find(used, label.value) == used.end() &&
        std::ranges::find(tier->vocabulary, label.value, &VocabularyEntry::value) == tier->vocabulary.end())
      used.push_back(label.value);
  return used;
}

void VocabularyEditor::addUsed() {
  auto entries = vocabulary();
  for (const std::string& value : usedOnly()) {
    VocabularyEntry entry{value};
    entry.key = free_key(entries);
    entries.push_back(std::move(entry));
  }
  settle(std::move(entries), "add the used values");
}

std::vector<VocabularyEntry> VocabularyEditor::vocabulary() const {
  const AnnotationTier* tier = m_annotations.tier(m_tier);
  return tier ? tier->vocabulary : std::vector<VocabularyEntry>();
}

void VocabularyEditor::fill() {
  m_filling = true;
  const int at = m_table->currentRow();
  const AnnotationTier* tier = m_annotations.tier(m_tier);
  const auto entries = vocabulary();
  m_table->setRowCount(static_cast<int>(entries.size()));
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const VocabularyEntry& entry = entries[static_cast<std::size_t>(row)];
    m_table->setItem(row, Key, new QTableWidgetItem(entry.key ? QString(QChar(entry.key)) : QString()));
    auto* colour = new QTableWidgetItem;
    colour->setBackground(value_colour(m_palette, *tier, entry.value));
    colour->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    colour->setToolTip("Double click: another colour");
    m_table->setItem(row, Colour, colour);
    m_table->setItem(row, Value, new QTableWidgetItem(text(entry.value)));
    m_table->setItem(row, Description, new QTableWidgetItem(text(entry.description)));
  }
  if (at >= 0 && at < m_table->rowCount()) m_table->setCurrentCell(at, Value);
  m_hint->setText(!tier ? QString("Choose a tier above")
                  : entries.empty()
                      ? QString("No values: labels of %1 are free text").arg(text(tier->name))
                      : QString("Values of %1; hold a key while playing, or press it").arg(text(tier->name)));
  m_filling = false;
}

/// Beside the table, too: a person who types there does not look at the scene.
void VocabularyEditor::refuse(const QString& why) {
  fill();
  const QString words = "Not changed: " + why;
  m_hint->setText(words);
  emit refused(words);
}

void VocabularyEditor::settle(std::vector<VocabularyEntry> vocabulary, const QString& what) {
  Annotations next = m_annotations;
  const Status done = next.set_vocabulary(m_tier, std::move(vocabulary));
  if (!done) return refuse(text(done.error().message));
  emit changeRequested(next, what);
}

/// Labels with the old value get the new one.
void VocabularyEditor::rename(std::size_t row, const std::string& value) {
  Annotations next = m_annotations;
  auto entries = vocabulary();
  const std::string before = entries[row].value;
  entries[row].value = value;
  const Status done = next.set_vocabulary(m_tier, std::move(entries));
  if (!done) return refuse(text(done.error().message));
  const auto labels = next.tier(m_tier)->annotations;
  for (const Annotation& each : labels)
    if (each.value == before) (void)next.say(each.id, with_value(each, value));
  emit changeRequested(next, "rename value");
}

void VocabularyEditor::edited(QTableWidgetItem* item) {
  if (m_filling) return;
  auto entries = vocabulary();
  const auto row = static_cast<std::size_t>(item->row());
  if (row >= entries.size()) return;
  const QString typed = item->text().trimmed();
  if (item->column() == Value) return rename(row, typed.toStdString());
  if (item->column() == Key) {
    const bool one = typed.isEmpty() || (typed.size() == 1 && typed.at(0).isLetterOrNumber() &&
                                         typed.at(0).unicode() < 128 && typed.at(0) != '0');
    if (!one) return refuse("a key is one digit from 1 to 9 or one letter");
    entries[row].key = typed.isEmpty() ? '\0' : typed.at(0).toLower().toLatin1();
    return settle(std::move(entries), "key of a value");
  }
  if (item->column() == Description) {
    entries[row].description = typed.toStdString();
    settle(std::move(entries), "describe value");
  }
}

void VocabularyEditor::chooseColour(int row) {
  auto entries = vocabulary();
  const AnnotationTier* tier = m_annotations.tier(m_tier);
  VocabularyEntry& entry = entries[static_cast<std::size_t>(row)];
  const QColor chosen = QColorDialog::getColor(value_colour(m_palette, *tier, entry.value), this,
                                               "Colour of " + text(entry.value));
  if (!chosen.isValid()) return;
  entry.rgb = chosen.rgb() & 0xFFFFFFU;
  settle(std::move(entries), "colour of a value");
}

void VocabularyEditor::add() {
  auto entries = vocabulary();
  QString name = "new value";
  for (int n = 2; std::any_of(entries.begin(), entries.end(),
                              [&name](const VocabularyEntry& each) { return text(each.value) == name; });
       ++n)
    name = QString("new value %1").arg(n);
  const char key = free_key(entries);
  entries.push_back({name.toStdString(), {}, {}, key});
  const int row = static_cast<int>(entries.size()) - 1;
  settle(std::move(entries), "add value");
  if (row < m_table->rowCount()) {
    m_table->setCurrentCell(row, Value);
    m_table->editItem(m_table->item(row, Value));
    // A scroll bar that came with the line takes its place only with the next layout.
    QTimer::singleShot(0, m_table, [this] { m_table->scrollTo(m_table->currentIndex()); });
  }
}

void VocabularyEditor::remove() {
  auto entries = vocabulary();
  const int row = m_table->currentRow();
  if (row < 0 || row >= static_cast<int>(entries.size())) return;
  entries.erase(entries.begin() + row);
  settle(std::move(entries), "remove value");
}

void VocabularyEditor::move(int by) {
  auto entries = vocabulary();
  const int row = m_table->currentRow(), to = row + by;
  if (row < 0 || to < 0 || to >= static_cast<int>(entries.size())) return;
  std::swap(entries[static_cast<std::size_t>(row)], entries[static_cast<std::size_t>(to)]);
  m_table->setCurrentCell(to, Value);
  settle(std::move(entries), "move value");
}

}  // namespace abrazo::widgets
