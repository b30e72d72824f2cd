#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "core/annotation/suggestions.hpp"
#include "core/library/build/library_extension.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::mapped_library_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

constexpr LibraryReading map_all{.largest_in_memory_bytes = 0};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const MotionLibrary& dance() {
  static const MotionLibrary library = *build_library(
      "dance", {test::circling_take("first", 150), test::circling_take("second", 90, 0.6, 2)}, {}, {});
  return library;
}

/// A library that is mapped, in a folder of its own.
class MappedLibrary : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) /
             (std::string("abrazo_mapped_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    file = folder / "dance.h5";
    ASSERT_TRUE(write_library(dance(), file).ok());
  }
  void TearDown() override { fs::remove_all(folder); }

  MotionLibrary mapped() const {
    auto library = read_library(file, map_all);
    EXPECT_TRUE(library.ok()) << library.error().text();
    return std::move(library.value());
  }

  /// Writes one value of a table.
  void poke(const char* path, const std::vector<hsize_t>& at, double value) const {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t set = H5Dopen2(id, path, H5P_DEFAULT);
    const hid_t space = H5Dget_space(set);
    H5Sselect_elements(space, H5S_SELECT_SET, 1, at.data());
    const hsize_t one = 1;
    const hid_t single = H5Screate_simple(1, &one, nullptr);
    ASSERT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, single, space, H5P_DEFAULT, &value), 0);
    H5Sclose(single);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(id);
  }

  /// Writes the poses anew, stored in another way.
  void store_poses(hid_t type, bool compressed) const {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Ldelete(id, "pairs/pose", H5P_DEFAULT);
    const std::array<hsize_t, 3> shape = {static_cast<hsize_t>(dance().pair_count()), pair_vertex_count, 3};
    const std::array<hsize_t, 3> chunk = {16, pair_vertex_count, 3};
    const hid_t space = H5Screate_simple(3, shape.data(), nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    if (compressed) {
      H5Pset_chunk(creation, 3, chunk.data());
      H5Pset_deflate(creation, 6);
    }
    const hid_t set = H5Dcreate2(id, "pairs/pose", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    ASSERT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                       dance().columns().poses.front().data()),
              0);
    H5Dclose(set);
    H5Pclose(creation);
    H5Sclose(space);
    H5Fclose(id);
  }

  static void expect_same_pairs(const MotionLibrary& found, const MotionLibrary& wanted) {
    ASSERT_EQ(found.pair_count(), wanted.pair_count());
    for (int pair = 0; pair < wanted.pair_count(); ++pair) {
      ASSERT_EQ(found.pose(pair), wanted.pose(pair)) << pair;
      ASSERT_EQ(found.features(pair), wanted.features(pair));
      ASSERT_EQ(found.root(pair).position, wanted.root(pair).position);
      ASSERT_TRUE(std::ranges::equal(found.edges(pair), wanted.edges(pair)));
      ASSERT_TRUE(std::ranges::equal(found.tetrahedra(pair), wanted.tetrahedra(pair)));
    }
  }

  fs::path folder, file;
};

TEST_F(MappedLibrary, GivesTheSamePairsAsOneInMemory) {
  const MotionLibrary library = mapped();
  expect_same_pairs(library, dance());
  EXPECT_FALSE(library.damage());
}

TEST_F(MappedLibrary, LeavesPosesAndMeshesInTheFile) {
  const MotionLibrary library = mapped();
  const LibraryColumns& columns = library.columns();
  EXPECT_TRUE(columns.poses.is_view() && columns.features.is_view() && columns.edges.is_view() &&
              columns.tetrahedra.is_view());
  const std::uint64_t poses_and_meshes =
      columns.poses.size() * sizeof(PairPose) + columns.edges.size() * 2 + columns.tetrahedra.size() * 4;
  EXPECT_GT(mapped_bytes(library), poses_and_meshes);
  EXPECT_LT(mapped_bytes(library), fs::file_size(file));
}

TEST_F(MappedLibrary, IsNotWhatASmallFileBecomesUnasked) {
  const auto library = read_library(file);
  ASSERT_TRUE(library.ok());
  EXPECT_EQ(mapped_bytes(*library), 0U);
  EXPECT_EQ(library->columns().mapping, nullptr);
}

TEST_F(MappedLibrary, AFileIsMappedWhenItsPosesAndMeshesAreLargerThanAllowed) {
  const LibraryColumns& columns = dance().columns();
  const std::uint64_t poses_and_meshes =
      columns.poses.size() * sizeof(PairPose) + columns.edges.size() * 2 + columns.tetrahedra.size() * 4;
  EXPECT_EQ(mapped_bytes(*read_library(file, {.largest_in_memory_bytes = poses_and_meshes})), 0U);
  EXPECT_GT(mapped_bytes(*read_library(file, {.largest_in_memory_bytes = poses_and_meshes - 1})), 0U);
}

TEST_F(MappedLibrary, RefusesPosesThatAnotherProgramCompressedAndSaysHowToUndoIt) {
  store_poses(H5T_IEEE_F64LE, true);
  for (const LibraryReading& reading : {LibraryReading{}, map_all}) {
    const auto library = read_library(file, reading);
    ASSERT_FALSE(library.ok());
    EXPECT_THAT(library.error().text(),
                AllOf(HasSubstr("pairs/pose is compressed"), HasSubstr("h5repack -l CONTI -f NONE")));
  }
}

TEST_F(MappedLibrary, ReadsPosesThatAreStoredInOtherNumbers) {
  store_poses(H5T_IEEE_F64BE, false);
  const MotionLibrary library = mapped();
  EXPECT_FALSE(library.columns().poses.is_view());
  expect_same_pairs(library, dance());
}

TEST_F(MappedLibrary, ReplacedOrDeletedItStaysAsItWas) {
  const MotionLibrary library = mapped();
  ASSERT_TRUE(write_library(with_roles_exchanged(dance()), file).ok()) << "puts a new file in its place";
  expect_same_pairs(library, dance());
  fs::remove(file);
  expect_same_pairs(library, dance());
  EXPECT_FALSE(library.damage());
}

TEST_F(MappedLibrary, CutShortWhileInUseAnswersWithItsFirstPairAndSaysWhatHappened) {
  const MotionLibrary library = mapped();
  fs::resize_file(file, 4096);
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    ASSERT_EQ(library.pose(pair), dance().pose(0));
    ASSERT_TRUE(std::ranges::equal(library.edges(pair), dance().edges(0)));
    ASSERT_TRUE(std::ranges::equal(library.tetrahedra(pair), dance().tetrahedra(0)));
    ASSERT_TRUE(library.features(pair).allFinite());
  }
  ASSERT_TRUE(library.damage());
  EXPECT_THAT(library.damage()->text(), AllOf(HasSubstr("dance"), HasSubstr("was cut short while in use")));
}

TEST_F(MappedLibrary, WrittenToWhileInUseSaysSoBeforeAnyPairIsAskedFor) {
  const MotionLibrary library = mapped();
  fs::last_write_time(file, fs::last_write_time(file) - std::chrono::seconds(1));  // time need not pass
  poke("pairs/pose", {5, 0, 0}, 0.25);
  ASSERT_TRUE(library.damage());
  EXPECT_THAT(library.damage()->text(), HasSubstr("another program wrote to the library's file"));
}

TEST_F(MappedLibrary, GrownWhileInUseSaysSo) {
  const MotionLibrary library = mapped();
  fs::resize_file(file, fs::file_size(file) + 1);
  ASSERT_TRUE(library.damage());
  EXPECT_THAT(library.damage()->text(), HasSubstr("another program wrote"));
}

TEST_F(MappedLibrary, APairWithoutAPlaceIsAnsweredWithTheFirstAndNamed) {
  poke("pairs/pose", {7, 30, 1}, nan);
  const MotionLibrary library = mapped();
  EXPECT_FALSE(library.damage()) << "nobody looked at it yet";
  EXPECT_EQ(library.pose(6), dance().pose(6));
  EXPECT_EQ(library.pose(7), dance().pose(0));
  ASSERT_TRUE(library.damage());
  EXPECT_THAT(library.damage()->text(), HasSubstr("pair 7 is damaged"));
}

TEST_F(MappedLibrary, AnEdgeToNowhereIsNotFollowed) {
  poke("meshes/edges", {dance().columns().edge_offsets[4] + 3, 1}, 200);
  const MotionLibrary library = mapped();
  EXPECT_TRUE(std::ranges::equal(library.edges(4), dance().edges(0)));
  EXPECT_THAT(library.damage()->text(), HasSubstr("pair 4 is damaged"));
}

TEST_F(MappedLibrary, NorIsATetrahedronOfNoJoints) {
  poke("meshes/tetrahedra", {dance().columns().tetrahedron_offsets[9], 2}, 50);
  const MotionLibrary library = mapped();
  EXPECT_TRUE(std::ranges::equal(library.tetrahedra(9), dance().tetrahedra(0)));
  EXPECT_THAT(library.damage()->text(), HasSubstr("pair 9 is damaged"));
}

TEST_F(MappedLibrary, OfSeveralDamagedPairsTheOneFoundFirstIsNamed) {
  poke("pairs/pose", {3, 0, 0}, nan);
  poke("pairs/pose", {7, 0, 0}, nan);
  const MotionLibrary library = mapped();
  EXPECT_EQ(library.pose(7), dance().pose(0));
  EXPECT_EQ(library.pose(3), dance().pose(0));
  ASSERT_TRUE(library.damage());
  EXPECT_THAT(library.damage()->text(), HasSubstr("pair 7 is damaged"));
}

TEST_F(MappedLibrary, OffsetsThatChangeWhileInUseLeadNowhereElse) {
  const MotionLibrary library = mapped();
  poke("meshes/edge_offset", {6}, 1e15);
  EXPECT_TRUE(std::ranges::equal(library.edges(5), dance().edges(0))) << "its end is behind the file's";
  EXPECT_TRUE(std::ranges::equal(library.edges(6), dance().edges(0))) << "its begin is behind its end";
  EXPECT_TRUE(library.damage());
}

TEST_F(MappedLibrary, AnEmptyRowBehindTheFilesEndIsNotARowEither) {
  const MotionLibrary library = mapped();
  for (const char* offsets : {"meshes/edge_offset", "meshes/tetrahedron_offset"})
    for (const hsize_t end_of_row : {5, 6}) poke(offsets, {end_of_row}, 1e15);
  EXPECT_TRUE(std::ranges::equal(library.edges(5), dance().edges(0)));
  EXPECT_TRUE(std::ranges::equal(library.tetrahedra(5), dance().tetrahedra(0)));
}

TEST_F(MappedLibrary, IsRefusedWhenItsFirstPairHasMoreEdgesOrTetrahedraThanThereCanBe) {
  const LibraryColumns& columns = dance().columns();
  for (const auto& [table, offsets] : {std::pair("meshes/edge_offset", &columns.edge_offsets),
                                       {"meshes/tetrahedron_offset", &columns.tetrahedron_offsets}}) {
    ASSERT_TRUE(write_library(dance(), file).ok());
    // Still ascending: the first pair has the items of all, and the others have none.
    for (std::size_t pair = 1; pair + 1 < offsets->size(); ++pair)
      poke(table, {pair}, static_cast<double>(offsets->back()));
    const auto library = read_library(file, map_all);
    ASSERT_FALSE(library.ok()) << table;
    EXPECT_THAT(library.error().text(), HasSubstr("the first pair's pose or mesh is damaged"));
  }
}

TEST_F(MappedLibrary, IsRefusedWhenAlreadyItsFirstPairIsDamaged) {
  poke("pairs/pose", {0, 0, 0}, nan);
  const auto library = read_library(file, map_all);
  ASSERT_FALSE(library.ok());
  EXPECT_THAT(library.error().text(), HasSubstr("the first pair's pose or mesh is damaged"));
}

TEST_F(MappedLibrary, WithOffsetsOutOfOrderIsRefusedAsAnyOther) {
  poke("meshes/edge_offset", {6}, 1e15);
  const auto library = read_library(file, map_all);
  ASSERT_FALSE(library.ok());
  EXPECT_THAT(library.error().text(), HasSubstr("edge offsets are not ascending"));
}

TEST_F(MappedLibrary, CutShortBeforeItIsOpenedIsRefused) {
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_FALSE(read_library(file, map_all).ok());
}

TEST_F(MappedLibrary, WithRolesExchangedIsInMemoryAndTheSame) {
  const MotionLibrary exchanged = with_roles_exchanged(mapped());
  EXPECT_EQ(mapped_bytes(exchanged), 0U);
  expect_same_pairs(exchanged, with_roles_exchanged(dance()));
  fs::resize_file(file, 0);
  EXPECT_FALSE(exchanged.damage());
}

TEST_F(MappedLibrary, ExchangingTheRolesOfADamagedOneGoesOnAndItSaysSo) {
  poke("pairs/pose", {7, 30, 1}, nan);
  poke("meshes/edges", {dance().columns().edge_offsets[4] + 3, 1}, 200);
  const MotionLibrary library = mapped();
  const MotionLibrary exchanged = with_roles_exchanged(library), wanted = with_roles_exchanged(dance());
  EXPECT_TRUE(library.damage());
  EXPECT_TRUE(exchanged.damage()) << "what was copied stays as it was then";
  EXPECT_TRUE(std::ranges::equal(exchanged.edges(4), wanted.edges(0)));
  EXPECT_TRUE(std::ranges::equal(exchanged.edges(5), wanted.edges(5)));
  EXPECT_TRUE(exchanged.pose(7).allFinite());
  EXPECT_EQ(exchanged.pose(8), wanted.pose(8));
}

TEST_F(MappedLibrary, ADamagedOneIsNotExtended) {
  const MotionLibrary library = mapped();
  ASSERT_TRUE(extend_library(library, test::circling_take("third", 40), {}, {})) << "a whole one is";
  fs::resize_file(file, 4096);
  const auto extended = extend_library(library, test::circling_take("third", 40), {}, {});
  ASSERT_FALSE(extended.ok());
  EXPECT_THAT(extended.error().text(), HasSubstr("was cut short while in use"));
}

TEST_F(MappedLibrary, OfADamagedOneNothingIsSuggested) {
  PairedTake labelled = test::circling_take("first", 300), other = test::circling_take("second", 90, 0.6, 2);
  for (int begin = 0; begin < 300; begin += 60)
    labelled.labels.push_back({begin, begin + 60, begin % 120 == 0 ? "turn" : "step", "", ""});
  ASSERT_TRUE(write_library(*build_library("dance", {labelled, other}, {}, {}), file).ok());
  ASSERT_TRUE(suggest_annotations(mapped(), {.take = "second"}, {})) << "of a whole one there is";
  const MotionLibrary library = mapped();
  fs::resize_file(file, 4096);
  const auto suggested = suggest_annotations(library, {.take = "second"}, {});
  ASSERT_FALSE(suggested.ok());
  EXPECT_THAT(suggested.error().text(), HasSubstr("was cut short while in use"));
}

TEST_F(MappedLibrary, CanBeWrittenOverItsOwnFile) {
  const MotionLibrary library = mapped();
  ASSERT_TRUE(write_library(library, file).ok());
  expect_same_pairs(mapped(), dance());
  EXPECT_FALSE(library.damage());
}

TEST_F(MappedLibrary, DamagedIsNotWritten) {
  const MotionLibrary library = mapped();
  fs::resize_file(file, 4096);
  const fs::path copy = folder / "copy.h5";
  EXPECT_FALSE(write_library(library, copy).ok());
  EXPECT_FALSE(fs::exists(copy));
}

}  // namespace
}  // namespace abrazo::mapped_library_test
