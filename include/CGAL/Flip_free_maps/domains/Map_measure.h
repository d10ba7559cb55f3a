// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_MAP_MEASURE_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_MAP_MEASURE_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Smallest and largest signed singular value over all elements.
template <typename ConcurrencyTag, int D>
std::pair<double, double> singular_value_range(const Simplicial_domain<D>& domain, const Element_coloring& coloring, const Positions<D>& x)
{
  const double low =
    coloring.template minimum<ConcurrencyTag>([&](std::int64_t e) { return signed_singular_values(domain.jacobian(e, x))[D - 1]; });
  const double high =
    -coloring.template minimum<ConcurrencyTag>([&](std::int64_t e) { return -signed_singular_values(domain.jacobian(e, x))[0]; });
  return {low, high};
}

// The energy of an element by its signed singular values.
template <int D, typename Energy>
double energy_of_element(const Simplicial_domain<D>& domain, const Energy& energy, std::int64_t e, const Positions<D>& x)
{
  return energy.template value<D>(signed_singular_values(domain.jacobian(e, x)));
}

template <typename ConcurrencyTag, int D, typename Energy>
double mean_energy(const Simplicial_domain<D>& domain, const Element_coloring& coloring, const Energy& energy, const Positions<D>& x)
{
  return coloring.template sum<ConcurrencyTag>(
    [&](std::int64_t e) { return domain.measures[e] * energy_of_element(domain, energy, e, x); });
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsDomains
/// Measures maps of a domain: distortion, singular values and flips. Energies are asked for their values whatever the signs of
/// the singular values, so those of flipped elements are what the energy's formula gives there.
///
/// \tparam D dimension, 2 or 3
/// \tparam Kernel must be a CGAL kernel with exact orientation predicates and number type `double`
/// \tparam ConcurrencyTag as in `Flip_free_map_traits`
template <int D, typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel,
          typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
class Map_measure
{
public:
  /// Keeps a reference to `domain`, which must outlive this object.
  explicit Map_measure(const Simplicial_domain<D>& domain) : m_domain(domain)
  {
    m_coloring.build(domain.elements, domain.number_of_vertices);
  }

  /// Signed singular values of the map's Jacobian on element `e`, descending.
  internal::Vector<D> singular_values(const Positions<D>& x, std::int64_t e) const
  {
    return internal::signed_singular_values(m_domain.jacobian(e, x));
  }

  /// The energy of element `e`, not weighted.
  /// \tparam Energy must be a model of `DistortionEnergy`
  template <typename Energy>
  double energy(const Energy& energy, const Positions<D>& x, std::int64_t e) const
  {
    return internal::energy_of_element(m_domain, energy, e, x);
  }

  /// The mean energy, weighted by rest measures.
  /// \tparam Energy must be a model of `DistortionEnergy`
  template <typename Energy>
  double mean_energy(const Energy& energy, const Positions<D>& x) const
  {
    return internal::mean_energy<ConcurrencyTag>(m_domain, m_coloring, energy, x);
  }

  /// Smallest and largest signed singular value over all elements.
  std::pair<double, double> singular_value_range(const Positions<D>& x) const
  {
    return internal::singular_value_range<ConcurrencyTag>(m_domain, m_coloring, x);
  }

  /// The number of elements that are not positively oriented, by exact predicates; all of them where a position is not finite.
  std::int64_t number_of_flips(const Positions<D>& x) const
  {
    return x.allFinite() ? internal::count_flips<Kernel, ConcurrencyTag>(m_domain, m_coloring, x) : m_domain.number_of_elements();
  }

private:
  const Simplicial_domain<D>& m_domain;
  internal::Element_coloring m_coloring;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_MAP_MEASURE_H
