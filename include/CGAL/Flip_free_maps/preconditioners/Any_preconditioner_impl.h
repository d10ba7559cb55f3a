// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ANY_PRECONDITIONER_IMPL_H
#define CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ANY_PRECONDITIONER_IMPL_H

#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/preconditioners/Adaptive_preconditioner.h>
#include <CGAL/Flip_free_maps/preconditioners/Any_preconditioner.h>

namespace CGAL {
namespace Flip_free_maps {

CGAL_FLIP_FREE_MAPS_INLINE Any_preconditioner::Any_preconditioner() : Any_preconditioner(Adaptive_preconditioner()) {}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PRECONDITIONERS_ANY_PRECONDITIONER_IMPL_H
