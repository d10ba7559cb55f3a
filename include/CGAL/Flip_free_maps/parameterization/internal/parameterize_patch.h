// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PARAMETERIZE_PATCH_H
#define CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PARAMETERIZE_PATCH_H

#include <CGAL/Flip_free_maps/constraints/Position_constraints.h>
#include <CGAL/Flip_free_maps/domains/Face_graph_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/write_positions.h>
#include <CGAL/Flip_free_maps/initializers/Tutte_initializer.h>
#include <CGAL/Flip_free_maps/initializers/internal/adapt_to_developable.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>
#include <CGAL/Flip_free_maps/internal/parallel_invoke.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/report/Summary.h>

#include <boost/property_map/property_map.hpp>

#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

template <typename Minimizer, typename = void>
struct Has_analyze : std::false_type
{};

template <typename Minimizer>
struct Has_analyze<Minimizer, std::void_t<decltype(std::declval<Minimizer&>().analyze(std::declval<Summary&>()))>> : std::true_type
{};

// Makes a start by `start()`, which tells whether it succeeded, and minimises. The pattern of the matrix does not depend on the
// start, so both are found at the same time; but not where the start may be the solution.
template <typename Traits, typename Start>
void start_and_minimize(const Simplicial_domain<2>& domain, const Traits& traits, const Position_constraints<2>& constraints, Start&& start,
                        Positions<2>& x, Summary& summary)
{
  using Minimizer = Map_minimizer<2, Traits>;
  Minimizer minimizer(domain, traits, constraints);
  bool is_started = false;
  if constexpr(Has_analyze<Minimizer>::value) {
    if(traits.start.unfold) {
      is_started = start();
    } else {
      Summary analysis;
      parallel_invoke<typename Traits::Concurrency_tag>([&] { is_started = start(); }, [&] { minimizer.analyze(analysis); });
      summary.seconds.analyze += analysis.seconds.analyze;
      summary.seconds.assemble += analysis.seconds.assemble;
    }
  } else {
    is_started = start();
  }
  if(is_started)
    minimizer.minimize(x, summary);
}

// How to minimise when the image may overlap itself: flips are all that matters.
struct Free_minimization
{
  template <typename Traits, typename Start>
  void minimize(const Simplicial_domain<2>& domain, const Traits& traits, const Position_constraints<2>& constraints, Start&& start,
                Positions<2>& x, Summary& summary) const
  {
    start_and_minimize(domain, traits, constraints, start, x, summary);
  }

  template <typename Point>
  bool certify(const Simplicial_domain<2>&, const Positions<2>&, Summary&) const
  {
    return true;
  }
};

// From a mesh in memory to a written, certified uv map. `make_start(domain, vertices, x, name, message)` computes the start,
// after `constrain(graph, constraints, message)` has entered what is asked of the map. `traits` are adapted to the surface
// before. Fixed vertices keep their positions exactly: `exact_position(v, p)` gives them in the user's units, or returns false
// where there are none. `minimization` is like `Free_minimization`.
template <typename TriangleMesh, typename VertexPointMap, typename VertexUVMap, typename Traits, typename MakeStart, typename Constrain,
          typename ExactPosition, typename Minimization = Free_minimization>
Summary parameterize_patch(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border_halfedge,
                           const VertexPointMap& vertex_points, VertexUVMap uv_map, Traits& traits, MakeStart&& make_start,
                           Constrain&& constrain, ExactPosition&& exact_position, const Minimization& minimization = Minimization())
{
  Summary summary;
  const auto run = [&] {
    const Phase_timer total(summary.seconds.total, &summary.cpu_seconds);
    if(!traits.options.is_valid(&summary.message)) {
      summary.status = Status::invalid_option;
      return;
    }
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
    adapt_to_developable(domain, traits);

    Position_constraints<2> constraints;
    summary.status = constrain(graph, constraints, summary.message);
    if(summary.status != Status::success)
      return;

    Positions<2> x;
    const auto start = [&] {
      const Phase_timer timer(summary.seconds.start);
      summary.status = make_start(domain, graph.vertices(), x, summary.start, summary.message);
      return summary.status == Status::success;
    };
    minimization.minimize(domain, traits, constraints, start, x, summary);
    if(!summary.is_valid())
      return;

    const Phase_timer timer(summary.seconds.certify);
    x *= domain.scale;
    for(std::int32_t v : constraints.fixed_vertices) {
      Vector<2> p;
      if(exact_position(graph.vertices()[v], p))
        x.col(v) = p;
    }
    if(!minimization.template certify<typename boost::property_traits<VertexUVMap>::value_type>(domain, x, summary))
      return;
    write_positions<typename Traits::Kernel>(domain, graph.vertices(), x, uv_map, summary);
  };
  catch_out_of_memory(run, summary);
  summary.peak_memory_mb = peak_memory_mb();
  return summary;
}

// The same without constraints.
template <typename TriangleMesh, typename VertexPointMap, typename VertexUVMap, typename Traits, typename MakeStart>
Summary parameterize_patch(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border_halfedge,
                           const VertexPointMap& vertex_points, VertexUVMap uv_map, Traits& traits, MakeStart&& make_start)
{
  return parameterize_patch(
    mesh, border_halfedge, vertex_points, uv_map, traits, make_start, [](auto&, auto&, std::string&) { return Status::success; },
    [](auto, auto&) { return false; });
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_PARAMETERIZATION_INTERNAL_PARAMETERIZE_PATCH_H
