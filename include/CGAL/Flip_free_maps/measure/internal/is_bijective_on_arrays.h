// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_IS_BIJECTIVE_ON_ARRAYS_H
#define CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_IS_BIJECTIVE_ON_ARRAYS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/internal/error_message.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Whether a map of triangles is injective, borders included. A point of the plane is the image of as many points of the surface
// as the borders wind around it, since all triangles are positive;
// so it suffices that the borders are disjoint and wind around nothing twice.
bool is_bijective(const std::vector<std::array<std::int32_t, 3>>& elements, const Positions<2>& x, std::string* message = nullptr);

inline bool is_bijective(const Simplicial_domain<2>& domain, const Positions<2>& x, std::string* message = nullptr)
{
  return is_bijective(domain.elements, x, message);
}

// Numbers corners so that those with the same vertex and the same image have the same number: an edge whose two triangles agree
// on its image is no seam.
template <typename Vertex>
class Corner_numbers
{
public:
  std::int32_t operator()(const Vertex& v, double x, double y)
  {
    // Adding 0 makes both zeros the same.
    const auto entry = m_numbers.emplace(Key(v, x + 0., y + 0.), static_cast<std::int32_t>(m_images.size()));
    if(entry.second)
      m_images.push_back({x, y});
    return entry.first->second;
  }

  Positions<2> positions() const
  {
    Positions<2> x(2, m_images.size());
    for(std::size_t i = 0; i < m_images.size(); ++i)
      x.col(i) << m_images[i][0], m_images[i][1];
    return x;
  }

private:
  using Key = std::tuple<Vertex, double, double>;
  struct Hash
  {
    std::size_t operator()(const Key& key) const
    {
      std::size_t seed = std::hash<Vertex>()(std::get<0>(key));
      boost::hash_combine(seed, std::get<1>(key));
      boost::hash_combine(seed, std::get<2>(key));
      return seed;
    }
  };

  std::unordered_map<Key, std::int32_t, Hash> m_numbers;
  std::vector<std::array<double, 2>> m_images;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_MEASURE_INTERNAL_IS_BIJECTIVE_ON_ARRAYS_H
