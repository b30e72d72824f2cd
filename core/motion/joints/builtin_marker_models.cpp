#include <algorithm>

#include "core/motion/joints/marker_model.hpp"

namespace abrazo {

namespace {

using enum MarkerPlace;
using Names = std::vector<std::string>;

void set(MarkerModel& model, MarkerPlace place, const Names& names) {
  model.names[static_cast<std::size_t>(place)][0] = names;
}

/// '%' stands for L or R, '@' for Left or Right.
void set_both(MarkerModel& model, MarkerPlace place, const Names& names) {
  for (const std::size_t side : {0U, 1U})
    for (std::string name : names) {
      if (const auto mark = name.find('%'); mark != std::string::npos) name[mark] = side == 0 ? 'L' : 'R';
      if (const auto mark = name.find('@'); mark != std::string::npos)
        name.replace(mark, 1, side == 0 ? "Left" : "Right");
      model.names[static_cast<std::size_t>(place)][side].push_back(name);
    }
}

/// What Vicon's Plug-in Gait and the CMU laboratory call the same.
MarkerModel vicon(std::string name) {
  MarkerModel model;
  model.name = std::move(name);
  set(model, Neck, {"C7"});
  set(model, Back, {"T10"});
  set(model, Clavicle, {"CLAV"});
  set(model, Sternum, {"STRN", "STERN"});
  set_both(model, HeadFrontSide, {"%FHD", "%FH"});
  set_both(model, HeadBackSide, {"%BHD", "%BH"});
  set_both(model, Shoulder, {"%SHO", "%SHOULDER", "%ACR"});
  set_both(model, UpperArm, {"%UPA", "%UPAR", "%UARM"});
  set_both(model, Elbow, {"%ELB", "%ELBL", "%LELB", "%ELBOW"});
  set_both(model, ElbowInner, {"%ELBM", "%MELB", "%ELM"});
  set_both(model, WristThumb, {"%WRA", "%WRTH", "%WRI"});
  set_both(model, WristLittle, {"%WRB", "%WRPI"});
  set_both(model, Hand, {"%FIN", "%HND"});
  set_both(model, Thigh, {"%THI", "%THAP", "%THIGH"});
  set_both(model, Knee, {"%KNE", "%KNEE", "%KNEL"});
  set_both(model, KneeInner, {"%KNM", "%KNEM", "%MKNE", "%KNEEM", "%KNI"});
  set_both(model, Ankle, {"%ANK", "%ANKLE", "%ANKL"});
  set_both(model, AnkleInner, {"%ANM", "%ANKM", "%MANK", "%MED", "%MMA"});
  set_both(model, Heel, {"%HEE", "%HEEL"});
  set_both(model, Toe, {"%TOE"});
  set_both(model, ToeInner, {"%MT1", "%D1M"});
  set_both(model, ToeOuter, {"%MT5", "%VMH", "%D5M"});
  return model;
}

MarkerModel plug_in_gait() {
  MarkerModel model = vicon("plug-in-gait");
  set(model, Sacrum, {"SACR", "SACRUM"});
  set_both(model, PelvisFront, {"%ASI", "%ASIS"});
  set_both(model, PelvisBack, {"%PSI", "%PSIS"});
  set_both(model, Shin, {"%TIB", "%TIAP"});
  return model;
}

/// The 41 of the CMU laboratory, and its 53 with more on hands and feet.
MarkerModel cmu_markers() {
  MarkerModel model = vicon("cmu-markers");
  set_both(model, PelvisFront, {"%FWT"});
  set_both(model, PelvisBack, {"%BWT"});
  set_both(model, Shin, {"%SHN", "%SHIN"});
  return model;
}

/// Motive's Baseline (37, 41), its variants with fingers and toes (49, 57), and Core (50), whose feet are
/// named otherwise.
MarkerModel optitrack() {
  MarkerModel model;
  model.name = "optitrack-baseline";
  set(model, Neck, {"BackTop", "SpineTop"});
  set(model, Clavicle, {"Chest", "ChestTop"});
  set(model, Sternum, {"ChestLow"});
  set(model, HeadTop, {"HeadTop"});
  set(model, HeadFront, {"HeadFront"});
  set(model, HeadSide, {"HeadSide"});
  set_both(model, PelvisFront, {"Waist%Front", "%WaistFront"});
  set_both(model, PelvisBack, {"Waist%Back", "%WaistBack"});
  set_both(model, Shoulder, {"%ShoulderTop"});
  set_both(model, UpperArm, {"%UArmHigh", "%Arm"});
  set_both(model, Elbow, {"%ElbowOut"});
  set_both(model, ElbowInner, {"%ElbowIn"});
  set_both(model, WristThumb, {"%WristIn"});
  set_both(model, WristLittle, {"%WristOut"});
  set_both(model, Hand, {"%HandOut"});
  set_both(model, Thigh, {"%Thigh", "%ThighSide"});
  set_both(model, Knee, {"%KneeOut"});
  set_both(model, KneeInner, {"%KneeIn"});
  set_both(model, Shin, {"%Shin", "%ShinSide"});
  set_both(model, Ankle, {"%AnkleOut"});
  set_both(model, AnkleInner, {"%AnkleIn"});
  set_both(model, Heel, {"%Heel", "%HeelBack"});
  set_both(model, ToeInner, {"%ToeIn", "%ForefootIn"});
  set_both(model, ToeOuter, {"%ToeOut", "%ForefootOut"});
  set_both(model, ToeTip, {"%ToeTip"});
  return model;
}

/// Helen Hayes (Kadaba et al. 1990) and its form by Davis et al. 1991, as BTS and Motion Analysis name them.
/// Gait laboratories mostly mark no arms.
MarkerModel helen_hayes() {
  MarkerModel model;
  model.name = "helen-hayes";
  set(model, Neck, {"C7", "Neck"});
  set(model, Sacrum, {"sacrum", "V.Sacral", "V_Sacral", "Sacral"});
  set(model, HeadTop, {"Top.Head", "Head.Top"});
  set(model, HeadFront, {"Front.Head"});
  set_both(model, PelvisFront, {"% asis"});
  set_both(model, Shoulder, {"% should", "% shoulder"});
  set_both(model, Elbow, {"% elbow"});
  set_both(model, ElbowInner, {"% elbow medial", "% medial elbow"});
  set_both(model, WristThumb, {"% wrist"});
  set_both(model, Thigh, {"% bar 1", "% thigh"});
  set_both(model, Knee, {"% knee 1", "% knee"});
  set_both(model, KneeInner, {"% knee medial", "% medial knee"});
  set_both(model, Shin, {"% bar 2", "% shank"});
  set_both(model, Ankle, {"% mall", "% ankle"});
  set_both(model, AnkleInner, {"% ankle medial", "% medial ankle"});
  set_both(model, Heel, {"% heel"});
  set_both(model, Toe, {"% met", "% toe"});
  return model;
}

/// Landmarks as the ISB abbreviates them (van Sint Jan 2007), which the sets of the Istituti Ortopedici
/// Rizzoli and CAST (Cappozzo et al. 1995) use, and Qualisys and OptiTrack's Biomech with them.
MarkerModel ior_cast() {
  MarkerModel model;
  model.name = "ior-cast";
  set(model, Neck, {"CV7", "C7"});
  set(model, Back, {"TV8", "TV7", "TV10", "T10", "MAI"});
  set(model, Clavicle, {"SJN", "IJ"});
  set(model, Sternum, {"SXS", "PX"});
  set(model, Sacrum, {"SAC", "SACR"});
  set(model, HeadTop, {"HDT", "SGL_T"});
  set_both(model, HeadFrontSide, {"%_HDF", "%AH"});
  set_both(model, HeadBackSide, {"%_HDB", "%PH"});
  set_both(model, PelvisFront, {"%_IAS", "%_ASIS"});
  set_both(model, PelvisBack, {"%_IPS", "%_PSIS"});
  set_both(model, Shoulder, {"%_SAJ", "%_CAJ", "%_SAE", "%_ACR", "%A"});
  set_both(model, Elbow, {"%_HLE", "%_LE"});
  set_both(model, ElbowInner, {"%_HME", "%_ME"});
  set_both(model, WristThumb, {"%_RSP", "%_RS"});
  set_both(model, WristLittle, {"%_UHE", "%_USP", "%_US"});
  set_both(model, Hand, {"%_HM3"});
  set_both(model, HandThumb, {"%_HM2"});
  set_both(model, HandLittle, {"%_HM5"});
  set_both(model, Knee, {"%_FLE", "%_LFE"});
  set_both(model, KneeInner, {"%_FME", "%_MFE"});
  set_both(model, Ankle, {"%_FAL", "%_LM"});
  set_both(model, AnkleInner, {"%_TAM", "%_MM"});
  set_both(model, Heel, {"%_FCC", "%_CA"});
  set_both(model, Toe, {"%_FM2", "%_SM"});
  set_both(model, ToeInner, {"%_FM1", "%_FM"});
  set_both(model, ToeOuter, {"%_FM5", "%_VM"});
  return model;
}

/// Marker sets of OpenSim's models (gait2392, Rajagopal et al. 2016, OpenCap's and AddBiomechanics' files).
/// The toe marker is on the tip of the shoe.
MarkerModel rajagopal() {
  MarkerModel model;
  model.name = "rajagopal";
  set(model, Neck, {"C7", "C7_study"});
  set(model, Clavicle, {"CLAV"});
  set(model, Sternum, {"Sternum"});
  set(model, Sacrum, {"S2", "V.Sacral", "Sacrum"});
  set(model, HeadTop, {"Top.Head"});
  set_both(model, ClavicleSide, {"%.Clavicle", "%.SC"});
  set_both(model, PelvisFront, {"%.ASIS"});
  set_both(model, PelvisBack, {"%.PSIS"});
  set_both(model, Shoulder, {"%.Shoulder", "%.Acromium", "%.Acromion"});
  set_both(model, UpperArm, {"%.Biceps"});
  set_both(model, Elbow, {"%.Elbow", "%_elbow_lat", "%.LElbow", "%LEL", "%.Elbow.Lat"});
  set_both(model, ElbowInner, {"%_elbow_med", "%.MElbow", "%MEL", "%.Elbow.Med"});
  set_both(model, WristThumb, {"%.Wrist", "%_wrist_radius", "%FAradius", "%.Wrist.Rad"});
  set_both(model, WristLittle, {"%_wrist_ulna", "%FAulna", "%.Wrist.Ulna"});
  set_both(model, Knee, {"%.Knee", "%LFC", "%.Knee.Lat"});
  set_both(model, KneeInner, {"%_mknee", "%MFC", "%.Knee.Med"});
  set_both(model, Ankle, {"%.Ankle", "%LMAL", "%.Ankle.Lat"});
  set_both(model, AnkleInner, {"%_mankle", "%MMAL", "%.Ankle.Med"});
  set_both(model, Heel, {"%.Heel", "%CAL", "%_calc"});
  set_both(model, ToeOuter, {"%.MT5", "%_5meta"});
  set_both(model, ToeInner, {"%.MT1"});
  set_both(model, ToeTip, {"%.Toe", "%.Toe.Tip"});
  return model;
}

/// The 47 of the Human Body Model (van den Bogert et al. 2013).
MarkerModel human_body_model() {
  MarkerModel model;
  model.name = "human-body-model";
  set(model, Neck, {"C7"});
  set(model, Back, {"T10"});
  set(model, Clavicle, {"JN"});
  set(model, Sternum, {"XYPH", "STRN"});
  set(model, Sacrum, {"SACR"});
  set(model, HeadTop, {"THEAD"});
  set(model, HeadFront, {"FHEAD"});
  set_both(model, Ear, {"%HEAD"});
  set_both(model, PelvisFront, {"%ASIS"});
  set_both(model, PelvisBack, {"%PSIS"});
  set_both(model, Shoulder, {"%SHO"});
  set_both(model, Elbow, {"%LEE"});
  set_both(model, ElbowInner, {"%MEE"});
  set_both(model, WristThumb, {"%LW"});
  set_both(model, WristLittle, {"%MW"});
  set_both(model, Hand, {"%FIN"});
  set_both(model, Knee, {"%LEK"});
  set_both(model, KneeInner, {"%MEK"});
  set_both(model, Ankle, {"%LM"});
  set_both(model, AnkleInner, {"%MM"});
  set_both(model, Heel, {"%HEE"});
  set_both(model, Toe, {"%TOE"});
  set_both(model, ToeOuter, {"%MT5"});
  return model;
}

/// Points on the skin that Xsens MVN writes to C3D.
MarkerModel xsens_points() {
  MarkerModel model;
  model.name = "xsens-points";
  set(model, Neck, {"pC7SpinalProcess"});
  set(model, Back, {"pT8SpinalProcess"});
  set(model, Clavicle, {"pIJ"});
  set(model, Sternum, {"pPX"});
  set(model, Sacrum, {"pSacrum"});
  set(model, HeadTop, {"pTopOfHead"});
  set_both(model, Ear, {"p@Auricularis"});
  set_both(model, PelvisFront, {"p@ASI"});
  set_both(model, PelvisBack, {"p@PSI"});
  set_both(model, Shoulder, {"p@Acromion"});
  set_both(model, Elbow, {"p@ArmLatEpicondyle"});
  set_both(model, ElbowInner, {"p@ArmMedEpicondyle"});
  set_both(model, WristThumb, {"p@RadialStyloid"});
  set_both(model, WristLittle, {"p@UlnarStyloid"});
  set_both(model, HandThumb, {"p@BallHand"});
  set_both(model, HandLittle, {"p@Pinky"});
  set_both(model, Knee, {"p@KneeLatEpicondyle"});
  set_both(model, KneeInner, {"p@KneeMedEpicondyle"});
  set_both(model, Ankle, {"p@LatMalleolus"});
  set_both(model, AnkleInner, {"p@MedMalleolus"});
  set_both(model, Heel, {"p@HeelFoot"});
  set_both(model, ToeInner, {"p@FirstMetatarsal"});
  set_both(model, ToeOuter, {"p@FifthMetatarsal"});
  set_both(model, ToeTip, {"p@Toe"});
  return model;
}

/// All names of all models; of two places with one name the one of the earlier model.
MarkerModel landmarks(const std::vector<MarkerModel>& models) {
  MarkerModel all;
  all.name = "landmarks";
  std::vector<std::string> known;
  for (const MarkerModel& model : models) {
    std::vector<std::string> added;
    for (std::size_t place = 0; place < marker_place_count; ++place)
      for (const std::size_t side : {0U, 1U})
        for (const std::string& name : model.names[place][side]) {
          std::string plain;
          for (const char c : name)
            if (c != ' ' && c != '.' && c != '_')
              plain += static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c);
          if (std::find(known.begin(), known.end(), plain) != known.end()) continue;
          all.names[place][side].push_back(name);
          added.push_back(plain);
        }
    known.insert(known.end(), added.begin(), added.end());
  }
  return all;
}

}  // namespace

const std::vector<MarkerModel>& builtin_marker_models() {
  static const std::vector<MarkerModel> models = [] {
    std::vector<MarkerModel> all = {plug_in_gait(), cmu_markers(), optitrack(),        ior_cast(),
                                    rajagopal(),    helen_hayes(), human_body_model(), xsens_points()};
    all.push_back(landmarks(all));
    return all;
  }();
  return models;
}

}  // namespace abrazo
