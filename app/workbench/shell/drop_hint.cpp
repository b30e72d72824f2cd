#include "app/workbench/shell/drop_hint.hpp"

#include <QFileInfo>
#include <QPainter>

#include "app/workbench/document/material.hpp"
#include "app/workbench/document/open_video.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::app {
namespace {

constexpr int most_lines = 8, line_height = 24, margin = 24;

QString kind_in_words(const QFileInfo& file) {
  const QString ending = file.suffix().toLower();
  if (file.isDir()) return "a folder; drop the files in it";
  if (ending == "h5" || ending == "hdf5") return "a library";
  if (ending == "json") return "a manifest, or a joint map";
  if (ending == "abrazo") return "a recorded session";
  if (ending == "asf") return "the skeleton of a motion";
  if (ending == "csv" || ending == "tsv")
    return is_motion_file(file.filePath().toStdString()) ? "positions" : "labels";
  if (is_motion_file(file.filePath().toStdString())) return "a motion";
  if (is_video_file(file.filePath())) return "a reference video";
  return "not a kind of file that Abrazo opens";
}

}  // namespace

QStringList dropped_in_words(const QStringList& files) {
  QStringList words;
  for (const QString& file : files.mid(0, most_lines))
    words << QFileInfo(file).fileName() + ": " + kind_in_words(QFileInfo(file));
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
