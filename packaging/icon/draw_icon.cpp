// Draws an SVG as PNG at several sizes, while the packages are built: draw_icon IN.svg OUT.png SIZE [OUT.png
// SIZE]...
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <cstdio>
#include <cstdlib>

namespace {

bool draw(QSvgRenderer& drawing, const char* file, int size) {
  QImage picture(size, size, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  drawing.render(&painter);
  painter.end();
  return picture.save(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4 || argc % 2 != 0) {
    std::fprintf(stderr, "usage: draw_icon IN.svg OUT.png SIZE [OUT.png SIZE]...\n");
    return 2;
  }
  QSvgRenderer drawing(QString::fromLocal8Bit(argv[1]));
  for (int i = 2; i < argc; i += 2) {
    const int size = std::atoi(argv[i + 1]);
    if (drawing.isValid() && size > 0 && draw(drawing, argv[i], size)) continue;
    std::fprintf(stderr, "draw_icon: %s cannot be drawn as %s, %s pixels\n", argv[1], argv[i], argv[i + 1]);
    return 1;
  }
  return 0;
}
