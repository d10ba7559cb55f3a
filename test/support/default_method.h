// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_TEST_SUPPORT_DEFAULT_METHOD_H
#define FLIP_FREE_MAPS_TEST_SUPPORT_DEFAULT_METHOD_H

// Most tests use the default method, which does not depend on the type of the mesh: it is compiled once for all of them.

#include <CGAL/Flip_free_maps/parameterize.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {

#ifdef CGAL_FLIP_FREE_MAPS_USE_CHOLMOD
extern template class Automatic_solver<Cholmod_solver>;
#endif
extern template class Map_minimizer<2, Flip_free_map_traits<>>;

namespace internal {

extern template Status make_start(const Simplicial_domain<2>&, const Flip_free_map_traits<>&, Positions<2>&, std::string&, std::string&);

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_TEST_SUPPORT_DEFAULT_METHOD_H
