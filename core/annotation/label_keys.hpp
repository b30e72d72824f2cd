#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"

namespace abrazo {

/// The tier in which a key says something: the active one, or else, of a digit, the only one. Letters of
/// other tiers stay what they are in the window. Null when there is none.
/// @param key  '1' ... '9', 'a' ... 'z'
const AnnotationTier* tier_of_key(const Annotations& annotations, int active_tier, char key);

/// Labelling by keys while time goes on (playing, looping, live): a held key says its value from the press to
/// the release; in tapping mode each tap ends the last value of its tier and begins the next, and the same
/// key again only ends it. A tier says one value at a time. Keeps what is being said; what was said is given
/// back to be drawn.
class LabelKeys {
 public:
  /// What time does at a moment.
  struct Moment {
    double cursor_s = 0;               ///< of the subject
    double fps = 0;                    ///< of its frames; 0 = no fixed rate
    bool is_parked = false;            ///< the cursor stands
    double speed = 1;                  ///< negative = backwards
    std::optional<double> out_s = {};  ///< end of the range between in and out, where it is set
  };
  struct Running {
    int tier = 0;  ///< id
    std::string value;
    double from_s = 0;
  };
  /// What was said, from frame to frame; some length, start before end.
  struct Said {
    int tier = 0;  ///< id
    std::string value;
    Annotations::Range span;
  };

  bool taps() const { return taps_; }
  /// Ends what is being said.
  std::vector<Said> set_taps(bool on, const Moment& now);
  /// @param tier  of `tier_of_key`, which has a value of the key
  std::vector<Said> press(char key, const AnnotationTier& tier, const Moment& now);
  std::vector<Said> release(char key, const Moment& now);
  std::vector<Said> finish(const Moment& now);
  /// Time passed. A cursor that stands ends what is being said; so does a loop that starts over, at its end.
  /// In tapping mode, and of a key that was pressed within its last frame, it goes on from the beginning.
  std::vector<Said> follow(const Moment& now);
  /// Another subject: nothing is being said.
  void forget() { running_.clear(); }

  bool is_running(char key) const { return running_.contains(key); }
  const std::map<char, Running>& running() const { return running_; }

 private:
  void end(char key, double at_s, double fps, std::vector<Said>& said);

  bool taps_ = false;
  std::map<char, Running> running_;  ///< by key
  double last_s_ = 0;                ///< cursor of the moment before
};

}  // namespace abrazo
