// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PARAMETERIZE_PATCH_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PARAMETERIZE_PATCH_H

#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>
#include <CGAL/Flip_free_maps/method/Map_options.h>
#include <CGAL/Flip_free_maps/parameterization/internal/Planar_request.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Whether the function that flattens by a method is known.
template <typename Method, typename = void>
struct Is_known_method : std::false_type
{};

template <typename Method>
struct Is_known_method<Method, std::void_t<decltype(solve_planar(std::declval<const Planar_request&>(), std::declval<Method&>(),
                                                                 std::declval<Positions<2>&>(), std::declval<Summary&>()))>>
  : std::true_type
{};

// The functions that flatten by a method, traits or another, among which overloads choose.
template <typename Method, bool IsBijective = false>
struct Planar_solver
{
  static_assert(Is_known_method<Method>::value,
                "the methods of traits come with CGAL/Flip_free_maps/Flip_free_map_traits.h and CGAL/Flip_free_maps/Any_map_traits.h");

  Method& method;

  void solve(const Planar_request& request, Positions<2>& x, Summary& summary)
  {
    if constexpr(IsBijective)
      solve_bijectively(request, method, x, summary);
    else
      solve_planar(request, method, x, summary);
  }

  bool certify(const Planar_request& request, const Positions<2>& written, Summary& summary)
  {
    if constexpr(IsBijective)
      if(!certify_injective(request, method, written, summary))
        return false;
    return certify_planar(request, method, written, summary);
  }
};

// From a mesh in memory to a written, certified uv map. `prepare(graph, request, message)` enters what is asked of the map,
// `solver` is a `Planar_solver`. Fixed vertices keep their positions exactly: `exact_position(v, p)` gives them in the user's units, or returns false where there are none.
template <typename TriangleMesh, typename VertexPointMap, typename VertexUVMap, typename Prepare, typename ExactPosition, typename Solver>
Summary parameterize_patch(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border_halfedge,
                           const VertexPointMap& vertex_points, VertexUVMap uv_map, const Map_options& options, Prepare&& prepare,
                           ExactPosition&& exact_position, Solver&& solver)
{
  Summary summary;
  const auto run = [&] {
    const Phase_timer total(summary.seconds.total, &summary.cpu_seconds);
    if(!options.is_valid(&summary.message)) {
      summary.status = Status::invalid_option;
      return;
    }
    const Deadline deadline(options.max_seconds);
    Face_graph_domain<TriangleMesh> graph;
    {
      const Phase_timer timer(summary.seconds.load);
      summary.status = graph.load(mesh, border_halfedge, vertex_points, summary.message);
    }
    if(summary.status != Status::success)
      return;
    const Simplicial_domain<2>& domain = graph.domain();
    summary.vertices = domain.number_of_vertices;
    summary.elements = domain.number_of_elements();
    Planar_request request(domain);
    ask_deadline();
    summary.status = prepare(graph, request, summary.message);
    if(summary.status != Status::success)
      return;
    Positions<2> x;
    solver.solve(request, x, summary);
    if(!summary.is_valid())
      return;

    const Unbound_work certificate;
    const Phase_timer timer(summary.seconds.certify);
    x *= domain.scale;
    for(std::int32_t v : request.constraints.fixed_vertices) {
      Vector<2> p;
      if(exact_position(graph.vertices()[v], p))
        x.col(v) = p;
    }
    write_positions(graph.vertices(), x, uv_map, [&](const Positions<2>& written) { return solver.certify(request, written, summary); });
  };
  catch_out_of_memory(run, summary);
  summary.peak_memory_mb = peak_memory_mb();
  return summary;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PARAMETERIZE_PATCH_H
