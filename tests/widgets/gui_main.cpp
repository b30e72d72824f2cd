#include <gtest/gtest.h>

#include <QApplication>
#include <clocale>

#include "widgets/common/theme.hpp"
#include "widgets/scene/view/scene_view.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  abrazo::widgets::SceneView::prepareApplication();
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  abrazo::widgets::apply_theme(application, abrazo::widgets::palette_of(abrazo::widgets::Theme::Dark));
  return RUN_ALL_TESTS();
}
