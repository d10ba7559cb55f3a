// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MAP_VOLUME_H
#define CGAL_FLIP_FREE_MAPS_MAP_VOLUME_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/initializers/internal/uniform_extension.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/repair_map.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSplitting
/// Where the vertices inside begin in `map_volume()`.
enum class Volume_start
{
  extension, ///< each at the mean of its neighbours, which may flip elements
  given      ///< where the caller has them
};

/// \ingroup PkgFlipFreeMapsRef
/// Maps a volume whose boundary is mapped already to the volume inside the image of the boundary: volume correspondence (Stein,
/// Li and Solomon 2022, section 8.3). Flips of the start are removed by `repair_map()`, then the distortion is minimised.
///
/// \tparam Traits must be a model of `MapTraits`. <b>Default:</b> the symmetric gradient energy, as in the paper
///
/// \param domain the tetrahedra with their rest shapes
/// \param boundary_vertices the vertices whose positions are prescribed: usually all those on the boundary
/// \param x the prescribed positions, in the domain's units, in the columns of these vertices; on return the map if the summary
///   `is_valid()`, otherwise unchanged. Prescribed positions are kept exactly.
/// \param start where the other vertices begin
/// \param options how flips are removed, and whether the distortion is minimised at the end
/// \param traits the method of the minimisation
/// \returns what happened, as `repair_map()`; `linear_solver_failed` also where a component of the volume has no prescribed
///   position and `start` is `Volume_start::extension`
template <typename Traits = Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>
Summary map_volume(const Simplicial_domain<3>& domain, const std::vector<std::int32_t>& boundary_vertices, Positions<3>& x,
                   Volume_start start = Volume_start::extension, const Repair_options& options = Repair_options(),
                   const Traits& traits = Traits())
{
  Summary summary;
  const auto run = [&] {
    Position_constraints<3> constraints;
    constraints.fixed_vertices = boundary_vertices;
    summary.vertices = domain.number_of_vertices;
    summary.elements = domain.number_of_elements();
    summary.dimension = 3;
    summary.status = Status::invalid_option;
    if(!constraints.is_valid(domain.number_of_vertices, &summary.message))
      return;
    if(x.cols() != domain.number_of_vertices) {
      summary.message = "the positions must have a column for each vertex";
      return;
    }
    Positions<3> result = x;
    double seconds = 0;
    if(start == Volume_start::extension) {
      const internal::Phase_timer timer(seconds);
      if(!internal::uniform_extension(domain, boundary_vertices, traits.make_linear_solver(), result)) {
        summary.status = Status::linear_solver_failed;
        summary.message = "the vertices inside could not be placed: each component needs prescribed positions";
        return;
      }
    }
    summary = repair_map(domain, result, constraints, options, traits);
    summary.start = (start == Volume_start::extension ? "uniform extension, then " : "given positions, then ") + summary.start;
    summary.seconds.start += seconds;
    if(summary.is_valid())
      x = result;
  };
  internal::account_run(summary, run);
  return summary;
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with named parameters: `map_traits`, `map_options` and `repair_options` of `Flip_free_maps::parameters`.
template <typename T, typename Tag, typename Base>
Summary map_volume(const Simplicial_domain<3>& domain, const std::vector<std::int32_t>& boundary_vertices, Positions<3>& x,
                   Volume_start start, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return map_volume(domain, boundary_vertices, x, start, internal::parameter_or(np, internal::repair_options_tag, Repair_options()),
                    internal::chosen_traits<Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>(np));
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MAP_VOLUME_H
