#pragma once

#include <QDialog>

#include "core/session/run/pair_capture.hpp"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace abrazo::app {

/// Dialog for the take of a recorded pair: name, who leads, and the used range.
class PairDialog : public QDialog {
  Q_OBJECT
 public:
  PairDialog(const PairCapture& capture, const QString& name, const QStringList& labels, QWidget* parent);
  PairCapture::Wishes wishes() const;
  /// Shows an error; the dialog stays open.
  void showTrouble(const QString& text);
  QString trouble() const;
  /// Proposes who leads.
  void setLeader(ActivePerformer leader);

 signals:
  void addRequested();

 private:
  void showLength();

  double m_length_s;
  QLineEdit* m_name;
  QComboBox *m_leads, *m_label;
  QDoubleSpinBox *m_in, *m_out;
  QLabel *m_length, *m_trouble;
};

}  // namespace abrazo::app
