// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Ctrl-C and SIGTERM end a run with the map that there is, and a second one at once.

#ifndef FLIP_FREE_MAPS_PROGRAM_INTERRUPTION_H
#define FLIP_FREE_MAPS_PROGRAM_INTERRUPTION_H

namespace program {

// From now on signals are heeded. Those that whoever started the program ignores stay so.
void catch_signals();

// The number of the signal that has asked the program to end, 0 if none has.
int received_signal();

// What a program that a signal has ended returns, in the way of shells.
inline int exit_code_of_signal(int signal) { return 128 + signal; }

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_INTERRUPTION_H
