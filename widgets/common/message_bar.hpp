#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"

class QLabel;
class QTimer;
class QToolButton;

namespace abrazo::widgets {

enum class MessageKind { Information, Warning, Error, Progress };

/// Shows messages without blocking the window. Errors stay until closed, in a queue; other messages disappear
/// by themselves.
class MessageBar : public QWidget {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// The present or last text.
  QString text() const;
  /// Errors that are not closed yet.
  QStringList openErrors() const;

 public slots:
  void showError(const QString& text);
  /// An error that leaves by itself once the same job succeeds. @param job "export"
  void showErrorOf(const QString& job, const QString& text);
  /// The job succeeded: its errors leave. @param text listed among the messages; shown as well unless another
  /// bar does
  void succeed(const QString& job, const QString& text, bool is_shown_elsewhere = false);
  /// What the job's errors were about was changed: they leave, and nothing is told.
  void withdrawErrorsOf(const QString& job);
  void showInformation(const QString& text);
  /// A single warning is shown in full; several as their number and the first, with all in the tooltip.
  void showWarnings(const QStringList& warnings);
  /// Shows a running job. @param fraction done [0, 1]
  void showProgress(const QString& doing, double fraction);
  void endProgress();

 signals:
  void cancelRequested();
  /// All messages in full, except progress; for a list of messages.
  void told(abrazo::widgets::MessageKind kind, const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void present(MessageKind kind, const QString& text, const QString& tip = {});
  void leave();
  void close();

  Palette m_palette;
  MessageKind m_kind = MessageKind::Information;
  struct OpenError {
    QString job, text;
  };
  std::vector<OpenError> m_errors;
  double m_fraction = 0;
  QLabel* m_sign;
  QLabel* m_text;
  QLabel* m_count;
  QToolButton* m_close;
  QTimer* m_leave;
};

}  // namespace abrazo::widgets
