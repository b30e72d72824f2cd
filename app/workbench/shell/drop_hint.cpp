#include "app/workbench/shell/drop_hint.hpp"

#include <QFileInfo>
#include <QPainter>

#include "core/opening/file_kinds.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::app {
namespace {

constexpr int most_lines = 8, line_height = 24, margin = 24;

QString kind_in_words(const QString& file) {
  if (QFileInfo(file).isDir()) return "a folder; drop the files in it";
  switch (kind_of_file(file.toStdString())) {
    case FileKind::Library:
      return "a library";
    case FileKind::Manifest:
      return "a manifest";
    case FileKind::JointMap:
      return "a joint map";
    case FileKind::Session:
      return "a recorded session";
    case FileKind::Skeleton:
      return "the skeleton of a motion";
    case FileKind::Labels:
      return "labels";
    case FileKind::Motion:
      return "a motion";
    case FileKind::Video:
      return "a reference video";
    case FileKind::Unknown:
      break;
  }
  return "not a kind of file that Abrazo opens";
}

}  // namespace

QStringList dropped_in_words(const QStringList& files) {
  QStringList words;
  for (const QString& file : files.mid(0, most_lines))
    words << QFileInfo(file).fileName() + ": " + kind_in_words(file);
  if (files.size() > most_lines) words << QString("and %1 more").arg(files.size() - most_lines);
  return words;
}

DropHint::DropHint(QWidget* window) : QWidget(window), m_palette(widgets::palette_of(widgets::Theme::Dark)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setObjectName("drop hint");
  hide();
}

void DropHint::showFor(const QStringList& files, const widgets::Palette& palette) {
  m_palette = palette;
  m_words = dropped_in_words(files);
  setGeometry(parentWidget()->rect());
  raise();
  show();
  update();
}

void DropHint::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor veil = m_palette.window;
  veil.setAlpha(200);
  painter.fillRect(rect(), veil);
  painter.setPen(QPen(m_palette.accent.lighter(130), 2, Qt::DashLine));
  painter.drawRoundedRect(rect().adjusted(margin, margin, -margin, -margin), 8, 8);
  int y = height() / 2 - (static_cast<int>(m_words.size()) + 1) * line_height / 2;
  painter.setPen(m_palette.text);
  painter.setFont(widgets::interface_font(18, QFont::DemiBold));
  painter.drawText(QRect(0, y, width(), line_height), Qt::AlignCenter, "Drop to open");
  painter.setFont(widgets::interface_font(13));
  painter.setPen(m_palette.secondary);
  for (const QString& line : m_words)
    painter.drawText(QRect(0, y += line_height, width(), line_height), Qt::AlignCenter, line);
}

}  // namespace abrazo::app
