// What the timeline draws, and what it asks for under the pointer and the keys.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/long_recording.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::widgets::timeline_view_test {
namespace {

using test::picture_of;
using test::pixels_like;
using test::pixels_of_hue;
using test::synthetic_frame;
using test::two_take_library;

const Palette& dark() {
  return palette_of(Theme::Dark);
}

/// Ten seconds of frames, a playback parked in their middle, and a timeline that shows them all.
class Timeline : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const FrameSnapshotPtr like = synthetic_frame(0, 0);
    for (std::uint64_t i = 0; i < 300; ++i) {
      auto frame = std::make_shared<FrameSnapshot>(*like);
      frame->index = i;
      frame->time_s = static_cast<double>(i) / 30;
      if (i >= 120) frame->settings.alpha = 0.3;
      if (i >= 200) frame->settings.user_role = UserRole::Passive;
      history.append(frame);
    }
    library = two_take_library();
  }
  Timeline() {
    playback.extend(history.span().first_s, history.span().last_s);
    playback.seek(5);
    view.setLibrary(library);
    view.resize(900, view.sizeHint().height());
    view.show();
    view.refresh(history, playback);
  }

  int x(double time_s) const { return static_cast<int>(std::lround(view.axis().x(time_s))); }
  int middle_of(TimelineLane lane) const {
    return static_cast<int>(view.lanes().top_of(lane) + info_of(lane).height_px / 2);
  }
  QImage lane_picture(TimelineLane lane, double from_s, double to_s) {
    return picture_of(view).copy(x(from_s), static_cast<int>(view.lanes().top_of(lane)), x(to_s) - x(from_s),
                                 static_cast<int>(info_of(lane).height_px));
  }
  void move_to(const QPoint& place, Qt::MouseButtons held = Qt::LeftButton) {
    QMouseEvent move(QEvent::MouseMove, place, place, Qt::NoButton, held, {});
    QApplication::sendEvent(&view, &move);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {},
            Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&view, button, keys, from);
    move_to((from + to) / 2, button);
    move_to(to, button);
    QTest::mouseRelease(&view, button, keys, to);
  }
  void wheel(const QPoint& place, int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(place, view.mapToGlobal(place), {}, QPoint(0, 120 * notches), Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }

  static inline FrameHistory history{std::size_t{512} << 20};
  static inline std::shared_ptr<const MotionLibrary> library;
  Playback playback;
  TimelineView view;
};

TEST_F(Timeline, DrawsTheCursorWhereItsAxisSays) {
  const QImage picture = picture_of(view);
  const int lanes = static_cast<int>(view.lanes().bottom_px());
  EXPECT_GT(pixels_like(picture.copy(x(5) - 2, 10, 5, lanes - 12), Qt::white), lanes - 30);
  EXPECT_LT(pixels_like(picture.copy(x(5) + 30, 10, 40, lanes - 12), Qt::white, 8), 10);
}

TEST_F(Timeline, TheNextSessionStandsWhereTheLastOneStood) {
  const double left = view.axis().left_px, width = view.axis().width_px;
  view.setLibrary(library);
  EXPECT_DOUBLE_EQ(view.axis().left_px, left);
  EXPECT_DOUBLE_EQ(view.axis().width_px, width);
  EXPECT_TRUE(view.tracks().sources().empty());
}

/// They were empty until all frames were read again: half a minute of a long session.
TEST_F(Timeline, AnotherLibraryLeavesTheLanesAsTheyAreWithItsLabels) {
  const TimelineTracks before = view.tracks();
  LibraryColumns columns = library->columns();
  columns.takes.front().labels.front().label = "spin";
  view.extendLibrary(std::make_shared<const MotionLibrary>(std::move(columns)));
  ASSERT_EQ(view.tracks().sources().size(), before.sources().size());
  EXPECT_EQ(view.tracks().sources().back().to_s, before.sources().back().to_s);
  ASSERT_FALSE(view.tracks().moves().empty());
  EXPECT_EQ(view.tracks().label(view.tracks().moves().front().key), "spin");
}

/// A view that has more to read is due sooner than a parked one.
TEST_F(Timeline, SaysThatTheHistoryHasMoreThanWasRead) {
  QSignalSpy unfinished(&view, &TimelineView::unfinished);
  view.refresh(history, playback);
  EXPECT_EQ(unfinished.count(), 0);
  class Parts : public FrameStore {
   public:
    Span span() const override { return {0, frame(999)->time_s, 0, 999, 1000}; }
    FrameSnapshotPtr at(double) const override { return nullptr; }
    FrameSnapshotPtr frame(std::uint64_t index) const override {
      auto frame = std::make_shared<FrameSnapshot>();
      frame->index = index;
      frame->time_s = 0.01 * static_cast<double>(index);
      return frame;
    }
    std::vector<FrameSnapshotPtr> range(double, double, std::size_t) const override { return {}; }
    std::vector<FrameSnapshotPtr> between(std::uint64_t first, std::uint64_t last,
                                          std::size_t) const override {
      std::vector<FrameSnapshotPtr> frames;
      for (std::uint64_t i = first; i <= last; ++i) frames.push_back(frame(i));
      return frames;
    }
    std::optional<std::uint64_t> state_before(std::uint64_t) const override { return std::nullopt; }
  };
  FrameHistory stored;
  stored.set_store(std::make_shared<Parts>());
  view.showOtherFrames();
  for (std::size_t read = 0; read < 1000; read += FrameHistory::read_at_once) view.refresh(stored, playback);
  EXPECT_EQ(unfinished.count(), static_cast<int>(1000 / FrameHistory::read_at_once));
}

TEST_F(Timeline, MovesTheCursorAloneWithoutTheHistory) {
  Playback moved = playback;
  moved.seek(8);
  view.showPlayback(moved);
  const QImage picture = picture_of(view);
  EXPECT_GT(pixels_like(picture.copy(x(8) - 2, 30, 5, 80), Qt::white), 60);
  EXPECT_LT(pixels_like(picture.copy(x(5) - 2, 30, 5, 80), Qt::white), 20);
}

TEST_F(Timeline, ShowsSourcesAndMovesOfTheSelectedPairs) {
  const QImage picture = picture_of(view);
  EXPECT_GT(pixels_like(picture, take_colour(dark(), 0), 6), 1500);
  EXPECT_GT(pixels_like(picture, mixed(label_colour(dark(), "turn"), dark().panel, 0.26), 6), 1000);
}

TEST_F(Timeline, ShowsWhoLeads) {
  // The library's annotation says that the active performer leads, whom the user plays only at first.
  const auto filled = [](const QColor& colour) { return mixed(colour, dark().panel, 0.26); };
  EXPECT_GT(pixels_like(lane_picture(TimelineLane::Role, 0.5, 6), filled(dark().active), 6), 1000);
  EXPECT_LT(pixels_like(lane_picture(TimelineLane::Role, 0.5, 6), filled(dark().passive), 6), 20);
  EXPECT_GT(pixels_like(lane_picture(TimelineLane::Role, 7, 9.5), filled(dark().passive), 6), 300);
}

TEST_F(Timeline, MarksWhereSettingsChanged) {
  const QColor tick = mixed(dark().warning, dark().panel, 0.85);
  EXPECT_GT(pixels_like(lane_picture(TimelineLane::Settings, 3.9, 4.3), tick, 20), 10);
  EXPECT_LT(pixels_like(lane_picture(TimelineLane::Settings, 0.5, 3.8), tick, 20), 2);
}

TEST_F(Timeline, LanesCanBeHiddenAndTheRestMovesUp) {
  const int before = middle_of(TimelineLane::Role);
  TimelineLanes lanes = view.lanes();
  lanes.set_shown(TimelineLane::Source, false);
  QSignalSpy changed(&view, &TimelineView::lanesChanged);
  view.setLanes(lanes);
  EXPECT_EQ(changed.size(), 1);
  EXPECT_EQ(middle_of(TimelineLane::Role), before - 27);
  EXPECT_LT(pixels_like(picture_of(view), take_colour(dark(), 0), 6), 50);
}

TEST_F(Timeline, ScrollsItsLanesWhereThePanelIsLow) {
  auto* scroll = view.findChild<QScrollBar*>();
  EXPECT_FALSE(scroll->isVisible());
  view.resize(900, 100);
  ASSERT_TRUE(scroll->isVisible());
  const double before = view.lanes().top_of(TimelineLane::Role);
  wheel({20, 60}, -1);
  EXPECT_LT(view.lanes().top_of(TimelineLane::Role), before);
  view.resize(900, view.sizeHint().height());
  EXPECT_FALSE(scroll->isVisible());
}

TEST_F(Timeline, TheLaneOfTakesComesIntoViewWhenATakeIsRecorded) {
  view.resize(900, 100);
  const auto is_in_view = [this] {
    const TimelineLanes& lanes = view.lanes();
    const double top = lanes.top_of(TimelineLane::Takes);
    return top >= lanes.top_px() && top + info_of(TimelineLane::Takes).height_px <= lanes.bottom_px();
  };
  view.showTakes({{3, 1, 4, "salsa 001", false}});
  EXPECT_FALSE(is_in_view());
  view.showTakes({{3, 1, 4, "salsa 001", false}, {4, 6, 6, "salsa 002", true}});
  EXPECT_TRUE(is_in_view());
}

TEST_F(Timeline, AsksToGoWhereItIsClickedAndDragged) {
  QSignalSpy asked(&view, &TimelineView::seekRequested), scrubbing(&view, &TimelineView::scrubbing);
  drag({x(7), 10}, {x(9), 40});
  ASSERT_EQ(asked.size(), 3);
  EXPECT_NEAR(asked[0][0].toDouble(), 7, 2 * view.axis().seconds_per_pixel());
  EXPECT_NEAR(asked[2][0].toDouble(), 9, 2 * view.axis().seconds_per_pixel());
  ASSERT_EQ(scrubbing.size(), 2);
  EXPECT_TRUE(scrubbing[0][0].toBool());
  EXPECT_FALSE(scrubbing[1][0].toBool());
}

TEST_F(Timeline, ShiftAndADragMarksARange) {
  QSignalSpy asked(&view, &TimelineView::rangeRequested);
  drag({x(8), 40}, {x(6), 40}, Qt::ShiftModifier);
  ASSERT_GE(asked.size(), 1);
  EXPECT_NEAR(asked.back()[0].toDouble(), 6, 2 * view.axis().seconds_per_pixel());
  EXPECT_NEAR(asked.back()[1].toDouble(), 8, 2 * view.axis().seconds_per_pixel());
}

TEST_F(Timeline, TheHandlesOfTheRangeAreDragged) {
  playback.set_range(3, 7);
  view.showPlayback(playback);
  EXPECT_GT(pixels_like(picture_of(view).copy(x(3), 0, x(7) - x(3), 22),
                        mixed(dark().accent, dark().panel, 0.28), 14),
            900);
  QSignalSpy asked(&view, &TimelineView::rangeRequested), seek(&view, &TimelineView::seekRequested);
  drag({x(3), 10}, {x(4), 10});
  ASSERT_GE(asked.size(), 1);
  EXPECT_NEAR(asked.back()[0].toDouble(), 4, 2 * view.axis().seconds_per_pixel());
  EXPECT_DOUBLE_EQ(asked.back()[1].toDouble(), 7);
  drag({x(7), 10}, {x(1), 10});
  EXPECT_GT(asked.back()[1].toDouble(), asked.back()[0].toDouble()) << "stops at the other one";
  EXPECT_EQ(seek.size(), 0);
}

TEST_F(Timeline, DoubleClickOnTheRangeAsksForNumbers) {
  playback.set_range(3, 7);
  view.showPlayback(playback);
  QSignalSpy asked(&view, &TimelineView::rangeEntryRequested);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, {x(4.3), 10});
  EXPECT_EQ(asked.size(), 1);
}

TEST_F(Timeline, AMarkerIsSelectedByAClickAndMovedByADrag) {
  Markers markers;
  const int dip = markers.add(4, "dip");
  view.showMarkers(markers);
  QSignalSpy asked(&view, &TimelineView::markersRequested), seek(&view, &TimelineView::seekRequested);
  const int y = middle_of(TimelineLane::Markers);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {x(4) + 4, y});
  EXPECT_EQ(view.selectedMarker(), dip);
  EXPECT_DOUBLE_EQ(seek.back()[0].toDouble(), 4) << "and the cursor goes to it";
  drag({x(4) + 1, y}, {x(6), y});
  ASSERT_EQ(asked.size(), 1) << "one step of undo for the whole drag";
  const auto next = asked[0][0].value<Markers>();
  EXPECT_NEAR(next.find(dip)->time_s, 6, 2 * view.axis().seconds_per_pixel());
  EXPECT_DOUBLE_EQ(view.markers().find(dip)->time_s, 4) << "waits for the answer";
}

TEST_F(Timeline, DoubleClickOnAMarkerAsksForItsName) {
  Markers markers;
  const int dip = markers.add(4, "dip");
  view.showMarkers(markers);
  QSignalSpy asked(&view, &TimelineView::markerEntryRequested);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, {x(4) + 4, middle_of(TimelineLane::Markers)});
  ASSERT_EQ(asked.size(), 1);
  EXPECT_EQ(asked[0][0].toInt(), dip);
}

TEST_F(Timeline, AMarkerThatIsGoneIsNoLongerSelected) {
  Markers markers;
  view.showMarkers(markers);
  const int id = markers.add(4);
  view.showMarkers(markers);
  view.selectMarker(id);
  markers.remove(id);
  view.showMarkers(markers);
  EXPECT_EQ(view.selectedMarker(), 0);
}

TEST_F(Timeline, TheWheelZoomsAroundThePointerAndPansWithShift) {
  const double time = view.axis().time(300), span = view.axis().span_s;
  for (const Qt::KeyboardModifiers keys :
       {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ControlModifier)})
    wheel({300, 60}, 2, keys);
  EXPECT_LT(view.axis().span_s, 0.6 * span);
  EXPECT_NEAR(view.axis().time(300), time, 1e-6);
  const double first = view.axis().first_s;
  wheel({300, 60}, -1, Qt::ShiftModifier);
  EXPECT_GT(view.axis().first_s, first);
}

TEST_F(Timeline, TheMiddleButtonAndTheOverviewMoveTheView) {
  wheel({x(5), 60}, 6);
  const double first = view.axis().first_s;
  drag({400, 60}, {300, 60}, {}, Qt::MiddleButton);
  EXPECT_NEAR(view.axis().first_s, first + 100 * view.axis().seconds_per_pixel(), 0.01);
  ASSERT_TRUE(view.viewport().is_partial());
  QSignalSpy seek(&view, &TimelineView::seekRequested);
  const double wanted_s = 2;
  const auto at = static_cast<int>(view.viewport().whole().x(wanted_s));
  QTest::mouseClick(&view, Qt::LeftButton, {}, {at, static_cast<int>(view.lanes().bottom_px()) + 6});
  EXPECT_NEAR(view.axis().first_s + view.axis().span_s / 2, wanted_s, 0.1);
  EXPECT_EQ(seek.size(), 0);
}

TEST_F(Timeline, ShowsAllAndTheRange) {
  playback.set_range(3, 4);
  view.showPlayback(playback);
  view.showRange();
  EXPECT_LT(view.axis().span_s, 1.2);
  EXPECT_TRUE(view.viewport().is_partial());
  view.showAll();
  EXPECT_FALSE(view.viewport().is_partial());
}

TEST_F(Timeline, KeysZoomAndMoveTheView) {
  const double span = view.axis().span_s;
  QTest::keyClick(&view, Qt::Key_Plus);
  QTest::keyClick(&view, Qt::Key_Plus);
  QTest::keyClick(&view, Qt::Key_Plus);
  EXPECT_LT(view.axis().span_s, 0.5 * span);
  const double first = view.axis().first_s;
  QTest::keyClick(&view, Qt::Key_PageUp);
  EXPECT_LT(view.axis().first_s, first);
  EXPECT_EQ(view.focusPolicy(), Qt::StrongFocus);
}

TEST_F(Timeline, TellsTheFactsOfAPlace) {
  TimelineContent content;
  content.library = library;
  content.viewport.set_place(100, 700);
  content.lanes.set_height(300);
  content.playback = playback;
  content.viewport.show(playback);
  for (int i = 0; i < 100; ++i)
    content.tracks.append({0.1 * i, 2, 0, "turn", false, Leader::User, 0.25, 0.01});
  const auto facts = [&content](TimelineLane lane, double time_s) {
    return facts_at(content, {content.axis().x(time_s), content.lanes.top_of(lane) + 5});
  };
  EXPECT_TRUE(facts(TimelineLane::Source, 4).contains("salsa_01 · frame 2"));
  EXPECT_TRUE(facts(TimelineLane::Source, 4).contains("turn"));
  EXPECT_TRUE(facts(TimelineLane::Role, 4).contains("user leads, as the recording is annotated"));
  EXPECT_TRUE(facts(TimelineLane::Cost, 4).contains("cost 0.25 m²"));
  EXPECT_TRUE(facts(TimelineLane::Source, 30).isEmpty());
  for (int i = 100; i < 110; ++i)
    content.tracks.append({0.1 * i, 2, 0, "turn", false, Leader::User, 0.15, 0.01, true, 0, true});
  EXPECT_TRUE(facts(TimelineLane::Cost, 10.5).contains("cost 0.15 m<"));
  auto before = *synthetic_frame(0, 1), after = *synthetic_frame(1, 2);
  after.settings.alpha = 0.3;
  content.settings.append(before);
  content.settings.append(after);
  content.settings_marks = content.settings.merged(0.1);
  EXPECT_TRUE(facts(TimelineLane::Settings, 2).contains("α 0.5 → 0.3"));
}

TEST_F(Timeline, TellsAssistiveProgramsItsCursorAndIsMovedByThem) {
  QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&view);
  ASSERT_TRUE(accessible);
  EXPECT_EQ(accessible->text(QAccessible::Name), QString("Timeline"));
  EXPECT_EQ(accessible->text(QAccessible::Value), QString("00:05.000, parked 5.0 s behind live"));
  auto* value = accessible->valueInterface();
  ASSERT_TRUE(value);
  EXPECT_DOUBLE_EQ(value->currentValue().toDouble(), 5);
  EXPECT_DOUBLE_EQ(value->minimumValue().toDouble(), 0);
  QSignalSpy asked(&view, &TimelineView::seekRequested);
  value->setCurrentValue(7.5);
  ASSERT_EQ(asked.size(), 1);
  EXPECT_DOUBLE_EQ(asked[0][0].toDouble(), 7.5);
}

TEST_F(Timeline, DrawsInLightColoursToo) {
  view.setColours(palette_of(Theme::Light));
  const QImage picture = picture_of(view);
  EXPECT_GT(pixels_like(picture, palette_of(Theme::Light).panel, 3), picture.width() * picture.height() / 4);
  EXPECT_GT(pixels_like(picture, take_colour(palette_of(Theme::Light), 0), 6), 1500);
}

TEST_F(Timeline, TakesAreBlocksAndADoubleClickAsksForOne) {
  view.showTakes({{3, 1, 4, "salsa 001", false}, {4, 6, 6, "salsa 002", true}});
  const QColor ended = mixed(mixed(dark().text, dark().panel, 0.7), dark().panel, 0.22);
  const QColor running = mixed(dark().live, dark().panel, 0.5);
  EXPECT_GT(pixels_like(lane_picture(TimelineLane::Takes, 1, 4), ended, 6), 300);
  EXPECT_GT(pixels_like(lane_picture(TimelineLane::Takes, 7, 9), running, 6), 300)
      << "a running take lasts until the live end";
  EXPECT_LT(pixels_like(lane_picture(TimelineLane::Takes, 4.5, 5.5), ended, 6), 30);
  QSignalSpy asked(&view, &TimelineView::takeRequested);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, {x(2), middle_of(TimelineLane::Takes)});
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked[0][0].toLongLong(), 3);
}

TEST_F(Timeline, KnowsSinceWhenTheUserHasARole) {
  ASSERT_EQ(view.tracks().user_roles().size(), 2U);
  EXPECT_NEAR(view.tracks().user_roles()[1].from_s, 200.0 / 30, 1e-6);
}

/// Lost packets, and two takes between which nothing was recorded.
TEST(TimelineOfARecordingWithGaps, DrawsNoLineAcrossThem) {
  const FrameSnapshotPtr like = synthetic_frame(0, 0);
  FrameHistory history;
  for (std::uint64_t i = 0; i < 300; ++i) {
    auto frame = std::make_shared<FrameSnapshot>(*like);
    frame->index = i < 200 ? i : i + 90;
    frame->time_s = static_cast<double>(i) / 30 + (i < 100 ? 0 : i < 200 ? 3 : 6);
    frame->input_rate_hz = 30;
    history.append(frame);
  }
  Playback playback;
  playback.extend(history.span().first_s, history.span().last_s);
  playback.seek(1);
  TimelineView view;
  view.setLibrary(two_take_library());
  view.resize(900, view.sizeHint().height());
  view.show();
  view.refresh(history, playback);
  const auto line = [&view](double from_s, double to_s) {
    const int left = static_cast<int>(view.axis().x(from_s)), right = static_cast<int>(view.axis().x(to_s));
    const QRect cost(left, static_cast<int>(view.lanes().top_of(TimelineLane::Cost)), right - left,
                     static_cast<int>(info_of(TimelineLane::Cost).height_px));
    return pixels_like(picture_of(view).copy(cost), dark().user);
  };
  EXPECT_GT(line(1.5, 3), 20);
  EXPECT_EQ(line(3.5, 6.1), 0) << "packets were lost";
  EXPECT_GT(line(6.5, 9), 20);
  EXPECT_EQ(line(9.8, 12.5), 0) << "between the takes, whose frames are not numbered on";
  EXPECT_GT(line(13, 15), 20);
}

/// Of which the timeline reads one frame in five.
TEST(TimelineOfALongRecording, HasTheGapsThatItHadLive) {
  const FrameSnapshotPtr like = synthetic_frame(0, 0);
  FrameHistory history;
  history.set_store(std::make_shared<test::LongRecording>(20'000, [&](std::uint64_t index) {
    auto frame = std::make_shared<FrameSnapshot>(*like);
    frame->time_s = static_cast<double>(index) / 100 + (index < 10'000 ? 0 : 8);  // nobody was tracked
    frame->input_rate_hz = 100;
    return frame;
  }));
  Playback playback;
  playback.extend(history.span().first_s, history.span().last_s);
  TimelineView view;
  view.setLibrary(two_take_library());
  for (int turns = 0; turns < 40; ++turns) view.refresh(history, playback);
  const TimelineTracks& tracks = view.tracks();
  for (const TimelineTracks::Lane* lane : {&tracks.sources(), &tracks.moves(), &tracks.leaders()}) {
    EXPECT_NE(interval_at(*lane, 50), nullptr);
    EXPECT_NE(interval_at(*lane, 150), nullptr);
    EXPECT_EQ(interval_at(*lane, 104), nullptr);
  }
}

}  // namespace
}  // namespace abrazo::widgets::timeline_view_test
