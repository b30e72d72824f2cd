#pragma once

namespace abrazo::app {

/// How long a job may take to stop [s]; a job that waits for something that does not come is ended then.
inline constexpr unsigned interruption_patience_s = 30;

/// Makes Ctrl-C, a request to end and a closed terminal set a flag instead of ending the program, so that the
/// job can stop and remove its partial files. The second such signal ends the program immediately, and so
/// does the first one after `patience_s`.
void note_interruptions(unsigned patience_s = interruption_patience_s);

/// The same in a program that another one started and waits for (ChildProcess). A signal to the whole process
/// group, as from `timeout` or a closed terminal, arrives here twice: once itself, and once passed on by the
/// parent. What the parent passes on therefore only sets the flag.
void note_interruptions_of_child();

/// From here on a child process decides what a second signal does: it gets the signals too, or has them
/// passed on. If this program ended first, nobody would wait for the child or tell its status, and its
/// display would go away while it cleans up.
void leave_second_signal_to_child();

/// Whether such a signal was received.
bool interrupted();

}  // namespace abrazo::app
