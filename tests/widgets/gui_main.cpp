#include <gtest/gtest.h>

#include <QApplication>
#include <clocale>

#include "widgets/common/theme.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // a test answers Qt's own
  QApplication application(argc, argv);
  QApplication::setQuitOnLastWindowClosed(
      false);  // a test may close a window and wait for something after it
  std::setlocale(LC_NUMERIC, "C");
  abrazo::widgets::apply_theme(application, abrazo::widgets::palette_of(abrazo::widgets::Theme::Dark));
  return RUN_ALL_TESTS();
}
