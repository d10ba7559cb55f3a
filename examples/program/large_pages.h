// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_EXAMPLES_PROGRAM_LARGE_PAGES_H
#define FLIP_FREE_MAPS_EXAMPLES_PROGRAM_LARGE_PAGES_H

namespace program {

// If an argument is a large file, starts the program once more with large pages for large arrays, where the system gives them to those
// who ask: fetching small pages one by one takes its time. The C library reads this setting only at the start of a
// program. Does nothing where it cannot be had, and where the variable GLIBC_TUNABLES is set.
void want_large_pages(int argc, char** argv);

} // namespace program

#endif // FLIP_FREE_MAPS_EXAMPLES_PROGRAM_LARGE_PAGES_H
