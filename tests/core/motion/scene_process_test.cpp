#include "core/motion/scenes/scene_process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/motion/scenes/assimp_scene.hpp"
#include "core/motion/scenes/glb_writer.hpp"
#include "core/motion/scenes/scene_answer.hpp"
#include "tests/core/motion/fbx_text.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::scene_process_test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Motions = Result<std::vector<NamedMotion>>;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::vector<Clip> dancer(double fps = 60, int frames = 50) {
  Clip clip;
  clip.name = "anna";
  clip.fps = fps;
  for (int f = 0; f < frames; ++f)
    clip.poses.push_back(test::moved(test::standing_pose(), 0.11 * f, Vec3(0, 0, 0.02 * f)));
  return {clip};
}

/// A folder of its own, and the environment as it was afterwards.
class SceneProcess : public ::testing::Test {
 protected:
  SceneProcess() : folder_(fs::temp_directory_path() / ("scene-process-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_ / "scenes");
  }
  ~SceneProcess() override {
    ::unsetenv("ABRAZO_SCENE_READER");
    fs::remove_all(folder_);
  }

  std::string place(const std::string& name) const { return (folder_ / "scenes" / name).string(); }

  /// Takes a program of our own in place of the reader.
  void reader_is(const std::string& script) const {
    const fs::path program = folder_ / "reader";
    std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(program, fs::perms::owner_all);
    ::setenv("ABRAZO_SCENE_READER", program.c_str(), 1);
  }

  Motions read(const std::string& bytes, MotionFormat format, const std::string& name,
               const Progress& progress = {}) const {
    return read_scene_apart(bytes, format, place(name), {}, progress);
  }
  std::string message(const std::string& bytes, MotionFormat format, const std::string& name) const {
    const Motions motions = read(bytes, format, name);
    return motions ? "read" : motions.error().text();
  }

  /// The dancer as text with its numbers in a file of this name, which is written unless something is there.
  std::string gltf_with_buffer(const std::string& uri) const {
    const std::string glb = *write_glb(dancer());
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, 4);
    std::string json = glb.substr(20, length);
    const std::string buffer = glb.substr(20 + length + 8);
    const auto at = json.find("\"byteLength\"", json.find("\"buffers\""));
    json.insert(at, "\"uri\":\"" + uri + "\",");
    std::error_code trouble;
    const fs::path target = folder_ / "scenes" / uri;
    if (!fs::exists(fs::symlink_status(target, trouble))) std::ofstream(target, std::ios::binary) << buffer;
    return json;
  }

  fs::path folder_;
};

/// Ten joints that turn from key to key by so many degrees.
std::string fbx_with_turns(double degrees, int keys = 2) {
  std::vector<test::FbxJoint> joints;
  for (int j = 0; j < 10; ++j) {
    joints.push_back({"J" + std::to_string(j), {1, 10, 0}, "", {}});
    for (int k = 0; k < keys; ++k)
      joints.back().rotations.emplace_back(k / 30.0, Vec3::Constant(degrees * k));
  }
  return test::fbx_text(joints);
}

/// Assimp adds a key for every 180 degrees: 8 GB, and more.
std::string fbx_with_a_huge_turn() {
  return fbx_with_turns(1e9);
}

void expect_same(const Motions& apart, const Motions& direct, const std::string& what) {
  SCOPED_TRACE(what);
  ASSERT_EQ(apart.ok(), direct.ok()) << (apart ? direct : apart).error().text();
  if (!apart) {
    EXPECT_EQ(apart.error().text(), direct.error().text());
    return;
  }
  // To the bit: as bytes, in which not-a-number is a number like any other.
  EXPECT_EQ(scene_answer(apart), scene_answer(direct));
}

TEST_F(SceneProcess, GivesToTheBitWhatReadingInThisProcessGives) {
  std::vector<std::pair<fs::path, MotionFormat>> files;
  const fs::path tests = fs::path(ABRAZO_FIXTURES).parent_path();
  for (const auto& [folder, format] :
       {std::pair("fuzz/corpus/fbx", MotionFormat::Fbx), std::pair("fuzz/corpus/glb", MotionFormat::Gltf),
        std::pair("fuzz/corpus/gltf", MotionFormat::Gltf),
        std::pair("fuzz/corpus/collada", MotionFormat::Collada)}) {
    const std::size_t others = files.size();
    for (const auto& entry : fs::directory_iterator(tests / folder)) files.emplace_back(entry.path(), format);
    EXPECT_GT(files.size(), others) << folder;
  }
  for (const auto& entry : fs::recursive_directory_iterator(tests / "fixtures"))
    if (const auto format = format_of_name(entry.path().string());
        format == MotionFormat::Fbx || format == MotionFormat::Gltf || format == MotionFormat::Collada)
      files.emplace_back(entry.path(), *format);
  for (const auto& [file, format] : files) {
    const std::string bytes = read_whole_file(file).value();
    const Motions apart = read_scene_apart(bytes, format, file.string(), {}, {});
    expect_same(apart, read_scene(bytes, format, file.string()), file.string());
  }
  const std::string dance = *write_glb(dancer(29.97, 400)), walk = fbx_with_turns(1.7, 300);
  for (const auto& [bytes, format] :
       {std::pair(dance, MotionFormat::Gltf), std::pair(walk, MotionFormat::Fbx)}) {
    const Motions apart = read(bytes, format, "whole");
    EXPECT_TRUE(apart) << apart.error().text();
    expect_same(apart, read_scene(bytes, format, place("whole")), "a whole one");
  }
}

TEST_F(SceneProcess, AFileThatWouldTakeAllMemoryIsGivenUpAtALimit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "instrumented programs have no limit of addresses";
#endif
  // Of memory after 7 s; on a busy machine, where that takes three times as long, of time.
  EXPECT_THAT(message(fbx_with_a_huge_turn(), MotionFormat::Fbx, "turn.fbx"),
              AllOf(AnyOf(HasSubstr("turn.fbx: takes more than"), HasSubstr("turn.fbx: takes longer than")),
                    HasSubstr("to read, so it was given up; export it again, or as GLB or BVH")));
}

TEST_F(SceneProcess, AskingToStopKillsItAtOnce) {
  for (const std::string script : {"", "trap '' TERM INT; while :; do :; done"}) {
    if (!script.empty()) reader_is(script);
    const auto begin = Clock::now();
    const Motions motions =
        read(fbx_with_a_huge_turn(), MotionFormat::Fbx, "turn.fbx", [&](double, std::string_view doing) {
          EXPECT_EQ(doing, "reading turn.fbx");
          return seconds_since(begin) < 0.2;
        });
    ASSERT_FALSE(motions);
    EXPECT_EQ(motions.error().text(), place("turn.fbx") + ": cancelled");
    EXPECT_LT(seconds_since(begin), 1.5);
  }
}

TEST_F(SceneProcess, BuffersAreReadFromItsFolderAndBelow) {
  fs::create_directories(folder_ / "scenes/parts");
  for (const std::string uri : {"dance.bin", "./dance.bin", "parts/dance.bin"}) {
    const Motions motions = read(gltf_with_buffer(uri), MotionFormat::Gltf, "dance.gltf");
    ASSERT_TRUE(motions) << uri << ": " << motions.error().text();
    EXPECT_EQ(motions->front().frames.size(), 50U);
  }
}

TEST_F(SceneProcess, NothingElseIsOpenedHoweverItIsNamed) {
  const std::string json = gltf_with_buffer("dance.bin");
  fs::copy_file(place("dance.bin"), folder_ / "outside.bin");
  fs::create_symlink(folder_ / "outside.bin", place("link.bin"));
  fs::create_directory_symlink(folder_, place("linked"));
  fs::create_directory(place("folder.bin"));
  ASSERT_EQ(::mkfifo(place("pipe.bin").c_str(), 0600), 0);
  const auto with = [&](const std::string& uri) {
    std::string changed = json;
    changed.replace(changed.find("dance.bin"), 9, uri);
    return changed;
  };
  const std::vector<std::pair<std::string, std::string>> names = {
      {"../outside.bin", "does not lie beside it"},
      {"parts/../../outside.bin", "does not lie beside it"},
      {(folder_ / "outside.bin").string(), "does not lie beside it"},
      {"file:///etc/passwd", "does not lie beside it"},
      {"/dev/zero", "does not lie beside it"},
      {"link.bin", "is a link"},
      {"linked/outside.bin", "is a link"},
      {"folder.bin", "is no file but a folder, a pipe or a device"},
      {"pipe.bin", "is no file but a folder, a pipe or a device"},
      {"nowhere.bin", "is not there"}};
  for (const auto& [uri, why] : names) {
    const auto begin = Clock::now();
    EXPECT_THAT(message(with(uri), MotionFormat::Gltf, "dance.gltf"),
                AllOf(HasSubstr("dance.gltf: names the file '"), HasSubstr(why)))
        << uri;
    EXPECT_LT(seconds_since(begin), 2) << uri;
    // The reader itself refuses it, also where the system cannot help.
    const Motions direct = read_scene(with(uri), MotionFormat::Gltf, place("dance.gltf"));
    ASSERT_FALSE(direct) << uri;
    EXPECT_THAT(direct.error().text(), HasSubstr(why)) << uri;
  }
}

TEST_F(SceneProcess, ACrashIsASentenceAboutTheFile) {
  for (const auto& [script, how] :
       {std::pair("kill -SEGV $$", "Segmentation fault"), std::pair("kill -ABRT $$", "Aborted"),
        std::pair("kill -KILL $$", "Killed"), std::pair("exit 77", "exit status 77")}) {
    reader_is(script);
    EXPECT_THAT(message("FBX", MotionFormat::Fbx, "walk.fbx"),
                AllOf(HasSubstr("walk.fbx: is damaged: the program that reads FBX failed on it"),
                      HasSubstr(how), HasSubstr("export it again"), Not(HasSubstr("\n"))));
  }
  reader_is("kill -XCPU $$");
  EXPECT_THAT(message("FBX", MotionFormat::Fbx, "walk.fbx"),
              HasSubstr("walk.fbx: takes longer than 20 s to read"));
}

TEST_F(SceneProcess, AnAnswerThatMakesNoSenseIsRefused) {
  for (const char* script : {"exit 0", "echo hello", "head -c 3000000 /dev/urandom",
                             "printf 'abrazo scene 1\\n\\000\\377\\377\\377\\377\\377\\377\\377\\177'"}) {
    reader_is(script);
    EXPECT_THAT(
        message("FBX", MotionFormat::Fbx, "walk.fbx"),
        AllOf(HasSubstr("walk.fbx: cannot be read"), HasSubstr("makes no sense; install Abrazo anew")))
        << script;
  }
}

TEST_F(SceneProcess, WithoutTheProgramNothingIsRead) {
  ::setenv("ABRAZO_SCENE_READER", place("nowhere").c_str(), 1);
  EXPECT_THAT(message(*write_glb(dancer()), MotionFormat::Gltf, "dance.glb"),
              AllOf(HasSubstr("dance.glb: cannot be read, since the program abrazo-scene-reader"),
                    HasSubstr("is missing (looked for " + place("nowhere") + ")"),
                    HasSubstr("install Abrazo anew, or name the program in ABRAZO_SCENE_READER")));
  std::ofstream(place("nowhere")) << "no program";
  EXPECT_THAT(message(*write_glb(dancer()), MotionFormat::Gltf, "dance.glb"),
              AllOf(HasSubstr("dance.glb: cannot be read"), HasSubstr("cannot be started")));
}

TEST(SceneLimits, GrowWithTheFileAndStayWithinTheMemoryThatThereIs) {
  EXPECT_LE(scene_limits(3'000'000).memory_bytes, (std::size_t{2} << 30U) + 16 * 3'000'000);
  EXPECT_GE(scene_limits(0).memory_bytes, std::size_t{1} << 29U);
  EXPECT_GT(scene_limits(300'000'000).processor_s, 10 * scene_limits(3'000'000).processor_s);
  EXPECT_GT(scene_limits(0).wall_s, scene_limits(0).processor_s);
}

std::vector<NamedMotion> odd_motions() {
  NamedMotion motion;
  motion.name = "Anna\n";
  motion.points = {"Hips", "", "Head"};
  motion.parents = {-1, 0, 1};
  motion.frames.assign(3, Positions::Constant(3, 3, -0.0));
  motion.frames[1](2, 2) = std::numeric_limits<double>::quiet_NaN();
  motion.fps = 29.97;
  motion.up_axis = UpAxis::Z;
  motion.animations = {"a", "b"};
  motion.warnings = {{"sampled", 3, "its keys"}};
  return {motion, NamedMotion{}};
}

TEST(SceneAnswer, ComesOverWhole) {
  const SceneAnswer answer = parse_scene_answer(scene_answer(odd_motions()), "walk.fbx");
  ASSERT_TRUE(answer.is_whole && answer.motions);
  EXPECT_EQ(scene_answer(answer.motions), scene_answer(odd_motions()));
  const SceneAnswer error =
      parse_scene_answer(scene_answer(Error{"is \x1b[2J odd\n", "elsewhere"}), "walk.fbx");
  ASSERT_TRUE(error.is_whole);
  EXPECT_EQ(error.motions.error().text(), "walk.fbx: is ?[2J odd?");
}

TEST(SceneAnswer, CutShortItIsNone) {
  const std::string whole = scene_answer(odd_motions());
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(parse_scene_answer(std::string_view(whole).substr(0, length), "walk.fbx").is_whole)
        << length;
  EXPECT_FALSE(parse_scene_answer(whole + "x", "walk.fbx").is_whole);
}

TEST(SceneAnswer, WhateverByteIsWrongItIsRefusedOrGivesWholeMotions) {
  const std::string whole = scene_answer(odd_motions());
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char wrong : {'\x00', '\x7f', '\xff'}) {
      std::string changed = whole;
      changed[at] = wrong;
      const SceneAnswer answer = parse_scene_answer(changed, "walk.fbx");
      if (!answer.is_whole || !answer.motions) continue;
      for (const NamedMotion& motion : *answer.motions) {
        ASSERT_EQ(motion.parents.size(), motion.points.size());
        for (std::size_t p = 0; p < motion.points.size(); ++p)
          ASSERT_LT(motion.parents[p], static_cast<int>(p));
        for (const Positions& frame : motion.frames)
          ASSERT_EQ(frame.rows(), static_cast<Eigen::Index>(motion.points.size()));
      }
    }
}

}  // namespace
}  // namespace abrazo::scene_process_test
