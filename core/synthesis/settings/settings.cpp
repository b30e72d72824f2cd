#include "core/synthesis/settings/settings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/json_text.hpp"
#include "core/base/limits.hpp"
#include "core/base/text.hpp"
#include "core/synthesis/settings/settings_check.hpp"

namespace abrazo {

namespace {

constexpr double reference_rate_hz = 15;
constexpr double lowest_step_rate_hz = 5;
constexpr double highest_weighed_rate_hz =
    240;  ///< poses closer than this are weighed as if they were this far apart

using Kind = SettingInfo::Kind;

/// A setting's description and its place in Settings, as a number (flags 0/1, choices their index).
struct Entry {
  SettingInfo info;
  std::function<double(const Settings&)> get;
  std::function<void(Settings&, double)> set;
  BodyChoice Settings::*body = nullptr;  ///< with Kind::Body, instead of a number
};

template <typename T>
Entry entry(const SettingInfo& info, T Settings::*member) {
  return {info, [member](const Settings& s) { return static_cast<double>(s.*member); },
          [member](Settings& s, double value) { s.*member = static_cast<T>(value); }};
}

Entry body_entry(const SettingInfo& info, BodyChoice Settings::*member) {
  return {info, [](const Settings&) { return 0.0; }, [](Settings&, double) {}, member};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      entry({"selection", "", "method", "Selection", "", Kind::Choice, 0, 1, false, "paper|intent",
             "How a recorded pair is selected.\n"
             "  paper: the cheapest of the k nearest poses by Eq. 7\n"
             "  intent: the pair with the least expected distance from the partner that fits the user's last "
             "two seconds; learned from the library in a second or more\n"
             "Paper 3.3.2-3.3.3: paper."},
            &Settings::selection),
      entry(
          {"alpha", "\u03b1", "temporal smoothness", "Selection", "", Kind::Real, 0, 5, false, "",
           "Weight of temporal coherence in the selection.\n"
           "  cost = \u03a3|p_in \u2212 p_A|\u00b2 + \u03b1 (\u03a3|s_{A,i*} \u2212 q\u2033_A|\u00b2 + "
           "\u03a3|s_{S,i*} \u2212 q\u2033_S|\u00b2)\n"
           "s_{i*} is the previous result, extrapolated with its velocity (Eq. 3-4). The method intent adds "
           "\u03b1 times the sum of the mean distance from the shown partner, 0.1 s of the difference in "
           "velocity, and the effect of the change on held hands and standing feet [m]. Higher: fewer "
           "changes "
           "of source, but the partner stays in a move longer.\n"
           "Paper 3.3.3, Eq. 7: 0.5."},
          &Settings::alpha),
      entry(
          {"neighbours", "k", "neighbours", "Selection", "", Kind::Integer, 1, 200, true, "",
           "Number of recorded pairs nearest to the user's pose, by the positions of head, hands and feet, "
           "that Eq. 7 compares.\n"
           "Higher: the best pair is missed less often, and a step takes longer. The method intent compares "
           "all pairs, and fully evaluates and lists this number of the best.\n"
           "Paper 3.3.2: 10."},
          &Settings::neighbours),
      entry({"continuations", "", "continuations", "Selection", "frames", Kind::Integer, 0, 15, false, "",
             "Number of recorded successors of the current source that join the candidates, so that the "
             "source can always continue.\n"
             "Not in the paper: 0. Used by the method paper with the playback frames."},
            &Settings::continuations),
      entry({"switch-margin", "", "switch margin", "Selection", "m", Kind::Real, 0, 0.5, false, "",
             "Gain in cost that a change of source must bring. Higher: fewer and later changes.\n"
             "Not in the paper; used by the method intent."},
            &Settings::switch_margin),
      entry({"leader-weight", "w_l", "leader weight", "Selection", "m", Kind::Real, 0, 2, false, "",
             "Cost of a pair whose recorded leader moved differently from the user.\n"
             "  w_l (1 \u2212 k(user's last 2 s, leader's 2 s before the pair))\n"
             "Not in the paper; used by the method intent."},
            &Settings::leader_weight),
      entry({"move-weight", "w_m", "move weight", "Selection", "m", Kind::Real, 0, 2, false, "",
             "Cost of a pair whose label is unlikely after the user's last motion.\n"
             "  w_m (1 \u2212 P(label))\n"
             "Not in the paper; used by the method intent. No effect in a library without labels."},
            &Settings::move_weight),
      entry({"meant-weight", "w_p", "intended-move weight", "Selection", "m", Kind::Real, 0, 2, false, "",
             "Cost of a pair that does not have the declared label or take. Higher: the declaration counts "
             "more than the observed motion.\n"
             "Not in the paper; used by the method intent. Eq. 7 compares only pairs of the declared move."},
            &Settings::meant_weight),
      entry(
          {"user-role", "", "user's role", "Selection", "", Kind::Choice, 0, 1, false, "active|passive",
           "Whether the user leads (active, Role_A) or follows (passive, Role_S). After a change both bodies "
           "continue from their positions.\n"
           "Paper 3.3.1: active; section 5 mentions both."},
          &Settings::user_role),
      entry({"velocity-weight", "w_\u0394", "velocity weight", "Energies", "", Kind::Real, 0, 2, false, "",
             "Weight of the velocity energy, which compares a pose with the previous one.\n"
             "  minimise E_L + w_\u0394 E_V + E_C\n"
             "At f steps per second it is w_\u0394 f/15, or w_\u0394 (f/15)\u00b2 when predicted, so that "
             "the time constant is the same. Higher: smoother, but the partner lags behind.\n"
             "Paper 3.4.2, Eq. 11: 0.2 at 15 steps per second."},
            &Settings::velocity_weight),
      entry({"velocity-form", "", "velocity energy", "Energies", "", Kind::Choice, 0, 1, false,
             "velocity|predicted",
             "What the velocity energy compares a pose with: the previous result, or the linear prediction "
             "from the previous two.\n"
             "  velocity: E_V = \u00bd|V_i \u2212 V_{i-1}|\u00b2\n"
             "  predicted: E_V = \u00bd|V_i \u2212 (2V_{i-1} \u2212 V_{i-2})|\u00b2\n"
             "Paper 3.4.2 has E_V(V_i, V_{i-1}) without a formula."},
            &Settings::velocity_form),
      entry({"morph-weight", "w_C", "morphing weight", "Energies", "", Kind::Real, 0.1, 1000, true, "",
             "Weight of the morphing constraint, which pulls the user's character to the user's pose.\n"
             "  E_C = \u00bd w_C \u03a3|q_interpolated \u2212 v_A|\u00b2\n"
             "Higher: it follows the user more exactly.\n"
             "Paper 3.4.2, Eq. 9; a soft constraint whose weight is not stated."},
            &Settings::morph_weight),
      entry({"edge-weights", "", "edge weights", "Energies", "", Kind::Choice, 0, 2, false,
             "inverse|inverse-mean|uniform",
             "Weights of the mesh neighbours of a joint in its Laplacian coordinate, by their distance d in "
             "the selected pair.\n"
             "  L(v_j) = \u03a3_l w_jl (v_j \u2212 v_l)\n"
             "  inverse: w_jl = (1/d_jl) / \u03a3_k (1/d_jk)\n"
             "  inverse-mean: w_jl = (1/n)(1/d_jl)\n"
             "  uniform: w_jl = 1/n\n"
             "Paper 3.4.2 takes E_L from Ho et al. 2010: inverse."},
            &Settings::edge_weights),
      entry({"anchor-weight", "", "anchor weight", "Energies", "", Kind::Real, 1e-6, 0.1, true, "",
             "Weak pull of the partner to the selected pair, for joints without a short mesh edge.\n"
             "  \u00bd w_a |V_S \u2212 q\u2033_{S,sel}|\u00b2\n"
             "Not in the paper."},
            &Settings::anchor_weight),
      entry({"hold-weight", "w_H", "hold weight", "Energies", "", Kind::Real, 0, 1000, false, "",
             "Pulls hands together that hold one another in the recording. 0: only the mesh does.\n"
             "  \u00bd w_H |(v_S \u2212 v_A) \u2212 (q_S \u2212 q_A)|\u00b2\n"
             "Not in the paper: 0; used by the playback continuous."},
            &Settings::hold_weight),
      entry({"morph-steps", "m", "morph steps", "Constraints", "", Kind::Integer, 1, 20, false, "",
             "Steps from the selected pose to the user's. Each solves Eq. 11 once.\n"
             "  q_interpolated = (i/m)(q\u2032_in \u2212 q\u2033_{A,sel}) + q\u2033_{A,sel}\n"
             "Paper 3.4.2, Eq. 8, without a number. Used by the playback frames."},
            &Settings::morph_steps),
      entry({"projection-steps", "", "projection steps", "Constraints", "", Kind::Integer, 0, 10, false, "",
             "Further steps on the full target, which restore the bone lengths.\n"
             "More are taken while a bone length is wrong by more than 0.02 %.\n"
             "Not in the paper."},
            &Settings::projection_steps),
      entry({"foot-locks", "", "foot locks", "Constraints", "", Kind::Flag, 0, 1, false, "",
             "A foot that was landed in the previous frame and still is does not move.\n"
             "  V_{feet,i} = V_{feet,i-1}\n"
             "Paper 3.4.2, Eq. 10: on."},
            &Settings::foot_locks),
      entry(
          {"foot-lock-speed", "", "planted below", "Constraints", "m/s", Kind::Real, 0, 1, false, "",
           "A foot faster than this is not planted. 0: only the height decides. With the playback continuous "
           "it applies to the user's feet; the partner's stand as in the recording.\n"
           "Paper 3.4.2: 0."},
          &Settings::foot_lock_speed),
      entry({"collisions", "", "collisions", "Constraints", "", Kind::Flag, 0, 1, false, "",
             "Keeps the bodies' capsules apart, as far as they are apart in the recorded pair.\n"
             "Paper 3.4.2, hard constraint C_C: on."},
            &Settings::collisions),
      entry(
          {"playback", "", "playback", "Timing", "", Kind::Choice, 0, 1, false, "frames|continuous",
           "How the selected pair becomes motion.\n"
           "  frames: every step edits the selected recorded frame, placed at the user\n"
           "  continuous: the recording continues at the user's pace, the partner's place is a state with a "
           "speed, changes of source fade, feet stand where they landed, hands that hold stay together\n"
           "Paper 3.4: frames."},
          &Settings::playback),
      entry({"transition-time", "", "transition time", "Timing", "s", Kind::Real, 0.05, 1, false, "",
             "Duration of the transition after a small change of source; a large one takes up to 5/3 of it. "
             "Longer: smoother, but the partner reaches its place later.\n"
             "Not in the paper; used by the playback continuous."},
            &Settings::transition_time_s),
      entry({"place-rate", "\u03c9", "place rate", "Timing", "1/s", Kind::Real, 0.5, 30, true, "",
             "Rate at which the partner approaches its desired place D; v and d are the speeds of the "
             "recording and of D, filtered.\n"
             "  P\u2033 = \u03c9\u00b2 e / (1 + |e| / 0.35 m) \u2212 2 \u03c9 (P\u2032 \u2212 0.6 v \u2212 "
             "0.4 d),  e = "
             "D \u2212 P\n"
             "Higher: nearer, but the partner follows every movement of the user's hips.\n"
             "Not in the paper; used by the playback continuous."},
            &Settings::place_rate),
      entry({"step-rate", "", "step rate", "Timing", "Hz", Kind::Real, 0, 120, false, "",
             "Solved frames per second, at least 5. 0: the input's own rate, at most 120.\n"
             "Paper 3.3.3: \u0394t = 1/15 s, so 15."},
            &Settings::step_rate_hz),
      entry({"scale-root-path", "", "scale the user's path", "Timing", "", Kind::Flag, 0, 1, false, "",
             "Scales the path of a user of another size by the ratio of the leg lengths.\n"
             "Off: the path stays 1:1, and planted feet of such a user slide.\n"
             "Paper 3.3.1 retargets after Gleicher 1998 without a statement on this."},
            &Settings::scale_root_path),
      body_entry(
          {"active-body", "", "leader's body", "Bodies", "", Kind::Body, 0, 0, false,
           "library|user|scale:NUMBER|FILE",
           "Body that the active character is shown with.\n"
           "  library: the recorded performer's\n"
           "  user: the user's own, in the user's own pose\n"
           "  scale:0.85: the recorded performer's, all lengths times 0.85\n"
           "  FILE: with the lengths of the performer in a motion file\n"
           "The partner is selected and moved with the library's bodies, and then fitted: holds and near "
           "joints keep their relation, steps follow the legs. A change takes 1.5 s.\n"
           "Not in the paper: library."},
          &Settings::active_body),
      body_entry({"passive-body", "", "follower's body", "Bodies", "", Kind::Body, 0, 0, false,
                  "library|scale:NUMBER|FILE",
                  "Body that the passive character is shown with; see the leader's body.\n"
                  "Not in the paper: library."},
                 &Settings::passive_body),
  };
  return all;
}

const Entry* find_entry(std::string_view key) {
  const auto found =
      std::find_if(entries().begin(), entries().end(), [&](const Entry& e) { return e.info.key == key; });
  return found == entries().end() ? nullptr : &*found;
}

Error wrong_value(const SettingInfo& info, std::string_view text, const std::string& expected) {
  return Error{"'" + std::string(text) + "' cannot be used: " + expected, "--" + std::string(info.key)};
}

Status set_checked(Settings& settings, const Entry& found, double value, std::string_view text) {
  const SettingInfo& info = found.info;
  const bool whole = info.kind == Kind::Real || value == std::floor(value);
  if (!std::isfinite(value) || !whole || value < info.minimum || value > info.maximum)
    return wrong_value(info, text,
                       std::string(info.kind == Kind::Integer ? "a whole number" : "a number") + " from " +
                           exact_text(info.minimum) + " to " + exact_text(info.maximum) + " is expected");
  if (info.key == "step-rate" && value > 0 && value < lowest_step_rate_hz)
    return wrong_value(info, text,
                       "0 (the input's own rate) or a number from 5 to 120 is expected: after a gap of 0.3 s "
                       "every step would be a first one");
  found.set(settings, value);
  return Done{};
}

Status set_body(Settings& settings, const Entry& found, std::string_view text) {
  auto choice = parse_body_choice(text);
  if (!choice) return Error{choice.error().message, "--" + std::string(found.info.key)};
  if (choice->kind == BodyChoice::Kind::User && found.body == &Settings::passive_body)
    return wrong_value(found.info, text, "library, scale:NUMBER or a motion file is expected");
  // A file that was read stays read.
  BodyChoice& chosen = settings.*found.body;
  if (choice->kind == BodyChoice::Kind::OfFile && choice->file == chosen.file)
    choice->measured = chosen.measured;
  chosen = std::move(*choice);
  return Done{};
}

constexpr double greatest_length_m = 10;

/// {"file": "walk.bvh", "bones": [...], "pseudo-bones": [...], "toe-rest-height": 0.02}, as body_json writes.
Status set_body(Settings& settings, const Entry& found, const nlohmann::json& value) {
  const auto wrong = [&] {
    return wrong_value(found.info, value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                       "a file with its lengths in metres is expected");
  };
  const auto is_length = [](const nlohmann::json& length) {
    return length.is_number() && std::abs(length.get<double>()) <= greatest_length_m;
  };
  Body body;
  const auto read = [&](const char* key, auto& lengths) {
    if (!value.contains(key) || !value[key].is_array() || value[key].size() != lengths.size()) return false;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (!is_length(value[key][i]) || value[key][i].template get<double>() < 0) return false;
      lengths[i] = value[key][i].template get<double>();
    }
    return true;
  };
  if (value.size() != 4 || !value.contains("file") || !value["file"].is_string() ||
      !value.contains("toe-rest-height") || !is_length(value["toe-rest-height"]) ||
      !read("bones", body.bone_lengths) || !read("pseudo-bones", body.pseudo_lengths))
    return wrong();
  body.toe_rest_height = value["toe-rest-height"].get<double>();
  const Status set = set_body(settings, found, std::string_view(value["file"].get_ref<const std::string&>()));
  if (!set) return set;
  BodyChoice& choice = settings.*found.body;
  if (choice.kind != BodyChoice::Kind::OfFile) return wrong();
  choice.measured = body;
  return Done{};
}

void write_body(const BodyChoice& choice, JsonText& json) {
  if (!choice.measured) {
    json.value(body_choice_text(choice));
    return;
  }
  json.begin_object().key("file").value(body_choice_text(choice)).key("bones").begin_array();
  for (const double length : choice.measured->bone_lengths) json.value(length);
  json.end_array().key("pseudo-bones").begin_array();
  for (const double length : choice.measured->pseudo_lengths) json.value(length);
  json.end_array().key("toe-rest-height").value(choice.measured->toe_rest_height).end_object();
}

Status set_json(Settings& settings, const Entry& found, const nlohmann::json& value) {
  if (found.body && value.is_object()) return set_body(settings, found, value);
  if (value.is_boolean()) return set_setting(settings, found.info.key, value.get<bool>() ? "on" : "off");
  if (value.is_string()) return set_setting(settings, found.info.key, value.get<std::string>());
  if (value.is_number()) return set_setting(settings, found.info.key, exact_text(value.get<double>()));
  return wrong_value(found.info, value.dump(), "a number, a text or true/false is expected");
}

}  // namespace

Result<Settings> preset(std::string_view name) {
  Settings settings;
  if (name == "paper") {
    settings.step_rate_hz = 15;
    return settings;
  }
  if (name == "responsive") {
    settings.selection = SelectionMethod::Intent;
    settings.step_rate_hz = 0;
    settings.alpha = 0.2;
    settings.velocity_weight = 0;
    settings.continuations = 3;
    settings.foot_lock_speed = 0.3;
    settings.playback = SourcePlayback::Continuous;
    settings.hold_weight = 50;
    settings.switch_margin = 0.097;
    return settings;
  }
  return Error{"'" + std::string(name) + "' is not a preset; use paper or responsive", "",
               Hint::ChoosePreset};
}

double velocity_weight_at(const Settings& settings, double dt_s) {
  if (dt_s <= 0) return settings.velocity_weight;
  const double rate_ratio = std::min(1.0 / dt_s, highest_weighed_rate_hz) / reference_rate_hz;
  return settings.velocity_weight *
         (settings.velocity_form == VelocityForm::Velocity ? rate_ratio : rate_ratio * rate_ratio);
}

std::span<const SettingInfo> all_settings() {
  static const std::vector<SettingInfo> infos = [] {
    std::vector<SettingInfo> list;
    for (const Entry& e : entries()) list.push_back(e.info);
    return list;
  }();
  return infos;
}

const SettingInfo* find_setting(std::string_view key) {
  const Entry* found = find_entry(key);
  return found ? &found->info : nullptr;
}

std::string setting_names() {
  std::string names;
  for (const SettingInfo& info : all_settings()) names += (names.empty() ? "" : ", ") + std::string(info.key);
  return names;
}

namespace {

/// What a setting refines is off: "a velocity weight above 0; it is 0 now". Empty if it is not, or if it
/// refines none.
std::string_view what_is_off(const Settings& settings, std::string_view key) {
  if (key == "velocity-form" && settings.velocity_weight == 0)
    return "a velocity weight above 0; it is 0 now";
  if (key == "foot-lock-speed" && !settings.foot_locks) return "foot locks; they are off now";
  return {};
}

}  // namespace

bool applies(const Settings& settings, std::string_view key) {
  constexpr std::array<std::string_view, 1> of_paper = {"continuations"};
  // The continuation of the running recording is always a candidate.
  constexpr std::array<std::string_view, 2> of_frames = {"morph-steps", "continuations"};
  constexpr std::array<std::string_view, 3> of_continuous = {"transition-time", "place-rate", "hold-weight"};
  constexpr std::array<std::string_view, 4> of_intent = {"switch-margin", "leader-weight", "move-weight",
                                                         "meant-weight"};
  const auto is_of = [key](const auto& keys) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  if (!what_is_off(settings, key).empty()) return false;
  if (settings.playback == SourcePlayback::Frames ? is_of(of_continuous) : is_of(of_frames)) return false;
  return settings.selection == SelectionMethod::Intent ? !is_of(of_paper) : !is_of(of_intent);
}

std::string why_it_does_not_apply(const Settings& settings, std::string_view key) {
  if (const std::string_view off = what_is_off(settings, key); !off.empty())
    return "Only with " + std::string(off);
  Settings of_method = settings, of_playback = settings;
  of_method.selection =
      settings.selection == SelectionMethod::Paper ? SelectionMethod::Intent : SelectionMethod::Paper;
  of_playback.playback =
      settings.playback == SourcePlayback::Frames ? SourcePlayback::Continuous : SourcePlayback::Frames;
  const bool by_method = applies(of_method, key), by_playback = applies(of_playback, key);
  std::string needed, now;
  const auto need = [&](const char* what, const std::string& wanted, const std::string& is) {
    needed += (needed.empty() ? "" : " and ") + (what + (" " + wanted));
    now += (now.empty() ? "" : " and ") + is;
  };
  if (!by_playback)
    need("the method", setting_text(of_method, "selection"), setting_text(settings, "selection"));
  if (!by_method)
    need("the playback", setting_text(of_playback, "playback"), setting_text(settings, "playback"));
  return "Only with " + needed + "; it is " + now + " now";
}

double setting_number(const Settings& settings, std::string_view key) {
  return find_entry(key)->get(settings);
}

std::string setting_text(const Settings& settings, std::string_view key) {
  const Entry& found = *find_entry(key);
  if (found.body) return body_choice_text(settings.*found.body);
  const double value = found.get(settings);
  if (found.info.kind == Kind::Flag) return value != 0 ? "on" : "off";
  if (found.info.kind == Kind::Choice)
    return std::string(split_fields(found.info.choices, '|').at(static_cast<std::size_t>(value)));
  return exact_text(value);
}

Status set_setting(Settings& settings, std::string_view key, std::string_view text) {
  const Entry* found = find_entry(key);
  if (!found) return Error{"there is no setting of this name", std::string(key)};
  if (found->body) return set_body(settings, *found, text);
  if (found->info.kind == Kind::Flag) {
    if (text != "on" && text != "off") return wrong_value(found->info, text, "on or off is expected");
    found->set(settings, text == "on" ? 1 : 0);
    return Done{};
  }
  if (found->info.kind == Kind::Choice) {
    const auto choices = split_fields(found->info.choices, '|');
    const auto at = std::find(choices.begin(), choices.end(), text);
    if (at == choices.end())
      return wrong_value(found->info, text, "one of " + std::string(found->info.choices) + " is expected");
    found->set(settings, static_cast<double>(at - choices.begin()));
    return Done{};
  }
  const auto value = parse_number(text);
  return set_checked(settings, *found, value.value_or(std::numeric_limits<double>::quiet_NaN()), text);
}

Status check_settings(const Settings& settings) {
  Settings checked;
  for (const Entry& e : entries()) {
    if (e.body) {
      const BodyChoice& choice = settings.*e.body;
      if (choice.kind == BodyChoice::Kind::OfFile && !choice.measured)
        return Error{"the body in this file was not measured", choice.file};
      if (choice.kind == BodyChoice::Kind::User && e.body == &Settings::passive_body)
        return wrong_value(e.info, "user", "library, scale:NUMBER or a motion file is expected");
      continue;
    }
    const double value = e.get(settings);
    const Status fits = set_checked(checked, e, value, exact_text(value));
    if (!fits) return fits;
  }
  return Done{};
}

std::string settings_json(const Settings& settings) {
  JsonText json;
  json.begin_object();
  for (const Entry& e : entries()) {
    json.key(e.info.key);
    if (e.body)
      write_body(settings.*e.body, json);
    else if (e.info.kind == Kind::Flag)
      json.value(e.get(settings) != 0);
    else if (e.info.kind == Kind::Choice)
      json.value(setting_text(settings, e.info.key));
    else
      json.value(e.get(settings));
  }
  json.end_object();
  return json.take();
}

Result<Settings> parse_settings(std::string_view json, const Settings& start, std::string_view where) {
  if (json.size() > limits::settings_bytes)
    return Error{"has " + std::to_string(json.size()) + " bytes of settings; up to " +
                     std::to_string(limits::settings_bytes) + " are read",
                 std::string(where)};
  if (const char* beyond = json_beyond_bounds(json)) return Error{beyond, std::string(where)};
  const nlohmann::json parsed = nlohmann::json::parse(json, nullptr, false);
  if (!parsed.is_object())
    return Error{"an object of settings is expected, as in {\"alpha\": 0.5}", std::string(where)};
  Settings settings = start;
  for (const auto& [key, value] : parsed.items()) {
    const Entry* found = find_entry(key);
    if (!found)
      return Error{in_quotes(key) + " is not a setting; there are " + setting_names(), std::string(where)};
    const Status set = set_json(settings, *found, value);
    if (!set) return Error{set.error().text(), std::string(where)};
  }
  return settings;
}

}  // namespace abrazo
