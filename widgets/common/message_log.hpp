#pragma once

#include <QWidget>

#include "widgets/common/message_bar.hpp"

class QListWidget;

namespace abrazo::widgets {

/// All messages since the start, latest at the bottom, for reading and copying.
class MessageLog : public QWidget {
  Q_OBJECT
 public:
  explicit MessageLog(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// All lines, "12:30:05  error  …".
  QString text() const;

 public slots:
  void add(abrazo::widgets::MessageKind kind, const QString& text);

 protected:
  /// Opens at the newest.
  void showEvent(QShowEvent* event) override;

 private:
  void paint(int row);

  Palette m_palette;
  QListWidget* m_list;
};

}  // namespace abrazo::widgets
