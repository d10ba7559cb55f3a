// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Owns what the tests share: the precompiled headers and the compiled default method.

#include "support/default_method.h"

namespace CGAL {
namespace Flip_free_maps {

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
template class Automatic_solver<Cholmod_solver>;
#endif
template class Map_minimizer<2, Flip_free_map_traits<>>;

namespace internal {

template Status make_start(const Simplicial_domain<2>&, const Flip_free_map_traits<>&, Positions<2>&, std::string&, std::string&);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL
