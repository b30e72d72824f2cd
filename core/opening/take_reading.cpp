#include "core/opening/take_reading.hpp"

namespace abrazo {

Result<Manifest> manifest_behind(const Material& material) {
  if (material.manifest) return *material.manifest;
  if (std::filesystem::path(material.library_file).extension() == ".json")
    return read_manifest(material.library_file);
  return Error{material.is_generated
                   ? "was generated, and not built from motion files"
                   : "does not say which motion files it was built from; open its manifest, "
                     "or build it again from the files",
               material.library_file.empty() ? material.library->name() : material.library_file};
}

MotionReading reading_of(const Manifest::Take& take, Performer performer) {
  const Manifest::Performer& source = performer == Performer::A ? take.a : take.b;
  MotionReading reading;
  reading.file = source.motion.string();
  reading.skeleton = source.skeleton.string();
  reading.joint_map = source.joint_map;
  reading.joints = source.joints;
  if (source.up_axis) reading.up = name_of(*source.up_axis);
  reading.metres_per_unit = source.metres_per_unit ? source.metres_per_unit : take.metres_per_unit;
  reading.fps = take.fps;
  if (source.index) reading.performer = std::to_string(*source.index + 1);
  // Both in one file, without an index: they are taken in its order.
  else if (take.a.motion == take.b.motion)
    reading.performer = performer == Performer::A ? "1" : "2";
  reading.animation = source.animation;
  reading.body_model = source.body_model.string();
  return reading;
}

Result<Manifest::Take> with_reading(Manifest::Take take, Performer performer, const MotionReading& reading,
                                    int index) {
  if (reading.floor_m)
    return Error{"the floor of a take is found when the library is built; leave Floor as found", take.name};
  const bool share_file = take.a.motion == take.b.motion;
  // What holds for the take would else go on to hold for the other performer's file, or cease to.
  for (Manifest::Performer* each : {&take.a, &take.b})
    if (!each->metres_per_unit) each->metres_per_unit = take.metres_per_unit;
  take.metres_per_unit.reset();
  take.fps = reading.fps;
  Manifest::Performer& source = performer == Performer::A ? take.a : take.b;
  for (Manifest::Performer* each : {&take.a, &take.b}) {
    if (each != &source && !share_file) continue;
    each->joint_map = reading.joint_map;
    each->joints = reading.joints;
    each->up_axis = find_up_axis(reading.up);
    each->metres_per_unit = reading.metres_per_unit;
    each->animation = reading.animation;
    each->body_model = reading.body_model;
  }
  const bool is_first_of_its_file = index == 0 && !share_file;
  if (source.index || !is_first_of_its_file) source.index = index;
  if (share_file && !take.b.index) take.b.index = index == 1 && performer == Performer::A ? 0 : 1;
  if (share_file && !take.a.index) take.a.index = index == 0 && performer == Performer::B ? 1 : 0;
  return take;
}

}  // namespace abrazo
