#include "widgets/common/plain_text.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QTextDocument>

namespace abrazo::widgets {

PlainTextLabels::PlainTextLabels(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool PlainTextLabels::eventFilter(QObject* watched, QEvent* event) {
  // Every widget is polished once, before it is shown first. A tooltip is a label, too, but the tips of our
  // own are often rich: those of outside texts go through plain_tip.
  if (event->type() == QEvent::Polish)
    if (auto* label = qobject_cast<QLabel*>(watched);
        label && label->textFormat() == Qt::AutoText && !label->inherits("QTipLabel"))
      label->setTextFormat(Qt::PlainText);
  return false;
}

QString plain_tip(const QString& text) {
  if (!Qt::mightBeRichText(text)) return text;
  return "<qt>" + text.toHtmlEscaped().replace('\n', "<br>") + "</qt>";
}

}  // namespace abrazo::widgets
