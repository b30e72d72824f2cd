#include "widgets/compare/compare_panel.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "tests/widgets/pictures.hpp"
#include "widgets/compare/compare_curve.hpp"
#include "widgets/compare/figure_table.hpp"

namespace abrazo::widgets::compare_panel_test {
namespace {

using test::picture_of;
using test::pixels_like;

std::vector<ComparedStep> swaying(int count) {
  std::vector<ComparedStep> steps;
  for (int i = 0; i < count; ++i) {
    ComparedStep step;
    step.time_s = 10 + i / 60.0;
    step.a.fill(0.05 + 0.02 * std::sin(0.1 * i));
    step.b.fill(0.03);
    steps.push_back(step);
  }
  return steps;
}

class Compare : public testing::Test {
 protected:
  Compare() {
    panel.setColours(palette_of(Theme::Dark));
    panel.resize(400, 620);
    panel.showSides({"frozen at 12.3 s", "live", "α 0.5", "α 0.25", true, false});
    RunFigures a, b;
    a.fill(0.151);
    b.fill(0.064);
    panel.showFigures(a, b, swaying(120), "The last 2 s");
  }
  QPushButton* button(const QString& text) {
    for (QPushButton* found : panel.findChildren<QPushButton*>())
      if (found->text() == text) return found;
    return nullptr;
  }
  ComparePanel panel;
};

TEST_F(Compare, TheBetterFigureIsGreenAndMarked) {
  const QImage picture = picture_of(panel);
  EXPECT_GT(pixels_like(picture, palette_of(Theme::Dark).good), 100);
  EXPECT_TRUE(panel.table().text().contains("Behind selected pair\t151\t64\t−87\tmm"));
  EXPECT_EQ(panel.note(), "The last 2 s");
}

TEST_F(Compare, BothThemesDraw) {
  const QImage dark = picture_of(panel);
  panel.setColours(palette_of(Theme::Light));
  EXPECT_GT(test::difference(dark, picture_of(panel)), 0.001);
}

TEST_F(Compare, ButtonsAskAndChangeNothingThemselves) {
  picture_of(panel);
  QSignalSpy freeze(&panel, &ComparePanel::freezeRequested), swap(&panel, &ComparePanel::swapRequested);
  QSignalSpy adopt(&panel, &ComparePanel::adoptRequested), clear(&panel, &ComparePanel::clearRequested);
  for (const char* text : {"Freeze A", "Swap", "Adopt A", "Clear"}) {
    ASSERT_TRUE(button(text)) << text;
    QTest::mouseClick(button(text), Qt::LeftButton);
  }
  EXPECT_EQ(freeze.count() * swap.count() * adopt.count() * clear.count(), 1);
}

TEST_F(Compare, WithoutAFrozenRunThereIsNothingToSwap) {
  panel.showSides({});
  EXPECT_FALSE(button("Swap")->isEnabled());
  EXPECT_FALSE(button("Adopt A")->isEnabled());
  EXPECT_TRUE(button("Freeze A")->isEnabled());
}

TEST_F(Compare, AClickOnTheCurveSeeksThere) {
  picture_of(panel);
  auto* curve = panel.findChild<CompareCurve*>();
  QSignalSpy seek(&panel, &ComparePanel::seekRequested);
  QTest::mouseClick(curve, Qt::LeftButton, {}, {curve->width() / 2, curve->height() / 2});
  ASSERT_EQ(seek.count(), 1);
  EXPECT_NEAR(seek[0][0].toDouble(), 10 + 119 / 120.0, 0.03);
  panel.showCursor(10);
  QTest::keyClick(curve, Qt::Key_Right);
  EXPECT_NEAR(seek[1][0].toDouble(), 10 + 1 / 60.0, 1e-9);
}

TEST_F(Compare, TheCurveReadsBothRunsAtTheCursor) {
  panel.findChild<QComboBox*>()->setCurrentIndex(static_cast<int>(StepFigure::BehindSelected));
  panel.showCursor(10);
  EXPECT_EQ(panel.curve().reading(), "A 50 mm · B 30 mm");
}

TEST_F(Compare, TheSpanIsChosenByItsButton) {
  QSignalSpy chosen(&panel, &ComparePanel::spanRequested);
  EXPECT_EQ(panel.span(), WhatIfSpan::TwoSeconds);
  for (QToolButton* span : panel.findChildren<QToolButton*>())
    if (span->text() == "This frame") QTest::mouseClick(span, Qt::LeftButton);
  EXPECT_EQ(chosen.count(), 1);
  EXPECT_EQ(panel.span(), WhatIfSpan::Frame);
}

TEST_F(Compare, ProgressIsOnlyThereWhileSomethingIsSolved) {
  picture_of(panel);
  EXPECT_FALSE(button("Cancel")->isVisible());
  panel.showProgress(0.4);
  EXPECT_TRUE(button("Cancel")->isVisible());
  QSignalSpy cancel(&panel, &ComparePanel::cancelRequested);
  QTest::mouseClick(button("Cancel"), Qt::LeftButton);
  EXPECT_EQ(cancel.count(), 1);
}

TEST_F(Compare, EveryControlHasANameAndIsReachedByKeyboard) {
  for (QWidget* part : panel.findChildren<QWidget*>()) {
    const bool is_control = qobject_cast<QAbstractButton*>(part) || qobject_cast<QComboBox*>(part) ||
                            qobject_cast<CompareCurve*>(part);
    if (!is_control) continue;
    auto* face = qobject_cast<QAbstractButton*>(part);
    EXPECT_FALSE(part->accessibleName().isEmpty() && (!face || face->text().isEmpty()))
        << part->metaObject()->className();
    EXPECT_TRUE(part->focusPolicy() & Qt::TabFocus) << part->metaObject()->className();
  }
}

}  // namespace
}  // namespace abrazo::widgets::compare_panel_test
