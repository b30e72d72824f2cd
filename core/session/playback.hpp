#pragma once

namespace abrazo {

/// The time cursor of the workbench: one timeline for what was recorded and what is still coming in.
/// Plain data and rules; the caller says how much time passed.
struct Playback {
  enum class State { Parked, Playing, Following };

  State state = State::Following;
  double cursor_s = 0;
  double speed = 1;    ///< negative plays backwards
  double first_s = 0;  ///< range there is
  double last_s = 0;
  bool loop = false;
  double in_s = 0;  ///< loop range; used when out_s > in_s
  double out_s = 0;

  /// New data extends the range; only a following cursor moves with it. What was evicted pulls the cursor
  /// along.
  void extend(double first, double last);
  /// Time passes: a playing cursor moves, and follows once it reaches the live end at normal speed.
  void advance(double elapsed_s);
  void seek(double time_s);  ///< parks there
  void play();               ///< from the cursor; at the end starts over
  void pause();              ///< parks where the cursor is
  void toggle();
  void follow();  ///< goes to the live end and stays there
  double behind_live_s() const { return last_s - cursor_s; }
};

}  // namespace abrazo
