#include "core/opening/file_kinds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/motion/files/format_recognition.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::file_kinds_test {
namespace {

using ::testing::HasSubstr;

class FileKinds : public ::testing::Test, protected test::TemporaryFolder {
 protected:
  std::string with(const std::string& name, const std::string& content) const {
    std::ofstream(file(name)) << content;
    return file(name);
  }
  std::string refusal(const std::vector<std::string>& files) const {
    const auto result = sorted(recognised(files));
    return result ? std::string() : result.error().text();
  }
};

TEST_F(FileKinds, AreToldByTheName) {
  EXPECT_EQ(kind_of_file("a.h5"), FileKind::Library);
  EXPECT_EQ(kind_of_file("a.ABRAZO"), FileKind::Session);
  EXPECT_EQ(kind_of_file("a.bvh"), FileKind::Motion);
  EXPECT_EQ(kind_of_file("a.asf"), FileKind::Skeleton);
  EXPECT_EQ(kind_of_file("a.eaf"), FileKind::Labels);
  EXPECT_EQ(kind_of_file("a.MP4"), FileKind::Video);
  EXPECT_EQ(kind_of_file("a.txt"), FileKind::Unknown);
  EXPECT_EQ(kind_of_file("a"), FileKind::Unknown);
}

TEST_F(FileKinds, OfJsonAreToldByWhatItHas) {
  EXPECT_EQ(kind_of_file(with("m.json", R"({"name":"x","takes":[]})")), FileKind::Manifest);
  EXPECT_EQ(kind_of_file(with("j.json", R"({"name":"x","joints":{}})")), FileKind::JointMap);
  EXPECT_EQ(kind_of_file(with("k.json", R"({"name":"x","markers":{"neck":"C7"}})")), FileKind::JointMap);
  EXPECT_EQ(kind_of_file(with("t.json", R"({"tiers":[]})")), FileKind::Labels);
  EXPECT_EQ(kind_of_file(file("none.json")), FileKind::Manifest) << "and is then refused as missing";
}

/// The name is a person's: the dialog that saves a library takes any.
TEST_F(FileKinds, OfALibraryUnderAnotherNameIsToldByItsHead) {
  EXPECT_EQ(kind_of_file(with("salsa.abrazolib", "\x89HDF\r\n\x1a\n")), FileKind::Library);
  EXPECT_EQ(kind_of_file(with("salsa", "\x89HDF\r\n\x1a\n")), FileKind::Library);
  EXPECT_EQ(refusal({with("salsa.abrazolib", "\x89HDF\r\n\x1a\n")}), "");
  EXPECT_THAT(foreign_kind("\x89HDF\r\n", "salsa.bvh"), HasSubstr("a name that ends in .h5"));
}

TEST_F(FileKinds, OfTablesAreToldByTheirHead) {
  EXPECT_EQ(kind_of_file(with("l.csv", "take,start_frame,end_frame,label\n")), FileKind::Labels);
  EXPECT_EQ(kind_of_file(with("t.csv", "\n Tier,start,end,value\n")), FileKind::Labels);
  EXPECT_EQ(kind_of_file(with("x.csv", "name,price\n")), FileKind::Unknown);
}

TEST_F(FileKinds, WhatCannotBeOpenedTogetherIsRefusedWithWhatToDo) {
  const std::string motion = with("a.bvh", ""), other = with("b.bvh", ""), session = with("s.abrazo", "");
  EXPECT_THAT(refusal({motion, other}), HasSubstr("list both as a pair in a manifest"));
  EXPECT_THAT(refusal({session, motion}), HasSubstr("open it alone, or together with its library"));
  EXPECT_THAT(refusal({with("l.h5", ""), with("m.json", "{}")}), HasSubstr("second of its kind"));
  EXPECT_THAT(refusal({with("a.asf", "")}), HasSubstr("open it together with one"));
  EXPECT_THAT(refusal({with("a.txt", "x")}), HasSubstr("use a motion"));
  EXPECT_THAT(refusal({file("none.bvh")}), HasSubstr("there is no such file"));
  std::filesystem::create_directory(file("folder"));
  EXPECT_THAT(refusal({file("folder")}), HasSubstr("is a folder"));
}

TEST_F(FileKinds, EachGoesToItsPlace) {
  const auto files =
      sorted(recognised({with("a.bvh", ""), with("a.asf", ""), with("m.json", "{\"takes\":[]}")}));
  ASSERT_TRUE(files) << files.error().text();
  EXPECT_EQ(files->motion, file("a.bvh"));
  EXPECT_EQ(files->skeleton, file("a.asf"));
  EXPECT_EQ(files->library, file("m.json"));
  EXPECT_EQ(files->session, "");
}

}  // namespace
}  // namespace abrazo::file_kinds_test
