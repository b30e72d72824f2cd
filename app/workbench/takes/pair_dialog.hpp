#pragma once

#include <QDialog>

#include "core/session/run/pair_capture.hpp"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace abrazo::app {

/// What a recorded pair is to be called as a take of the library, who leads, and how much of it is used.
class PairDialog : public QDialog {
  Q_OBJECT
 public:
  PairDialog(const PairCapture& capture, const QString& name, const QStringList& labels, QWidget* parent);
  PairCapture::Wishes wishes() const;
  /// Stays open, with what is wrong.
  void showTrouble(const QString& text);
  QString trouble() const;

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
