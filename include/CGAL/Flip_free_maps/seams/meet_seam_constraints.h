// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_SEAMS_MEET_SEAM_CONSTRAINTS_H
#define CGAL_FLIP_FREE_MAPS_SEAMS_MEET_SEAM_CONSTRAINTS_H

#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/seams/Seam_constraints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsSeams
/// What relates the two sides of a seam.
enum class Seam_relation
{
  similarity,  ///< a rotation by any angle, a scale and a translation
  quarter_turn ///< a rotation by a multiple of 90 degrees and a translation: the map is seamless
};

/// \ingroup PkgFlipFreeMapsSeams
/// How constraints on seams are met.
struct Seam_options
{
  Seam_relation relation = Seam_relation::quarter_turn; ///< for all seams whose rotation is not prescribed
  double tolerance = 1e-8;                              ///< largest residual of a seam's edge, over the length of the seam
  double first_weight = 0.1;                            ///< of the similarities in the first run
  double first_quarter_turn_weight = 1e-5;              ///< of the quarter turns in their first run
  double factor = 10;                                   ///< by which weights are raised, greater than 1
  double largest_weight = 1e8;                          ///< at which to give up
  double cone_curvature = 0.5;                          ///< radians by which the angles around a vertex differ from 2 pi where a seam ends,
                                                        ///< see `find_seams()`

  /// Checks the ranges; when one is wrong, says so in `*message` (if given) and returns `false`.
  bool is_valid(std::string* message = nullptr) const;
};

/// \ingroup PkgFlipFreeMapsSeams
/// The account of a map with constrained seams.
struct Seam_summary : Summary
{
  double residual = -1; ///< the greatest residual of a seam's edge, over the length of the seam
  /// For each seam the (a, b) of T = [a b; -b a], which takes its left side to its right one; a rotation by t has (cos t,
  /// -sin t).
  std::vector<internal::Vector<2>> transformations;

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    Summary::for_each_field(visit);
    visit("residual", residual);
    visit("transformations", transformations);
  }
};

namespace internal {

// The nearest rotation by a multiple of 90 degrees.
Vector<2> nearest_quarter_turn(const Vector<2>& p);

// Minimises with growing multipliers and weight until the seams are met.
template <typename Minimizer>
bool meet(Minimizer& minimizer, Seam_constraints& term, const Seam_options& options, Positions<2>& x, Seam_summary& summary)
{
  constexpr int MAX_RUNS = 60;
  constexpr double GOOD_DECREASE = 0.1;
  double previous = term.residual(x);
  for(int run = 0; run < MAX_RUNS; ++run) {
    minimizer.minimize(x, summary);
    summary.residual = term.residual(x);
    if(summary.status != Status::success)
      return false;
    if(summary.residual <= options.tolerance)
      return true;
    term.update_multipliers(x);
    if(summary.residual > GOOD_DECREASE * previous && term.weight * options.factor <= options.largest_weight)
      term.scale_weight(options.factor);
    previous = summary.residual;
  }
  summary.status = Status::unreachable_constraints;
  summary.message = "the seams are " + std::to_string(summary.residual / options.tolerance) + " times their tolerance apart";
  return false;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsSeams
/// Optimises a map of a surface that was cut open such that the two sides of each seam fit together. After a run without
/// constraints the similarities are met first, by the method of multipliers with rising weights. For quarter turns the term of
/// equation 28 (Shtengel et al. 2017, section 5.3) is then added with weights that rise until each seam is nearer to one of them
/// than 0.05; its rotation is set to that one, and the now linear constraints are met in the same way.
///
/// \param domain the surface, cut open
/// \param x a map without flips; on return the result when the summary `is_valid()`, otherwise unchanged
/// \param seams the seams
/// \param options how they are related
/// \param traits the method and its settings, for each run
/// \param rotations prescribed rotations by seam, counterclockwise and in radians, NaN for a free one; or empty
/// \returns the account of all runs together. The status is `unreachable_constraints` when the residual stays above its
///   tolerance: the rotations may contradict the topology, a cone of angle 0 for example.
template <typename Traits = Flip_free_map_traits<>>
Seam_summary meet_seam_constraints(const Simplicial_domain<2>& domain, Positions<2>& x, const std::vector<Seam>& seams,
                                   const Seam_options& options = Seam_options(), const Traits& traits = Traits(),
                                   const std::vector<double>& rotations = {})
{
  using internal::Vector;
  constexpr double NEAR = 0.05;
  Seam_summary summary;
  if(!options.is_valid(&summary.message))
    return summary;
  if(!rotations.empty() && rotations.size() != seams.size()) {
    summary.message = "rotations are prescribed for another number of seams";
    return summary;
  }
  Simplicial_domain<2> extended = domain;
  extended.number_of_vertices += static_cast<std::int32_t>(seams.size());
  Positions<2> y(2, extended.number_of_vertices);
  y.leftCols(domain.number_of_vertices) = x;
  y.rightCols(seams.size()).setZero();

  const auto term = std::make_shared<Seam_constraints>(seams, domain.number_of_vertices);
  term->weight = options.first_weight;
  {
    Position_constraints<2> none;
    typename Traits::template Minimizer<2, Traits> minimizer(domain, traits, none);
    Positions<2> z = x;
    minimizer.minimize(z, summary);
    if(summary.status != Status::success)
      return summary;
    y.leftCols(domain.number_of_vertices) = z;
  }
  const double energy_initial = summary.energy_initial;
  Position_constraints<2> constraints;
  for(std::size_t s = 0; s < seams.size(); ++s) {
    const bool is_prescribed = !rotations.empty() && !std::isnan(rotations[s]);
    y.col(term->transformation(s)) =
      is_prescribed ? Vector<2>(std::cos(rotations[s]), -std::sin(rotations[s])) : term->best_transformation(y, s);
    if(is_prescribed)
      constraints.fixed_vertices.push_back(term->transformation(s));
  }

  const bool is_free = constraints.fixed_vertices.size() < seams.size();
  if(is_free || options.relation == Seam_relation::similarity) {
    typename Traits::template Minimizer<2, Traits> minimizer(extended, traits, constraints);
    minimizer.add_term(term);
    if(options.relation == Seam_relation::similarity) {
      if(!internal::meet(minimizer, *term, options, y, summary))
        return summary;
    } else {
      const auto distance = [&] {
        double largest = 0;
        for(std::size_t s = 0; s < seams.size(); ++s) {
          const Vector<2> p = y.col(term->transformation(s));
          if(rotations.empty() || std::isnan(rotations[s]))
            largest = (std::max)(largest, (p - internal::nearest_quarter_turn(p)).norm());
        }
        return largest;
      };
      for(double w = options.first_quarter_turn_weight; w <= options.largest_weight && distance() > NEAR; w *= options.factor) {
        term->quarter_turn_weight = w;
        minimizer.minimize(y, summary);
        if(summary.status != Status::success)
          return summary;
      }
      term->quarter_turn_weight = 0;
    }
  }
  if(options.relation == Seam_relation::quarter_turn) {
    for(std::size_t s = 0; s < seams.size(); ++s)
      if(rotations.empty() || std::isnan(rotations[s])) {
        const std::int32_t t = term->transformation(s);
        y.col(t) = internal::nearest_quarter_turn(y.col(t));
        constraints.fixed_vertices.push_back(t);
      }
    typename Traits::template Minimizer<2, Traits> minimizer(extended, traits, constraints);
    minimizer.add_term(term);
    if(!internal::meet(minimizer, *term, options, y, summary))
      return summary;
  }
  x = y.leftCols(domain.number_of_vertices);
  // The multipliers' part is no distortion.
  summary.energy -= summary.energy_of_terms;
  summary.energy_of_terms = 0;
  summary.energy_initial = energy_initial;
  summary.vertices = domain.number_of_vertices;
  for(std::size_t s = 0; s < seams.size(); ++s)
    summary.transformations.push_back(y.col(term->transformation(s)));
  return summary;
}

} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/seams/meet_seam_constraints_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_SEAMS_MEET_SEAM_CONSTRAINTS_H
