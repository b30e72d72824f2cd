#include "core/motion/tables/c3d_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/tables/c3d_parameters.hpp"

#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/c3d_bytes.hpp"
#include "tests/core/motion/motion_fixtures.hpp"

namespace abrazo::c3d_reader_test {
namespace {

using test::C3dBytesWriter;
using test::has_warning;
using test::place;
using test::the_warning;
using ::testing::HasSubstr;

/// Two markers in two frames, in tenths of millimetres so that integers hold them exactly.
C3dBytesWriter two_markers() {
  C3dBytesWriter writer;
  writer.labels = {"LASI", "RASI"};
  writer.frames = {{{100.5, -20.3, 900.1}, {-100.5, 20.0, 901.0}},
                   {{101.0, -20.0, 899.9}, {-99.5, 20.5, 900.0}}};
  return writer;
}

NamedMotion read_one(const std::string& bytes) {
  Result<std::vector<NamedMotion>> motions = read_c3d(bytes, "walk.c3d");
  if (motions && motions->size() == 1) return std::move(motions->front());
  ADD_FAILURE() << (motions ? "not one performer" : motions.error().text());
  return {};
}

std::string message_of(const std::string& bytes) {
  const auto motions = read_c3d(bytes, "walk.c3d");
  return motions ? "read" : motions.error().text();
}

TEST(C3dReader, ReadsFloatsAndIntegersOfAllThreeProcessors) {
  for (const auto processor : {C3dBytesWriter::Intel, C3dBytesWriter::Dec, C3dBytesWriter::Mips})
    for (const bool floats : {true, false}) {
      SCOPED_TRACE(std::to_string(processor) + (floats ? " floats" : " integers"));
      C3dBytesWriter writer = two_markers();
      writer.processor = processor;
      writer.floats = floats;
      const NamedMotion motion = read_one(writer.bytes());
      ASSERT_EQ(motion.frames.size(), 2U);
      EXPECT_EQ(motion.fps, 100.0);
      EXPECT_EQ(motion.metres_per_unit, 0.001);
      // Single precision, 900 mm: 3e-5 mm. The scale 0.1 is rounded to single precision as well.
      test::expect_near(place(motion, 0, "LASI"), {100.5, -20.3, 900.1}, 5e-5);
      test::expect_near(place(motion, 1, "RASI"), {-99.5, 20.5, 900.0}, 5e-5);
    }
}

TEST(C3dReader, KnowsTheBytesOfANumberOnADecMachine) {
  // 1.0 on a VAX: sign 0, exponent 129, no fraction: words 0x4080, 0x0000, each with its low byte first.
  const std::string one{'\x80', '\x40', '\x00', '\x00'};
  EXPECT_EQ(C3dBytes(one, C3dProcessor::Dec).real(0), 1.0F);
  // -7.5 = -0.9375 * 2^3: sign 1, exponent 131, fraction 0.875: 0xC1F0, 0x0000.
  const std::string minus{'\xF0', '\xC1', '\x00', '\x00'};
  EXPECT_EQ(C3dBytes(minus, C3dProcessor::Dec).real(0), -7.5F);
}

TEST(C3dReader, RefusesParametersWhoseValuesLieOverEachOther) {
  std::string text(4, '\0');
  // Texts of one letter, 250 x 200 of them: the next entry begins where they should.
  for (int entry = 0; entry < 10'000; ++entry) text += std::string("\1\1A\7\0\xFF\3\1\xFA\xC8", 10);
  std::vector<ImportWarning> warnings;
  const C3dBytes bytes(text, C3dProcessor::Intel);
  const auto parameters = parse_c3d_parameters(bytes, 0, text.size(), "walk.c3d", warnings);
  ASSERT_FALSE(parameters);
  EXPECT_THAT(parameters.error().text(), HasSubstr("they lie over each other"));
}

TEST(C3dReader, TakesAMarkerWithANegativeResidualOrAtTheOriginAsNotSeen) {
  for (const bool floats : {true, false}) {
    C3dBytesWriter writer = two_markers();
    writer.floats = floats;
    writer.frames[0][1] = {12, 13, 14, -1};
    writer.frames[1][0] = {0, 0, 0, 0};
    const NamedMotion motion = read_one(writer.bytes());
    EXPECT_FALSE(place(motion, 0, "RASI").allFinite());
    EXPECT_FALSE(place(motion, 1, "LASI").allFinite());
    EXPECT_TRUE(place(motion, 1, "RASI").allFinite());
  }
}

TEST(C3dReader, StepsOverAnalogValues) {
  for (const bool floats : {true, false}) {
    C3dBytesWriter writer = two_markers();
    writer.floats = floats;
    writer.analog_values = 12;
    test::expect_near(place(read_one(writer.bytes()), 1, "RASI"), {-99.5, 20.5, 900.0}, 5e-5);
  }
}

TEST(C3dReader, ReadsMoreThan255Labels) {
  C3dBytesWriter writer;
  writer.frames.resize(1);
  for (int m = 0; m < 600; ++m) {
    writer.labels.push_back("M" + std::to_string(m));
    writer.frames[0].push_back({m + 1.0, 2, 3});
  }
  const NamedMotion motion = read_one(writer.bytes());
  ASSERT_EQ(motion.points.size(), 600U);
  EXPECT_EQ(place(motion, 0, "M599").x(), 600.0);
}

TEST(C3dReader, ReadsMoreThan65535Frames) {
  C3dBytesWriter writer;
  writer.labels = {"A"};
  for (int f = 0; f < 70'000; ++f) writer.frames.push_back({{f + 1.0, 1, 1}});
  const NamedMotion by_size = read_one(writer.bytes());
  EXPECT_EQ(by_size.frames.size(), 70'000U);
  // 70000 = 4464 + 65536.
  writer.add_integers("TRIAL", "ACTUAL_START_FIELD", {1, 0});
  writer.add_integers("TRIAL", "ACTUAL_END_FIELD", {4464, 1});
  EXPECT_EQ(read_one(writer.bytes()).frames.size(), 70'000U);
  EXPECT_EQ(place(read_one(writer.bytes()), 69'999, "A").x(), 70'000.0);
}

TEST(C3dReader, KnowsUnits) {
  for (const auto& [unit, metres] :
       {std::pair("m", 1.0), std::pair("CM", 0.01), std::pair("inches", 0.0254)}) {
    C3dBytesWriter writer = two_markers();
    writer.units = unit;
    EXPECT_EQ(read_one(writer.bytes()).metres_per_unit, metres);
  }
  C3dBytesWriter writer = two_markers();
  writer.units = "furlong";
  const NamedMotion motion = read_one(writer.bytes());
  EXPECT_FALSE(motion.metres_per_unit);
  EXPECT_THAT(the_warning(motion.warnings, "unit").detail, HasSubstr("'furlong'"));
}

TEST(C3dReader, TellsWhichAxisWasShownUpwardsAndTurnsNothing) {
  C3dBytesWriter writer = two_markers();
  const Vec3 as_written = place(read_one(writer.bytes()), 0, "LASI");
  for (const auto& [screen, up] : {std::pair("+Z", UpAxis::Z), std::pair("y", UpAxis::Y),
                                   std::pair("-Z", UpAxis::MinusZ), std::pair("-X", UpAxis::MinusX)}) {
    writer.x_screen = "+X", writer.y_screen = screen;
    const NamedMotion motion = read_one(writer.bytes());
    EXPECT_EQ(motion.up_axis, up) << screen;
    EXPECT_EQ(place(motion, 0, "LASI"), as_written);
    EXPECT_FALSE(has_warning(motion.warnings, "up-axis"));
  }
  writer.y_screen = "up";
  EXPECT_FALSE(read_one(writer.bytes()).up_axis);
}

TEST(C3dReader, LeavesOutWhatAModelComputedAndWhatHasNoName) {
  C3dBytesWriter writer = two_markers();
  writer.labels = {"LASI", "LKneeAngles", "*12", "RASI"};
  writer.frames = {{{1, 2, 3}, {10, 0, 0}, {4, 5, 6}, {7, 8, 9}}};
  writer.add_texts("POINT", "ANGLES", {"LKneeAngles"});
  const NamedMotion motion = read_one(writer.bytes());
  EXPECT_THAT(motion.points, ::testing::ElementsAre("LASI", "RASI"));
  EXPECT_TRUE(has_warning(motion.warnings, "computed"));
  EXPECT_THAT(the_warning(motion.warnings, "unlabelled").detail, HasSubstr("1 of 4"));
}

TEST(C3dReader, GivesEverySubjectAMotion) {
  C3dBytesWriter writer;
  writer.frames.resize(2);
  for (const char* who : {"Anna:", "Ben:"})
    for (int m = 0; m < 10; ++m) {
      writer.labels.push_back(who + ("M" + std::to_string(m)));
      for (auto& frame : writer.frames) frame.push_back({m + 1.0, 2, *who == 'B' ? 9.0 : 3.0});
    }
  const auto motions = read_c3d(writer.bytes(), "pair.c3d");
  ASSERT_TRUE(motions);
  ASSERT_EQ(motions->size(), 2U);
  EXPECT_EQ((*motions)[0].name, "Anna");
  EXPECT_EQ((*motions)[1].name, "Ben");
  EXPECT_EQ(place((*motions)[1], 1, "M3"), Vec3(4, 2, 9));
}

TEST(C3dReader, GivesSubjectsWhosePrefixesAreDeclaredAMotionEach) {
  C3dBytesWriter writer;
  writer.frames.resize(1);
  for (const char* who : {"A_", "B_"})
    for (int m = 0; m < 8; ++m) {
      writer.labels.push_back(who + ("M" + std::to_string(m)));
      writer.frames[0].push_back({1, 2, 3});
    }
  EXPECT_EQ(read_one(writer.bytes()).points.size(), 16U) << "nothing says that these are two";
  writer.add_texts("SUBJECTS", "LABEL_PREFIXES", {"A_", "B_"});
  const auto motions = read_c3d(writer.bytes(), "pair.c3d");
  ASSERT_TRUE(motions);
  EXPECT_EQ(motions->size(), 2U);
}

TEST(C3dReader, KeepsTheWholeFramesOfAFileThatIsCutOff) {
  const std::string whole = two_markers().bytes();
  const NamedMotion motion = read_one(whole.substr(0, whole.size() - 5));
  EXPECT_EQ(motion.frames.size(), 1U);
  EXPECT_THAT(the_warning(motion.warnings, "frame-count").detail,
              HasSubstr("announces 2 frames and ends after 1"));
}

TEST(C3dReader, SaysWhatIsWrongWithABrokenFile) {
  const std::string whole = two_markers().bytes();
  EXPECT_THAT(message_of(whole.substr(0, 300)),
              HasSubstr("has 300 bytes; a C3D file has at least its header"));
  std::string broken = whole;
  broken[1] = 'x';
  EXPECT_THAT(message_of(broken), HasSubstr("expected the key of C3D, 80, found 120"));
  broken = whole;
  broken[0] = 100;
  EXPECT_THAT(message_of(broken), HasSubstr("parameters are said to begin at block 100"));
  broken = whole;
  broken[C3dBytesWriter::section + 3] = 7;
  EXPECT_THAT(message_of(broken), HasSubstr("type of processor, 84 (Intel)"));
  broken = whole;
  broken[2] = broken[3] = 0;
  EXPECT_THAT(message_of(broken), HasSubstr("has no markers"));
  broken = whole;
  broken[2] = '\xFF', broken[3] = '\xFF';
  EXPECT_THAT(message_of(broken), HasSubstr("ends inside the first frame"));
  broken = whole;
  broken[16] = broken[17] = '\x7F';
  EXPECT_THAT(message_of(broken), HasSubstr("markers are said to begin at byte"));
  EXPECT_THAT(message_of(whole.substr(0, 1024)), HasSubstr("it is cut off"));
}

TEST(C3dReader, StopsAtParametersThatPointBackOrAreTooLong) {
  C3dBytesWriter writer = two_markers();
  std::string bytes = writer.bytes();
  // The first entry is the group POINT: length, id, name, then where the next begins.
  bytes[C3dBytesWriter::section + 4 + 2 + 5] = 1;
  bytes[C3dBytesWriter::section + 4 + 2 + 6] = 0;
  EXPECT_THAT(message_of(bytes), HasSubstr("stated to begin before it ends"));
  bytes = writer.bytes();
  const auto labels = bytes.find("LABELS");
  bytes[labels + 6 + 2 + 2] = '\xFF', bytes[labels + 6 + 2 + 3] = '\xFF';
  EXPECT_THAT(message_of(bytes), HasSubstr("would need"));
}

TEST(C3dReader, SurvivesDamagedFiles) {
  C3dBytesWriter writer = two_markers();
  writer.analog_values = 3;
  const std::string whole = writer.bytes();
  std::mt19937 random(7);
  for (int n = 0; n < 3000; ++n) {
    std::string bytes = whole;
    for (unsigned i = 0; i < 1 + random() % 6; ++i)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    if (random() % 3 == 0) bytes.resize(random() % bytes.size());
    const auto motions = read_c3d(bytes, "damaged.c3d");
    EXPECT_TRUE(motions.ok() || !motions.error().message.empty());
  }
}

}  // namespace
}  // namespace abrazo::c3d_reader_test
