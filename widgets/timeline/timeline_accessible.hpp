#pragma once

namespace abrazo::widgets {

/// From now on a TimelineView tells assistive programs its cursor as the value of a slider, and lets them
/// set it. Once is enough; more is harmless.
void install_timeline_accessibility();

}  // namespace abrazo::widgets
