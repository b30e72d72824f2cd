#include "core/motion/joints/marker_set.hpp"

#include <cctype>
#include <map>

#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

using enum MarkerPlace;

/// "Anna:L.ASIS" -> "lasis".
std::string marker_key(std::string_view name) {
  if (const auto colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  std::string key;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return key;
}

bool marks_toes(const MarkerSet& set, std::size_t side) {
  return set.has(Toe, side) || set.has(ToeInner, side) || set.has(ToeOuter, side);
}

bool marks_wrist(const MarkerSet& set, std::size_t side) {
  return set.has(WristThumb, side) || set.has(WristLittle, side);
}

std::vector<std::string> missing_of(const MarkerModel& model, const MarkerSet& set) {
  std::vector<std::string> missing;
  const auto need = [&](bool there, std::initializer_list<MarkerPlace> places, std::size_t side) {
    if (there) return;
    for (const MarkerPlace place : places)
      if (const auto& names = model.names[static_cast<std::size_t>(place)][side]; !names.empty()) {
        missing.push_back(names.front());
        return;
      }
    missing.push_back(name_of_place(*places.begin(), side));
  };
  for (const std::size_t side : {0U, 1U}) {
    need(set.has(PelvisBack, side) || set.has(Sacrum), {PelvisBack}, side);
    for (const MarkerPlace place : {PelvisFront, Shoulder, Elbow, Knee, Ankle})
      need(set.has(place, side), {place}, side);
    need(marks_toes(set, side), {Toe, ToeInner, ToeOuter}, side);
    need(marks_wrist(set, side), {WristThumb, WristLittle}, side);
  }
  return missing;
}

}  // namespace

MarkerSet::MarkerSet(const MarkerModel& model, std::vector<std::string> points) {
  std::map<std::string, int> known;
  const auto take_names = [&] {
    for (std::size_t p = 0; p < points.size(); ++p)
      if (const std::string key = marker_key(points[p]); !key.empty())
        known.emplace(key, static_cast<int>(p));
  };
  // As written, for a model that was made for this file; then without what all have in common.
  take_names();
  strip_common_beginning(points);
  take_names();
  for (std::size_t place = 0; place < marker_place_count; ++place)
    for (const std::size_t side : {0U, 1U}) {
      points_[place][side] = -1;
      for (const std::string& name : model.names[place][side])
        if (const auto found = known.find(marker_key(name)); found != known.end()) {
          points_[place][side] = found->second;
          break;
        }
    }
}

std::vector<int> MarkerSet::all() const {
  std::vector<int> every;
  for (const auto& both : points_)
    for (const int point : both)
      if (point >= 0) every.push_back(point);
  return every;
}

std::vector<std::string> missing_markers(const MarkerModel& model, const std::vector<std::string>& points) {
  return missing_of(model, MarkerSet(model, points));
}

MarkerFit fit_of(const MarkerModel& model, const std::vector<std::string>& points) {
  const MarkerSet set(model, points);
  MarkerFit fit{&model, set.all().size(), missing_of(model, set)};
  fit.legs = set.has_both(PelvisFront) && set.has_both(Knee) && (set.has_both(Ankle) || set.has_both(Heel));
  fit.arms = set.has_both(Elbow) && marks_wrist(set, 0) && marks_wrist(set, 1);
  fit.shoulders = set.has_both(Shoulder);
  return fit;
}

MarkerFit nearest_marker_model(const std::vector<std::string>& points) {
  MarkerFit nearest;
  for (const MarkerModel& model : builtin_marker_models()) {
    MarkerFit fit = fit_of(model, points);
    if (fit.missing.empty()) return fit;
    const bool better = fit.found > nearest.found ||
                        (fit.found == nearest.found && fit.missing.size() < nearest.missing.size());
    if (!nearest.model || better) nearest = std::move(fit);
  }
  return nearest;
}

std::string why_not_enough(const MarkerFit& fit) {
  constexpr std::size_t most_names = 3;
  if (fit.missing.empty()) return {};
  std::vector<std::string> joints;
  if (!fit.legs) joints.emplace_back("the legs");
  if (!fit.shoulders) joints.emplace_back("the shoulders");
  if (!fit.arms) joints.emplace_back("elbows, wrists and hands");
  return (joints.empty() ? std::string() : "No marker tells where " + some_of(joints) + " are. ") +
         "The file cannot be used without " + some_of(fit.missing, most_names) +
         ": give these places to markers, or export the recording with markers there";
}

std::string why_no_body(const MarkerFit& fit) {
  constexpr std::size_t most_names = 8;
  const std::string nearest = "the nearest marker set, '" + fit.model->name + "', of which " +
                              std::to_string(fit.found) + " markers are there, also has " +
                              some_of(fit.missing, most_names);
  const std::string needed =
      ". A partner answers the head, the hands and the feet: both shoulders, elbows, wrists, knees, ankles "
      "and "
      "toes and the pelvis must be marked";
  if (fit.legs && !fit.arms)
    return std::string(fit.shoulders ? "" : "the markers are of the lower body; ") +
           "arms are not marked, and cannot be inferred: " + nearest + needed;
  if (fit.arms && !fit.legs)
    return "the markers are of the upper body; legs are not marked, and cannot be inferred: " + nearest +
           needed;
  return "the markers are of a part of a body, or have unknown names: " + nearest + needed +
         ". Where they are, a marker model says: {\"name\": \"mine\", \"markers\": {\"neck\": \"M1\", \"left "
         "shoulder\": \"M2\", ...}}";
}

}  // namespace abrazo
