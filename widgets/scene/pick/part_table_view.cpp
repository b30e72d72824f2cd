#include "widgets/scene/pick/part_table_view.hpp"

#include <QApplication>
#include <QButtonGroup>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/common/plain_text.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int live_fill_ms = 500;
constexpr int row_role = Qt::UserRole, number_role = Qt::UserRole + 1;

/// As many as can be read; Copy has the same, the file all.
int decimals_of(const QString& column) {
  return column.contains("[mm]") || column.contains("[%]") ? 2 : 4;
}

/// Sorted by its number; what is none comes first.
class NumberItem : public QTableWidgetItem {
 public:
  NumberItem(double value, int decimals)
      : QTableWidgetItem(std::isfinite(value) ? QString::number(value, 'f', decimals) : QString("–")) {
    setData(number_role, std::isfinite(value) ? value : -1e300);
    setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  bool operator<(const QTableWidgetItem& other) const override {
    return data(number_role).toDouble() < other.data(number_role).toDouble();
  }
};

}  // namespace

PartTableView::PartTableView(QWidget* parent)
    : QWidget(parent), m_table(new QTableWidget(this)), m_count(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  auto* head = new QHBoxLayout;
  auto* kinds = new QButtonGroup(this);
  for (const auto& [kind, name] : {std::pair{TableOf::Joints, "Joints"},
                                   {TableOf::Edges, "Edges"},
                                   {TableOf::Tetrahedra, "Tetrahedra"}}) {
    auto* button = new QToolButton(this);
    button->setObjectName("chip");
    button->setText(name);
    button->setCheckable(true);
    button->setChecked(kind == m_kind);
    kinds->addButton(button);
    connect(button, &QToolButton::clicked, this, [this, kind = kind] { setKind(kind); });
    m_kinds[static_cast<std::size_t>(kind)] = button;
    head->addWidget(button);
  }
  m_count->setObjectName("secondary");
  head->addWidget(m_count, 1);
  column->addLayout(head);
  m_table->setAccessibleName("Figures of the selection");
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::SingleSelection);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(22);
  m_table->setTabKeyNavigation(false);
  column->addWidget(m_table, 1);
  auto* foot = new QHBoxLayout;
  auto* copy = new QPushButton("Copy", this);
  auto* csv = new QPushButton("CSV…", this);
  copy->setToolTip("The rows as text with tabs, in the order shown (Ctrl+C)");
  for (QPushButton* button : {copy, csv}) button->setAutoDefault(false);
  foot->addStretch(1);
  foot->addWidget(copy);
  foot->addWidget(csv);
  column->addLayout(foot);
  const auto to_clipboard = [this] { QApplication::clipboard()->setText(copied()); };
  connect(copy, &QPushButton::clicked, this, to_clipboard);
  auto* key = new QShortcut(QKeySequence::Copy, this);
  key->setContext(Qt::WidgetWithChildrenShortcut);
  connect(key, &QShortcut::activated, this, to_clipboard);
  connect(csv, &QPushButton::clicked, this, &PartTableView::csvRequested);
  connect(m_table, &QTableWidget::itemSelectionChanged, this, &PartTableView::chooseRow);
}

void PartTableView::setKind(TableOf kind) {
  m_kind = kind;
  m_kinds[static_cast<std::size_t>(kind)]->setChecked(true);
  fill();
}

void PartTableView::showFrame(const FrameSnapshotPtr& frame, const FrameSnapshotPtr& before) {
  if (frame == m_frame) return;
  const bool is_soon = m_frame && m_sinceFilled.isValid() && m_sinceFilled.elapsed() < live_fill_ms;
  const bool follows = m_frame && frame && frame->time_s > m_frame->time_s;
  if (is_soon && follows) return;
  m_frame = frame;
  m_before = before;
  fill();
}

void PartTableView::showSelection(const Selection& selection) {
  // A row of this table was chosen: the others stay, to go on from it.
  if (m_isChoosing) return;
  m_selection = selection;
  fill();
}

void PartTableView::fill() {
  if (!m_frame) return;
  m_isFilling = true;
  m_rows = part_table(*m_frame, m_before.get(), m_kind, m_selection);
  const bool is_other_table = m_table->columnCount() != static_cast<int>(m_rows.columns.size()) + 1;
  m_table->setSortingEnabled(false);
  m_table->setRowCount(static_cast<int>(m_rows.rows.size()));
  m_table->setColumnCount(static_cast<int>(m_rows.columns.size()) + 1);
  QStringList names = {"part"};
  for (const std::string& name : m_rows.columns) names << text(name);
  m_table->setHorizontalHeaderLabels(names);
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const PartTable::Row& figures = m_rows.rows[static_cast<std::size_t>(row)];
    auto* name = new QTableWidgetItem(text(figures.name));
    name->setData(row_role, row);
    m_table->setItem(row, 0, name);
    for (int column = 1; column < m_table->columnCount(); ++column)
      m_table->setItem(
          row, column,
          new NumberItem(figures.values[static_cast<std::size_t>(column) - 1], decimals_of(names[column])));
  }
  m_table->setSortingEnabled(true);
  if (is_other_table) {
    m_table->sortByColumn(0, Qt::AscendingOrder);
    m_table->resizeColumnsToContents();
  }
  m_count->setText(QString("%1 %2, frame %3 at %4 s")
                       .arg(m_rows.rows.size())
                       .arg(m_selection.is_of_mesh() ? "of the selection" : "in all")
                       .arg(m_frame->index)
                       .arg(m_frame->time_s, 0, 'f', 3));
  m_sinceFilled.start();
  m_isFilling = false;
}

PartTable PartTableView::shown() const {
  PartTable sorted{m_rows.columns, {}};
  for (int row = 0; row < m_table->rowCount(); ++row)
    sorted.rows.push_back(
        m_rows.rows[static_cast<std::size_t>(m_table->item(row, 0)->data(row_role).toInt())]);
  return sorted;
}

QString PartTableView::copied() const {
  QString text;
  for (int row = -1; row < m_table->rowCount(); ++row) {
    QStringList fields;
    for (int column = 0; column < m_table->columnCount(); ++column)
      fields << (row < 0 ? m_table->horizontalHeaderItem(column) : m_table->item(row, column))->text();
    text += fields.join('\t') + '\n';
  }
  return text;
}

void PartTableView::chooseRow() {
  const int row = m_table->currentRow();
  if (m_isFilling || row < 0 || m_table->selectedItems().isEmpty()) return;
  const int place = m_table->item(row, 0)->data(row_role).toInt();
  m_isChoosing = true;
  emit selectionRequested(m_rows.rows[static_cast<std::size_t>(place)].item);
  m_isChoosing = false;
}

}  // namespace abrazo::widgets
