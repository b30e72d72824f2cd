#include "tests/widgets/pictures.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace abrazo::test {
namespace {

bool is_near(int a, int b, int tolerance) {
  return std::abs(a - b) <= tolerance;
}

}  // namespace

QImage picture_of(QWidget& widget) {
  widget.show();
  if (widget.isWindow()) (void)QTest::qWaitForWindowExposed(&widget);
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < 60) QApplication::processEvents(QEventLoop::AllEvents, 10);
  QApplication::sendPostedEvents();  // a layout may ask for another: on a busy machine the time was over
                                     // before
  return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

int pixels_like(const QImage& picture, const QColor& colour, int tolerance) {
  int found = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor here = picture.pixelColor(x, y);
      found += is_near(here.red(), colour.red(), tolerance) &&
               is_near(here.green(), colour.green(), tolerance) &&
               is_near(here.blue(), colour.blue(), tolerance);
    }
  return found;
}

int pixels_of_hue(const QImage& picture, const QColor& colour, int degrees) {
  int found = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor here = picture.pixelColor(x, y);
      if (here.hsvSaturation() < 90 || here.value() < 60) continue;
      const int apart = std::abs(here.hue() - colour.hue());
      found += std::min(apart, 360 - apart) <= degrees;
    }
  return found;
}

double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 1;
  int differ = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      differ += !is_near(p.red(), q.red(), 12) || !is_near(p.green(), q.green(), 12) ||
                !is_near(p.blue(), q.blue(), 12);
    }
  return static_cast<double>(differ) / (a.width() * a.height());
}

}  // namespace abrazo::test
