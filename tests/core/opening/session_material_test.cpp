// A session file and all that it stands on, as one value or one error.
#include "core/opening/session_material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/opening/generated_set.hpp"
#include "core/session/file/library_reference.hpp"
#include "tests/core/opening/opening_files.hpp"

namespace abrazo::session_material_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
namespace fs = std::filesystem;

class SessionMaterial : public ::testing::Test, protected test::TemporaryFolder {
 protected:
  Result<Material> opened(const SessionWish& wish = {}, const Places& places = {}) const {
    const auto session = open_session(path);
    return session ? material_of(with_places(*session, places), wish, {}) : Result<Material>(session.error());
  }
  AnnotationBook said() const { return {{"take_01", test::said_of(*built.library, "take_01", "dip")}}; }

  const std::string path = file("s.abrazo");
  const Material built = test::built_of(test::two_takes(*this));
};

TEST_F(SessionMaterial, ALibraryThatWasBuiltAndNotSavedIsThereAgain) {
  test::save(path, built, said());
  const auto material = opened();
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_THAT(material->warnings, IsEmpty());
  EXPECT_EQ(library_fingerprint(*material->library), library_fingerprint(*built.library));
  EXPECT_EQ(material->input.name, "take_02");
  EXPECT_EQ(material->project->project().annotations, said());
  EXPECT_TRUE(material->has_unsaved_library()) << "it may be written next time";
}

TEST_F(SessionMaterial, WithoutItsMotionFilesItSaysSoAndKeepsWhatWasSaid) {
  test::save(path, built, said());
  fs::remove_all(file("captures"));
  EXPECT_THAT(open_session(path)->project->missing(), SizeIs(5)) << "which can be asked for";
  const auto material = opened();
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_TRUE(material->stands_in);
  ASSERT_GE(material->warnings.size(), 2U);
  EXPECT_THAT(material->warnings[0], StartsWith("the generated dance answers in place of the library"));
  EXPECT_THAT(material->warnings[0], HasSubstr("take_01_a.bvh"));
  EXPECT_THAT(material->warnings[0], HasSubstr(" and 3 more are not there"));
  EXPECT_THAT(material->warnings[0], Not(HasSubstr(file("captures")))) << "short";
  EXPECT_THAT(material->warnings[1], HasSubstr(file("captures"))) << "the whole follows";
  EXPECT_THAT(material->warnings, Contains(HasSubstr("of take_01 are kept, and not shown")));
  Project again;
  describe(*material, again);
  EXPECT_EQ(again.manifest, material->project->project().manifest);
  EXPECT_THAT(again.data, SizeIs(5));
}

TEST_F(SessionMaterial, ItsMotionFilesMayBeElsewhere) {
  test::save(path, built);
  fs::rename(file("captures"), file("moved"));
  const auto session = open_session(path);
  const auto& data = session->project->project().data;
  const std::string first = file("moved/") + fs::path(data[0].absolute_path).filename().string();
  Places places = relocated(data, 0, first);
  places[0] = first;
  EXPECT_THAT(places, SizeIs(5));
  const auto material = opened({}, places);
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_FALSE(material->stands_in);
  EXPECT_EQ(library_fingerprint(*material->library), library_fingerprint(*built.library));
}

/// The library is taken from what is open, which says nothing of the motion.
TEST_F(SessionMaterial, TheGeneratedLeaderDancesAgainWhereItsLibraryIsOpen) {
  const Material dance = *generated_dance({});
  test::save(path, dance);
  SessionWish wish;
  wish.open = dance;
  wish.open.input = {};
  const auto material = opened(wish);
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_EQ(material->input.name, dance.input.name);
  EXPECT_EQ(material->input.poses.size(), dance.input.poses.size());
  EXPECT_THAT(material->warnings, IsEmpty());
}

TEST_F(SessionMaterial, ATakeThatStandsInForTheMotionIsNamed) {
  Material without = built;
  without.input.name = "of a device";
  without.input.poses.clear();
  test::save(path, without);
  const auto material = opened();
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_THAT(material->warnings,
              Contains(HasSubstr("the motion \"of a device\" is not there; the take take_02 plays")));
}

TEST_F(SessionMaterial, AProjectOnTheGeneratedFightIsNotOpenedWithTheDance) {
  Material fight = built;
  fight.library = std::make_shared<const MotionLibrary>(
      *build_library("generated fight", {test::swinging_take("a", 60, 1)}, {}, {}));
  fight.is_generated = true;
  fight.manifest = nullptr;
  test::save(path, fight);
  EXPECT_EQ(opened()->library->name(), "generated fight");
}

TEST_F(SessionMaterial, AFileFromBeforeLibrariesWereNotedSaysWhichAnnotationsItCannotShow) {
  Project project;
  project.annotations = said();
  ASSERT_TRUE(save_project(path, project));
  const auto material = opened();
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_TRUE(material->is_generated);
  EXPECT_THAT(material->warnings, Contains(HasSubstr("take_01")));
}

TEST_F(SessionMaterial, ARecordingComesWithFramesLibraryAndProject) {
  test::record(path, built.library, "");
  test::save(path, built, said());
  const auto material = opened();
  ASSERT_TRUE(material) << material.error().text();
  ASSERT_TRUE(material->recorded);
  EXPECT_GT(material->recorded->contents.frames, 10U);
  const auto span = material->recorded->frames->span();
  EXPECT_FALSE(material->recorded->frames->frame(span.last_index)->result.edges.empty()) << "of the library";
  EXPECT_EQ(material->input.name, "take_02") << "it played when the session was saved, and goes on";
  EXPECT_FALSE(material->is_only_recorded());
  EXPECT_TRUE(material->project);
}

/// It said that the library was built again, at each opening.
TEST_F(SessionMaterial, FramesUnderRolesThatWereTakenBackAreNotThoseOfAnotherLibrary) {
  const LibraryTake& take = built.library->takes().front();
  const auto led_by_b = with_annotations(*built.library, {{take.name, {{{0, 20, ActivePerformer::B}}, {}}}});
  ASSERT_TRUE(led_by_b);
  test::record(path, built.library, "");
  test::record(path, std::make_shared<const MotionLibrary>(*led_by_b), "");
  test::save(path, built, said());
  const auto material = opened();
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_THAT(material->warnings, Contains(HasSubstr("while the takes had other roles")));
  EXPECT_THAT(material->warnings, Not(Contains(HasSubstr("built again"))));
}

TEST_F(SessionMaterial, ARecordingWithoutItsLibraryOpensOnlyWhenAPersonSaysSo) {
  test::record(path, built.library, "", {"take_02"});
  const auto refused = opened();
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("both files at once"));
  const auto material = opened({"", {}, true});
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_TRUE(material->stands_in);
  EXPECT_TRUE(material->is_only_recorded()) << "nothing was saved that could go on";
  EXPECT_EQ(material->input.name, "s");
  EXPECT_THAT(material->excluded_takes, IsEmpty()) << "the generated dance has no such take";
  EXPECT_THAT(material->warnings, Contains(HasSubstr("was not a file")));
}

/// What it was recorded with while its library was missing does not take the library's place.
TEST_F(SessionMaterial, ALibraryThatAnotherStoodInForIsAskedForAndThereAgain) {
  test::record(path, built.library, "");
  test::save(path, built, said());
  test::record(path, generated_dance({})->library, "");
  fs::rename(file("captures"), file("moved"));
  const auto without = opened({"", {}, true});
  ASSERT_TRUE(without) << without.error().text();
  EXPECT_TRUE(without->stands_in);
  Project saved_without;
  describe(*without, saved_without);
  EXPECT_EQ(saved_without.library, built.library->name());
  EXPECT_EQ(saved_without.input, "take_02");
  EXPECT_EQ(saved_without.manifest, without->project->project().manifest);
  EXPECT_THAT(saved_without.data, SizeIs(5));
  fs::rename(file("moved"), file("captures"));
  const auto again = opened();
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_FALSE(again->stands_in);
  EXPECT_EQ(library_fingerprint(*again->library), library_fingerprint(*built.library));
  EXPECT_EQ(again->input.name, "take_02");
  EXPECT_THAT(again->warnings, IsEmpty());
}

TEST_F(SessionMaterial, TheFileIsReadOnce) {
  test::record(path, built.library, "");
  test::save(path, built);
  const auto session = open_session(path);
  ASSERT_TRUE(session) << session.error().text();
  fs::remove(path);  // what is open stays readable
  const auto material = material_of(*session, {}, {});
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_TRUE(material->recorded->frames->frame(material->recorded->contents.last_frame));
}

TEST_F(SessionMaterial, AFileWithNothingInItIsRefused) {
  const auto recorder = Recorder::open(path, test::session_facts());
  ASSERT_TRUE((*recorder)->finish());
  const auto material = opened();
  ASSERT_FALSE(material);
  EXPECT_THAT(material.error().text(), HasSubstr("nothing was recorded into it"));
}

TEST_F(SessionMaterial, WhatWasKeptAgainstACrashBelongsToItsFileOnlyInItsFolder) {
  fs::create_directory(file("autosave"));
  Project project;
  project.view[autosaved_key] = path;
  const std::string kept = file("autosave/1.abrazo");
  ASSERT_TRUE(save_project(kept, project));
  EXPECT_EQ(open_session(kept, file("autosave"))->project->file, path);
  EXPECT_EQ(open_session(kept, file("autosave"))->project->autosave, kept);
  EXPECT_EQ(open_session(kept, file("elsewhere"))->project->file, kept);
  EXPECT_EQ(open_session(kept)->project->file, kept);
}

}  // namespace
}  // namespace abrazo::session_material_test
