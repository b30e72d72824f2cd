#pragma once

namespace abrazo {

/// The calling thread works for a moment, often, and each time something waits for it: from now on the
/// scheduler lets it go before threads that calculate at length. It gets no larger share of the processor and
/// needs no rights. Where the system has no such thing (Linux before 6.12) nothing changes, nor for a thread
/// that was given a real-time policy from outside.
void let_this_thread_go_first();

}  // namespace abrazo
