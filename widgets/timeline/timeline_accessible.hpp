#pragma once

namespace abrazo::widgets {

/// Makes TimelineView expose its cursor to assistive programs as the value of a slider. May be called more
/// than once.
void install_timeline_accessibility();

}  // namespace abrazo::widgets
