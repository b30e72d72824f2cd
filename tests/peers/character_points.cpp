/// Where a character has its bones in a recorded pair, as JSON for character_check.py: of each body and bone
/// the number of its node, its place in every frame and, of a limb, the performer's joint on the character's
/// path. Metres, Y up.
///
///     abrazo_character_points CHARACTER.glb PAIR.npz
#include <cstdio>
#include <map>
#include <memory>
#include <string_view>

#include "core/base/atomic_file.hpp"
#include "core/base/json_text.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/rig_motion.hpp"

namespace {

using namespace abrazo;

const std::map<std::string_view, int> joint_of_bone = {
    {"leftupperarm", joints::left_shoulder}, {"rightupperarm", joints::right_shoulder},
    {"leftlowerarm", joints::left_elbow},    {"rightlowerarm", joints::right_elbow},
    {"lefthand", joints::left_wrist},        {"righthand", joints::right_wrist},
    {"leftupperleg", joints::left_hip},      {"rightupperleg", joints::right_hip},
    {"leftlowerleg", joints::left_knee},     {"rightlowerleg", joints::right_knee},
    {"leftfoot", joints::left_ankle},        {"rightfoot", joints::right_ankle}};

void write_place(const Vec3& place, JsonText& json) {
  json.begin_array();
  for (const double value : place) json.value(value);
  json.end_array();
}

void write_body(const HumanoidRig& rig, const Clip& clip, RigMotion motion, JsonText& json) {
  std::map<std::string, std::vector<Vec3>> places;
  for (const Pose& pose : clip.poses) {
    motion.set_pose(pose, 1 / clip.fps);
    for (const auto& [bone, node] : rig.bones)
      places[bone].push_back(motion.world()[static_cast<std::size_t>(node)].translation());
  }
  json.begin_object();
  for (const auto& [bone, node] : rig.bones) {
    json.key(bone).begin_object().key("node").value(node);
    json.key("places").begin_array();
    for (const Vec3& place : places[bone]) write_place(place, json);
    json.end_array();
    if (const auto joint = joint_of_bone.find(bone); joint != joint_of_bone.end()) {
      json.key("performer").begin_array();
      for (const Pose& pose : clip.poses)
        write_place(motion.place().path * joint_at(pose, joint->second), json);
      json.end_array();
    }
    json.end_object();
  }
  json.end_object();
}

Result<std::string> points(const std::string& character, const std::string& pair) {
  const auto content = read_whole_file(character);
  if (!content) return content.error();
  const auto glb = parse_glb(*content, character);
  if (!glb) return glb.error();
  auto read = read_humanoid_rig(*glb, character);
  if (!read) return read.error();
  const auto rig = std::make_shared<const HumanoidRig>(std::move(*read));
  const auto performers = load_motion(pair, "", {});
  if (!performers) return performers.error();
  std::vector<Clip> clips;
  for (const ImportedClip& performer : *performers) clips.push_back(performer.clip);
  JsonText json;
  json.begin_object().key("fps").value(clips.front().fps).key("bodies").begin_array();
  std::size_t body = 0;
  for (RigMotion& motion : rig_motions(rig, clips)) write_body(*rig, clips[body++], std::move(motion), json);
  json.end_array().end_object();
  return json.take();
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  const auto text = points(words[1], words[2]);
  if (!text) {
    std::fprintf(stderr, "%s\n", text.error().text().c_str());
    return 1;
  }
  std::puts(text->c_str());
  return 0;
}
