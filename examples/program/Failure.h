// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// How what goes wrong is told, apart from geometry, so that readers of files compile fast.

#ifndef FLIP_FREE_MAPS_PROGRAM_FAILURE_H
#define FLIP_FREE_MAPS_PROGRAM_FAILURE_H

#include <CGAL/Flip_free_maps/report/Status.h>

#include <string>

namespace program {

namespace FFM = CGAL::Flip_free_maps;
using FFM::Status;

struct Failure
{
  Status status;
  std::string message;
};

inline void check(bool done, const std::string& message)
{
  if(!done)
    throw Failure{Status::file_error, message};
}

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FAILURE_H
