// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_BY_TRAITS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_BY_TRAITS_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_atlas.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterization/internal/parameterize_patch.h>
#include <CGAL/Flip_free_maps/parameterization/internal/solve_planar.h>

#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// An atlas whose charts are mapped by a method.
template <typename Traits>
class Chart_atlas_by_traits : public Chart_atlas
{
public:
  Chart_atlas_by_traits(const Linked_triangles& surface, double begin, const Traits& traits, const Unwrap_options& options,
                        Unwrap_summary& summary)
    : Chart_atlas(surface, begin, options, summary), m_traits(traits)
  {}

private:
  bool has_valid_method(std::string& message) const override { return m_traits.options.is_valid(&message); }

  // The method's observer sees pieces one by one.
  bool is_parallel() const override
  {
    return !m_traits.options.observer && std::is_convertible<typename Traits::Concurrency_tag, CGAL::Parallel_tag>::value;
  }

  Summary solve(const Open_piece& open, Positions<2>& x, const Map_request& request, bool is_hasty) override
  {
    Traits traits = m_traits;
    if(is_hasty) {
      traits.options.target_energy = (std::max)(traits.options.target_energy, GOOD_ENOUGH);
      // A limit for each chart is one for charts that come in time.
      traits.options.max_seconds = std::numeric_limits<double>::infinity();
    }
    if(request.is_convex)
      traits.options.max_iterations = 0;
    if(m_is_stopped || request.is_convex || is_hasty)
      traits.start.multilevel_size = -1;
    traits.start.unfold = traits.start.unfold && !request.is_convex;
    traits.options.observer = [this, given = m_traits.options.observer](const Iteration_report& report) {
      if(given && !m_is_stopped && !given(report))
        m_is_stopped = true;
      return report_progress();
    };
    if(m_is_stopped)
      traits.options.observer = nullptr; // who has said all
    std::vector<Point_2> uv(open.surface.points.cols());
    const auto uv_map = boost::make_iterator_property_map(uv.begin(), get(boost::vertex_index, open.mesh));
    const auto prepare = [&](const auto& graph, Planar_request& planar, std::string&) {
      const auto* vertices = &graph.vertices();
      const double scale = graph.domain().scale;
      if(request.has_start)
        planar.make_start = [vertices, scale, given = x](Positions<2>& y, std::string& name, std::string&) {
          name = "the map of a larger chart";
          y.resize(2, vertices->size());
          for(std::size_t v = 0; v < vertices->size(); ++v)
            y.col(v) = given.col((*vertices)[v]) / scale;
          return Status::success;
        };
      if(request.is_hopeless)
        planar.is_hopeless = [vertices, scale, &request](const Positions<2>& y) {
          Positions<2> z(2, y.cols());
          for(std::size_t v = 0; v < vertices->size(); ++v)
            z.col((*vertices)[v]) = scale * y.col(v);
          return request.is_hopeless(z);
        };
      return Status::success;
    };
    Planar_solver<Traits> solver{traits};
    const Summary summary = parameterize_patch(
      open.mesh, longest_border(open), open.mesh.points(), uv_map, traits.options, true, prepare, [](Vertex, Vector<2>&) { return false; },
      solver);
    x.resize(2, uv.size());
    if(summary.is_valid())
      for(std::size_t v = 0; v < uv.size(); ++v)
        x.col(v) << uv[v].x(), uv[v].y();
    return summary;
  }

  bool can_relax() const override { return std::is_same<Minimizer, Map_minimizer<2, Traits>>::value; }

  bool relax(Chart_zipper::Patch& patch) const override
  {
    if constexpr(std::is_same<Minimizer, Map_minimizer<2, Traits>>::value) {
      Traits traits = m_traits;
      // Whoever does not get there soon would be distorted too much.
      traits.options.observer = [steps = 0](const Iteration_report&) mutable { return ++steps <= MOST_STEPS; };
      traits.options.relative_energy_tolerance = (std::max)(traits.options.relative_energy_tolerance, ROUGH);
      Minimizer minimizer(patch.domain, traits, patch.constraints);
      const Summary summary = minimizer.move_fixed_vertices(patch.x, patch.targets);
      return summary.is_valid() && (patch.x - patch.targets)(Eigen::all, patch.constraints.fixed_vertices).isZero(0) &&
             summary.energy - summary.energy_initial <= MOST_INCREASE;
    } else {
      static_cast<void>(patch);
      return false;
    }
  }

  using Minimizer = typename Traits::template Minimizer<2, Traits>;

  // Steps of a part of a map on its way, and the most by which its energy may increase.
  static constexpr int MOST_STEPS = 20;
  static constexpr double MOST_INCREASE = 0.1;
  // The mean energy at which a chart that is made when the time is up ends.
  static constexpr double GOOD_ENOUGH = 1.5;

  Traits m_traits;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_BY_TRAITS_H
