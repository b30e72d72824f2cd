#include "core/opening/material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/opening/generated_set.hpp"
#include "tests/core/opening/opening_files.hpp"

namespace abrazo::material_test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;
using Use = DataReference::Use;

class MaterialTest : public ::testing::Test, protected test::TemporaryFolder {};

Project described(const Material& material) {
  Project project;
  describe(material, project);
  return project;
}

TEST_F(MaterialTest, ALibraryFileIsDataOfTheProject) {
  Material material;
  material.library = test::session_library();
  material.library_file = file("small.h5");
  material.reading.file = file("a.amc"), material.reading.skeleton = file("a.asf");
  const Project project = described(material);
  EXPECT_EQ(project.library, "small");
  EXPECT_EQ(project.manifest, "");
  ASSERT_THAT(project.data, SizeIs(3));
  EXPECT_EQ(project.data[0].use, Use::Library);
  EXPECT_EQ(project.data[0].absolute_path, file("small.h5"));
  EXPECT_EQ(project.data[1].use, Use::Motion);
  EXPECT_EQ(project.data[2].use, Use::Skeleton);
}

TEST_F(MaterialTest, OfALibraryThatWasBuiltTheManifestIsKeptAndItsFilesAreData) {
  const Material built = test::built_of(test::two_takes(*this));
  EXPECT_TRUE(built.has_unsaved_library());
  EXPECT_EQ(built.input.name, "take_02");
  EXPECT_THAT(built.excluded_takes, ElementsAre("take_02"));
  const Project project = described(built);
  EXPECT_EQ(project.library, built.library->name());
  ASSERT_THAT(project.data, SizeIs(5)) << "four motions and their labels, each once";
  EXPECT_THAT(project.data, Each(Field(&DataReference::use, Use::Take)));
  const auto again = parse_manifest(project.manifest, "/kept");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(files_of(*again), files_of(*built.manifest));
}

TEST_F(MaterialTest, AGeneratedOneNeedsNoFile) {
  Material material;
  material.library = test::session_library();
  material.is_generated = true;
  EXPECT_FALSE(material.has_unsaved_library());
  EXPECT_THAT(described(material).data, IsEmpty());
}

TEST_F(MaterialTest, WhatAnotherStandsInForStaysInTheProject) {
  const Material built = test::built_of(test::two_takes(*this));
  auto opened = std::make_shared<OpenedProject>();
  opened->reading.project = described(built);
  Material material;
  material.library = test::session_library();
  material.stands_in = true;
  material.project = opened;
  const Project project = described(material);
  EXPECT_EQ(project.manifest, opened->project().manifest);
  EXPECT_EQ(project.library, opened->project().library);
  EXPECT_EQ(project.data, opened->project().data);
  EXPECT_FALSE(material.has_unsaved_library());
}

TEST_F(MaterialTest, ALibraryThatIsWrittenTakesThePlaceOfItsManifest) {
  Project project = described(test::built_of(test::two_takes(*this)));
  project.videos.push_back({static_cast<int>(project.data.size()), "", {}, {}, {}});
  project.data.push_back(unread_reference(Use::Video, file("v.mp4")));
  const Project written = with_library_file(project, file("l.h5"));
  EXPECT_EQ(written.manifest, "");
  ASSERT_THAT(written.data, SizeIs(2));
  EXPECT_EQ(written.data[0].use, Use::Library);
  EXPECT_EQ(written.data[static_cast<std::size_t>(written.videos[0].data)].absolute_path, file("v.mp4"));
}

TEST_F(MaterialTest, ALibraryBesideASessionGetsAFileOfItsOwn) {
  EXPECT_EQ(library_file_beside(file("s.abrazo"), "my/takes"), file("my_takes.h5"));
  std::ofstream(file("my_takes.h5")) << "x";
  EXPECT_EQ(library_file_beside(file("s.abrazo"), "my/takes"), file("my_takes (2).h5"));
}

TEST_F(MaterialTest, TheNextSessionBeginsWithTheLibraryOfTheFiles) {
  Material open;
  open.library = test::two_take_library();
  EXPECT_EQ(open.library_of_files(), open.library);
  open.unannotated = test::session_library();
  open.stands_in = true;
  open.warnings = {"of that opening"};
  const Material next = for_next_session(open);
  EXPECT_EQ(next.library, open.unannotated);
  EXPECT_FALSE(next.unannotated);
  EXPECT_FALSE(next.stands_in);
  EXPECT_THAT(next.warnings, IsEmpty());
  const Material dance = asked_dance(open, 0);
  EXPECT_EQ(dance.library, open.unannotated);
  EXPECT_EQ(dance.input.name, open.unannotated->takes().front().name);
  EXPECT_TRUE(dance.is_input_asked);
}

TEST_F(MaterialTest, AnnotatedTakesThatAreNotInTheLibraryAreCounted) {
  const auto& small = *test::session_library();
  const AnnotationBook book = {{"", test::said_of(small, "first", "dip")},
                               {"first", test::said_of(small, "first", "dip")},
                               {"take_01", test::said_of(small, "first", "dip")},
                               {"take_02", {}}};
  const auto elsewhere = annotated_elsewhere(book, small);
  ASSERT_THAT(elsewhere, SizeIs(1));
  EXPECT_EQ(elsewhere[0].first, "take_01");
  EXPECT_GT(elsewhere[0].second, 0U);
}

}  // namespace
}  // namespace abrazo::material_test
