#include "core/opening/open_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/opening/generated_set.hpp"
#include "core/opening/joint_maps.hpp"
#include "core/opening/prepared_solver.hpp"
#include "tests/core/opening/opening_files.hpp"

namespace abrazo::open_files_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class OpenFiles : public ::testing::Test, protected test::TemporaryFolder {
 protected:
  Result<Material> opened(const std::vector<std::string>& files, const Material& open = {}) const {
    return open_files({recognised(files), open, "", "", {}}, {});
  }
  const std::string manifest = test::two_takes(*this);
  const std::string motion = file("captures/take_01_a.bvh");
};

TEST_F(OpenFiles, OfALibraryTheLastTakePlaysTheUser) {
  const auto material = opened({manifest});
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_EQ(material->library_file, manifest);
  EXPECT_EQ(material->input.name, "take_02");
  EXPECT_THAT(material->excluded_takes, ElementsAre("take_02"));
  EXPECT_FALSE(material->has_unsaved_library());
  EXPECT_FALSE(material->is_input_asked) << "it came with the library";
}

TEST_F(OpenFiles, AMotionReplacesTheUserAndKeepsTheLibrary) {
  Material open = *opened({manifest});
  const auto material = opened({motion}, open);
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_EQ(material->library, open.library);
  EXPECT_EQ(material->library_file, manifest);
  EXPECT_THAT(material->input_files(), ElementsAre(motion));
  EXPECT_THAT(material->excluded_takes, IsEmpty());
  EXPECT_TRUE(material->is_input_asked);
  EXPECT_TRUE(opened({motion, manifest})->is_input_asked) << "with another library, too";
  EXPECT_FALSE(opened({manifest}, *material)->is_input_asked);
}

/// Frames of 60 Hz that are played at a guessed 120 dance twice as fast as the library's takes beside them.
TEST_F(OpenFiles, WhatAMotionDoesNotSayIsReadAsTheLibraryOfItsFolderWas) {
  Manifest timed = *read_manifest(manifest);
  for (Manifest::Take& take : timed.takes) take.fps = 50;
  const std::string library = file("timed.json");
  ASSERT_TRUE(write_whole_file(library, manifest_json(timed, std::filesystem::path(library).parent_path())));
  std::string text = *read_whole_file(motion);
  const std::size_t at = text.find("Frame Time:");
  text.replace(at, text.find('\n', at) - at, "Frame Time: 0");
  const std::string untimed = file("captures/untimed.bvh");
  ASSERT_TRUE(write_whole_file(untimed, text));
  EXPECT_EQ(opened({untimed})->input.fps, 120) << "guessed";
  const auto together = opened({untimed, library});
  ASSERT_TRUE(together) << together.error().text();
  EXPECT_EQ(together->input.fps, 50);
  EXPECT_THAT(together->warnings,
              Contains(HasSubstr("read as the takes of the library: 50 frames per second")));
  EXPECT_EQ(opened({untimed}, *opened({library}))->input.fps, 50) << "the open library, too";
  EXPECT_EQ(opened({motion, library})->input.fps, opened({motion})->input.fps) << "what the file says holds";
}

TEST_F(OpenFiles, AGuessedRateThatIsNotThatOfTheLibrarysTakesIsToldFirst) {
  std::string text = *read_whole_file(motion);
  const std::size_t at = text.find("Frame Time:");
  text.replace(at, text.find('\n', at) - at, "Frame Time: 0");
  const std::string untimed = file("captures/untimed.bvh"), library = file("alone.h5");
  ASSERT_TRUE(write_whole_file(untimed, text));
  ASSERT_TRUE(write_library(*test::built_of(manifest).library, library));
  const auto material = opened({untimed, library});
  ASSERT_TRUE(material) << material.error().text();
  const double rate = material->library->takes().front().fps;
  ASSERT_NE(material->input.fps, rate);
  EXPECT_THAT(material->warnings.front(), HasSubstr(fmt::format("the takes of the library have {}", rate)));
  EXPECT_THAT(opened({motion, library})->warnings, Not(Contains(HasSubstr("the takes of the library have"))));
}

TEST_F(OpenFiles, AMotionByItselfIsAnsweredByTheGeneratedDanceWhichIsSaid) {
  const auto material = opened({motion});
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_TRUE(material->is_generated);
  EXPECT_THAT(material->input_files(), ElementsAre(motion));
  EXPECT_THAT(material->warnings, Contains(HasSubstr("a generated dance answers")));
}

TEST_F(OpenFiles, ASessionIsOpenedWithTheLibraryBesideItInTheList) {
  const Material built = test::built_of(manifest);
  test::record(file("s.abrazo"), built.library, "");
  const auto alone = opened({file("s.abrazo")});
  ASSERT_FALSE(alone);
  EXPECT_THAT(alone.error().text(), HasSubstr("both files at once"));
  const auto together = opened({file("s.abrazo"), manifest});
  ASSERT_TRUE(together) << together.error().text();
  EXPECT_TRUE(together->recorded);
  EXPECT_EQ(together->library_file, manifest);
}

TEST_F(OpenFiles, WhatIsOpenIsNotChangedByAFileThatCannotBeRead) {
  const auto material = opened({manifest, file("none.bvh")});
  ASSERT_FALSE(material);
  EXPECT_THAT(material.error().text(), HasSubstr("none.bvh"));
}

TEST_F(OpenFiles, AJointMapThatWasRememberedIsTriedWhereNoneFits) {
  const std::string arm = std::string(ABRAZO_FIXTURES) + "/motion/arm.bvh";
  const UnmappedMotion unmapped = motion_to_map({arm}, file("maps"));
  ASSERT_TRUE(unmapped);
  JointMap map = builtin_joint_maps().front();
  map.name = "arm";
  for (auto& rules : map.rules) rules = {JointRule{{{unmapped->points.front(), 1.0}}}};
  const auto kept = remember_map(map, file("maps"));
  ASSERT_TRUE(kept) << kept.error().text();
  EXPECT_EQ(motion_to_map({arm}, file("maps")), nullptr);
  const auto refused = open_files({recognised({arm, manifest}), {}, "", "", {}}, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("no joint map fits"));
  const auto tried = open_files({recognised({arm, manifest}), {}, file("maps"), "", {}}, {});
  EXPECT_TRUE(tried || tried.error().text().find("no joint map fits") == std::string::npos)
      << tried.error().text();
}

/// A session whose library was moved, and a question that counts and answers with the new place.
class MovedLibrary : public OpenFiles {
 protected:
  MovedLibrary() {
    Material built = test::built_of(manifest);
    built.library_file = file("lib.h5");
    EXPECT_TRUE(write_library(*built.library, built.library_file));
    test::save(path, built);
    std::filesystem::rename(built.library_file, moved);
  }
  Result<Material> opened_asking(std::vector<std::string> files, std::optional<Places> answer) {
    OpeningWish wish{recognised(files), {}, "", "", {}};
    wish.locate = [this, answer](const auto& project, const Progress&) {
      ++asked;
      missing = project->missing();
      return answer;
    };
    return open_files(wish, {});
  }
  const std::string path = file("s.abrazo"), moved = file("moved.h5");
  int asked = 0;
  std::vector<std::size_t> missing;
};

TEST_F(MovedLibrary, IsAskedForOnceAndOpenedFromTheAnsweredPlace) {
  const auto material = opened_asking({path}, Places{{0, moved}});
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_EQ(asked, 1);
  EXPECT_THAT(missing, ElementsAre(0U));
  EXPECT_EQ(material->library_file, moved);
  EXPECT_THAT(material->warnings, IsEmpty());
}

TEST_F(MovedLibrary, IsReplacedByTheGeneratedDanceIfThePersonDoesWithoutIt) {
  const auto material = opened_asking({path}, Places{{0, ""}});
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_TRUE(material->stands_in);
}

TEST_F(MovedLibrary, IsNotOpenedIfThePersonCancels) {
  const auto material = opened_asking({path}, std::nullopt);
  ASSERT_FALSE(material);
  EXPECT_EQ(material.error().message, "cancelled");
}

TEST_F(MovedLibrary, IsNotAskedForIfALibraryIsOpenedWithTheSession) {
  const auto material = opened_asking({path, moved}, std::nullopt);
  ASSERT_TRUE(material) << material.error().text();
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(material->library_file, moved);
}

TEST_F(OpenFiles, VideosOfAProjectAreWhereTheyWereFoundOrWereLast) {
  OpenedProject project;
  for (const char* name : {"here.mp4", "gone.mp4"}) {
    project.reading.project.data.push_back({});
    project.reading.project.data.back().use = DataReference::Use::Video;
    project.reading.project.data.back().absolute_path = std::string("/then/") + name;
    project.found.emplace_back();
  }
  project.found[0].path = "/now/here.mp4";
  for (const int data : {1, -1, 0, 2}) {
    project.reading.project.videos.emplace_back();
    project.reading.project.videos.back().data = data;
  }
  EXPECT_THAT(project.video_places(), ElementsAre("/then/gone.mp4", "", "/now/here.mp4", ""));
}

TEST_F(OpenFiles, AMotionWithoutFramesIsRefusedBeforeTheSessionEnds) {
  Material material = *opened({manifest});
  material.input.poses.clear();
  const auto refused = prepare_solver(material, *preset("responsive"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("no frames; open another one"));
  material.recorded = std::make_shared<const RecordedSession>();
  EXPECT_TRUE(prepare_solver(material, *preset("responsive"))) << "its frames are the recorded ones";
}

}  // namespace
}  // namespace abrazo::open_files_test
