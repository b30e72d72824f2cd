#pragma once

#include <optional>

namespace abrazo {

/// The time cursor of the workbench: one timeline for what was recorded and what is still coming in.
/// Plain data and rules; the caller says how much time passed.
struct Playback {
  enum class State { Parked, Playing, Following };
  /// What playing does at the end of the range between in and out, or of all there is.
  enum class Repeat { Loop, PingPong };
  struct Range {
    double from_s = 0;
    double to_s = 0;
    double length_s() const { return to_s - from_s; }
    bool operator==(const Range&) const = default;
  };

  static constexpr double slowest = 0.01, fastest = 10, fastest_shuttle = 8;

  State state = State::Following;
  double cursor_s = 0;
  double speed = 1;    ///< negative plays backwards
  double first_s = 0;  ///< range there is
  double last_s = 0;
  bool every_frame = false;  ///< rather slower than asked than with a frame left out
  bool loop = false;
  Repeat repeat = Repeat::Loop;
  bool in_set = false;  ///< by hand; what is not set lies at the end of what there is
  bool out_set = false;
  double in_s = 0;  ///< a range only when out_s > in_s
  double out_s = 0;

  /// New data extends the range; only a following cursor moves with it. What was evicted pulls the cursor
  /// along.
  void extend(double first, double last);
  /// Time passes: a playing cursor moves, and follows once it reaches the live end at its speed or faster.
  void advance(double elapsed_s);
  /// The same, but not past the frame that comes next. @return how much of the time it took
  double advance_to_next(double elapsed_s, double next_frame_s);
  void seek(double time_s);  ///< parks there
  void play();               ///< from the cursor; at the end, or outside a looped range, starts over
  void pause();              ///< parks where the cursor is
  void toggle();             ///< parks, or plays onwards whatever the direction was before
  void follow();             ///< goes to the live end and stays there
  /// J, K, L: -1 backwards, 0 stop, 1 onwards; again in the same direction doubles the speed up to 8.
  void shuttle(int direction);
  /// So many of the usual speeds up, or down (negative). As set_speed.
  void change_speed(int steps);
  /// Held to 0.01 .. 10; the direction of playing stays. A following cursor falls behind when it is slower
  /// than 1, and cannot be faster.
  void set_speed(double factor);

  void set_in();  ///< at the cursor; an out before it is given up
  void set_out();
  void clear_in();
  void clear_out();
  /// Both, in either order; an empty range clears them.
  void set_range(double a_s, double b_s);
  /// What of the range between in and out there still is.
  std::optional<Range> range() const;

  double behind_live_s() const { return last_s - cursor_s; }

 private:
  void wrap(const Range& range);
  void settle_range();
};

}  // namespace abrazo
