#pragma once

#include <QObject>
#include <QString>

namespace abrazo::widgets {

/// During its lifetime, labels with Qt::AutoText show plain text: names and messages from files and networks
/// are never interpreted as markup with pictures and links. Rich labels must set their format explicitly.
class PlainTextLabels : public QObject {
 public:
  /// Requires an existing application.
  explicit PlainTextLabels(QObject* parent = nullptr);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// External text as a tooltip, protected from Qt's detection of markup.
QString plain_tip(const QString& text);

}  // namespace abrazo::widgets
