// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_POLISH_MAP_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_POLISH_MAP_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <string>

namespace CGAL {
namespace Flip_free_maps {
/// \ingroup PkgFlipFreeMapsRef
/// Minimises the distortion of a map that is valid already. Where that fails the map stays as it is, and so does the summary, but
/// for its message.
///
/// \tparam Minimizer `Map_minimizer<D, Traits>`, or what the traits call their `Minimizer`
///
/// \param domain the simplices with their rest shapes
/// \param traits the method and its settings
/// \param constraints vertices that are fixed or pulled to places
/// \param x a map without flips
/// \param summary how the map was found; counts and times are added to it
/// \returns whether it succeeded
template <typename Minimizer, int D, typename Traits>
bool polish_map(const Simplicial_domain<D>& domain, const Traits& traits, const Position_constraints<D>& constraints, Positions<D>& x,
                Summary& summary)
{
  const Summary before = summary;
  Minimizer minimizer(domain, traits, constraints);
  minimizer.minimize(x, summary);
  if(summary.is_valid())
    return true;
  const std::string message = before.message + "; not polished: " + summary.message;
  summary = before;
  summary.message = message;
  return false;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_POLISH_MAP_H
