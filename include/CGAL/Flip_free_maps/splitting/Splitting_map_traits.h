// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_MAP_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_MAP_TRAITS_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_minimizer.h>
#include <CGAL/Flip_free_maps/splitting/Splitting_options.h>

#include <CGAL/Default.h>

#include <algorithm>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSplitting
/// The minimizer of `Splitting_map_traits`: a `Splitting_minimizer` that takes its settings from the traits, and is followed by
/// `Map_minimizer` if `Splitting_options::polish` says so.
template <int D, typename Traits>
class Splitting_map_minimizer : public Splitting_minimizer<D, Traits>
{
public:
  /// Keeps a reference to `domain`, which must outlive this object, and copies of the others.
  explicit Splitting_map_minimizer(const Simplicial_domain<D>& domain, const Traits& traits = Traits(),
                                   const Position_constraints<D>& constraints = Position_constraints<D>())
    : Splitting_minimizer<D, Traits>(domain, traits, constraints, settings(traits))
  {}

  /// Does nothing: the pattern, a small one, is analysed in the first run.
  ///
  /// \returns `true`
  bool analyze(Summary&) { return true; }

private:
  static Splitting_options settings(const Traits& traits)
  {
    Splitting_options result = traits.splitting;
    result.max_iterations = (std::min)(result.max_iterations, traits.options.max_iterations);
    result.max_seconds = (std::min)(result.max_seconds, traits.options.max_seconds);
    result.target_energy = (std::max)(result.target_energy, traits.options.target_energy);
    if(!result.observer)
      result.observer = traits.options.observer;
    return result;
  }
};

/// \ingroup PkgFlipFreeMapsRef
/// Traits with which `parameterize()`, `deform()`, `deform_volume()` and `Deformation` run on the splitting scheme of Stein, Li
/// and Solomon 2022 instead of descending without flips. Starts and iterates may have flipped elements, handles jump to their
/// targets, and iterations cost little; the status is `flips_remain` where no map without flips was found. Parameterizations
/// begin with a Tutte embedding or a given start, such as a conformal or an ARAP map.
///
/// \tparam BaseTraits must be a model of `MapTraits`: the energy, which must be convex in the singular values, the linear solver,
///   the kernel, the start, and all of it for the polish, if there is one
///
/// Of `options`, those of the base, the splitting heeds `max_iterations`, `max_seconds`, `target_energy` and the observer, beside
/// its own. The session `Deformation` begins each move with the factors, the penalties and the factorization of the last one.
/// Bijective maps, seams and terms of one's own are not for these traits.
///
/// \cgalModels{MapTraits}
template <typename BaseTraits = Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>
class Splitting_map_traits : public BaseTraits
{
public:
  /// The polish.
  using Base_traits = BaseTraits;
  /// Runs the method. `Traits` are these traits, or a class derived from them.
  template <int D, typename Traits>
  using Minimizer = Splitting_map_minimizer<D, Traits>;

  /// Copies both.
  explicit Splitting_map_traits(const BaseTraits& base = BaseTraits(), const Splitting_options& options = Splitting_options())
    : BaseTraits(base), splitting(options)
  {
    this->start.multilevel_size = -1;
  }

  /// Settings of the splitting scheme.
  Splitting_options splitting;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_SPLITTING_SPLITTING_MAP_TRAITS_H
