#include "core/motion/numpy/numpy_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/files/format_recognition.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/numpy/npy_array.hpp"
#include "core/motion/numpy/numpy_writer.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/core/motion/numpy_fixtures.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/numpy_python.hpp"

namespace abrazo::numpy_reader_test {
namespace {

using test::in_c_order;
using test::NpyBytes;
using ::testing::HasSubstr;

std::vector<Pose> dance() {
  return test::swinging_take("dance", 12, 1).a.poses;
}

std::string names_file() {
  const auto& own = builtin_joint_orders().front();
  return npy_of_texts(own.points, {own.points.size()});
}

/// The archive with these files, and names for 25 joints.
std::string archive(std::vector<ZipContent> files) {
  files.push_back({"joint_names.npy", names_file()});
  return write_zip(files).value();
}

/// A .npz with one entry as one stored block of deflated data.
std::string deflated_archive(const std::string& name, const std::string& content) {
  std::string bytes = write_zip(std::vector<ZipContent>{{name, content}}).value();
  const auto length = static_cast<unsigned>(content.size());
  std::string block = "\x01";
  for (const unsigned number : {length, ~length})
    for (const unsigned shift : {0U, 8U}) block += static_cast<char>(number >> shift & 0xffU);
  bytes.replace(bytes.find(content), content.size(), block + content);
  const std::size_t contents = bytes.rfind("PK\x01\x02"), end = bytes.rfind("PK\x05\x06");
  bytes[8] = 8, bytes[contents + 10] = 8;
  const auto add = [&](std::size_t at, unsigned more) {
    const unsigned value =
        static_cast<unsigned char>(bytes[at]) + 256U * static_cast<unsigned char>(bytes[at + 1]) + more;
    bytes[at] = static_cast<char>(value & 0xffU), bytes[at + 1] = static_cast<char>(value >> 8U & 0xffU);
  };
  add(18, 5), add(contents + 20, 5), add(end + 16, 5);
  return bytes;
}

NamedMotion read_one(const std::string& bytes, const std::optional<JointOrder>& order = {}) {
  auto motions = read_numpy(bytes, order, "dance.npz");
  if (!motions) {
    ADD_FAILURE() << motions.error().text();
    return {};
  }
  EXPECT_EQ(motions->size(), 1U);
  return motions->front();
}

std::string refusal(const std::string& bytes, const std::optional<JointOrder>& order = {}) {
  const auto motions = read_numpy(bytes, order, "dance.npz");
  return motions ? "was read" : motions.error().text();
}

void expect_positions(const NamedMotion& motion, const std::vector<Pose>& poses, double tolerance) {
  ASSERT_EQ(motion.frames.size(), poses.size());
  for (std::size_t f = 0; f < poses.size(); ++f)
    EXPECT_LE((motion.frames[f] - poses[f]).cwiseAbs().maxCoeff(), tolerance) << "frame " << f;
}

TEST(NumpyReader, ReadsBothPrecisionsOrdersAndEndsOfBytes) {
  const std::vector<Pose> poses = dance();
  for (const char* type : {"<f8", ">f8", "<f4", ">f4"})
    for (const bool column_order : {false, true})
      for (const int version : {1, 2, 3}) {
        SCOPED_TRACE(type);
        const NpyBytes file{type, column_order, {poses.size(), 25, 3}, version};
        expect_positions(read_one(file.of(in_c_order(poses))), poses, type[2] == '8' ? 0 : 1e-6);
      }
}

TEST(NumpyReader, HonoursNamesRateUnitAndAxisBesideThePositions) {
  const std::vector<Pose> poses = dance();
  const NamedMotion motion = read_one(archive({
      {"positions.npy", NpyBytes{"<f8", false, {poses.size(), 25, 3}}.of(in_c_order(poses))},
      {"fps.npy", NpyBytes{"<i8", false, {1}}.of({50})},
      {"up.npy", npy_of_texts({"Z"}, {})},
      {"metres_per_unit.npy", npy_of_numbers({0.01}, {})},
  }));
  EXPECT_EQ(motion.points, builtin_joint_orders().front().points);
  EXPECT_EQ(motion.fps, 50);
  EXPECT_EQ(motion.up_axis, UpAxis::Z);
  EXPECT_EQ(motion.metres_per_unit, 0.01);
  EXPECT_TRUE(motion.warnings.empty());
}

TEST(NumpyReader, TakesTheOnlyPositionsWhateverTheirNameAndSaysWhatItLeftOut) {
  const std::vector<Pose> poses = dance();
  const NamedMotion motion =
      read_one(archive({{"xyz.npy", NpyBytes{"<f8", false, {poses.size(), 25, 3}}.of(in_c_order(poses))},
                        {"contacts.npy", npy_of_numbers({1, 2}, {2})}}));
  expect_positions(motion, poses, 0);
  EXPECT_EQ(test::the_warning(motion.warnings, "arrays").detail, "not read: contacts");
}

TEST(NumpyReader, ObjectsAreRefusedWhereTheyAreWantedAndLeftOutElsewhere) {
  const std::string header = "{'descr': '|O', 'fortran_order': False, 'shape': (3,), }\n";
  const std::string objects = std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) +
                              std::string(1, '\0') + header + "pickled";
  EXPECT_THAT(refusal(objects), HasSubstr("Python objects (a pickle)"));
  EXPECT_THAT(refusal(archive({{"positions.npy", objects}})), HasSubstr("Python objects (a pickle)"));
  EXPECT_THAT(refusal(archive({{"SBJ_position.npy", objects}})), HasSubstr("Python objects (a pickle)"));
  const std::string one = NpyBytes{"<f8", false, {1, 25, 3}}.of(in_c_order({test::standing_pose()}));
  const NamedMotion motion = read_one(archive({{"positions.npy", one}, {"notes.npy", objects}}));
  EXPECT_EQ(test::the_warning(motion.warnings, "arrays").detail, "not read: notes");
}

TEST(NumpyReader, ReadsBoneNamesFrameratesAndParentsOfOtherPrograms) {
  const std::vector<Pose> poses = dance();
  const auto& own = builtin_joint_orders().front();
  std::vector<double> parents(joint_parents.begin(), joint_parents.end());
  const auto bytes_with = [&](const std::vector<double>& tree) {
    const std::vector<ZipContent> files = {
        {"bone_names.npy", npy_of_texts(own.points, {own.points.size()})},
        {"framerate.npy", NpyBytes{"<f8", false, {1}}.of({50})},
        {"parent_indices.npy", NpyBytes{"<i4", false, {tree.size()}}.of(tree)},
        {"positions.npy", NpyBytes{"<f8", false, {poses.size(), 25, 3}}.of(in_c_order(poses))}};
    return write_zip(files).value();
  };
  const auto motions = read_numpy(bytes_with(parents), {}, "a.npz");
  ASSERT_TRUE(motions) << motions.error().text();
  EXPECT_EQ(motions->front().fps, 50);
  EXPECT_EQ(motions->front().points, own.points);
  EXPECT_EQ(motions->front().parents, std::vector<int>(joint_parents.begin(), joint_parents.end()));
  EXPECT_FALSE(test::has_warning(motions->front().warnings, "arrays"));
  parents[3] = 3;
  EXPECT_THAT(read_numpy(bytes_with(parents), {}, "a.npz").error().text(),
              HasSubstr("parent_indices: expected for each of the 25 joints"));
}

TEST(NumpyReader, ReadsTwoPersons) {
  const std::string one = NpyBytes{"<f8", false, {1, 25, 3}}.of(in_c_order({test::standing_pose()}));
  const auto motions =
      read_numpy(archive({{"person1.npy", one}, {"person2.npy", one}}), std::nullopt, "pair.npz");
  ASSERT_TRUE(motions) << motions.error().text();
  ASSERT_EQ(motions->size(), 2U);
  EXPECT_EQ((*motions)[1].name, "person2");
}

TEST(NumpyReader, ReadsWhatIsDeflated) {
  const std::vector<Pose> poses = dance();
  expect_positions(read_one(deflated_archive(
                       "positions.npy", NpyBytes{"<f8", false, {poses.size(), 25, 3}}.of(in_c_order(poses)))),
                   poses, 0);
}

TEST(NumpyReader, GuessesTheOrderByTheCountWhereThatTellsAndSaysSo) {
  const NamedMotion motion = read_one(NpyBytes{"<f8", false, {1, 53, 3}}.of(std::vector<double>(159, 0.5)));
  EXPECT_THAT(test::the_warning(motion.warnings, "joint-order").detail, HasSubstr("mocap53 was guessed"));
  const std::string either = NpyBytes{"<f8", false, {1, 22, 3}}.of(std::vector<double>(66, 0.5));
  EXPECT_THAT(refusal(either),
              HasSubstr("may be lafan22 or smplx22; say which joint is which with an array joint_names"));
  EXPECT_EQ(read_one(either, find_joint_order("lafan22").value()).points[1], "RightUpLeg");
  EXPECT_THAT(refusal(either, find_joint_order("smplh52").value()), HasSubstr("the order smplh52 has 52"));
}

/// An order with as many joints as another would put knees where elbows are, and be read without a word.
TEST(NumpyReader, OfTwoOrdersTakesTheOneByWhichBonesKeepTheirLengths) {
  const auto take = test::swinging_take("dance", 60, 1);
  for (const char* name : {"lafan22", "smplx22", "smplh52", "smplhmodel52"}) {
    const JointOrder order = find_joint_order(name).value();
    const std::string bytes = clip_file_content("a.npy", std::array{take.a}, {1, UpAxis::Y, order}).value();
    const NamedMotion motion = read_one(bytes);
    EXPECT_EQ(motion.points, order.points) << name;
    EXPECT_THAT(test::the_warning(motion.warnings, "joint-order").detail,
                HasSubstr(std::string("the order ") + name + " was guessed, since by it the bones keep"));
  }
}

TEST(NumpyReader, WhatWasNotSeenIsAGap) {
  std::vector<double> values = in_c_order({test::standing_pose()});
  values[4] = std::nan("");
  EXPECT_TRUE(std::isnan(read_one(NpyBytes{"<f8", false, {1, 25, 3}}.of(values)).frames[0](1, 1)));
}

TEST(NumpyReader, MakesNoRoomForWhatIsOnlyAnnounced) {
  const std::vector<double> few(75, 0.5);
  EXPECT_THAT(refusal(NpyBytes{"<f8", false, {1'000'000'000'000, 25, 3}}.of(few)), HasSubstr("cut off"));
  EXPECT_THAT(refusal(NpyBytes{"<f8", false, {~0ULL, 25, 3}}.of(few)), HasSubstr("cut off"));
  EXPECT_THAT(refusal(NpyBytes{"<f8", false, {0, 25, 3}}.of({})), HasSubstr("no frames"));
  // more than 2^64 bytes, as the table of contents says as well.
  std::string bomb = deflated_archive("positions.npy", NpyBytes{"<f8", false, {1ULL << 57U, 25, 3}}.of(few));
  const std::size_t contents = bomb.rfind("PK\x01\x02");
  EXPECT_THAT(refusal(bomb), HasSubstr("cut off"));
  bomb.replace(contents + 24, 4, "\xff\xff\xff\xff");
  EXPECT_THAT(refusal(bomb), HasSubstr("cut off")) << "4 GiB are less as well";
}

// A small file of zeros is a large one of doubles.
TEST(NumpyReader, MoreNumbersThanAreReadAreRefusedBeforeAnyIs) {
  const std::uint64_t frames = limits::numpy_numbers / 75;
  const auto zeros = [](std::uint64_t count) {
    const std::string file = NpyBytes{"|i1", false, {count, 25, 3}}.of({});
    return archive({{"positions.npy", file + std::string(count * 75, '\0')}});
  };
  EXPECT_THAT(
      refusal(zeros(frames + 1)),
      HasSubstr("positions: has the shape (894785, 25, 3), 67108875 numbers; up to 67108864 are read"));
  const std::string half =
      NpyBytes{"|i1", false, {frames / 2 + 1, 25, 3}}.of({}) + std::string((frames / 2 + 1) * 75, '\0');
  EXPECT_THAT(refusal(archive({{"person1.npy", half}, {"person2.npy", half}})),
              HasSubstr("2 persons have more than 67108864 numbers together"));
}

TEST(NumpyReader, MoreNamesThanAreReadAreRefused) {
  const auto named = [](std::uint64_t count) {
    return write_zip(std::vector<ZipContent>{
                         {"positions.npy",
                          NpyBytes{"|i1", false, {1, count, 3}}.of(std::vector<double>(3 * count))},
                         {"joint_names.npy", npy_of_texts(std::vector<std::string>(count, "j"), {count})}})
        .value();
  };
  EXPECT_EQ(refusal(named(limits::numpy_texts)), "was read");
  EXPECT_THAT(refusal(named(limits::numpy_texts + 1)), HasSubstr("10001 texts; up to 10000 are read"));
}

TEST(NumpyReader, AnEntryThatAnnouncesMoreThanItsBytesCanGiveIsDamaged) {
  const std::string file = NpyBytes{"<f8", false, {1, 25, 3}}.of(std::vector<double>(75, 0.5));
  std::string archive = deflated_archive("positions.npy", file);
  const std::size_t size_at = archive.rfind("PK\x01\x02") + 24;
  const auto announces = [&](std::uint64_t bytes) {
    for (std::size_t byte = 0; byte < 4; ++byte)
      archive[size_at + byte] = static_cast<char>(bytes >> 8 * byte & 0xff);
    return refusal(archive);
  };
  const std::uint64_t stored = file.size() + 5;  // a block's own bytes
  EXPECT_THAT(announces((stored + 1) * limits::deflate_ratio), HasSubstr("more than its"));
  EXPECT_THAT(announces((stored + 1) * limits::deflate_ratio - 1), testing::Not(HasSubstr("more than its")));
}

// It takes no room on the disk, and all of it in memory.
TEST(NumpyReader, ASparseFileIsRefusedBeforeItIsRead) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("abrazo_sparse_" + std::to_string(::getpid()) + ".npy");
  ASSERT_TRUE(write_whole_file(file, NpyBytes{"<f8", false, {1'000'000, 25, 3}}.of({})));
  std::filesystem::resize_file(file, limits::npy_file_bytes + 1);
  const auto motions = load_motion(file.string(), "", {});
  std::filesystem::remove(file);
  ASSERT_FALSE(motions);
  EXPECT_THAT(motions.error().text(), HasSubstr("is 512 MB large; files of this kind are read up to 512 MB"));
}

TEST(NumpyReader, AnArchiveOfThousandsOfEntriesIsRefused) {
  std::vector<ZipContent> files;
  for (std::uint64_t i = 0; i <= limits::archive_entries; ++i)
    files.push_back({"a" + std::to_string(i) + ".npy", ""});
  EXPECT_THAT(refusal(write_zip(files).value()),
              HasSubstr("has 4097 entries; archives of up to 4096 are read"));
}

TEST(NumpyReader, NoCutOrChangedByteIsReadAsSomethingElse) {
  const std::vector<Pose> poses = {test::standing_pose()};
  const std::string whole =
      archive({{"positions.npy", NpyBytes{"<f8", false, {1, 25, 3}}.of(in_c_order(poses))}});
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_FALSE(read_numpy(whole.substr(0, size), std::nullopt, "cut.npz")) << size;
  const std::size_t data = whole.find("\x93NUMPY");
  for (std::size_t at = data + 128; at < data + 600; at += 13) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    EXPECT_THAT(refusal(changed), HasSubstr("checksum")) << at;
  }
}

TEST(NumpyReader, IsRecognisedByItsContent) {
  EXPECT_EQ(format_of_content("\x93NUMPY\x01"), MotionFormat::Numpy);
  EXPECT_EQ(format_of_content(archive({})), MotionFormat::Numpy);
  EXPECT_EQ(format_of_content(write_zip(std::vector<ZipContent>{{"scene.usdc", ""}}).value()), std::nullopt);
}

// ---- orders of joints ----

TEST(JointOrders, HaveAsManyJointsAsTheirNamesSayAndNoneTwice) {
  for (const JointOrder& order : builtin_joint_orders()) {
    EXPECT_TRUE(order.name.ends_with(std::to_string(order.points.size()))) << order.name;
    EXPECT_EQ(std::set(order.points.begin(), order.points.end()).size(), order.points.size());
  }
}

TEST(JointOrders, AreReadFromAFileOfLinesOrAList) {
  EXPECT_EQ(parse_joint_order("Hips\n Spine \r\n\nHead\n", "mine.txt")->points,
            (std::vector<std::string>{"Hips", "Spine", "Head"}));
  EXPECT_EQ(parse_joint_order(R"(["Hips", "Spine"])", "mine.json")->points,
            (std::vector<std::string>{"Hips", "Spine"}));
  EXPECT_THAT(parse_joint_order("a\nb\na\n", "mine.txt").error().text(), HasSubstr("names 'a' twice"));
  EXPECT_THAT(parse_joint_order("[1, 2]", "mine.json").error().text(), HasSubstr("one a line"));
  EXPECT_THAT(find_joint_order("lafan").error().text(), HasSubstr("abrazo25, lafan22, smplx22"));
}

TEST(JointOrders, GiveEveryJointOfEveryBuiltInOrderAndRefuseOthers) {
  for (const JointOrder& order : builtin_joint_orders()) {
    const auto points = OrderedPoints::of(order);
    ASSERT_TRUE(points) << points.error().text();
    EXPECT_TRUE(points->positions_of(test::standing_pose()).allFinite());
  }
  EXPECT_THAT(OrderedPoints::of({"mine", {"Hips", "Tail"}}).error().text(), HasSubstr("'Tail'"));
}

TEST(JointOrders, KneesStayKneesInEveryOrder) {
  const Pose pose = test::standing_pose();
  for (const auto& [order, knee] : {std::pair("lafan22", "LeftLeg"),
                                    {"smplx22", "L_Knee"},
                                    {"smplh52", "L_Knee"},
                                    {"smplhmodel52", "L_Knee"},
                                    {"mocap53", "LeftLeg"},
                                    {"abrazo25", "lfemur"}}) {
    const JointOrder found = find_joint_order(order).value();
    const auto at = std::ranges::find(found.points, knee) - found.points.begin();
    EXPECT_EQ(OrderedPoints::of(found)->positions_of(pose).row(at), pose.row(joints::left_knee)) << order;
  }
}

// ---- there and back ----

std::vector<ImportedClip> imported(const std::string& bytes, const std::optional<JointOrder>& order) {
  std::vector<ImportedClip> clips;
  const auto motions = read_numpy(bytes, order, "back");
  EXPECT_TRUE(motions) << motions.error().text();
  for (const NamedMotion& motion : motions.value()) {
    ImportOptions said;
    if (!motion.fps) said.fps = 60, said.metres_per_unit = 1, said.up_axis = UpAxis::Y;
    auto clip = import_clip(motion, said);
    EXPECT_TRUE(clip) << clip.error().text();
    clips.push_back(clip.value());
  }
  return clips;
}

TEST(NumpyWriter, TheTwentyFiveJointsComeBackBitByBit) {
  const auto take = test::swinging_take("dance", 60, 1);
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
    const auto back = imported(clip_file_content("a.npz", std::array{take.a, take.b}, {1, up}).value(), {});
    ASSERT_EQ(back.size(), 2U);
    EXPECT_EQ(back[0].clip.fps, take.a.fps);
    for (std::size_t f = 0; f < take.a.poses.size(); ++f) {
      EXPECT_EQ(back[0].clip.poses[f], take.a.poses[f]);
      EXPECT_EQ(back[1].clip.poses[f], take.b.poses[f]);
    }
  }
  const auto alone = imported(write_npy(take.a, builtin_joint_orders().front()).value(), {});
  EXPECT_EQ(alone[0].clip.poses, take.a.poses);
}

TEST(NumpyWriter, EveryOrderReadAndWrittenAgainIsTheSameFile) {
  const auto take = test::swinging_take("dance", 60, 1);
  for (const JointOrder& order : builtin_joint_orders()) {
    const std::string once =
        clip_file_content("a.npz", std::array{take.a, take.b}, {1, UpAxis::Y, order}).value();
    const auto read = imported(once, {});
    EXPECT_EQ(
        clip_file_content("a.npz", std::array{read[0].clip, read[1].clip}, {1, UpAxis::Y, order}).value(),
        once)
        << order.name;
    const std::string plain = write_npy(take.a, order).value();
    EXPECT_EQ(write_npy(imported(plain, order)[0].clip, order).value(), plain) << order.name;
  }
}

TEST(NumpyWriter, UnitAndAxisAreSaidInTheFile) {
  const auto take = test::swinging_take("dance", 12, 1);
  const auto motions = read_numpy(clip_file_content("a.npz", std::array{take.a}, {100, UpAxis::Z}).value(),
                                  std::nullopt, "a.npz");
  ASSERT_TRUE(motions);
  EXPECT_EQ(motions->front().metres_per_unit, 0.01);
  EXPECT_EQ(motions->front().up_axis, UpAxis::Z);
  EXPECT_NEAR(motions->front().frames[0](joints::Head, 2), 100 * take.a.poses[0](joints::Head, 1), 1e-9);
}

/// What numpy_round_trip.py calls positions.
std::vector<Pose> python_positions() {
  std::vector<Pose> poses(5);
  for (int f = 0; f < 5; ++f)
    for (int j = 0; j < joint_count; ++j)
      poses[static_cast<std::size_t>(f)].row(j) << j / 64.0 + f / 8.0, j / 16.0, f / 32.0 - j / 128.0;
  return poses;
}

TEST(NumpyWriter, NumPyReadsWhatWasWrittenAndWritesWhatIsRead) {
  const std::string python = test::python_with_numpy();
  if (python.empty()) GTEST_SKIP() << "there is no Python 3 with NumPy here";
  const auto folder = std::filesystem::temp_directory_path() / "abrazo_numpy_round_trip";
  std::filesystem::create_directories(folder);
  const std::string script =
      python + " " +
      (std::filesystem::path(ABRAZO_FIXTURES).parent_path() / "core/motion/numpy_round_trip.py").string();
  ASSERT_EQ(test::printed_by(script + " write " + folder.string()), "");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    const auto motions = read_numpy(read_whole_file(entry.path()).value(), std::nullopt, "a");
    ASSERT_TRUE(motions) << motions.error().text();
    expect_positions(motions->front(), python_positions(), 0);
    const bool is_pair = entry.path().stem().string().ends_with("c");
    ASSERT_EQ(motions->size(), is_pair ? 2U : 1U);
    if (entry.path().extension() == ".npz") {
      EXPECT_EQ(motions->front().points[24], "point24");
      EXPECT_EQ(motions->front().fps, is_pair ? 30 : 24.5);
      EXPECT_EQ(motions->front().up_axis, is_pair ? UpAxis::Y : UpAxis::Z);
    }
    ++files;
  }
  EXPECT_EQ(files, 24);
  const std::array clips = {Clip{"a", 24.5, python_positions()}};
  const std::string archive_file = folder / "ours.npz", array_file = folder / "ours.npy";
  ASSERT_TRUE(write_clip_file(archive_file, clips));
  ASSERT_TRUE(write_clip_file(array_file, clips));
  EXPECT_EQ(test::printed_by(script + " check " + archive_file + " " + array_file + " 2>&1"), "");
  std::filesystem::remove_all(folder);
}

TEST(NumpyWriter, WhatAFileCannotHoldIsRefused) {
  const auto take = test::swinging_take("dance", 12, 1);
  EXPECT_THAT(check_clip_file("a.npy", {}, 2).error().text(), HasSubstr("a .npy holds one body"));
  EXPECT_THAT(check_clip_file("a.csv", {1, UpAxis::Y, builtin_joint_orders()[1]}).error().text(),
              HasSubstr("for .npz and .npy"));
  Clip slower = take.b;
  slower.fps = 30;
  EXPECT_THAT(clip_file_content("a.npz", std::array{take.a, slower}).error().text(),
              HasSubstr("another frame rate"));
}

}  // namespace
}  // namespace abrazo::numpy_reader_test
