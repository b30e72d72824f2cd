#include <gtest/gtest.h>

#include <QApplication>
#include <clocale>

#include "widgets/common/theme.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  abrazo::widgets::apply_theme(application, abrazo::widgets::palette_of(abrazo::widgets::Theme::Dark));
  return RUN_ALL_TESTS();
}
