#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QPushButton;
class QTableWidget;

namespace abrazo::app {

/// Lists the remembered rules for reading motion files, and removes them.
class ImportRulesDialog : public QDialog {
  Q_OBJECT
 public:
  ImportRulesDialog(QString folder, QWidget* parent);
  QTableWidget& table() { return *m_table; }

 public slots:
  /// Removes the chosen rules.
  void removeChosen();

 private:
  void fill();

  QString m_folder;
  QStringList m_files;  ///< of the rows
  QTableWidget* m_table;
  QLabel* m_state;
  QPushButton* m_remove;
};

}  // namespace abrazo::app
