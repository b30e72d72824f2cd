#include "widgets/scene/pick/part_table_view.hpp"

#include <QAbstractTableModel>
#include <QApplication>
#include <QButtonGroup>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "widgets/common/plain_text.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr int live_fill_ms = 500;
/// As many as can be read; Copy has the same, the file all.
int decimals_of(const std::string& column) {
  return column.find("[mm]") != std::string::npos || column.find("[%]") != std::string::npos ? 2 : 4;
}

}  // namespace

/// Only cells that are seen become text: a frame has hundreds of edges, and twice a second they are others.
class PartTableModel : public QAbstractTableModel {
 public:
  using QAbstractTableModel::QAbstractTableModel;
  const PartTable& parts() const { return m_parts; }
  const PartTable::Row& part(int row) const { return m_parts.rows[m_order[static_cast<std::size_t>(row)]]; }

  void setParts(PartTable parts) {
    const bool is_other_table = parts.columns != m_parts.columns || parts.rows.size() != m_parts.rows.size();
    if (is_other_table) beginResetModel();
    m_parts = std::move(parts);
    order();
    if (is_other_table) return endResetModel();
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(m_parts.rows.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(m_parts.columns.size()) + 1;
  }
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == 0 ? QString("part") : text(m_parts.columns[static_cast<std::size_t>(section) - 1]);
  }
  QVariant data(const QModelIndex& at, int role) const override {
    if (role == Qt::TextAlignmentRole && at.column() > 0) return int(Qt::AlignRight | Qt::AlignVCenter);
    return role == Qt::DisplayRole ? QVariant(words(at.row(), at.column())) : QVariant();
  }
  QString words(int row, int column) const {
    if (column == 0) return text(part(row).name);
    const auto place = static_cast<std::size_t>(column) - 1;
    const double value = part(row).values[place];
    return std::isfinite(value) ? QString::number(value, 'f', decimals_of(m_parts.columns[place]))
                                : QString("–");
  }
  void sort(int column, Qt::SortOrder direction) override {
    m_column = column;
    m_direction = direction;
    emit layoutAboutToBeChanged();
    const std::vector<std::size_t> before = m_order;
    order();
    const QModelIndexList kept = persistentIndexList();
    QModelIndexList moved;
    for (const QModelIndex& each : kept) {
      const auto place =
          std::find(m_order.begin(), m_order.end(), before[static_cast<std::size_t>(each.row())]);
      moved << index(static_cast<int>(place - m_order.begin()), each.column());
    }
    changePersistentIndexList(kept, moved);
    emit layoutChanged();
  }
  /// Of the part of this name; -1 if there is none.
  int rowOf(const std::string& name) const {
    for (int row = 0; row < rowCount(); ++row)
      if (part(row).name == name) return row;
    return -1;
  }

 private:
  /// By the numbers; what is none comes first.
  void order() {
    m_order.resize(m_parts.rows.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    const auto place = static_cast<std::size_t>(std::max(m_column, 1)) - 1;
    const auto number = [&](std::size_t row) {
      const double value = m_parts.rows[row].values[place];
      return std::isfinite(value) ? value : -1e300;
    };
    const auto comes_before = [&](std::size_t a, std::size_t b) {
      return m_column <= 0 ? text(m_parts.rows[a].name) < text(m_parts.rows[b].name) : number(a) < number(b);
    };
    if (place >= m_parts.columns.size()) return;
    std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) {
      return m_direction == Qt::AscendingOrder ? comes_before(a, b) : comes_before(b, a);
    });
  }

  PartTable m_parts;
  std::vector<std::size_t> m_order;
  int m_column = 0;
  Qt::SortOrder m_direction = Qt::AscendingOrder;
};

PartTableView::PartTableView(QWidget* parent)
    : QWidget(parent),
      m_model(new PartTableModel(this)),
      m_table(new QTableView(this)),
      m_count(new QLabel(this)) {
  m_table->setModel(m_model);
  m_table->setSortingEnabled(true);
  m_table->sortByColumn(0, Qt::AscendingOrder);
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
  m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(22);
  m_table->setTabKeyNavigation(false);
  column->addWidget(m_table, 1);
  auto* foot = new QHBoxLayout;
  auto* copy = new QPushButton("Copy", this);
  auto* csv = new QPushButton("CSV…", this);
  copy->setToolTip("The chosen rows, or all, as text with tabs, in the order shown (Ctrl+C)");
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
  connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PartTableView::chooseRow);
}

void PartTableView::setKind(TableOf kind) {
  m_kind = kind;
  m_kinds[static_cast<std::size_t>(kind)]->setChecked(true);
  fill();
}

bool PartTableView::isDue(const FrameSnapshotPtr& frame) const {
  if (frame == m_frame) return false;
  const bool is_soon = m_frame && m_sinceFilled.isValid() && m_sinceFilled.elapsed() < live_fill_ms;
  const bool follows = m_frame && frame && frame->time_s > m_frame->time_s;
  return !is_soon || !follows;
}

void PartTableView::showFrame(const FrameSnapshotPtr& frame, const FrameSnapshotPtr& before) {
  if (!isDue(frame)) return;
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
  PartTable parts = part_table(*m_frame, m_before.get(), m_kind, m_selection);
  const bool is_other_table = parts.columns != m_model->parts().columns;
  std::vector<std::string> chosen;
  for (const int row : chosenRows()) chosen.push_back(m_model->part(row).name);
  m_model->setParts(std::move(parts));
  QItemSelection rows;  // sorted by another value they are elsewhere
  for (const std::string& name : chosen)
    if (const int row = m_model->rowOf(name); row >= 0)
      rows.select(m_model->index(row, 0), m_model->index(row, m_model->columnCount() - 1));
  m_table->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (!rows.isEmpty())
    m_table->selectionModel()->setCurrentIndex(rows.first().topLeft(), QItemSelectionModel::NoUpdate);
  if (is_other_table) {
    m_table->sortByColumn(0, Qt::AscendingOrder);
    m_table->resizeColumnsToContents();
  }
  m_count->setText(QString("%1 %2, frame %3 at %4 s")
                       .arg(m_model->rowCount())
                       .arg(m_selection.is_of_mesh() ? "of the selection" : "in all")
                       .arg(m_frame->index)
                       .arg(m_frame->time_s, 0, 'f', 3));
  m_sinceFilled.start();
  m_isFilling = false;
}

PartTable PartTableView::shown() const {
  PartTable sorted{m_model->parts().columns, {}};
  for (int row = 0; row < m_model->rowCount(); ++row) sorted.rows.push_back(m_model->part(row));
  return sorted;
}

std::vector<int> PartTableView::chosenRows() const {
  std::vector<int> rows;
  for (const QModelIndex& each : m_table->selectionModel()->selectedRows()) rows.push_back(each.row());
  std::sort(rows.begin(), rows.end());
  return rows;
}

QString PartTableView::copied() const {
  std::vector<int> rows = chosenRows();
  if (rows.empty())
    for (int row = 0; row < m_model->rowCount(); ++row) rows.push_back(row);
  rows.insert(rows.begin(), -1);  // the heads
  QString text;
  for (const int row : rows) {
    QStringList fields;
    for (int column = 0; column < m_model->columnCount(); ++column)
      fields << (row < 0 ? m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()
                         : m_model->words(row, column));
    text += fields.join('\t') + '\n';
  }
  return text;
}

void PartTableView::chooseRow() {
  const std::vector<int> rows = chosenRows();
  if (m_isFilling || rows.size() != 1) return;  // several are chosen to be copied
  m_isChoosing = true;
  emit selectionRequested(m_model->part(rows.front()).item);
  m_isChoosing = false;
}

}  // namespace abrazo::widgets
