#include "widgets/common/tabular.hpp"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGlyphRun>
#include <QHash>
#include <QPainter>
#include <QRawFont>
#include <algorithm>
#include <array>
#include <cmath>

namespace abrazo::widgets {
namespace {

constexpr int kept_fonts = 64;
constexpr ushort letters = 256;  ///< of Latin-1: what numbers and units consist of

/// What is measured of a font once: numbers are drawn with every picture, and shaping a letter takes longer
/// than drawing it.
struct Face {
  QFontMetricsF metrics;
  QRawFont raw;
  double digit = 0;
  std::array<double, letters> advances{};
  std::array<quint32, letters> glyphs{};  ///< 0 = not in this font

  explicit Face(const QFont& font) : metrics(font), raw(QRawFont::fromFont(font)) {
    for (ushort c = 0; c < letters; ++c) {
      advances[c] = metrics.horizontalAdvance(QChar(c));
      quint32 glyph = 0;
      int count = 1;
      const QChar letter(c);
      if (raw.glyphIndexesForChars(&letter, 1, &glyph, &count) && count == 1) glyphs[c] = glyph;
    }
    for (char c = '0'; c <= '9'; ++c) digit = std::max(digit, advances[static_cast<uchar>(c)]);
  }
  double own(QChar c) const {
    return c.unicode() < letters ? advances[c.unicode()] : metrics.horizontalAdvance(c);
  }
  double advance(QChar c) const { return c.isDigit() ? digit : own(c); }
  quint32 glyph(QChar c) const { return c.unicode() < letters ? glyphs[c.unicode()] : 0; }
  double width(const QString& text) const {
    double width = 0;
    for (const QChar c : text) width += advance(c);
    return width;
  }
};

/// Only for the window's thread, as all that draws text.
QHash<QString, Face>& faces() {
  static QHash<QString, Face> kept;
  return kept;
}

const Face& face_of(const QFont& font) {
  const QString key = font.key();
  const auto found = faces().constFind(key);
  if (found != faces().constEnd()) return *found;
  if (faces().size() >= kept_fonts) faces().clear();
  if (faces().isEmpty()) qAddPostRoutine([] { faces().clear(); });  // fonts end with the application
  return *faces().insert(key, Face(font));
}

}  // namespace

double tabular_width(const QFont& font, const QString& text) {
  return face_of(font).width(text);
}

void draw_tabular(QPainter& painter, const QRectF& rect, Qt::Alignment alignment, const QString& text) {
  const Face& face = face_of(painter.font());
  double x = rect.left();
  if (alignment & (Qt::AlignRight | Qt::AlignHCenter)) {
    const double spare = rect.width() - face.width(text);
    x += alignment & Qt::AlignRight ? spare : spare / 2;
  }
  const double baseline = rect.center().y() + (face.metrics.ascent() - face.metrics.descent()) / 2;
  QVector<quint32> glyphs;
  QVector<QPointF> places;
  for (const QChar c : text) {
    const double cell = face.advance(c);
    const QPointF place(x + (cell - face.own(c)) / 2, baseline);
    if (const quint32 glyph = face.glyph(c)) {
      glyphs << glyph;
      places << place;
    } else {
      painter.drawText(place, QString(c));  // from another font
    }
    x += cell;
  }
  if (glyphs.isEmpty()) return;
  QGlyphRun run;
  run.setRawFont(face.raw);
  run.setGlyphIndexes(glyphs);
  run.setPositions(places);
  painter.drawGlyphRun({}, run);
}

TabularLabel::TabularLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
}

void TabularLabel::setText(const QString& text) {
  if (text == m_text) return;
  m_text = text;
  const int width = static_cast<int>(std::ceil(tabular_width(font(), text))) + 2;
  if (width > m_widest) {
    m_widest = width;
    updateGeometry();
  }
  update();
}

void TabularLabel::fit() {
  m_widest = static_cast<int>(std::ceil(tabular_width(font(), m_text))) + 2;
  updateGeometry();
}

void TabularLabel::setColour(const QColor& colour) {
  if (colour == m_colour) return;
  m_colour = colour;
  update();
}

QSize TabularLabel::sizeHint() const {
  return {m_widest, fontMetrics().height() + 2};
}

void TabularLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(font());
  painter.setPen(m_colour.isValid() ? m_colour : palette().color(QPalette::WindowText));
  draw_tabular(painter, rect(), m_alignment, m_text);
}

}  // namespace abrazo::widgets
