#pragma once

namespace abrazo::app {

/// From here on Ctrl-C, a request to end and a closed terminal are noted instead of ending the program, so
/// that the job can stop and take its partial files away. The second such signal ends the program
/// immediately.
void note_interruptions();

/// One of those signals came.
bool interrupted();

}  // namespace abrazo::app
