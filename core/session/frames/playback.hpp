#pragma once

#include <optional>

namespace abrazo {

/// The time cursor of the workbench: one timeline for recorded and incoming frames. Plain data and rules; the
/// caller passes the elapsed time.
struct Playback {
  enum class State { Parked, Playing, Following };
  /// What playing does at the end of the range between in and out, or of the whole timeline.
  enum class Repeat { Loop, PingPong };
  struct Range {
    double from_s = 0;
    double to_s = 0;
    double length_s() const { return to_s - from_s; }
    bool operator==(const Range&) const = default;
  };

  /// In and out as the user set them; none = not set.
  struct Ends {
    std::optional<double> in_s, out_s;
    bool operator==(const Ends&) const = default;
  };

  static constexpr double slowest = 0.01, fastest = 10, fastest_shuttle = 8;

  State state = State::Following;
  bool is_live = true;  ///< the end moves on; otherwise it is that of a clip or a take, where playing stops
  double cursor_s = 0;
  double speed = 1;    ///< negative plays backwards
  double first_s = 0;  ///< available range
  double last_s = 0;
  bool every_frame = false;  ///< play slower rather than skip frames
  bool loop = false;
  Repeat repeat = Repeat::Loop;
  bool in_set = false;  ///< set by the user; an end that is not set lies at the end of the available range
  bool out_set = false;
  double in_s = 0;  ///< a range only when out_s > in_s
  double out_s = 0;

  /// New data extends the range; only a following cursor moves with it. A cursor on evicted data moves to the
  /// new start.
  void extend(double first, double last);
  /// Advances the time: a playing cursor moves, and follows once it reaches the live end at its speed or
  /// faster.
  void advance(double elapsed_s);
  /// The same, but not past the next frame. @return the time consumed [s]
  double advance_to_next(double elapsed_s, double next_frame_s);
  /// Passes over a stretch without frames, such as that of a held input: of a gap between two frames longer
  /// than `longest_gap_s` only the first `gap_shown_s` are played. Only while it plays. A looped range that
  /// begins or ends in the gap is repeated from there; one that has nothing else is not played: it parks.
  void pass_over_gap(double from_s, double to_s);
  static constexpr double longest_gap_s = 2, gap_shown_s = 0.5;
  void seek(double time_s);  ///< parks there
  void play();               ///< from the cursor; at the end, or outside a looped range, starts over
  void pause();              ///< parks where the cursor is
  void toggle();             ///< parks, or plays forward whatever the direction was before
  void follow();             ///< goes to the end, and follows it if it is live
  /// J, K, L: -1 backward, 0 stop, 1 forward; the same direction again doubles the speed up to 8.
  void shuttle(int direction);
  /// Moves `steps` up (negative: down) the list of usual speeds. Otherwise as set_speed.
  void change_speed(int steps);
  /// Clamped to 0.01 .. 10; the direction stays. A following cursor falls behind below 1 and cannot be faster
  /// than 1.
  void set_speed(double factor);

  void set_in();  ///< at the cursor; clears an out point before it
  void set_out();
  void clear_in();
  void clear_out();
  /// Sets both ends, in either order; an empty range clears them.
  void set_range(double a_s, double b_s);
  Ends ends() const;
  /// Exactly as they were there, for undo.
  void set_ends(const Ends& ends);
  /// The part of the range between in and out that is still available.
  std::optional<Range> range() const;

  double behind_live_s() const { return last_s - cursor_s; }

 private:
  void wrap(const Range& range);
  void settle_range();
};

}  // namespace abrazo
