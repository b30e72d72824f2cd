#pragma once

namespace abrazo::app {

/// Makes Ctrl-C, a request to end and a closed terminal set a flag instead of ending the program, so that the
/// job can stop and remove its partial files. The second such signal ends the program immediately.
void note_interruptions();

/// Whether such a signal was received.
bool interrupted();

}  // namespace abrazo::app
