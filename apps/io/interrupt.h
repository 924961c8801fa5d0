// What: Ctrl-C and a polite kill as something the program notices between two steps, so that it can tidy up.
#pragma once

namespace rbpa::app {

/// From now on SIGINT and SIGTERM only set a flag, and a pipe closed by its reader is an error of write().
void catch_interrupts();

/// In any thread.
bool interrupted();

/// Throws Cancelled once a signal has come. Cost: a load.
void stop_if_interrupted();

}  // namespace rbpa::app
