// The list of suggestions: its order, its keys, what it asks for.
#include "widgets/annotation/suggestion_section.hpp"

#include <gtest/gtest.h>

#include <QListWidget>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "widgets/annotation/annotation_panel.hpp"

namespace abrazo::widgets::suggestion_section_test {
namespace {

/// Three suggestions; the second of the take is the surest.
Annotations suggested() {
  Annotations annotations;
  const int tier = *annotations.add_tier("move", TierKind::Move, {});
  annotations.suggest(
      std::vector<int>{tier},
      {{.tier = tier, .start_s = 0, .end_s = 1, .value = "jab", .confidence = 0.5, .reason = "fast"},
       {.tier = tier, .start_s = 1, .end_s = 2, .value = "kick", .confidence = 0.9, .reason = "high"},
       {.tier = tier, .start_s = 2, .end_s = 3, .value = "jab", .confidence = 0.7, .reason = "near"}});
  return annotations;
}

TEST(SuggestionRows, HaveTheSurestFirst) {
  const auto rows = suggestion_rows(suggested());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].value, "kick");
  EXPECT_EQ(rows[2].confidence, 0.5);
  EXPECT_EQ(words_of(rows[0]), "0:01.00 – 0:02.00   kick   90 %");
  EXPECT_EQ(rows[0].tier_name, "move");
}

/// Buttons that are not whole in the panel.
QStringList cut_in(const QWidget& panel) {
  QStringList cut;
  for (const QToolButton* button : panel.findChildren<QToolButton*>())
    if (button->isVisible() && !button->text().isEmpty() &&
        (button->mapTo(&panel, QPoint(button->width(), 0)).x() > panel.width() ||
         button->width() < button->sizeHint().width()))
      cut << button->text();
  return cut;
}

/// The menu of label files was cut at the edge of the panel.
TEST(AnnotationPanel, IsNotCutInANarrowColumn) {
  for (const int width : {300, 340, 406}) {  // of the right column in windows of several sizes
    AnnotationPanel panel;
    panel.addSection(new SuggestionSection);
    panel.resize(width, 700);
    panel.setVisible(true);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    // The height of rows that go on in another line is settled in turns.
    EXPECT_TRUE(QTest::qWaitFor([&panel] { return cut_in(panel).isEmpty(); }))
        << cut_in(panel).join(", ").toStdString() << " at a width of " << width;
  }
}

TEST(SuggestionRows, OfAtLeastAConfidenceComeInOrderOfTime) {
  const auto rows = suggestion_rows(suggested());
  EXPECT_EQ(at_least(rows, 0.7), (std::vector<int>{rows[0].id, rows[1].id}));
  EXPECT_TRUE(at_least(rows, 0.91).empty());
  EXPECT_EQ(row_of(rows, rows[2].id), 2);
  EXPECT_EQ(row_of(rows, -1), -1);
}

class Section : public testing::Test {
 protected:
  Section() {
    section.resize(340, 320);
    section.show();
    section.showSuggestions(annotations);
  }
  Annotations annotations = suggested();
  SuggestionSection section;
};

TEST_F(Section, ShowsTheSurestOneWithItsReason) {
  EXPECT_EQ(section.list().count(), 3);
  EXPECT_EQ(section.current(), suggestion_rows(annotations).front().id);
}

TEST_F(Section, AsksByOneKeyEach) {
  QSignalSpy accepted(&section, &SuggestionSection::acceptRequested),
      edited(&section, &SuggestionSection::editRequested),
      rejected(&section, &SuggestionSection::rejectRequested);
  for (const int key : {Qt::Key_A, Qt::Key_E, Qt::Key_X})
    QTest::keyClick(&section.list(), static_cast<Qt::Key>(key));
  for (QSignalSpy* asked : {&accepted, &edited, &rejected}) {
    ASSERT_EQ(asked->count(), 1);
    EXPECT_EQ(asked->front().front().toInt(), section.current());
  }
}

TEST_F(Section, GoesOnToTheNextWhenOneIsDecided) {
  const auto rows = suggestion_rows(annotations);
  ASSERT_TRUE(annotations.reject(rows[0].id));
  section.showSuggestions(annotations);
  EXPECT_EQ(section.current(), rows[1].id);
}

TEST_F(Section, CountsWhatTheSliderWouldAccept) {
  section.slider().setValue(70);
  EXPECT_EQ(section.acceptAll().text(), "Accept 2");
  section.slider().setValue(95);
  EXPECT_FALSE(section.acceptAll().isEnabled());
}

TEST_F(Section, SaysThatThereIsNothing) {
  section.showSuggestions(Annotations());
  EXPECT_EQ(section.current(), 0);
  QSignalSpy accepted(&section, &SuggestionSection::acceptRequested);
  QTest::keyClick(&section.list(), Qt::Key_A);
  EXPECT_EQ(accepted.count(), 0);
}

}  // namespace
}  // namespace abrazo::widgets::suggestion_section_test
