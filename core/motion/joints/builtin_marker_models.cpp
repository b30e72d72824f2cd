#include "core/motion/joints/marker_model.hpp"

namespace abrazo {

namespace {

using Names = std::vector<std::string>;

void set(MarkerModel& model, MarkerPlace place, const Names& names) {
  model.names[static_cast<std::size_t>(place)][0] = names;
}

/// '%' stands for L or R.
void set_both(MarkerModel& model, MarkerPlace place, const Names& names) {
  for (const std::size_t side : {0U, 1U})
    for (std::string name : names) {
      if (const auto mark = name.find('%'); mark != std::string::npos) name[mark] = side == 0 ? 'L' : 'R';
      model.names[static_cast<std::size_t>(place)][side].push_back(name);
    }
}

/// What Vicon's Plug-in Gait and the CMU laboratory call the same.
MarkerModel vicon(std::string name) {
  using enum MarkerPlace;
  MarkerModel model;
  model.name = std::move(name);
  set(model, Neck, {"C7"});
  set(model, Back, {"T10"});
  set(model, Clavicle, {"CLAV"});
  set(model, Sternum, {"STRN", "STERN"});
  set_both(model, HeadFrontSide, {"%FHD", "%FH"});
  set_both(model, HeadBackSide, {"%BHD", "%BH"});
  set_both(model, Shoulder, {"%SHO"});
  set_both(model, UpperArm, {"%UPA"});
  set_both(model, Elbow, {"%ELB", "%ELBL"});
  set_both(model, ElbowInner, {"%ELBM", "%MELB", "%ELM"});
  set_both(model, WristThumb, {"%WRA"});
  set_both(model, WristLittle, {"%WRB"});
  set_both(model, Hand, {"%FIN", "%HND"});
  set_both(model, Thigh, {"%THI", "%THAP"});
  set_both(model, Knee, {"%KNE"});
  set_both(model, KneeInner, {"%KNM", "%KNEM", "%MKNE", "%KNEEM"});
  set_both(model, Ankle, {"%ANK"});
  set_both(model, AnkleInner, {"%ANM", "%ANKM", "%MANK", "%MED", "%MMA"});
  set_both(model, Heel, {"%HEE", "%HEEL"});
  set_both(model, Toe, {"%TOE"});
  return model;
}

MarkerModel plug_in_gait() {
  MarkerModel model = vicon("plug-in-gait");
  set(model, MarkerPlace::Sacrum, {"SACR", "SACRUM"});
  set_both(model, MarkerPlace::PelvisFront, {"%ASI", "%ASIS"});
  set_both(model, MarkerPlace::PelvisBack, {"%PSI", "%PSIS"});
  set_both(model, MarkerPlace::Shin, {"%TIB", "%TIAP"});
  return model;
}

MarkerModel cmu_markers() {
  MarkerModel model = vicon("cmu-markers");
  set_both(model, MarkerPlace::PelvisFront, {"%FWT"});
  set_both(model, MarkerPlace::PelvisBack, {"%BWT"});
  set_both(model, MarkerPlace::Shin, {"%SHN", "%SHIN"});
  return model;
}

MarkerModel optitrack_baseline() {
  using enum MarkerPlace;
  MarkerModel model;
  model.name = "optitrack-baseline";
  model.toes_are_mean = true;
  set(model, Neck, {"BackTop", "SpineTop"});
  set(model, Clavicle, {"Chest", "ChestTop"});
  set(model, HeadTop, {"HeadTop"});
  set(model, HeadFront, {"HeadFront"});
  set(model, HeadSide, {"HeadSide"});
  set_both(model, PelvisFront, {"Waist%Front"});
  set_both(model, PelvisBack, {"Waist%Back"});
  set_both(model, Shoulder, {"%ShoulderTop"});
  set_both(model, UpperArm, {"%UArmHigh", "%Arm"});
  set_both(model, Elbow, {"%ElbowOut"});
  set_both(model, ElbowInner, {"%ElbowIn"});
  set_both(model, WristThumb, {"%WristIn"});
  set_both(model, WristLittle, {"%WristOut"});
  set_both(model, Hand, {"%HandOut"});
  set_both(model, Thigh, {"%Thigh"});
  set_both(model, Knee, {"%KneeOut"});
  set_both(model, KneeInner, {"%KneeIn"});
  set_both(model, Shin, {"%Shin"});
  set_both(model, Ankle, {"%AnkleOut"});
  set_both(model, AnkleInner, {"%AnkleIn"});
  set_both(model, Heel, {"%Heel", "%HeelBack"});
  set_both(model, Toe, {"%ToeIn", "%ToeOut", "%ForefootIn", "%ForefootOut"});
  set_both(model, ToeTip, {"%ToeTip"});
  return model;
}

}  // namespace

const std::vector<MarkerModel>& builtin_marker_models() {
  static const std::vector<MarkerModel> models = {plug_in_gait(), cmu_markers(), optitrack_baseline()};
  return models;
}

}  // namespace abrazo
