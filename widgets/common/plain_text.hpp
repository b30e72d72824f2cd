#pragma once

#include <QObject>
#include <QString>

namespace abrazo::widgets {

/// As long as it lives, a label whose text format was left to guessing shows its text as it is: names and
/// messages that come from files and networks are never taken for markup, with pictures and links in them.
/// Labels that are to be rich say so themselves.
class PlainTextLabels : public QObject {
 public:
  /// Of the application, which has to be there.
  explicit PlainTextLabels(QObject* parent = nullptr);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Text from outside as a tooltip, which Qt would otherwise guess to be markup when it looks like it.
QString plain_tip(const QString& text);

}  // namespace abrazo::widgets
