/// What a motion file's reader makes of it, as JSON for import_check.py: every point in metres, Y up, before
/// any of them is taken as a joint.
///
///     abrazo_file_points FILE [ANIMATION]
#include <cstdio>

#include "core/base/json_text.hpp"
#include "core/motion/files/import_clip.hpp"

int main(int count, char** words) {
  if (count < 2) return 2;
  abrazo::ImportOptions options;
  options.animation = count > 2 ? words[2] : "";
  const auto motions = abrazo::read_motion_points(words[1], "", options);
  if (!motions) {
    std::fprintf(stderr, "%s\n", motions.error().text().c_str());
    return 1;
  }
  abrazo::JsonText json;
  json.begin_object();
  json.key("fps").value(motions->front().fps.value_or(0));
  json.key("frames").value(static_cast<long long>(motions->front().frames.size()));
  json.key("points").begin_object();
  for (const abrazo::NamedMotion& motion : *motions)
    for (std::size_t p = 0; p < motion.points.size(); ++p) {
      json.key(motion.name + "/" + motion.points[p]).begin_array();
      for (const abrazo::Positions& frame : motion.frames) {
        Eigen::RowVector3d place =
            motion.metres_per_unit.value_or(1) * frame.row(static_cast<Eigen::Index>(p));
        turn_to_y_up(place, motion.up_axis.value_or(abrazo::UpAxis::Y));
        json.begin_array();
        for (const double value : {place.x(), place.y(), place.z()}) json.value(value);
        json.end_array();
      }
      json.end_array();
    }
  json.end_object();
  json.key("warnings").begin_array();
  for (const abrazo::NamedMotion& motion : *motions)
    for (const abrazo::ImportWarning& warning : motion.warnings)
      json.value(warning.kind + ": " + warning.detail);
  json.end_array();
  json.end_object();
  std::puts(json.text().c_str());
  return 0;
}
