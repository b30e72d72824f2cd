#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"

namespace abrazo {

/// The tier to which a key applies: the active one if it has the key, else for a digit the only tier that has
/// it. Letters of inactive tiers keep their function in the window. Null if there is none.
/// @param key  '1' ... '9', 'a' ... 'z'
const AnnotationTier* tier_of_key(const Annotations& annotations, int active_tier, char key);

/// Labelling by keys while time advances (playing, looping, live): a held key sets its value from press to
/// release; in tapping mode each tap ends the last value of its tier and begins the next, and the same key
/// again only ends it. A tier has one value at a time. Keeps the open labels; returns finished ones to be
/// drawn.
///
/// A keyboard that repeats a held key reports releases that are none, each followed by a press. A release
/// therefore counts only once it is settled, with the time at which it came.
class LabelKeys {
 public:
  /// State of the time cursor.
  struct Moment {
    double cursor_s = 0;               ///< of the subject
    double fps = 0;                    ///< of its frames; 0 = no fixed rate
    bool is_parked = false;            ///< the cursor is parked
    double speed = 1;                  ///< negative = backwards
    std::optional<double> out_s = {};  ///< end of the range between in and out, where it is set
  };
  struct Running {
    int tier = 0;  ///< id
    std::string value;
    double from_s = 0;
  };
  /// A finished label, from frame to frame; start before end.
  struct Said {
    int tier = 0;  ///< id
    std::string value;
    Annotations::Range span;
  };

  bool taps() const { return taps_; }
  /// Switches tapping mode; ends open labels.
  std::vector<Said> set_taps(bool on, const Moment& now);
  /// A press was reported. @return false for a repetition: the release before it was none
  bool hold(char key);
  /// @param key  a press that is no repetition; @param tier  from `tier_of_key`
  std::vector<Said> press(char key, const AnnotationTier& tier, const Moment& now);
  /// A release was reported. It counts when no press of this key follows until `settle`.
  void let_go(char key, const Moment& now);
  std::vector<Said> settle();
  /// Later releases are not reported: all held keys count as released.
  std::vector<Said> let_all_go(const Moment& now);
  /// Advances the time. A parked cursor ends open labels; so does the restart of a loop, at the loop's end.
  /// In tapping mode, and for a key pressed within the last frame, the label continues from the beginning.
  std::vector<Said> follow(const Moment& now);
  /// Drops open labels, for another subject.
  void forget() { running_.clear(); }

  bool is_held(char key) const { return held_.contains(key); }
  bool is_running(char key) const { return running_.contains(key); }
  const std::map<char, Running>& running() const { return running_; }

 private:
  const Moment* release_of(char key) const;
  void end(char key, double at_s, double fps, std::vector<Said>& said);
  std::vector<Said> finish(const Moment& now);

  bool taps_ = false;
  std::map<char, Running> running_;             ///< by key
  std::map<char, std::optional<Moment>> held_;  ///< by key; with the release that is not settled yet
  double last_s_ = 0;                           ///< previous cursor
};

}  // namespace abrazo
