// Where the library of a session is found, and that it is the one its frames were solved with.
#include "core/opening/library_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/annotation/annotated_library.hpp"
#include "core/opening/generated_set.hpp"
#include "core/session/file/library_reference.hpp"
#include "tests/core/opening/opening_files.hpp"

namespace abrazo::library_search_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace fs = std::filesystem;

class LibrarySearchTest : public ::testing::Test, protected test::TemporaryFolder {
 protected:
  LibrarySearchTest() { fs::create_directory(file("data")); }

  /// What is known of the recorded session, as it is opened.
  LibraryClues clues() const {
    const auto session = open_session(path);
    EXPECT_TRUE(session) << session.error().text();
    return {path, session->recording.contents.libraries, session->project, "", {}};
  }
  Result<FoundLibrary> found(LibraryClues of) const {
    const SessionLibrary reference = of.references.back();
    return LibrarySearch(std::move(of)).find(&reference);
  }
  static bool is(const Result<FoundLibrary>& found, const test::LibraryPtr& library) {
    return found && found->fits &&
           library_fingerprint(*found->material.library) == library_fingerprint(*library);
  }

  const std::string path = file("s.abrazo");
  const std::string library_file = file("data/small.h5");
  const test::LibraryPtr small = test::session_library();
};

TEST_F(LibrarySearchTest, WhereItWasWhenItWasRecorded) {
  ASSERT_TRUE(write_library(*small, library_file));
  test::record(path, small, library_file);
  const auto library = found(clues());
  EXPECT_TRUE(is(library, small));
  EXPECT_EQ(library->material.library_file, library_file);
}

TEST_F(LibrarySearchTest, BesideTheSessionWhenBothWereMoved) {
  ASSERT_TRUE(write_library(*small, library_file));
  test::record(path, small, library_file);
  LibraryClues moved = clues();
  fs::create_directories(file("elsewhere"));
  fs::rename(file("data"), file("elsewhere/data"));
  moved.session = file("elsewhere/s.abrazo");
  EXPECT_EQ(found(moved)->material.library_file, file("elsewhere/data/small.h5"));
}

TEST_F(LibrarySearchTest, AGivenOneGoesBeforeAllOthersAndIsSaidToBeAnother) {
  ASSERT_TRUE(write_library(*small, library_file));
  test::record(path, small, library_file);
  LibraryClues given = clues();
  given.given = test::two_takes(*this);  // a manifest will do as well
  const auto another = found(given);
  ASSERT_TRUE(another) << another.error().text();
  ASSERT_FALSE(another->fits);
  EXPECT_THAT(another->fits.error().text(), HasSubstr("other content"));
  given.given = file("none.h5");
  EXPECT_THAT(found(given).error().text(), HasSubstr("none.h5"));
}

TEST_F(LibrarySearchTest, WhatIsOpenWhenItHasTheContent) {
  test::record(path, small, "");
  LibraryClues open = clues();
  EXPECT_THAT(found(open).error().text(), HasSubstr("\"small\", which was not a file"));
  open.open.library = small;
  EXPECT_TRUE(is(found(open), small));
}

TEST_F(LibrarySearchTest, TheFileThatTheProjectNames) {
  test::record(path, small, "");
  ASSERT_TRUE(write_library(*small, library_file));
  Material material;
  material.library = small;
  material.library_file = library_file;
  test::save(path, material);
  EXPECT_TRUE(is(found(clues()), small));
}

TEST_F(LibrarySearchTest, BuiltAgainFromTheManifestThatTheProjectKeeps) {
  const Material built = test::built_of(test::two_takes(*this));
  test::record(path, built.library, "");
  test::save(path, built);
  const auto again = found(clues());
  EXPECT_TRUE(is(again, built.library));
  ASSERT_TRUE(again->material.manifest);
  EXPECT_EQ(again->material.library_file, "");
  fs::remove(file("captures/take_01_a.bvh"));
  const auto without = found(clues());
  ASSERT_FALSE(without);
  EXPECT_THAT(without.error().text(), HasSubstr("cannot be built again"));
  EXPECT_THAT(without.error().text(), HasSubstr("take_01_a.bvh is not there"));
}

TEST_F(LibrarySearchTest, WithWhatWasSaidOfItsTakes) {
  const AnnotationBook book = {{"first", test::said_of(*small, "first", "dip")}};
  const LibraryTake& take = small->takes().front();
  const auto said = take_annotation(book.at("first"), take.fps, take.frames);
  const auto annotated = std::make_shared<const MotionLibrary>(*with_annotations(*small, {{"first", *said}}));
  ASSERT_TRUE(write_library(*small, library_file));
  test::record(path, annotated, "");
  Material material;
  material.library = small;
  material.library_file = library_file;
  test::save(path, material, book);
  const auto library = found(clues());
  EXPECT_TRUE(is(library, annotated));
  ASSERT_TRUE(library->material.unannotated) << "earlier frames may be of it";
  EXPECT_EQ(library_fingerprint(*library->material.unannotated), library_fingerprint(*small));
}

TEST_F(LibrarySearchTest, GeneratedAgainByItsName) {
  const auto fight = generated_fight({});
  test::record(path, fight->library, "");
  const auto library = found(clues());
  EXPECT_TRUE(is(library, fight->library));
  EXPECT_TRUE(library->material.is_generated);
}

TEST_F(LibrarySearchTest, OneThatWasBuiltAnewIsTakenAndSaidToBeAnother) {
  ASSERT_TRUE(write_library(*small, library_file));
  test::record(path, small, library_file);
  ASSERT_TRUE(write_library(*build_library(small->name(), {test::swinging_take("first", 90, 7)}, {}, {}),
                            library_file));
  const auto another = found(clues());
  ASSERT_TRUE(another) << another.error().text();
  EXPECT_FALSE(another->fits);
  const auto session = SessionFile::open(path);
  const auto strict = library_opener(*session, "", "; say where")(&(*session)->contents().libraries.back());
  ASSERT_FALSE(strict) << "what goes through a session takes no other";
  EXPECT_THAT(strict.error().text(), HasSubstr("other content"));
  EXPECT_THAT(strict.error().text(), HasSubstr("; say where"));
}

TEST_F(LibrarySearchTest, WhereNoneIsTheErrorSaysWhereItWasLookedFor) {
  test::record(path, small, library_file);
  const auto none = found(clues());
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().text(), HasSubstr(library_file + " and is not there"));
}

TEST_F(LibrarySearchTest, AllOfASessionAreFoundAndTheMissingOnesAreNamed) {
  const auto other = std::make_shared<const MotionLibrary>(
      *build_library("other", {test::swinging_take("third", 60, 3)}, {}, {}));
  const std::string first = file("first.h5"), second = file("second.h5");
  ASSERT_TRUE(write_library(*small, first));
  ASSERT_TRUE(write_library(*other, second));
  test::record(path, small, first);
  test::record(path, other, second);
  std::vector<std::string> warnings;
  const auto all = LibrarySearch(clues()).all(warnings);
  ASSERT_TRUE(all) << all.error().text();
  ASSERT_THAT(*all, SizeIs(2));
  EXPECT_THAT(warnings, IsEmpty());
  fs::remove(first);
  LibraryClues given = clues();
  given.given = second;
  const auto left = LibrarySearch(given).all(warnings);
  ASSERT_TRUE(left);
  ASSERT_THAT(*left, SizeIs(1));
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_THAT(warnings, Contains(HasSubstr("first.h5")));
  EXPECT_THAT(warnings, Contains(HasSubstr("have no mesh")));
}

}  // namespace
}  // namespace abrazo::library_search_test
