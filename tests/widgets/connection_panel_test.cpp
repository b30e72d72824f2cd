// The connection panel and its parts by themselves, on values.
#include "widgets/stream/connection_panel.hpp"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "tests/widgets/pictures.hpp"
#include "widgets/common/value_slider.hpp"
#include "widgets/plots/latency_plot.hpp"
#include "widgets/stream/address_form.hpp"
#include "widgets/stream/issue_list.hpp"
#include "widgets/stream/latency_button.hpp"
#include "widgets/stream/latency_table.hpp"
#include "widgets/stream/number_row.hpp"
#include "widgets/stream/performer_card.hpp"
#include "widgets/stream/scene_notice.hpp"
#include "widgets/stream/sink_list.hpp"
#include "widgets/stream/stream_head.hpp"
#include "widgets/stream/stream_sign.hpp"

namespace abrazo::widgets::connection_panel_test {
namespace {

using test::picture_of;
using test::pixels_like;

PerformerHealth performer(const char* name, bool tracked) {
  PerformerHealth made;
  made.performer = name;
  made.frames = 12'345;
  made.rate_hz = 119.9;
  made.interval_p50_ms = 8.3;
  made.interval_p95_ms = 9.4;
  made.assembly_p50_ms = 0.3;
  made.assembly_p95_ms = 0.8;
  made.tracked = tracked;
  made.joint_map = "unity";
  made.height_m = 1.62;
  made.estimated_joints = {"lowerneck", "ltoes", "rtoes"};
  return made;
}

StreamHealth two_performers() {
  StreamHealth health;
  health.state = StreamHealth::State::Receiving;
  health.uri = "vmc://0.0.0.0:39539";
  health.packets = 61'725;
  health.bytes = 98'000'000;
  health.packets_with_issues = 12;
  health.senders = {"192.168.1.7:50021", "192.168.1.8:50022"};
  health.facts = {"VMC protocol, bundles, T last"};
  health.performers = {performer("192.168.1.7:50021", true), performer("192.168.1.8:50022", false)};
  health.performers[1].lost = 4;
  health.issues = {{"wrong-types", 12, "/VMC/Ext/Bone/Pos: expected sfffffff, found sffff; left out"}};
  health.diagnoses = {{"two-senders", StreamDiagnosis::Severity::Warning,
                       "Two senders on one port: choose who plays the user, or give each a port of its own"}};
  return health;
}

class Connection : public testing::Test {
 protected:
  Connection() {
    panel.setColours(palette_of(Theme::Dark));
    panel.resize(390, 1000);
    panel.showHealth(&health);
    SinkHealth sink;
    sink.uri = "vmc://127.0.0.1:39540?framing=t-last";
    sink.character = "partner";
    sink.packets = 7'200;
    panel.showSinks({{sink, 480}});
  }
  QPushButton* button(const QString& text) {
    for (QPushButton* found : panel.findChildren<QPushButton*>())
      if (found->text() == text) return found;
    return nullptr;
  }
  template <typename Part>
  Part* part() {
    return panel.findChild<Part*>();
  }
  StreamHealth health = two_performers();
  ConnectionPanel panel;
};

TEST_F(Connection, EveryStateHasAColourAndAShapeOfItsOwn) {
  const Palette& dark = palette_of(Theme::Dark);
  std::vector<QImage> shapes;
  for (const auto mark :
       {StreamMark::Off, StreamMark::Waiting, StreamMark::Good, StreamMark::Warning, StreamMark::Bad}) {
    StreamHead head;
    head.setColours(dark);
    head.show({mark, "word", "detail"});
    head.resize(200, 46);
    const QImage picture = picture_of(head).copy(8, 4, 22, 22);
    if (mark != StreamMark::Off) {
      EXPECT_GT(pixels_like(picture, colour_of(mark, dark)), 5);
    }
    for (const QImage& other : shapes) EXPECT_GT(test::difference(picture, other), 0.01);
    shapes.push_back(picture);
  }
}

TEST_F(Connection, BothThemesDraw) {
  const QImage dark = picture_of(panel);
  panel.setColours(palette_of(Theme::Light));
  EXPECT_GT(test::difference(dark, picture_of(panel)), 0.001);
}

TEST_F(Connection, NothingMovesWhenNumbersGrow) {
  picture_of(panel);
  std::vector<QRect> before, after;
  const auto places = [this] {
    std::vector<QRect> found;
    for (QWidget* each : panel.findChildren<QWidget*>())
      if (each->isVisible() && each->parentWidget() == part<StreamHead>()->parentWidget())
        found.push_back(each->geometry());
    return found;
  };
  before = places();
  for (PerformerHealth& one : health.performers) {
    one.frames = 99'999'999;
    one.lost = one.late = one.repeated = 1'000'000;
    one.interval_p95_ms = 1234.5;
    one.tracked = !one.tracked;
    one.calibrated = true;
    one.estimated_joints = {};
  }
  health.packets = 999'999'999;
  health.bytes = 999'999'999'999;
  for (int i = 0; i < 20; ++i) health.issues.push_back({"kind-" + std::to_string(i), 7, "a long text of it"});
  panel.showHealth(&health);
  picture_of(panel);
  EXPECT_EQ(places(), before);
}

TEST_F(Connection, ConnectAsksWithTheUriOfTheFields) {
  panel.showHealth(nullptr);
  QSignalSpy asked(&panel.form(), &AddressForm::connectRequested);
  panel.form().setUri("xsens://10.0.0.2:9764");
  QTest::mouseClick(button("Connect"), Qt::LeftButton);
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked[0][0].toString(), "xsens://10.0.0.2:9764");
}

TEST_F(Connection, APastedUriFillsTheFieldsAndFieldsWriteTheUri) {
  panel.form().setUri("natnet://10.0.0.9:1511?multicast=239.1.1.1");
  QLineEdit* host = nullptr;
  QLineEdit* port = nullptr;
  for (QLineEdit* field : panel.form().findChildren<QLineEdit*>()) {
    if (field->accessibleName() == "Address") host = field;
    if (field->accessibleName() == "Port") port = field;
  }
  ASSERT_TRUE(host && port);
  EXPECT_EQ(host->text(), "10.0.0.9");
  EXPECT_EQ(port->text(), "1511");
  port->selectAll();
  QTest::keyClicks(port, "1512");
  EXPECT_EQ(panel.form().uri(), "natnet://10.0.0.9:1512?multicast=239.1.1.1");
}

TEST_F(Connection, AWrongUriIsToldAndAsksForNothing) {
  panel.showHealth(nullptr);
  QSignalSpy asked(&panel.form(), &AddressForm::connectRequested);
  panel.form().setUri("ftp://nowhere");
  QTest::mouseClick(button("Connect"), Qt::LeftButton);
  EXPECT_EQ(asked.count(), 0);
  EXPECT_FALSE(panel.form().complaint().isEmpty());
}

TEST_F(Connection, WhileConnectedTheButtonDisconnects) {
  QSignalSpy asked(&panel.form(), &AddressForm::disconnectRequested);
  ASSERT_TRUE(button("Disconnect"));
  QTest::mouseClick(button("Disconnect"), Qt::LeftButton);
  EXPECT_EQ(asked.count(), 1);
}

TEST_F(Connection, TheFirstPerformerPlaysTheUserUntilAnotherIsChosen) {
  picture_of(panel);
  ASSERT_EQ(panel.cards().size(), 2U);
  EXPECT_EQ(panel.cards()[0]->part(), PerformerPart::User);
  QSignalSpy user(&panel, &ConnectionPanel::userChosen), second(&panel, &ConnectionPanel::secondChosen);
  for (QToolButton* choice : panel.cards()[1]->findChildren<QToolButton*>())
    if (choice->text() == "User") QTest::mouseClick(choice, Qt::LeftButton);
  ASSERT_EQ(user.count(), 1);
  EXPECT_EQ(user[0][0].toString(), "192.168.1.8:50022");
  panel.setParts("192.168.1.8:50022", "192.168.1.7:50021");
  EXPECT_EQ(panel.cards()[1]->part(), PerformerPart::User);
  EXPECT_EQ(panel.cards()[0]->part(), PerformerPart::Second);
  for (QToolButton* choice : panel.cards()[0]->findChildren<QToolButton*>())
    if (choice->text() == "Second") QTest::mouseClick(choice, Qt::LeftButton);
  ASSERT_EQ(second.count(), 1);
  EXPECT_EQ(second[0][0].toString(), "") << "a second click gives the part up";
}

TEST_F(Connection, TheUserStaysTheUserWhenItsButtonIsPressedAgain) {
  for (QToolButton* choice : panel.cards()[0]->findChildren<QToolButton*>())
    if (choice->text() == "User") {
      QTest::mouseClick(choice, Qt::LeftButton);
      EXPECT_TRUE(choice->isChecked());
    }
}

TEST_F(Connection, AnIssueKeepsItsPlaceAndStaysOpenWhileItsCountGrows) {
  auto* list = part<IssueList>();
  QTreeWidgetItem* issue = list->topLevelItem(2);
  ASSERT_TRUE(issue && issue->text(0).contains("wrong-types"));
  issue->setExpanded(true);
  health.issues[0].count = 13;
  panel.showHealth(&health);
  EXPECT_EQ(list->topLevelItem(2), issue);
  EXPECT_TRUE(issue->isExpanded());
  EXPECT_EQ(issue->text(0), "13 × wrong-types");
  EXPECT_TRUE(list->text().contains("warning: Two senders"));
  EXPECT_TRUE(list->text().contains("expected sfffffff"));
  health.issues.clear();
  panel.showHealth(&health);
  EXPECT_FALSE(list->text().contains("wrong-types"));
}

TEST_F(Connection, TheReportGoesToTheClipboard) {
  button("Copy report")->click();
  const QString text = QGuiApplication::clipboard()->text();
  EXPECT_TRUE(text.contains("two-senders"));
  EXPECT_TRUE(text.contains("192.168.1.8:50022: not tracked"));
}

TEST_F(Connection, TheDelayIsDraggedTypedAndSetBack) {
  picture_of(panel);
  auto* row = part<NumberRow>();
  QSignalSpy asked(&panel, &ConnectionPanel::delayRequested);
  auto* slider = row->findChild<ValueSlider*>();
  QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->width() / 2, slider->height() / 2});
  ASSERT_GE(asked.count(), 1);
  EXPECT_NEAR(asked.last()[0].toInt(), 250, 5);
  auto* field = row->findChild<QLineEdit*>();
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "40");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(asked.last()[0].toInt(), 40);
  EXPECT_EQ(field->text(), "40 ms");
  field->selectAll();
  QTest::keyClicks(field, "9000");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(asked.last()[0].toInt(), 500);
  QTest::mouseDClick(slider, Qt::LeftButton, {}, {slider->width() / 2, slider->height() / 2});
  EXPECT_EQ(asked.last()[0].toInt(), 0);
}

TEST_F(Connection, TheStepRateIsThatOfTheSettings) {
  QComboBox* rate = nullptr;
  for (QComboBox* box : panel.findChildren<QComboBox*>())
    if (box->accessibleName() == "Solver step rate") rate = box;
  ASSERT_TRUE(rate);
  panel.setStepRate(0);
  EXPECT_EQ(rate->currentText(), "input's rate");
  panel.setStepRate(15);
  EXPECT_EQ(rate->currentText(), "15 Hz");
  panel.setStepRate(37.5);
  EXPECT_EQ(rate->currentText(), "37.5 Hz");
  QSignalSpy asked(&panel, &ConnectionPanel::stepRateRequested);
  emit rate->activated(rate->findText("60 Hz"));
  EXPECT_EQ(asked.count(), 1);
}

TEST_F(Connection, ASinkIsAddedAndTakenAway) {
  SinkList& sinks = panel.sinks();
  QSignalSpy send(&sinks, &SinkList::sendRequested), stop(&sinks, &SinkList::stopRequested);
  sinks.setAddress("10.0.0.5", 39000);
  QTest::mouseClick(button("Send"), Qt::LeftButton);
  ASSERT_EQ(send.count(), 1);
  EXPECT_EQ(send[0][0].toString(), "vmc://10.0.0.5:39000?framing=t-last");
  for (QToolButton* each : sinks.findChildren<QToolButton*>()) each->click();
  ASSERT_EQ(stop.count(), 1);
  EXPECT_EQ(stop[0][0].toString(), "vmc://127.0.0.1:39540?framing=t-last");
}

TEST_F(Connection, EveryControlHasANameAndIsReachedByKeyboard) {
  for (QWidget* each : panel.findChildren<QWidget*>()) {
    const bool is_control = qobject_cast<QAbstractButton*>(each) || qobject_cast<QComboBox*>(each) ||
                            qobject_cast<ValueSlider*>(each) || qobject_cast<QTreeWidget*>(each);
    if (!is_control) continue;
    auto* face = qobject_cast<QAbstractButton*>(each);
    EXPECT_FALSE(each->accessibleName().isEmpty() && (!face || face->text().isEmpty()))
        << each->metaObject()->className();
    EXPECT_TRUE(each->focusPolicy() & Qt::TabFocus) << each->metaObject()->className();
  }
}

LatencySample sample_at(double time_s, double solve_ms) {
  LatencySample sample;
  sample.time_s = time_s;
  sample.stages = {0.5, 1, solve_ms, 0.1, 20};
  sample.end_to_end = 1.6 + solve_ms;
  return sample;
}

TEST(LatencyPlot, EachColumnIsTheSlowestFrameInIt) {
  const std::vector<LatencySample> samples = {
      sample_at(0.1, 1), sample_at(0.2, 9), sample_at(0.3, 2), sample_at(0.7, 1), {}};
  const auto columns = slowest_of_each(samples, 0, 1, 2);
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[0].time_s, 0.2);
  EXPECT_EQ(columns[1].time_s, 0.7);
}

TEST(LatencyPlot, DrawsTheStagesInTheirColoursAndAClickSeeks) {
  LatencyPlot plot;
  plot.setColours(palette_of(Theme::Dark));
  plot.resize(500, 160);
  std::vector<LatencySample> samples;
  for (int i = 0; i < 500; ++i) samples.push_back(sample_at(10 + 0.01 * i, 2));
  picture_of(plot);
  plot.show(samples, 10, 15, 12);
  const QImage picture = picture_of(plot);
  EXPECT_GT(test::pixels_of_hue(picture, palette_of(Theme::Dark).residual_bones), 500) << "solve";
  EXPECT_GT(test::pixels_of_hue(picture, palette_of(Theme::Dark).energy_constraint), 500) << "wait";
  EXPECT_GE(plot.upperEnd(), 3.6);
  EXPECT_LE(plot.upperEnd(), 7.2);
  QSignalSpy seek(&plot, &LatencyPlot::seekRequested);
  QWidget* curves = plot.childAt(plot.width() / 2, plot.height() / 2);
  QTest::mouseClick(curves, Qt::LeftButton, {}, {curves->width() / 2, curves->height() / 2});
  ASSERT_EQ(seek.count(), 1);
  EXPECT_NEAR(seek[0][0].toDouble(), 12.5, 0.5);
}

TEST(LatencyButton, ShowsMedianAnd95thPercentileAndKeepsItsWidth) {
  LatencyButton button;
  const int width = button.sizeHint().width();
  EXPECT_EQ(button.words(), "in → out –");
  LatencyRow row{"In → out", ""};
  row.p50 = 2.138;
  row.p95 = 123.4;
  button.show(&row, LatencyVerdict::Bad);
  EXPECT_EQ(button.words(), "in → out 2.14 / 123 ms");
  EXPECT_TRUE(button.toolTip().contains("answers late"));
  EXPECT_EQ(button.sizeHint().width(), width);
}

TEST(LatencyTable, HasALineForEachStage) {
  LatencyTable table;
  const LatencySample here = sample_at(3, 2);
  table.show(latency_rows(std::vector{here}, &here), "last 5 s");
  EXPECT_TRUE(table.text().contains("Solve\t2.00\t2.00\t2.00\t2.00"));
  EXPECT_GT(pixels_like(picture_of(table), palette_of(Theme::Dark).energy_constraint), 20);
}

TEST(SceneNotice, CoversTheSceneAndLetsThePointerThrough) {
  QWidget scene;
  scene.resize(600, 400);
  SceneNotice notice(&scene);
  const QImage empty = picture_of(scene);
  notice.say("3", "Stand in the T-pose");
  const QImage counting = picture_of(scene);
  EXPECT_GT(test::difference(empty, counting), 0.005);
  EXPECT_EQ(notice.words(), "3, Stand in the T-pose");
  EXPECT_EQ(notice.geometry(), scene.rect());
  EXPECT_TRUE(notice.testAttribute(Qt::WA_TransparentForMouseEvents));
  notice.badge(StreamMark::Warning, "Tracking lost");
  EXPECT_EQ(notice.words(), "Tracking lost");
  EXPECT_LT(test::difference(empty, picture_of(scene)), test::difference(empty, counting));
  notice.clear();
  EXPECT_FALSE(notice.isVisible());
}

}  // namespace
}  // namespace abrazo::widgets::connection_panel_test
