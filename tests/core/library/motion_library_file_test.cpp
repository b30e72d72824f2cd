#include "core/library/store/motion_library_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/base/atomic_file.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "tests/core/library/synthetic_takes.hpp"
#include "tests/support/broken_world.hpp"

namespace abrazo::motion_library_file_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

MotionLibrary small_library() {
  PairedTake first = test::circling_take("first", 12);
  first.roles = {{0, 6, ActivePerformer::A}, {6, 9, ActivePerformer::B}};
  first.labels = {{0, 4, "turn", "follower right x1; hold Lr", "high"}, {4, 9, "Wärme", "", ""}};
  auto library =
      build_library("small \"library\"", {first, test::circling_take("second", 8, 0.6, 2)}, {}, {});
  return std::move(library.value());
}

/// A folder of its own per test, removed afterwards.
class MotionLibraryFile : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) /
             (std::string("abrazo_library_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    file = folder / "library.h5";
    ASSERT_TRUE(write_library(library, file).ok());
  }
  void TearDown() override { fs::remove_all(folder); }

  void expect_refused(const std::string& message) const {
    const auto read = read_library(file);
    ASSERT_FALSE(read.ok()) << "accepted; expected: " << message;
    EXPECT_EQ(read.error().where, file.string());
    EXPECT_THAT(read.error().message, HasSubstr(message));
  }

  // What damage can do to a file.
  void set_attribute(const char* name, int value) const {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t attribute = H5Aopen(id, name, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_INT, &value);
    H5Aclose(attribute);
    H5Fclose(id);
  }
  void remove(const char* path) const {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Ldelete(id, path, H5P_DEFAULT);
    H5Fclose(id);
  }
  /// Replaces a dataset by one of another shape, whose values are zeros or, for `values` = null, are not
  /// there at all.
  void reshape(const char* path, const std::vector<hsize_t>& shape, hid_t type, bool with_values) const {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Ldelete(id, path, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t set = H5Dcreate2(id, path, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    hsize_t count = 1;
    for (const hsize_t size : shape) count *= size;
    if (with_values) {
      const std::vector<double> zeros(count);
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
    }
    H5Dclose(set);
    H5Sclose(space);
    H5Fclose(id);
  }
  /// Changes the value at one place of a dataset.
  /// Every place in the file that holds one number, of 8 bytes, holds the other. @return how many
  int replace_numbers(std::uint64_t from, std::uint64_t to) const {
    std::ifstream in(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    in.close();
    std::string number(8, '\0'), other(8, '\0');
    std::memcpy(number.data(), &from, 8);
    std::memcpy(other.data(), &to, 8);
    int count = 0;
    for (std::size_t at = bytes.find(number); at != std::string::npos; at = bytes.find(number, at + 8)) {
      bytes.replace(at, 8, other);
      ++count;
    }
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    return count;
  }

  void poke(const char* path, const std::vector<hsize_t>& at, double value) const {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t set = H5Dopen2(id, path, H5P_DEFAULT);
    const hid_t space = H5Dget_space(set);
    H5Sselect_elements(space, H5S_SELECT_SET, 1, at.data());
    const hsize_t one = 1;
    const hid_t single = H5Screate_simple(1, &one, nullptr);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, single, space, H5P_DEFAULT, &value);
    H5Sclose(single);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(id);
  }

  const MotionLibrary library = small_library();
  fs::path folder, file;
};

TEST_F(MotionLibraryFile, GivesBackWhatWasWritten) {
  const auto read = read_library(file);
  ASSERT_TRUE(read.ok()) << read.error().text();
  const LibraryColumns& before = library.columns();
  const LibraryColumns& after = read->columns();
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.rate_hz, before.rate_hz);
  EXPECT_EQ(after.edge_offsets, before.edge_offsets);
  EXPECT_EQ(after.edges, before.edges);
  EXPECT_EQ(after.tetrahedron_offsets, before.tetrahedron_offsets);
  EXPECT_EQ(after.tetrahedra, before.tetrahedra);
  EXPECT_EQ(after.mesh_quality, before.mesh_quality);
  ASSERT_EQ(after.sources.size(), before.sources.size());
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    EXPECT_EQ(read->pose(pair), library.pose(pair));
    EXPECT_EQ(read->features(pair), library.features(pair));
    EXPECT_EQ(read->root(pair).position, library.root(pair).position);
    EXPECT_EQ(read->root(pair).heading_rad, library.root(pair).heading_rad);
    EXPECT_EQ(read->source(pair).take, library.source(pair).take);
    EXPECT_EQ(read->source(pair).frame, library.source(pair).frame);
    EXPECT_EQ(read->source(pair).swapped, library.source(pair).swapped);
    EXPECT_EQ(read->source(pair).annotated, library.source(pair).annotated);
    EXPECT_EQ(read->label(pair), library.label(pair));
  }
}

TEST_F(MotionLibraryFile, GivesBackTakesRolesLabelsAndBodies) {
  const auto read = read_library(file);
  ASSERT_TRUE(read.ok()) << read.error().text();
  ASSERT_EQ(read->takes().size(), 2U);
  for (std::size_t t = 0; t < 2; ++t) {
    const LibraryTake& before = library.takes()[t];
    const LibraryTake& after = read->takes()[t];
    EXPECT_EQ(after.name, before.name);
    EXPECT_EQ(after.fps, before.fps);
    EXPECT_EQ(after.frames, before.frames);
    EXPECT_EQ(after.frame_stride, before.frame_stride);
    EXPECT_EQ(after.body_a, before.body_a);
    EXPECT_EQ(after.body_b, before.body_b);
  }
  ASSERT_EQ(read->takes()[0].roles.size(), 2U);
  EXPECT_EQ(read->takes()[0].roles[1].start, 6);
  EXPECT_EQ(read->takes()[0].roles[1].active, ActivePerformer::B);
  ASSERT_EQ(read->takes()[0].labels.size(), 2U);
  EXPECT_EQ(read->takes()[0].labels[0].detail, "follower right x1; hold Lr");
  EXPECT_EQ(read->takes()[0].labels[0].confidence, "high");
  EXPECT_EQ(read->takes()[0].labels[1].label, "Wärme");
  ASSERT_EQ(read->bodies().size(), library.bodies().size());
  for (std::size_t b = 0; b < library.bodies().size(); ++b) {
    EXPECT_EQ(read->bodies()[b].name, library.bodies()[b].name);
    EXPECT_EQ(read->bodies()[b].body.bone_lengths, library.bodies()[b].body.bone_lengths);
    EXPECT_EQ(read->bodies()[b].body.pseudo_lengths, library.bodies()[b].body.pseudo_lengths);
    EXPECT_EQ(read->bodies()[b].body.toe_rest_height, library.bodies()[b].body.toe_rest_height);
    EXPECT_EQ(read->bodies()[b].capsule_radii, library.bodies()[b].capsule_radii);
  }
}

TEST_F(MotionLibraryFile, KeepsALibraryWithoutRolesAndLabels) {
  auto plain = build_library("plain", {test::circling_take("t", 4)}, {}, {});
  ASSERT_TRUE(plain.ok());
  ASSERT_TRUE(write_library(*plain, file).ok());
  const auto read = read_library(file);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_TRUE(read->takes()[0].labels.empty());
  EXPECT_EQ(read->pair_count(), 8);
}

TEST_F(MotionLibraryFile, HasTheSameBytesEveryTime) {
  ASSERT_TRUE(write_library(library, folder / "again.h5").ok());
  EXPECT_EQ(*read_whole_file(file), *read_whole_file(folder / "again.h5"));
}

TEST_F(MotionLibraryFile, KeepsNoTimes) {
  // They would make two files of the same library differ.
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5O_info_t info{};
#if H5_VERSION_GE(1, 12, 0)
  EXPECT_GE(H5Oget_info_by_name(id, "pairs/pose", &info, H5O_INFO_TIME, H5P_DEFAULT), 0);
#else
  EXPECT_GE(H5Oget_info_by_name2(id, "pairs/pose", &info, H5O_INFO_TIME, H5P_DEFAULT), 0);
#endif
  EXPECT_EQ(info.ctime, 0);
  EXPECT_EQ(info.mtime, 0);
  H5Fclose(id);
}

TEST_F(MotionLibraryFile, LeavesNothingBehindWhenItCannotBeWritten) {
  const Status written = write_library(library, folder / "missing" / "library.h5");
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error().text(), HasSubstr("library.h5: cannot be created: No such file or directory"));
  const Status onto_folder = write_library(library, folder);
  EXPECT_FALSE(onto_folder.ok());
}

TEST_F(MotionLibraryFile, LeavesNothingBehindWhenWritingIsCancelled) {
  const std::string before = *read_whole_file(file);
  const Status written =
      write_library(library, file, [](double fraction, std::string_view) { return fraction < 0.05; });
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().message, "cancelled");
  EXPECT_EQ(*read_whole_file(file), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(MotionLibraryFile, RefusesAFileThatIsNotThere) {
  fs::remove(file);
  expect_refused("cannot be opened: No such file or directory");
}

TEST_F(MotionLibraryFile, RefusesAFolder) {
  fs::remove(file);
  fs::create_directory(file);
  expect_refused("is a folder");
}

TEST_F(MotionLibraryFile, RefusesWhatIsNotHdf5) {
  std::ofstream(file, std::ios::trunc) << "name,value\nno,library\n";
  expect_refused("is not an HDF5 file");
}

TEST_F(MotionLibraryFile, RefusesAnEmptyFile) {
  std::ofstream(file, std::ios::trunc).flush();
  expect_refused("is not an HDF5 file");
}

TEST_F(MotionLibraryFile, RefusesHdf5OfSomeoneElse) {
  fs::remove(file);
  H5Fclose(H5Fcreate(file.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT));
  expect_refused("is HDF5 but not an Abrazo motion library");
}

TEST_F(MotionLibraryFile, RefusesANewerVersionAndNamesItsWriter) {
  set_attribute("format_version", 2);
  expect_refused("has format version 2, this program reads up to 1; it was written by abrazo ");
}

TEST_F(MotionLibraryFile, RefusesAFileCutShortAnywhere) {
  const std::string whole = *read_whole_file(file);
  for (const double fraction : {0.999, 0.9, 0.5, 0.1, 0.01}) {
    const auto size = static_cast<std::size_t>(fraction * static_cast<double>(whole.size()));
    std::ofstream(file, std::ios::binary | std::ios::trunc) << whole.substr(0, size);
    expect_refused("is cut short or damaged");
  }
}

TEST_F(MotionLibraryFile, RefusesAMissingTable) {
  remove("pairs/features");
  expect_refused("pairs/features is missing or damaged");
}

TEST_F(MotionLibraryFile, RefusesTablesOfTheWrongShape) {
  reshape("pairs/pose", {static_cast<hsize_t>(library.pair_count()), 48, 3}, H5T_IEEE_F64LE, true);
  expect_refused("pairs/pose is " + std::to_string(library.pair_count()) + " x 48 x 3, expected " +
                 std::to_string(library.pair_count()) + " x 50 x 3");
}

TEST_F(MotionLibraryFile, RefusesTablesOfTheWrongLength) {
  reshape("pairs/features", {static_cast<hsize_t>(library.pair_count() - 1), 15}, H5T_IEEE_F64LE, true);
  expect_refused("pairs/features is " + std::to_string(library.pair_count() - 1) + " x 15, expected");
}

TEST_F(MotionLibraryFile, RefusesTablesOfTheWrongKind) {
  reshape("pairs/features", {static_cast<hsize_t>(library.pair_count()), 15}, H5T_STD_I32LE, true);
  expect_refused("pairs/features does not hold real numbers");
}

TEST_F(MotionLibraryFile, RefusesImpossibleSizesBeforeAllocating) {
  // 64 TiB of tetrahedra that nobody has written.
  reshape("meshes/tetrahedra", {hsize_t{1} << 44, 4}, H5T_STD_U8LE, false);
  expect_refused("meshes/tetrahedra says it is 17592186044416 x 4 but the file holds only 0 values of it");
}

TEST_F(MotionLibraryFile, RefusesSizesThatAFileOnlyClaimsBeforeAllocating) {
  // 2 TiB of edges: shape and length of the table say so, and some kilobytes are there.
  const std::uint64_t rows = library.columns().edges.size();
  constexpr std::uint64_t claimed = std::uint64_t{1} << 40;
  EXPECT_GT(replace_numbers(rows, claimed), 0) << "the shape";
  EXPECT_GT(replace_numbers(2 * rows, 2 * claimed), 0) << "the length";
  // HDF5 1.14 itself does not open such a table.
  expect_refused(H5_VERSION_GE(1, 14, 0) ? "meshes/edges is missing or damaged"
                                         : "meshes/edges claims 2199023255552 bytes but the file has ");
}

TEST_F(MotionLibraryFile, RefusesAPipeInsteadOfWaitingForItsWriter) {
  fs::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  expect_refused("is a pipe or a device; name a file");
}

TEST_F(MotionLibraryFile, RefusesOffsetsThatDescend) {
  poke("meshes/edge_offset", {3}, 0);
  expect_refused("does not fit together: edge offsets are not ascending");
}

TEST_F(MotionLibraryFile, RefusesOffsetsBeyondTheTable) {
  poke("meshes/tetrahedron_offset", {static_cast<hsize_t>(library.pair_count())}, 1e12);
  expect_refused("tetrahedron offsets are not ascending from 0 to the number of tetrahedra");
}

TEST_F(MotionLibraryFile, RefusesVerticesThatDoNotExist) {
  poke("meshes/edges", {5, 1}, 50);
  expect_refused("an edge names a vertex that does not exist");
}

TEST_F(MotionLibraryFile, RefusesTakesBodiesAndRolesThatDoNotExist) {
  poke("pairs/source", {2, 2}, 7);
  expect_refused("pairs/source says swapped = 7");
  poke("pairs/source", {2, 2}, 0);
  poke("pairs/source", {2, 3}, 3);
  expect_refused("pairs/source holds 3; expected 0 (a), 1 (b) or 2 (unknown)");
  poke("pairs/source", {2, 3}, 0);
  poke("labels/take", {1}, 9);
  expect_refused("labels/take names take 9, there are 2");
  poke("labels/take", {1}, 0);
  poke("takes/body_a", {0}, 5);
  expect_refused("a take names a body that does not exist");
}

TEST_F(MotionLibraryFile, RefusesPositionsThatAreNotFinite) {
  poke("pairs/pose", {4, 7, 1}, std::numeric_limits<double>::quiet_NaN());
  expect_refused("a position is not a finite number");
}

// What a stranger's file must not make the program read.

TEST_F(MotionLibraryFile, ALinkToAnotherFileIsNotFollowed) {
  const fs::path other = folder / "other.h5";
  fs::copy_file(file, other);
  remove("pairs/pose");
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Lcreate_external(other.c_str(), "/pairs/pose", id, "/pairs/pose", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(id);
  expect_refused("pairs/pose is a link to another place");
}

TEST_F(MotionLibraryFile, NorIsOneThatAGroupHidesBehind) {
  const fs::path other = folder / "other.h5";
  fs::copy_file(file, other);
  remove("meshes");
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Lcreate_external(other.c_str(), "/meshes", id, "/meshes", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(id);
  expect_refused("meshes is a link to another place");
}

TEST_F(MotionLibraryFile, NorIsADescriptionThatStandsElsewhere) {
  remove("bodies/bone_lengths");
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t type = H5Tcopy(H5T_IEEE_F64LE);
  H5Tcommit2(id, "/a type", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const std::array<hsize_t, 2> sizes = {2, 24};
  const hid_t space = H5Screate_simple(2, sizes.data(), nullptr);
  H5Dclose(H5Dcreate2(id, "/bodies/bone_lengths", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Sclose(space);
  H5Tclose(type);
  H5Fclose(id);
  expect_refused("bodies/bone_lengths has parts of its description elsewhere");
}

TEST_F(MotionLibraryFile, ASoftLinkIsNotFollowed) {
  remove("pairs/features");
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Lcreate_soft("/pairs/features", id, "/pairs/features", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(id);
  expect_refused("pairs/features is a link to another place");
}

TEST_F(MotionLibraryFile, NumbersThatLieInAnotherFileAreNotRead) {
  const auto pairs = static_cast<hsize_t>(library.pair_count());
  const std::vector<hsize_t> shape{pairs, pair_vertex_count, 3};
  const fs::path secret = folder / "secret";
  ASSERT_TRUE(write_whole_file(secret, std::string(pairs * pair_vertex_count * 3 * sizeof(double), 'x')));
  remove("pairs/pose");
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(3, shape.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(creation, secret.c_str(), 0, H5F_UNLIMITED);
  const hid_t set = H5Dcreate2(id, "/pairs/pose", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  ASSERT_GE(set, 0);
  H5Dclose(set);
  H5Pclose(creation);
  H5Sclose(space);
  H5Fclose(id);
  expect_refused("pairs/pose is kept in other files");
}

TEST_F(MotionLibraryFile, ATableMadeOfOtherFilesTablesIsNotRead) {
  const fs::path other = folder / "other.h5";
  fs::copy_file(file, other);
  const auto pairs = static_cast<hsize_t>(library.pair_count());
  const std::vector<hsize_t> shape{pairs, pair_vertex_count, 3};
  remove("pairs/pose");
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(3, shape.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_virtual(creation, space, other.c_str(), "/pairs/pose", space);
  const hid_t set = H5Dcreate2(id, "/pairs/pose", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  ASSERT_GE(set, 0);
  H5Dclose(set);
  H5Pclose(creation);
  H5Sclose(space);
  H5Fclose(id);
  expect_refused("pairs/pose is kept in other files");
}

TEST_F(MotionLibraryFile, OnAFullDiskTheOldFileStaysWhole) {
  {
    const test::LimitedFiles full(4096);
    const Status written = write_library(library, file);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), AllOf(HasSubstr("library.h5"), HasSubstr("full")));
  }
  EXPECT_TRUE(read_library(file).ok());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1)
      << "nothing half done is left";
  EXPECT_TRUE(write_library(library, file).ok()) << "and with space again it works";
}

TEST_F(MotionLibraryFile, OnceReadItsFileMayBeReplacedCutShortOrDeleted) {
  const auto read = read_library(file);
  ASSERT_TRUE(read.ok());
  fs::resize_file(file, 100);
  EXPECT_EQ(read->pose(3), library.pose(3));
  ASSERT_TRUE(write_whole_file(file, "no library"));
  EXPECT_EQ(read->pose(5), library.pose(5));
  fs::remove(file);
  for (int pair = 0; pair < library.pair_count(); ++pair) EXPECT_EQ(read->pose(pair), library.pose(pair));
}

}  // namespace
}  // namespace abrazo::motion_library_file_test
