// What: Ctrl-C, a polite kill and the end of the terminal as something the program notices between two steps, so that it can tidy up.
#pragma once

namespace rbpa::app {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag, and a pipe closed by its reader, or a file as large as may
/// be, is an error of write().
void catch_interrupts();

/// In any thread.
bool interrupted();

/// Throws Cancelled once a signal has come. Cost: a load.
void stop_if_interrupted();

}  // namespace rbpa::app
