// Films: which moments, what waits between two threads, what comes out.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <thread>

#include "app/workbench/base/bounded_queue.hpp"
#include "app/workbench/base/film_clock.hpp"
#include "app/workbench/base/film_writer.hpp"
#include "app/workbench/shell/scene_picture.hpp"
#include "widgets/scene/view/scene_pictures.hpp"

namespace abrazo::app::film_test {
namespace {

TEST(FilmPlan, HasBothEndsAndEqualSteps) {
  const FilmPlan plan{2, 4, 25};
  EXPECT_EQ(plan.pictures(), 51);
  EXPECT_DOUBLE_EQ(plan.time_of(0), 2);
  EXPECT_DOUBLE_EQ(plan.time_of(50), 4);
  EXPECT_EQ((FilmPlan{0, 0.1, 30}.pictures()), 4) << "0.1 * 30 is not quite 3 in binary numbers";
  EXPECT_EQ((FilmPlan{1, 1, 30}.pictures()), 1);
  EXPECT_EQ((FilmPlan{1, 0, 30}.pictures()), 0);
}

TEST(FilmClock, ALatePictureStandsForThoseThatWereMissed) {
  FilmClock clock(25);
  EXPECT_EQ(clock.due(0), 1);
  clock.given(1);
  EXPECT_EQ(clock.due(0.039), 0);
  EXPECT_EQ(clock.due(0.041), 1);
  EXPECT_EQ(clock.due(0.2), 5);
  clock.dropped();
  EXPECT_EQ(clock.due(0.24), 6) << "what was left out is made up for";
  clock.given(6);
  EXPECT_EQ(clock.pictures(), 7);
  EXPECT_EQ(clock.left_out(), 1);
}

TEST(BoundedQueue, TakesNoMoreThanItHolds) {
  BoundedQueue<int> queue(2);
  EXPECT_TRUE(queue.push(1));
  EXPECT_TRUE(queue.push(2));
  EXPECT_TRUE(queue.is_full());
  EXPECT_FALSE(queue.push(3));
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_TRUE(queue.push(4));
  queue.close();
  EXPECT_FALSE(queue.push(5));
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 4);
  EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(BoundedQueue, WakesWhoWaitsWhenItIsGivenUp) {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.abandon();
  EXPECT_EQ(queue.pop(), std::nullopt);
  BoundedQueue<int> empty(1);
  std::thread waiting([&empty] { EXPECT_EQ(empty.pop(), std::nullopt); });
  empty.abandon();
  waiting.join();
}

QImage plain(QSize size, const QColor& colour) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(colour);
  return image;
}

TEST(FilmWriter, WritesEveryPictureAsOftenAsItStands) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("film.mp4");
  FilmWriter film(file, {64, 48}, 25);
  EXPECT_TRUE(film.offer(plain({64, 48}, Qt::red), 3));
  EXPECT_TRUE(film.offer(plain({80, 20}, Qt::blue))) << "another shape is fitted in";
  EXPECT_EQ(film.finishNow(), QString());
  EXPECT_EQ(film.written(), 4);
  EXPECT_TRUE(QFile::exists(file));
}

TEST(FilmWriter, AFileThatCannotBeWrittenIsToldAtTheEnd) {
  FilmWriter film("/no/such/folder/film.mp4", {64, 48}, 25);
  EXPECT_TRUE(film.finishNow().contains("check that the folder exists"));
  EXPECT_EQ(film.written(), 0);
}

TEST(FilmWriter, LeavesNothingBehindWhenItIsGivenUp) {
  const QTemporaryDir folder;
  {
    FilmWriter film(folder.filePath("film.mp4"), {64, 48}, 25);
    film.offer(plain({64, 48}, Qt::red), 3);
  }
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(Fitted, KeepsTheShapeOnBlack) {
  const QImage film = widgets::fitted(plain({100, 50}, Qt::white), {64, 64});
  EXPECT_EQ(film.size(), QSize(64, 64));
  EXPECT_EQ(film.pixelColor(32, 32), QColor(Qt::white));
  EXPECT_EQ(film.pixelColor(32, 4), QColor(Qt::black));
}

/// `colour` that covers this share of what is behind it.
QImage over(const QColor& colour, int alpha, int background) {
  const auto mix = [&](int channel) { return (channel * alpha + background * (255 - alpha)) / 255; };
  return plain({1, 1}, QColor(mix(colour.red()), mix(colour.green()), mix(colour.blue())));
}

TEST(WithoutBackground, FindsColourAndCoverOfWhatStoodOnBlackAndOnWhite) {
  const QColor colour(200, 100, 40);
  for (const int alpha : {0, 64, 128, 255}) {
    const QImage found = without_background(over(colour, alpha, 0), over(colour, alpha, 255));
    const QRgb pixel = reinterpret_cast<const QRgb*>(found.constScanLine(0))[0];
    EXPECT_NEAR(qAlpha(pixel), alpha, 1);
    EXPECT_NEAR(qRed(pixel), 200 * alpha / 255, 1);
    EXPECT_NEAR(qBlue(pixel), 40 * alpha / 255, 1);
  }
}

}  // namespace
}  // namespace abrazo::app::film_test
