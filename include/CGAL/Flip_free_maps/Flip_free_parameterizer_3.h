// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_FLIP_FREE_PARAMETERIZER_3_H
#define CGAL_FLIP_FREE_MAPS_FLIP_FREE_PARAMETERIZER_3_H

#include <CGAL/Flip_free_maps/initializers/internal/make_start.h>
#include <CGAL/Flip_free_maps/linear_solvers/Sparse_linear_algebra_solver.h>
#include <CGAL/Flip_free_maps/method/Flip_free_map_traits.h>
#include <CGAL/Flip_free_maps/parameterization/internal/parameterize_patch.h>
#include <CGAL/Flip_free_maps/parameterization/internal/solve_planar.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/core/default_traits.h>
#endif

#include <CGAL/Default.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/kernel_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// The error code of CGAL's package Surface_mesh_parameterization that says the same as `status`. Statuses that leave a valid map
/// are `OK`: an iteration limit is no error there either.
inline CGAL::Surface_mesh_parameterization::Error_code to_error_code(Status status)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  switch(status) {
  case Status::success:
  case Status::iteration_limit:
  case Status::time_limit:
  case Status::stopped_by_observer:
    return SMP::OK;
  case Status::empty_mesh:
    return SMP::ERROR_EMPTY_MESH;
  case Status::not_triangular:
    return SMP::ERROR_NON_TRIANGULAR_MESH;
  case Status::no_border:
  case Status::several_components:
  case Status::not_a_disk:
  case Status::non_manifold:
    return SMP::ERROR_NO_TOPOLOGICAL_DISC;
  case Status::linear_solver_failed:
  case Status::out_of_memory:
  case Status::interrupted:
    return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  case Status::start_not_flip_free:
  case Status::unreachable_constraints:
  case Status::line_search_failed:
  case Status::result_not_representable:
  case Status::flips_remain:
  case Status::not_bijective:
    return SMP::ERROR_NO_1_TO_1_MAPPING;
  case Status::degenerate_rest_element:
  case Status::non_finite_input:
  case Status::invalid_option:
  case Status::file_error:
  case Status::not_planar:
    return SMP::ERROR_WRONG_PARAMETER;
  }
  return SMP::ERROR_WRONG_PARAMETER;
}

namespace internal {

// MapTraits whose linear solver is made from a given model of SparseLinearAlgebraTraits_d.
template <typename Traits, typename SparseLinearAlgebraTraits>
struct Traits_with_solver : Traits
{
  using Linear_solver = Sparse_linear_algebra_solver<SparseLinearAlgebraTraits>;

  Traits_with_solver(const Traits& traits, const SparseLinearAlgebraTraits& solver) : Traits(traits), m_solver(solver) {}

  Linear_solver make_linear_solver() const { return Linear_solver(m_solver); }

private:
  SparseLinearAlgebraTraits m_solver;
};

// Stands for the default solver argument.
struct No_solver_traits
{};

template <typename Traits>
const Traits& with_solver(const Traits& traits, const No_solver_traits&)
{
  return traits;
}

template <typename Traits, typename SparseLinearAlgebraTraits>
Traits_with_solver<Traits, SparseLinearAlgebraTraits> with_solver(const Traits& traits, const SparseLinearAlgebraTraits& solver)
{
  return {traits, solver};
}

} // namespace internal

/// \ingroup PkgFlipFreeMapsRef
/// A parameterizer for CGAL's package Surface_mesh_parameterization whose maps have no flipped triangles: in
/// `CGAL::Surface_mesh_parameterization::parameterize(mesh, parameterizer, halfedge, uv_map)` replacing the parameterizer's class
/// name is all that it takes. The border is free; the border parameterizer only makes the start. When its border admits no start
/// without flips (a square whose side holds all three vertices of a triangle, say), the circle is tried.
///
/// \tparam TriangleMesh_ must be a model of `FaceListGraph` whose descriptors are `Hashable`
/// \tparam BorderParameterizer_ must be a model of CGAL's concept `Parameterizer_3` for borders, such as
///   `CGAL::Surface_mesh_parameterization::Square_border_arc_length_parameterizer_3`.
///   <b>Default:</b> the start that the map traits ask for, from coarse to fine on large meshes;
///   the type `Border_parameterizer` is then
///   \code CGAL::Surface_mesh_parameterization::Circular_border_arc_length_parameterizer_3<TriangleMesh_> \endcode
/// \tparam SolverTraits_ must be a model of CGAL's concept `SparseLinearAlgebraTraits_d`, and then solves all linear systems but
///   those of mean-value starts. <b>Default:</b> the linear solver of `MapTraits_`, which is faster
/// \tparam MapTraits_ must be a model of `MapTraits`. <b>Default:</b> \code Flip_free_map_traits<> \endcode
///
/// CGAL passes parameterizers by value; a `Summary` given to the constructor receives the account of the run.
///
/// \cgalModels{Parameterizer_3}
template <typename TriangleMesh_, typename BorderParameterizer_ = CGAL::Default, typename SolverTraits_ = CGAL::Default,
          typename MapTraits_ = CGAL::Default>
class Flip_free_parameterizer_3
{
public:
  /// \name Types
  /// @{

  /// Triangle mesh, as the concept `Parameterizer_3` names it.
  using TriangleMesh = TriangleMesh_;
  /// The same, as the parameterizers of CGAL name it.
  using Triangle_mesh = TriangleMesh_;
  /// Places the border for the start.
  using Border_parameterizer =
    typename CGAL::Default::Get<BorderParameterizer_,
                                CGAL::Surface_mesh_parameterization::Circular_border_arc_length_parameterizer_3<TriangleMesh>>::type;
  /// Solves the linear systems, unless it is the default.
  using Solver_traits = typename CGAL::Default::Get<SolverTraits_, internal::No_solver_traits>::type;
  /// The method and its settings.
  using Map_traits = typename CGAL::Default::Get<MapTraits_, Flip_free_map_traits<>>::type;
  /// What `parameterize()` returns.
  using Error_code = CGAL::Surface_mesh_parameterization::Error_code;
  /// Vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  /// Face of the mesh.
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  /// @}

  /// All arguments are copied but the summary, which must outlive the call of `parameterize()`.
  explicit Flip_free_parameterizer_3(Border_parameterizer border_parameterizer = Border_parameterizer(),
                                     Solver_traits solver_traits = Solver_traits(), Map_traits map_traits = Map_traits(),
                                     Summary* summary = nullptr)
    : m_border_parameterizer(border_parameterizer), m_solver_traits(solver_traits), m_traits(map_traits), m_summary(summary)
  {}

  /// Default method, with a place for the account of the run.
  explicit Flip_free_parameterizer_3(Summary* summary) : m_summary(summary) {}

  /// A method with its settings.
  explicit Flip_free_parameterizer_3(const Map_traits& map_traits, Summary* summary = nullptr) : m_traits(map_traits), m_summary(summary) {}

  /// Flattens the component of a border halfedge.
  ///
  /// \tparam VertexUVMap must be a model of `ReadWritePropertyMap` with vertex descriptors as keys and `%Point_2` of the mesh'
  ///   kernel as values
  /// \tparam VertexIndexMap must be a model of `ReadablePropertyMap` with vertex descriptors as keys and `int` as values
  /// \tparam VertexParameterizedMap must be a model of `ReadWritePropertyMap` with vertex descriptors as keys and `bool` as
  ///   values
  ///
  /// \param mesh a mesh, of polygons and with faces without area, as `CGAL::Flip_free_maps::parameterize()` takes it
  /// \param border_halfedge a halfedge on the outer border of the component, a disk that may have holes
  /// \param uv_map receives the map if it is valid, see `CGAL::Flip_free_maps::parameterize()`
  /// \param vertex_index_map handed to the border parameterizer
  /// \param vertex_parameterized_map receives `true` for each vertex that was written
  /// \returns `to_error_code()` of the status
  template <typename VertexUVMap, typename VertexIndexMap, typename VertexParameterizedMap>
  Error_code parameterize(const TriangleMesh& mesh, halfedge_descriptor border_halfedge, VertexUVMap uv_map,
                          VertexIndexMap vertex_index_map, VertexParameterizedMap vertex_parameterized_map)
  {
    // A copy, which is adapted to the surface.
    auto traits = internal::with_solver(m_traits, m_solver_traits);
    using Traits = std::decay_t<decltype(traits)>;
    std::vector<vertex_descriptor> written;

    const auto start = [&](const Simplicial_domain<2>& domain, const std::vector<vertex_descriptor>& vertices, Positions<2>& x,
                           std::string& name, std::string& message) {
      const Tutte_initializer<typename Traits::Kernel, typename Traits::Linear_solver, typename Traits::Concurrency_tag> tutte(
        traits.start);
      const auto make_solver = [&traits] { return traits.make_linear_solver(); };
      Positions<2> border;
      std::string failed = "the given border parameterizer failed";
      if(place_border(mesh, border_halfedge, domain, vertices, vertex_index_map, border)) {
        failed.clear();
        if(tutte.with_border(domain, border, "given border", make_solver, x, name, failed) == Status::success)
          return Status::success;
      }
      if(!traits.start.fall_back) {
        message = "no start without flipped elements was found; tried: " + failed;
        return Status::start_not_flip_free;
      }
      const Status status = internal::make_start(domain, traits, x, name, message);
      name += "; " + failed;
      message += "; " + failed;
      return status;
    };

    const auto vertex_points = get(CGAL::vertex_point, mesh);
    const auto prepare = [&](const auto& graph, internal::Planar_request& request, std::string&) {
      written = graph.vertices();
      if constexpr(!std::is_same<BorderParameterizer_, CGAL::Default>::value)
        request.make_start = [&](Positions<2>& x, std::string& name, std::string& message) {
          return start(graph.domain(), written, x, name, message);
        };
      static_cast<void>(start);
      static_cast<void>(request);
      return Status::success;
    };
    internal::Planar_solver<Traits> solver{traits};
    const Summary summary = internal::parameterize_patch(
      mesh, border_halfedge, vertex_points, uv_map, traits.options, true, prepare, [](vertex_descriptor, auto&) { return false; }, solver);
    if(summary.is_valid())
      for(vertex_descriptor v : written)
        put(vertex_parameterized_map, v, true);
    if(m_summary != nullptr)
      *m_summary = summary;
    return to_error_code(summary.status);
  }

private:
  // Lets CGAL's border parameterizer write to maps of our own, so that the caller's stay untouched.
  template <typename VertexIndexMap>
  bool place_border(const TriangleMesh& mesh, halfedge_descriptor border_halfedge, const Simplicial_domain<2>& domain,
                    const std::vector<vertex_descriptor>& vertices, VertexIndexMap vertex_index_map, Positions<2>& positions)
  {
    using Point_2 = typename CGAL::Surface_mesh_parameterization::internal::Kernel_traits<TriangleMesh>::Kernel::Point_2;
    std::unordered_map<vertex_descriptor, Point_2> uv;
    std::unordered_map<vertex_descriptor, bool> is_parameterized;
    const Error_code code = m_border_parameterizer.parameterize(mesh, border_halfedge, boost::make_assoc_property_map(uv), vertex_index_map,
                                                                boost::make_assoc_property_map(is_parameterized));
    if(code != CGAL::Surface_mesh_parameterization::OK)
      return false;
    positions.resize(2, domain.border.size());
    for(std::size_t i = 0; i < domain.border.size(); ++i) {
      const auto found = uv.find(vertices[domain.border[i]]);
      if(found == uv.end())
        return false;
      positions.col(i) << CGAL::to_double(found->second.x()), CGAL::to_double(found->second.y());
    }
    double doubled_area = 0;
    for(std::size_t i = 0; i < domain.border.size(); ++i) {
      const auto p = positions.col(i), q = positions.col((i + 1) % domain.border.size());
      doubled_area += p[0] * q[1] - p[1] * q[0];
    }
    if(!(std::abs(doubled_area) > 0) || !positions.allFinite())
      return false;
    positions /= std::sqrt(std::abs(doubled_area) / 2);
    return true;
  }

  Border_parameterizer m_border_parameterizer;
  Solver_traits m_solver_traits;
  Map_traits m_traits;
  Summary* m_summary = nullptr;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_FLIP_FREE_PARAMETERIZER_3_H
