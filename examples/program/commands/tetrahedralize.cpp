// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "deform.h"

#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN
#include <CGAL/Flip_free_maps/tetrahedralize_with_tetgen.h>
#else
#include <CGAL/Flip_free_maps/tetrahedralize.h>
#endif

namespace program {

FFM::Tetrahedral_mesh tetrahedralized(const Mesh& surface, double cell_size)
{
  FFM::Tetrahedral_mesh result;
  std::string message;
#ifdef CGAL_FLIP_FREE_MAPS_USE_TETGEN
  FFM::Tetgen_options options;
  options.cell_size = cell_size;
  const Status status = FFM::tetrahedralize_with_tetgen(surface, result, options, message);
#else
  FFM::Tetrahedralization_options options;
  options.cell_size = cell_size;
  const Status status = FFM::tetrahedralize(surface, result, options, message);
#endif
  if(status != Status::success)
    throw Failure{status, message};
  return result;
}

} // namespace program
