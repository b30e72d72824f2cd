// Calibration files as OpenCV writes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/video/camera_model.hpp"

namespace abrazo::test::intrinsics_file_test {
namespace {

using ::testing::HasSubstr;

std::filesystem::path file_of(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("intrinsics" + std::to_string(::getpid()) + name);
}

const CameraIntrinsics example = {
    1920, 1080, 1391.3334, 1389.25, 960.1 / 3, 541.7, {-0.1 / 3, 0.09, 1e-4, -7e-5, -0.02, 0, 0, 1e-7}};

TEST(IntrinsicsFile, IsReadBackToTheSameNumbers) {
  for (const char* name : {".yaml", ".yml", ".xml", ".json"}) {
    ASSERT_TRUE(write_intrinsics(example, file_of(name)));
    const auto back = read_intrinsics(file_of(name));
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(*back, example) << name;
    std::filesystem::remove(file_of(name));
  }
}

Result<CameraIntrinsics> reading(const std::string& text) {
  std::ofstream(file_of(".txt")) << text;
  auto result = read_intrinsics(file_of(".txt"));
  std::filesystem::remove(file_of(".txt"));
  return result;
}

std::string yaml(const std::string& camera, const std::string& distortion, const std::string& rest = "") {
  return "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n" + rest +
         "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [" + camera +
         "]\ndistortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [" +
         distortion + "]\n";
}

TEST(IntrinsicsFile, OfTheCalibrationProgramIsRead) {
  const auto read = reading(yaml("500., 0., 320., 0., 501., 240., 0., 0., 1.", "-0.2, 0.1, 0., 0., 0.05"));
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->fx, 500);
  EXPECT_EQ(read->cy, 240);
  EXPECT_EQ(read->distortion[4], 0.05);
}

TEST(IntrinsicsFile, NamesTheEntryThatIsWrong) {
  const std::string camera = "500., 0., 320., 0., 501., 240., 0., 0., 1.", lens = "0., 0., 0., 0., 0.";
  const auto refusal = [](const std::string& text) {
    const auto read = reading(text);
    return read ? std::string("was read") : read.error().text();
  };
  EXPECT_THAT(refusal(""), HasSubstr("is empty"));
  EXPECT_THAT(refusal("take,frame\n1,2\n"), HasSubstr("cannot be read"));
  EXPECT_THAT(refusal("%YAML:1.0\n---\na: 1\n"), HasSubstr("\"image_width\" is missing"));
  EXPECT_THAT(refusal("%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n"),
              HasSubstr("\"camera_matrix\" is missing"));
  EXPECT_THAT(refusal(yaml("500., 0., 320., 0.", lens)), HasSubstr("has 4 numbers, 3 x 3"));
  EXPECT_THAT(refusal(yaml("-500., 0., 320., 0., 501., 240., 0., 0., 1.", lens)),
              HasSubstr("fx and fy above 0"));
  EXPECT_THAT(refusal(yaml("500., 3., 320., 0., 501., 240., 0., 0., 1.", lens)), HasSubstr("skew"));
  EXPECT_THAT(refusal(yaml(".Nan, 0., 320., 0., 501., 240., 0., 0., 1.", lens)), HasSubstr("not finite"));
  EXPECT_THAT(refusal(yaml(camera, "0., 0., 0.")), HasSubstr("has 3 numbers; 0, 4, 5 or 8"));
  EXPECT_THAT(refusal(yaml(camera, "0.,0.,0.,0.,0.,0.,0.,0.,0.1,0.,0.,0.")), HasSubstr("thin prism"));
  EXPECT_THAT(refusal(yaml(camera, lens, "fisheye_model: 1\n")), HasSubstr("fisheye"));
  EXPECT_THAT(refusal("%YAML:1.0\n---\nimage_width: 640.5\nimage_height: 480\n"),
              HasSubstr("\"image_width\""));
}

TEST(IntrinsicsFile, WhoseMatrixClaimsToBeHugeAllocatesNothing) {
  const auto read = reading(
      "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: "
      "2000000000\n   "
      "cols: 2000000000\n   dt: d\n   data: [1.]\ndistortion_coefficients: [0.,0.,0.,0.]\n");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text(), HasSubstr("has 1 numbers"));
}

TEST(IntrinsicsFile, SoDeepThatReadingItWouldTakeTheWholeStackIsRefused) {
  const auto times = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  for (const std::string& text :
       {"{\"a\":" + times(400'000, "["), "%YAML:1.0\n---\na: " + times(400'000, "["),
        "%YAML:1.0\n---\na:\n " + times(200'000, "- "),
        "<?xml version=\"1.0\"?>\n<opencv_storage>" + times(200'000, "<a>"),
        "{/* \" */\"a\":" + times(400'000, "[")}) {
    const auto read = reading(text);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().text(), HasSubstr("more than 2000 levels")) << text.substr(0, 40);
  }
}

TEST(IntrinsicsFile, XmlThatIsCutOffIsRefused) {
  for (const char* text : {"<?xml ve=", "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<opencv_storage b=\n",
                           "<?xml version=\"1.0\"?>\n<opencv_storage>\n<a type_id="}) {
    const auto read = reading(text);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().text(), HasSubstr("is XML that is cut off")) << text;
  }
}

TEST(IntrinsicsFile, WithAZeroByteIsRefusedBeforeOpenCvReadsIt) {
  const auto read = reading(std::string("<?xml version=\0\"1.0\"?>\n<opencv_storage/>\n", 41));
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text(), HasSubstr("has a zero byte"));
}

TEST(IntrinsicsFile, ThatMakesOpenCvsOwnStringsThrowIsRefused) {
  const auto read = reading("%YAML:1.3\n   s: 3\n   : [ 500.. ]\n");  // a value without a key
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text(), HasSubstr("cannot be read"));
}

TEST(IntrinsicsFile, IsWrittenInFormatsOfOpenCvAlone) {
  EXPECT_THAT(write_intrinsics(example, file_of(".csv")).error().text(),
              HasSubstr(".yaml, .yml, .xml or .json"));
}

}  // namespace
}  // namespace abrazo::test::intrinsics_file_test
