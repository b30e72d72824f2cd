#pragma once

namespace abrazo::widgets {

/// What plays the user at the newest frame. Only who is streamed is live.
enum class UserInput { None, Clip, Stream };

}  // namespace abrazo::widgets
