// What: runs any program as a contestant. Its command is run by the shell with two file names appended: points to read,
//       as
//       native float64 pairs x y x y …, and triangles to write, as native uint32 triples of indices into them.
// Law:  a peer that fails is reported as failed, with the reason; it is never left out. It finds all Delaunay
//       triangles.
// Time: the value of a line `seconds VALUE` on its standard error, or else of its whole process, files included.
#pragma once

#include <span>
#include <string>

#include "bench/contest.h"

namespace rbpa_bench {

/// Runs a command once. Its standard output is dropped.
/// Throws std::runtime_error when it ended with a code or a signal, wrote no triangles or an incomplete one, named a
/// point that does not exist, or its line of seconds is not a number.
Run run_peer(const std::string& command, std::span<const rbpa::Point> points, Triangles* list = nullptr);

Contestant peer(const std::string& name, const std::string& command);

}  // namespace rbpa_bench
