#include "app/workbench/library/import_rules_dialog.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>

#include "app/workbench/base/error_words.hpp"
#include "core/opening/import_rules.hpp"

namespace abrazo::app {

ImportRulesDialog::ImportRulesDialog(QString folder, QWidget* parent)
    : QDialog(parent),
      m_folder(std::move(folder)),
      m_table(new QTableWidget(0, 3, this)),
      m_state(new QLabel(this)),
      m_remove(new QPushButton("Remove", this)) {
  setWindowTitle("How motion files are read");
  resize(760, 360);
  auto* column = new QVBoxLayout(this);
  auto* about = new QLabel(
      "Files with the same points are read this way if they are in the folder, or have a similar name (# "
      "stands for "
      "any number).",
      this);
  about->setWordWrap(true);
  column->addWidget(about);
  m_table->setAccessibleName("Remembered imports");
  m_table->setHorizontalHeaderLabels({"Named", "Folder", "Read with"});
  m_table->verticalHeader()->hide();
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setShowGrid(false);
  m_table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_table->setColumnWidth(0, 180);
  m_table->setColumnWidth(1, 240);
  column->addWidget(m_table, 1);
  auto* row = new QHBoxLayout;
  auto* close = new QPushButton("Close", this);
  close->setDefault(true);
  m_remove->setAutoDefault(false);
  m_state->setWordWrap(true);
  row->addWidget(m_remove);
  row->addWidget(m_state, 1);
  row->addWidget(close);
  column->addLayout(row);
  connect(m_remove, &QPushButton::clicked, this, &ImportRulesDialog::removeChosen);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  connect(m_table, &QTableWidget::itemSelectionChanged, this,
          [this] { m_remove->setEnabled(m_table->selectionModel()->hasSelection()); });
  fill();
}

void ImportRulesDialog::fill() {
  const StoredRules stored = import_rules(m_folder.toStdString());
  m_files.clear();
  m_table->setRowCount(0);
  const auto add = [this](const std::string& file, const QStringList& cells) {
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(cells[column]);
      m_table->setItem(row, column, item);
    }
    m_files << QString::fromStdString(file);
  };
  for (const ImportRule& rule : stored.rules) {
    const QString how = QString::fromStdString(reading_words(rule.how));
    add(rule.path, {QString::fromStdString(rule.name_pattern), QString::fromStdString(rule.folder),
                    how.isEmpty() ? "as found, without a question" : how});
  }
  for (const Error& error : stored.damaged) add(error.where, {"cannot be read", "", words(error)});
  m_remove->setEnabled(false);
  m_state->setText(m_files.isEmpty() ? "Nothing is remembered yet" : QString());
}

void ImportRulesDialog::removeChosen() {
  QString trouble;
  for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
    if (const Status gone = forget_import(m_files[index.row()].toStdString()); !gone)
      trouble = words(gone.error());
  fill();
  if (!trouble.isEmpty()) m_state->setText(trouble);
}

}  // namespace abrazo::app
