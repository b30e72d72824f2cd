#pragma once

#include <QStringList>
#include <QWidget>

#include "widgets/common/palette.hpp"

class QLabel;
class QTimer;
class QToolButton;

namespace abrazo::widgets {

/// Tells what happened without getting in the way. Errors stay until closed; other messages leave by
/// themselves.
class MessageBar : public QWidget {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  QString text() const;

 public slots:
  void showError(const QString& text);
  void showInformation(const QString& text);
  /// One is shown whole; of more, how many and the first, with all of them as a tool tip.
  void showWarnings(const QStringList& warnings);
  /// A job that goes on. @param fraction  done [0, 1]
  void showProgress(const QString& doing, double fraction);
  void endProgress();

 signals:
  void cancelRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  enum class Kind { Information, Error, Progress };
  void present(Kind kind, const QString& text, const QString& tip = {});

  Palette m_palette;
  Kind m_kind = Kind::Information;
  double m_fraction = 0;
  QLabel* m_sign;
  QLabel* m_text;
  QToolButton* m_close;
  QTimer* m_leave;
};

}  // namespace abrazo::widgets
