// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_VOLUME_DOMAIN_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_VOLUME_DOMAIN_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <boost/functional/hash.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Aggregates, such as std::array, have no constructor from coordinates.
template <typename Point>
Point make_point_3(double x, double y, double z)
{
  using C = Coordinate<Point>;
  if constexpr(std::is_constructible_v<Point, C, C, C>)
    return Point(C(x), C(y), C(z));
  else
    return Point{C(x), C(y), C(z)};
}

// The inverse of the edge matrix of a tetrahedron and its volume. False when the volume has no correct digit, is not positive, or
// the inverse leaves the range of double.
inline bool spatial_rest_shape(const Matrix<3>& edges, Matrix<3>& rest_inverse, double& volume)
{
  const double longest = edges.cwiseAbs().maxCoeff();
  if(!(longest > 0))
    return false;
  const Matrix<3> unit = edges / longest;
  const double determinant = unit.determinant();
  // Below this the determinant is rounding of its products.
  if(!(determinant > 8 * std::numeric_limits<double>::epsilon() * unit.col(0).norm() * unit.col(1).norm() * unit.col(2).norm()))
    return false;
  volume = determinant * longest * longest * longest / 6;
  rest_inverse = unit.inverse() / longest;
  return rest_inverse.allFinite() && volume > 0;
}

// The number of sets of elements that are linked by common vertices. Where there are several parts of a mesh, each vertex takes the
// least number of the vertices that it is linked to, within its part and by the ghosts of others, until all have that of their set.
template <std::size_t N, typename World = Sequential_world>
std::int32_t count_components(const std::vector<std::array<std::int32_t, N>>& elements, std::int32_t number_of_vertices,
                              const World& world = World())
{
  Disjoint_sets sets(number_of_vertices);
  std::int32_t components = number_of_vertices;
  for(const auto& element : elements)
    for(std::size_t k = 1; k < N; ++k)
      components -= sets.unite(element[0], element[k]);
  if constexpr(!World::is_sequential) {
    Eigen::Matrix<double, 1, Eigen::Dynamic> labels(number_of_vertices), least(number_of_vertices);
    for(std::int32_t v = 0; v < number_of_vertices; ++v)
      labels[v] = static_cast<double>(world.global_numbers()[v]);
    const std::int32_t owned = world.owned_vertices(number_of_vertices);
    for(bool changes = true; world.any(changes);) {
      changes = false;
      least.setConstant(std::numeric_limits<double>::infinity());
      for(std::int32_t v = 0; v < number_of_vertices; ++v)
        least[sets.root(v)] = (std::min)(least[sets.root(v)], labels[v]);
      for(std::int32_t v = 0; v < owned; ++v) {
        changes = changes || least[sets.root(v)] < labels[v];
        labels[v] = least[sets.root(v)];
      }
      world.update_ghosts(labels);
    }
    double own = 0;
    for(std::int32_t v = 0; v < owned; ++v)
      own += labels[v] == static_cast<double>(world.global_numbers()[v]) ? 1 : 0;
    components = static_cast<std::int32_t>(world.sum(own));
  }
  return components;
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsDomains
/// What all domains of tetrahedra share: flat arrays with the way back to the user's vertices. The classes for single mesh types,
/// such as `Tetrahedral_domain` and `Triangulation_3_domain`, derive from it and fill it.
///
/// Only vertices of tetrahedra become part of the domain; others, and so their positions, are left alone. Lengths in the domain
/// are such that the total volume is 1, and its origin is the lower corner of the bounding box: a place `p` of the user has the
/// coordinates `to_domain(p)`.
///
/// A mesh in which all tetrahedra are negatively oriented follows the other convention for their vertices. It is accepted, with
/// two vertices of each element exchanged in the flat arrays; neither the numbers of the vertices nor the result are affected.
///
/// \tparam Vertex_ what the user names a vertex by: a handle, or a number
/// \tparam World_ must be a model of `World`. Where it is not sequential the arrays hold a part of the mesh, as the world says: the
///   elements that are counted first, and the owned vertices; the other functions are called by all processes then
template <typename Vertex_, typename World_ = Sequential_world>
class Volume_domain
{
public:
  /// Vertex of the user's mesh.
  using Vertex = Vertex_;
  /// Where the parts of the mesh are.
  using World = World_;

  Volume_domain() = default;

  /// In a world that is not made by default.
  explicit Volume_domain(const World& world) : m_world(world) {}

  /// Where the parts of the mesh are.
  const World& world() const { return m_world; }

  /// The flat arrays. `rest_points` holds the rest positions, which are the identity as a map.
  const Simplicial_domain<3>& domain() const { return m_domain; }

  /// The user's vertices by their numbers in the flat arrays.
  const std::vector<Vertex>& vertices() const { return m_vertices; }

  /// The number of the user's vertex in the flat arrays, -1 when no tetrahedron has it. Constant time on average.
  std::int32_t number(const Vertex& vertex) const
  {
    const auto found = m_numbers.find(vertex);
    return found != m_numbers.end() ? found->second : -1;
  }

  /// The number of parts that have no vertex in common.
  std::int32_t number_of_components() const { return m_number_of_components; }

  /// Whether the user's tetrahedra are negatively oriented, all of them.
  bool is_reflected() const { return m_is_reflected; }

  /// The place in the user's coordinates as one in the domain's.
  Eigen::Vector3d to_domain(const Eigen::Vector3d& place) const { return (place - m_domain.origin) / m_domain.scale; }

  /// The place in the domain's coordinates as one in the user's.
  Eigen::Vector3d from_domain(const Eigen::Vector3d& place) const { return place * m_domain.scale + m_domain.origin; }

  /// Writes a map to the user's property map, if every element is positively oriented by exact predicates after conversion to the
  /// user's coordinates and number type; otherwise the property map remains untouched. Vertices that belong to no tetrahedron
  /// are not written.
  ///
  /// \tparam VertexPointMap must be a model of `WritablePropertyMap` with `Vertex` as key and points in space as values
  /// \param x positions in the domain's coordinates, one column per vertex of the flat arrays
  /// \param vertex_points where the positions go, in the user's coordinates
  /// \param message receives a sentence on failure
  /// \param exact_places vertices (by their numbers in the flat arrays) that go to these places in the user's coordinates,
  ///   instead of where `x` puts them: the targets of fixed vertices, free of the rounding of the change of units
  /// \returns `success`, or `result_not_representable`
  ///
  /// Complexity: linear.
  template <typename VertexPointMap>
  Status write_back(const Positions<3>& x, VertexPointMap vertex_points, std::string& message,
                    const std::vector<std::pair<std::int32_t, Eigen::Vector3d>>& exact_places = {}) const
  {
    using Point = typename boost::property_traits<VertexPointMap>::value_type;
    Positions<3> converted = (x * m_domain.scale).colwise() + m_domain.origin;
    for(const auto& place : exact_places)
      converted.col(place.first) = place.second;
    std::vector<Point> points;
    points.reserve(m_vertices.size());
    for(std::size_t v = 0; v < m_vertices.size(); ++v) {
      points.push_back(internal::make_point_3<Point>(converted(0, v), converted(1, v), converted(2, v)));
      converted.col(v) << CGAL::to_double(points[v][0]), CGAL::to_double(points[v][1]), CGAL::to_double(points[v][2]);
    }
    const auto is_positive = [&](const Simplicial_domain<3>::Element& e) {
      return internal::is_positively_oriented<CGAL::Exact_predicates_inexact_constructions_kernel>(e, converted);
    };
    if(m_world.any(!converted.allFinite() || !std::all_of(m_domain.elements.begin(), m_domain.elements.end(), is_positive))) {
      message = "elements flip when the map is converted to the number type of the result";
      return Status::result_not_representable;
    }
    using boost::put; // for pointers
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      put(vertex_points, m_vertices[v], points[v]);
    return Status::success;
  }

protected:
  /// Begins anew.
  void clear()
  {
    m_domain = Simplicial_domain<3>();
    m_vertices.clear();
    m_numbers.clear();
    m_number_of_components = 0;
    m_is_reflected = false;
  }

  /// Gives the vertex the next number, unless it has one already; returns its number.
  std::int32_t add_vertex(const Vertex& vertex)
  {
    const auto entry = m_numbers.emplace(vertex, static_cast<std::int32_t>(m_vertices.size()));
    if(entry.second)
      m_vertices.push_back(vertex);
    return entry.first->second;
  }

  /// Appends a tetrahedron. Vertices that are new are numbered in the order in which they are met.
  void add(const std::array<Vertex, 4>& vertices)
  {
    m_domain.elements.push_back({add_vertex(vertices[0]), add_vertex(vertices[1]), add_vertex(vertices[2]), add_vertex(vertices[3])});
  }

  /// Finishes when all tetrahedra are there.
  ///
  /// \param point function from `Vertex` to its rest position, an `Eigen::Vector3d`
  /// \param message receives a sentence on failure
  /// \returns `success`, `empty_mesh`, `non_finite_input`, `degenerate_rest_element`, `several_components` or `out_of_memory`.
  ///   With `several_components` the domain is complete nevertheless, for uses that hold every component.
  template <typename PointOfVertex>
  Status finish(PointOfVertex&& point, std::string& message)
  {
    if(!m_world.any(!m_domain.elements.empty())) {
      message = "there is no tetrahedron";
      return Status::empty_mesh;
    }
    if(m_world.any(m_vertices.size() > static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)() / 4))) {
      message = "the mesh has more vertices than 32-bit numbers can count";
      return Status::out_of_memory;
    }
    m_domain.number_of_vertices = static_cast<std::int32_t>(m_vertices.size());

    Positions<3> points(3, m_vertices.size());
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      points.col(v) = point(m_vertices[v]);
    if(m_world.any(!points.allFinite())) {
      message = "a coordinate of the mesh is NaN or infinite";
      return Status::non_finite_input;
    }
    Status status = orient(points, message);
    if(status == Status::success)
      status = measure(points, message);
    if(status != Status::success)
      return status;

    m_number_of_components = internal::count_components(m_domain.elements, m_domain.number_of_vertices, m_world);
    if(m_number_of_components > 1) {
      message = "the mesh has " + std::to_string(m_number_of_components) + " components without common vertices";
      return Status::several_components;
    }
    return Status::success;
  }

private:
  // The numbers of elements in a part of a mesh mean nothing to the user.
  static std::string numbered(const char* text, std::size_t e)
  {
    return World::is_sequential ? std::string(text) + " has tetrahedron number " + std::to_string(e)
                                : std::string(text) + " has a tetrahedron";
  }

  Status orient(const Positions<3>& points, std::string& message)
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto point = [&points](std::int32_t v) { return Kernel::Point_3(points(0, v), points(1, v), points(2, v)); };
    constexpr std::size_t NONE = (std::numeric_limits<std::size_t>::max)();
    const std::size_t counted = static_cast<std::size_t>(m_world.counted_elements(m_domain.number_of_elements()));
    std::size_t negative = 0, first_negative = 0, first_positive = 0, flat = NONE;
    for(std::size_t e = counted; e-- > 0 && flat == NONE;) {
      const Simplicial_domain<3>::Element& v = m_domain.elements[e];
      const CGAL::Orientation orientation = Kernel::Orientation_3()(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
      if(orientation == CGAL::ZERO)
        flat = e;
      if(orientation == CGAL::NEGATIVE) {
        ++negative;
        first_negative = e;
      } else
        first_positive = e;
    }
    if(m_world.any(flat != NONE)) {
      message = numbered("zero volume", flat);
      return Status::degenerate_rest_element;
    }
    const double all_negative = m_world.sum(static_cast<double>(negative)), all = m_world.sum(static_cast<double>(counted));
    m_is_reflected = all_negative == all;
    if(m_is_reflected)
      for(Simplicial_domain<3>::Element& v : m_domain.elements)
        std::swap(v[2], v[3]);
    else if(all_negative > 0) {
      message = std::to_string(static_cast<std::int64_t>(all_negative)) + " of " + std::to_string(static_cast<std::int64_t>(all)) +
                " tetrahedra are inverted at rest";
      if constexpr(World::is_sequential)
        message +=
          ": number " + std::to_string(first_negative) + " and number " + std::to_string(first_positive) + " have opposite orientations";
      return Status::degenerate_rest_element;
    }
    return Status::success;
  }

  Status measure(Positions<3>& points, std::string& message)
  {
    // The box brings coordinates of any magnitude into range before volumes are formed. Halves, since the extent may overflow.
    constexpr double INFINITE = std::numeric_limits<double>::infinity();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(INFINITE), high = -low;
    if(points.cols() > 0) {
      low = points.rowwise().minCoeff();
      high = points.rowwise().maxCoeff();
    }
    for(int i = 0; i < 3; ++i) {
      low[i] = m_world.minimum(low[i]);
      high[i] = -m_world.minimum(-high[i]);
    }
    const double extent = 2 * (high / 2 - low / 2).maxCoeff();
    if(!std::isfinite(extent)) {
      message = "the extent of the mesh exceeds the range of double precision";
      return Status::non_finite_input;
    }
    points = ((points / 2).colwise() - low / 2) / (extent / 2);

    const std::size_t m = m_domain.elements.size();
    m_domain.measures.resize(m);
    m_domain.rest_inverses.resize(m);
    const std::size_t counted = static_cast<std::size_t>(m_world.counted_elements(m_domain.number_of_elements()));
    double total = 0;
    std::size_t flat = m;
    for(std::size_t e = 0; e < m && flat == m; ++e) {
      if(!internal::spatial_rest_shape(m_domain.image_edges(e, points), m_domain.rest_inverses[e], m_domain.measures[e]))
        flat = e;
      if(e < counted)
        total += m_domain.measures[e];
    }
    if(m_world.any(flat != m)) {
      message = numbered("zero volume within double precision", flat);
      return Status::degenerate_rest_element;
    }
    total = m_world.sum(total);
    const double length = std::cbrt(total);
    for(std::size_t e = 0; e < m; ++e) {
      m_domain.measures[e] /= total;
      m_domain.rest_inverses[e] *= length;
    }
    points /= length;
    m_domain.origin = low;
    m_domain.scale = extent * length;
    m_domain.rest_points.swap(points);
    return Status::success;
  }

  World m_world;
  Simplicial_domain<3> m_domain;
  std::vector<Vertex> m_vertices;
  std::unordered_map<Vertex, std::int32_t, boost::hash<Vertex>> m_numbers;
  std::int32_t m_number_of_components = 0;
  bool m_is_reflected = false;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_VOLUME_DOMAIN_H
