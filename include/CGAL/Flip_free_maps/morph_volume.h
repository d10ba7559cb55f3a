// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MORPH_VOLUME_H
#define CGAL_FLIP_FREE_MAPS_MORPH_VOLUME_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/constraints/internal/repeated_handles.h>
#include <CGAL/Flip_free_maps/domains/Volume_domain.h>
#include <CGAL/Flip_free_maps/energies/Symmetric_gradient.h>
#include <CGAL/Flip_free_maps/initializers/internal/uniform_extension.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/internal/account_run.h>
#include <CGAL/Flip_free_maps/measure/Element_quality.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/minimizer/internal/slide_on_boundary.h>
#include <CGAL/Flip_free_maps/named_parameters.h>
#include <CGAL/Flip_free_maps/repair_map.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// How `morph_volume()` goes about it.
struct Morph_options : Repair_options
{
  /// Whether vertices of the boundary that are not given slide on it: those in a plane in this plane, those on a straight crease or a
  /// cylinder along it; where the boundary bends in both directions, vertices keep their places. Otherwise they are free. The given
  /// vertices walk to their places then, since the methods that remove flips know no such constraint; `polish` and the other fields
  /// of `Repair_options` do not matter.
  bool slide_on_boundary = false;

  /// The default.
  Morph_options() = default;
  /// Those of a repair.
  Morph_options(const Repair_options& repair) : Repair_options(repair) {} // NOLINT(google-explicit-constructor)
};

/// \ingroup PkgFlipFreeMapsRef
/// The account of `morph_volume()`.
struct Morph_summary : Summary
{
  Element_quality quality_before; ///< at rest
  Element_quality quality;        ///< of the result

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    Summary::for_each_field(visit);
    visit("quality_before", quality_before);
    visit("quality", quality, is_valid() ? Field_role::shown : Field_role::detail);
  }
};

namespace internal {

// Moves some vertices of a solid to given places, and the others so that no element flips.
template <typename Traits>
class Volume_morpher
{
public:
  // Keeps references to all. Parts of the solid without a given vertex stay where they are.
  Volume_morpher(const Simplicial_domain<3>& domain, std::vector<std::int32_t> moved, const Morph_options& options, const Traits& traits)
    : m_domain(domain), m_options(options), m_traits(traits)
  {
    Disjoint_sets parts(domain.number_of_vertices);
    for(const auto& element : domain.elements)
      for(int k = 1; k < 4; ++k)
        parts.unite(element[0], element[k]);
    std::vector<char> moves(domain.number_of_vertices, 0);
    for(std::int32_t v : moved)
      moves[parts.root(v)] = 1;
    m_constraints.fixed_vertices = std::move(moved);
    for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
      if(!moves[parts.root(v)])
        m_constraints.fixed_vertices.push_back(v);
    if(options.slide_on_boundary)
      slide_on_boundary(domain, m_constraints);
  }

  // `targets` are the places of the vertices that are given, and the rest shape otherwise; `x` becomes the map.
  void run(const Positions<3>& targets, Positions<3>& x, Summary& summary) const
  {
    if(m_options.slide_on_boundary) {
      walk(targets, x, summary);
      return;
    }
    x = targets - m_domain.rest_points;
    if(!uniform_extension(m_domain, m_constraints.fixed_vertices, m_traits.make_linear_solver(), x)) {
      summary.status = Status::linear_solver_failed;
      summary.message = "the displacements could not be extended to the vertices that are not given";
      return;
    }
    x += m_domain.rest_points;
    for(std::int32_t v : m_constraints.fixed_vertices)
      x.col(v) = targets.col(v);
    summary = repair_map(m_domain, x, m_constraints, m_options, m_traits);
    summary.start = "displacements extended, then " + summary.start;
    if(summary.status != Status::flips_remain)
      return;
    const Summary direct = summary;
    walk(targets, x, summary);
    summary.start = direct.start + ", then " + summary.start;
    if(summary.is_valid()) {
      summary.flipped_elements.clear();
      return;
    }
    const std::string message = summary.message;
    summary = direct;
    summary.message += "; on the way from the rest shape " + message;
  }

private:
  // From rest to the targets, without a flip on the way.
  void walk(const Positions<3>& targets, Positions<3>& x, Summary& summary) const
  {
    x = m_domain.rest_points;
    typename Traits::template Minimizer<3, Traits> minimizer(m_domain, m_traits, m_constraints);
    minimizer.move_fixed_vertices(x, targets, summary);
    summary.start = "a way from the rest shape";
  }

  const Simplicial_domain<3>& m_domain;
  const Morph_options& m_options;
  const Traits& m_traits;
  Position_constraints<3> m_constraints;
};

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// Morphs a solid: all or a part of its boundary, or any other vertices, go to given places, and the others follow so that no
/// tetrahedron flips. The displacements are extended to the inside, flips are removed as `repair_map()` does, where that fails the
/// given vertices walk from their rest places to the targets, and finally the distortion is minimised. Parts of the solid that have
/// no vertex in common with others, and none that is given, stay at rest.
///
/// \tparam Vertex what the user names a vertex by: a handle of a triangulation, or a number
/// \tparam Places a range of pairs of `Vertex` and points in space
/// \tparam VertexPointMap must be a model of `WritablePropertyMap` with `Vertex` as key and points in space as values
/// \tparam Traits must be a model of `MapTraits`: what is minimised in the end. `Exponential_symmetric_dirichlet` is for a good
///   worst element, energies without exponential for a good mean. <b>Default:</b> the symmetric gradient energy
///
/// \param volume the rest shape, a loaded domain, of one component or of several
/// \param places where vertices go; a vertex may be given more than once, but at one place only
/// \param result receives the positions of all vertices of tetrahedra, given ones exactly at their places. It is written once, at
///   the end, if the map is valid, and left untouched otherwise.
/// \param traits the method of the minimisation
/// \param options how flips are removed, whether the distortion is minimised at the end, and what the rest of the boundary does
/// \returns how it ended and the shapes of the tetrahedra before and after: as `repair_map()`, and `invalid_option` for a vertex of
///   no tetrahedron, or at two places
template <typename Vertex, typename Places, typename VertexPointMap,
          typename Traits = Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>
Morph_summary morph_volume(const Volume_domain<Vertex>& volume, const Places& places, VertexPointMap result,
                           const Traits& traits = Traits(), const Morph_options& options = Morph_options())
{
  Morph_summary summary;
  summary.dimension = 3;
  const Simplicial_domain<3>& domain = volume.domain();
  Positions<3> x;
  std::vector<std::pair<std::int32_t, Eigen::Vector3d>> exact_places;
  const auto load = [&](std::string& message) {
    message = "the domain holds no tetrahedra";
    return domain.number_of_elements() == 0 ? Status::empty_mesh : Status::success;
  };
  const auto solve = [&] {
    std::vector<std::int32_t> moved;
    Positions<3> targets = domain.rest_points;
    const auto refuse = [&summary](const std::string& message) {
      summary.status = Status::invalid_option;
      summary.message = message;
    };
    for(const auto& [vertex, point] : places) {
      const std::int32_t v = volume.number(vertex);
      if(v < 0)
        return refuse("place number " + std::to_string(moved.size()) + " is that of a vertex of no tetrahedron");
      const Eigen::Vector3d place(CGAL::to_double(point[0]), CGAL::to_double(point[1]), CGAL::to_double(point[2]));
      if(!place.allFinite())
        return refuse("place number " + std::to_string(moved.size()) + " is not finite");
      targets.col(v) = volume.to_domain(place);
      moved.push_back(v);
      exact_places.emplace_back(v, place);
    }
    for(const auto& [i, j] : internal::repeated_handles(moved))
      if(exact_places[i].second != exact_places[j].second)
        return refuse(internal::TWO_TARGETS + (", as places number " + std::to_string(i)) + " and " + std::to_string(j));
    summary.quality_before = element_quality(domain, domain.rest_points);
    internal::Volume_morpher<Traits>(domain, moved, options, traits).run(targets, x, summary);
    if(summary.is_valid())
      summary.quality = element_quality(domain, x);
  };
  internal::run_map(summary, load, solve, [&] {
    std::string message;
    const Status status = volume.write_back(x, result, message, exact_places);
    if(status != Status::success) {
      summary.status = status;
      summary.message = message;
    }
  });
  return summary;
}

/// \ingroup PkgFlipFreeMapsRef
/// The same with named parameters: `map_traits`, `map_options` and `repair_options`, which takes `Morph_options`, too, of
/// `Flip_free_maps::parameters`.
template <typename Vertex, typename Places, typename VertexPointMap, typename T, typename Tag, typename Base>
Morph_summary morph_volume(const Volume_domain<Vertex>& volume, const Places& places, VertexPointMap result,
                           const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return morph_volume(volume, places, result, internal::chosen_traits<Flip_free_map_traits<CGAL::Default, Symmetric_gradient>>(np),
                      internal::parameter_or(np, internal::repair_options_tag, Morph_options()));
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MORPH_VOLUME_H
