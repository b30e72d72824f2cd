// How the figures of a recording are written.
#include "widgets/takes/recording_status.hpp"

#include <gtest/gtest.h>

namespace abrazo::widgets::recording_status_test {
namespace {

TEST(RecordingFigures, AreWrittenAsPeopleReadThem) {
  EXPECT_EQ(duration_text(35.9), "00:35");
  EXPECT_EQ(duration_text(3723), "1:02:03");
  EXPECT_EQ(duration_text(-1), "00:00");
  EXPECT_EQ(disk_size_text(0), "0 B");
  EXPECT_EQ(disk_size_text(812'400), "812 kB");
  EXPECT_EQ(disk_size_text(999'600), "1.00 MB");
  EXPECT_EQ(disk_size_text(12'430'000), "12.4 MB");
  EXPECT_EQ(disk_size_text(1'240'000'000), "1.24 GB");
}

TEST(RecordingStatus, TellsHowTheDiskKeepsUp) {
  RecordingStatus status;
  EXPECT_EQ(disk_words(status).weight, DiskWords::Weight::Fine);
  status.file = "s.abrazo";
  status.bytes = 12'430'000;
  status.behind_s = 0.3;
  EXPECT_EQ(disk_words(status).text, "12.4 MB on disk");
  status.behind_s = 2.25;
  EXPECT_EQ(disk_words(status).weight, DiskWords::Weight::Behind);
  EXPECT_NE(disk_words(status).text.find("2.2 s behind"), std::string::npos);
  status.failure = "s.abrazo: no space left on the disk";
  status.lost = 120;
  EXPECT_EQ(disk_words(status).weight, DiskWords::Weight::Failed);
  EXPECT_EQ(disk_words(status).text, "s.abrazo: no space left on the disk; 120 frames lost since");
}

}  // namespace
}  // namespace abrazo::widgets::recording_status_test
