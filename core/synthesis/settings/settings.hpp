#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/mesh/laplacian.hpp"
#include "core/motion/body/body_choice.hpp"

namespace abrazo {

enum class VelocityForm { Velocity, Predicted };
enum class UserRole { Active, Passive };
enum class SelectionMethod { Paper, Intent };
enum class SourcePlayback { Frames, Continuous };

/// All tunable settings, as one value. Weights of energies are those at 15 steps per second; at other rates
/// `velocity_weight_at` gives the weight with the same time constant.
struct Settings {
  SelectionMethod selection = SelectionMethod::Paper;
  double alpha = 0.5;            ///< weight of the temporal terms in Eq. 7
  double velocity_weight = 0.2;  ///< w_Delta of Eq. 11, at 15 Hz
  VelocityForm velocity_form = VelocityForm::Velocity;
  double morph_weight = 10;  ///< weight of the morphing constraint in E_C (Eq. 9)
  int morph_steps = 5;       ///< m of Eq. 8
  int projection_steps = 2;  ///< further steps on the full target, which restore bone lengths after the last
                             ///< rotation
  int neighbours = 10;       ///< k
  EdgeWeights edge_weights = EdgeWeights::Inverse;
  double step_rate_hz = 0;  ///< 0 = the input's own rate, at most 120
  bool collisions = true;
  bool foot_locks = true;
  UserRole user_role = UserRole::Active;

  // Of the selection `intent` [m]: see IntentCost.
  double switch_margin = 0.03;  ///< cost by which another source must be better
  double leader_weight = 0.2;   ///< w_l
  double move_weight = 0.15;    ///< w_m
  double meant_weight = 0.2;    ///< w_p

  int continuations = 0;  ///< number of next recorded frames of the source that join the candidates
  // How the selected pair becomes motion. All except the first apply only to `continuous`.
  SourcePlayback playback = SourcePlayback::Frames;
  double transition_time_s = 0.28;  ///< time in which a small change of source fades [s]
  double place_rate = 6;            ///< omega of the spring that moves the partner to its place [1/s]
  double hold_weight = 0;           ///< w_H: weight of the energy that brings held hands together

  double foot_lock_speed =
      0;  ///< a foot faster than this is not planted [m/s]; 0 = height alone decides (paper)
  double anchor_weight = 1e-3;  ///< holds the partner to the selected pair where no mesh edge does
  bool scale_root_path = true;  ///< scales the user's path in proportion to leg length

  BodyChoice active_body, passive_body;  ///< that the characters are shown with

  bool operator==(const Settings&) const = default;
};

/// "paper": as in the paper. "responsive": small lag, few jumps.
Result<Settings> preset(std::string_view name);
inline constexpr std::array<std::string_view, 2> preset_names = {"paper", "responsive"};

/// w_Delta for steps of `dt_s`. Keeps the time constant of 15 Hz: the velocity form is a first-order lag with
/// a weight proportional to the rate, the predicted form is second-order with a weight proportional to its
/// square.
double velocity_weight_at(const Settings& settings, double dt_s);

/// Description of one setting for the command line, JSON, session files and the settings panel.
struct SettingInfo {
  enum class Kind { Real, Integer, Flag, Choice, Body };
  std::string_view key;     ///< "alpha", "velocity-weight", ... as in the contract
  std::string_view symbol;  ///< "α", "w_Δ"; may be empty
  std::string_view title;   ///< "temporal smoothness"
  std::string_view group;   ///< "Selection", "Energies", "Constraints", "Timing"
  std::string_view unit;    ///< "", "Hz", "s", "m/s"
  Kind kind;
  double minimum, maximum;
  bool logarithmic;          ///< slider scale
  std::string_view choices;  ///< "velocity|predicted"
  std::string_view help;     ///< effect, with formula and section of the paper
};

/// In display order.
std::span<const SettingInfo> all_settings();
const SettingInfo* find_setting(std::string_view key);
/// "selection, alpha, ...": all keys, for messages.
std::string setting_names();
/// Whether a setting has an effect with the present selection method, playback and what it refines; most
/// always do.
bool applies(const Settings& settings, std::string_view key);
/// "Only with the method intent; it is paper now": reason why a setting does not apply.
std::string why_it_does_not_apply(const Settings& settings, std::string_view key);

/// A setting by key as text ("0.5", "on", "inverse-mean"). The key must exist.
std::string setting_text(const Settings& settings, std::string_view key);
/// As a number (flags 0/1, choices their index, bodies 0: they have only a text).
double setting_number(const Settings& settings, std::string_view key);
/// Sets a setting from text; the Error gives the range or the choices.
Status set_setting(Settings& settings, std::string_view key, std::string_view text);

/// {"alpha":0.5,...} with every key.
std::string settings_json(const Settings& settings);

/// Reads settings_json; missing keys keep their value in `start`. An unknown key is an Error.
Result<Settings> parse_settings(std::string_view json, const Settings& start, std::string_view where);

}  // namespace abrazo
