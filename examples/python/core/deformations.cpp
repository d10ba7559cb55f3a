// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Deformations of planar shapes and solids, at once or move by move, and maps of solids.

#include "Rows.h"
#include "Watch.h"
#include "account.h"
#include "functions.h"
#include "options.h"

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/deform.h>
#include <CGAL/Flip_free_maps/deform_volume.h>
#include <CGAL/Flip_free_maps/domains/Tetrahedral_domain.h>
#include <CGAL/Flip_free_maps/map_volume.h>
#include <CGAL/Flip_free_maps/morph_volume.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

using Numbers = Rows<std::int64_t, 1>;

template <std::size_t D>
using Places = std::vector<std::array<double, D>>;

template <std::size_t D>
std::vector<std::pair<std::int64_t, std::array<double, D>>> handles_of(const Numbers& vertices, const Rows<double, D>& targets)
{
  std::vector<std::pair<std::int64_t, std::array<double, D>>> handles;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    handles.emplace_back(vertices[i][0], targets[i]);
  return handles;
}

// The rows as columns of a matrix.
template <int D>
FFM::Positions<D> positions(const Rows<double, D>& rows)
{
  FFM::Positions<D> x(D, rows.size());
  for(std::size_t i = 0; i < rows.size(); ++i)
    for(int k = 0; k < D; ++k)
      x(k, i) = rows[i][k];
  return x;
}

// The method that is asked for, watched.
FFM::Any_map_traits traits_of(const program::Method_choice& choice, Watch& watch)
{
  FFM::Any_map_traits traits = make_traits(choice);
  set_limits(choice, traits.options);
  traits.options.observer = watch.observer<FFM::Iteration_report>();
  return traits;
}

} // namespace

py::tuple deform(const py::array& points, const py::array& triangles, const py::array& handles, const py::array& targets,
                 const py::dict& given, const py::object& progress)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const auto handles_2 = handles_of<2>(Numbers(handles, "handles"), Planar_points(targets, "targets"));
  const program::Method_choice choice = method_choice(given);
  const std::string reason = why_not_available(choice, 2);
  if(!reason.empty())
    return refusal(reason);
  Watch watch(progress);
  const FFM::Any_map_traits traits = traits_of(choice, watch);
  Places<2> start;
  if(given.contains("start")) {
    const Planar_points rows(given["start"], "start");
    start.assign(rows.begin(), rows.end());
  }
  Places<2> result;
  FFM::Summary summary;
  {
    const py::gil_scoped_release unlocked;
    const auto np = FFM::parameters::map_traits(traits);
    if(start.empty())
      summary = FFM::deform(p, t, handles_2, result, np);
    else
      summary =
        FFM::deform(p, t, handles_2, result, FFM::parameters::start_map(FFM::internal::Array_map<std::array<double, 2>>{&start}, np));
    traits.name_choices(summary);
  }
  watch.raise();
  return py::make_tuple(array_of(result), account(summary));
}

py::tuple deform_volume(const py::array& points, const py::array& tetrahedra, const py::array& handles, const py::array& targets,
                        const py::dict& given, const py::object& progress)
{
  const Points p(points, "points");
  const Tetrahedra t(tetrahedra, "tetrahedra");
  const auto handles_3 = handles_of<3>(Numbers(handles, "handles"), Points(targets, "targets"));
  const program::Method_choice choice = method_choice(given);
  const std::string reason = why_not_available(choice, 3);
  if(!reason.empty())
    return refusal(reason);
  Watch watch(progress);
  const FFM::Any_map_traits traits = traits_of(choice, watch);
  FFM::Deform_volume_options options;
  read(given, "soft_weight", options.soft_weight);
  std::unique_ptr<Points> start;
  if(given.contains("start"))
    start = std::make_unique<Points>(given["start"], "start");
  Places<3> result;
  FFM::Summary summary;
  {
    const py::gil_scoped_release unlocked;
    // The domain has the vertices of tetrahedra only, in their order.
    if(start != nullptr) {
      FFM::Tetrahedral_domain volume;
      std::string message;
      volume.load(p, t, message);
      options.start.resize(3, volume.vertices().size());
      for(std::size_t v = 0; v < volume.vertices().size(); ++v)
        options.start.col(v) = Eigen::Map<const Eigen::Vector3d>((*start)[volume.vertices()[v]].data());
    }
    summary = FFM::deform_volume(p, t, handles_3, result, FFM::parameters::volume_options(options, FFM::parameters::map_traits(traits)));
    traits.name_choices(summary);
  }
  watch.raise();
  return py::make_tuple(array_of(result), account(summary));
}

py::tuple map_volume(const py::array& points, const py::array& tetrahedra, const py::array& boundary, const py::array& places,
                     const py::dict& given, const py::object& progress)
{
  const Points p(points, "points");
  const Tetrahedra t(tetrahedra, "tetrahedra");
  const Numbers vertices(boundary, "boundary");
  const Points prescribed(places, "places");
  const program::Method_choice choice = method_choice(given);
  Watch watch(progress);
  const FFM::Any_map_traits traits = traits_of(choice, watch);
  FFM::Repair_options options;
  read(given, "polish", options.polish);
  set_limits(choice, options);
  options.splitting.observer = watch.observer<FFM::Splitting_report>();
  const bool is_given = given.contains("start");
  const Points start(is_given ? py::array(given["start"]) : points, "start");
  Places<3> result(start.begin(), start.end());
  FFM::Summary summary;
  const auto run = [&] {
    FFM::Tetrahedral_domain volume;
    summary.dimension = 3;
    summary.status = volume.load(p, t, summary.message);
    // Each component is held by its boundary.
    if(summary.status != FFM::Status::success && summary.status != FFM::Status::several_components)
      return;
    std::vector<std::int32_t> held;
    std::vector<std::pair<std::int32_t, Eigen::Vector3d>> exact_places;
    for(std::size_t i = 0; i < vertices.size(); ++i) {
      const std::int32_t v = volume.number(static_cast<std::size_t>(vertices[i][0]));
      if(v < 0) {
        summary.status = FFM::Status::invalid_option;
        summary.message = "vertex " + std::to_string(vertices[i][0]) + " of the boundary is not one of a tetrahedron";
        return;
      }
      result[vertices[i][0]] = prescribed[i];
      held.push_back(v);
      exact_places.emplace_back(v, Eigen::Map<const Eigen::Vector3d>(prescribed[i].data()));
    }
    FFM::Positions<3> x(3, volume.vertices().size());
    for(std::size_t v = 0; v < volume.vertices().size(); ++v)
      x.col(v) = volume.to_domain(Eigen::Map<const Eigen::Vector3d>(result[volume.vertices()[v]].data()));
    summary =
      FFM::map_volume(volume.domain(), held, x, is_given ? FFM::Volume_start::given : FFM::Volume_start::extension, options, traits);
    if(!summary.is_valid())
      return;
    if(options.polish)
      traits.name_choices(summary);
    const FFM::Status written =
      volume.write_back(x, FFM::internal::Array_map<std::array<double, 3>>{&result}, summary.message, exact_places);
    if(written != FFM::Status::success)
      summary.status = written;
  };
  {
    const py::gil_scoped_release unlocked;
    FFM::internal::catch_out_of_memory(run, summary);
  }
  watch.raise();
  return py::make_tuple(array_of(result), account(summary));
}

py::tuple morph_volume(const py::array& points, const py::array& tetrahedra, const py::array& vertices, const py::array& places,
                       const py::dict& given, const py::object& progress)
{
  const Points p(points, "points");
  const Tetrahedra t(tetrahedra, "tetrahedra");
  const auto moved = handles_of<3>(Numbers(vertices, "vertices"), Points(places, "places"));
  const program::Method_choice choice = method_choice(given);
  Watch watch(progress);
  const FFM::Any_map_traits traits = traits_of(choice, watch);
  FFM::Morph_options options;
  read(given, "polish", options.polish);
  read(given, "slide", options.slide_on_boundary);
  set_limits(choice, options);
  options.splitting.observer = watch.observer<FFM::Splitting_report>();
  Places<3> result(p.begin(), p.end());
  FFM::Morph_summary summary;
  const auto run = [&] {
    FFM::Tetrahedral_domain volume;
    summary.dimension = 3;
    summary.status = volume.load(p, t, summary.message);
    // Components that nobody moves stay at rest.
    if(summary.status != FFM::Status::success && summary.status != FFM::Status::several_components)
      return;
    summary = FFM::morph_volume(volume, moved, FFM::internal::Array_map<std::array<double, 3>>{&result}, traits, options);
    if(summary.is_valid() && options.polish)
      traits.name_choices(summary);
  };
  {
    const py::gil_scoped_release unlocked;
    FFM::internal::catch_out_of_memory(run, summary);
  }
  watch.raise();
  return py::make_tuple(array_of(result), account(summary));
}

namespace {

// A shape that is moved again and again. Its functions run one at a time.
template <int D>
class Session
{
  using Result = std::array<double, D>;

public:
  // `numbers[v]` is the number of vertex v of the domain among the points.
  template <typename Loaded>
  Session(Loaded&& loaded, const py::dict& given) : m_numbers(std::move(loaded.numbers)), m_points(std::move(loaded.points))
  {
    const program::Method_choice choice = method_choice(given);
    FFM::Any_map_traits traits = make_traits(choice);
    set_limits(choice, traits.options);
    m_deformation =
      std::make_unique<FFM::Deformation<D, FFM::Any_map_traits>>(std::move(loaded.domain), loaded.start, loaded.handles, traits);
    m_traits = std::make_unique<FFM::Any_map_traits>(traits);
    m_options = make_traits(choice).options;
    m_options.keep_factorization = m_deformation->options().keep_factorization;
  }

  py::tuple move(const py::array& targets, const py::dict& given, const py::object& progress)
  {
    const Rows<double, D> places(targets, "targets");
    const program::Method_choice choice = method_choice(given);
    Watch watch(progress);
    FFM::Map_options& options = m_deformation->options();
    options = m_options;
    set_limits(choice, options);
    options.observer = watch.observer<FFM::Iteration_report>();
    FFM::Summary summary;
    {
      const py::gil_scoped_release unlocked;
      summary.dimension = D;
      const auto run = [&] { m_deformation->move(positions<D>(places), summary); };
      FFM::internal::account_run(summary, run);
      m_traits->name_choices(summary);
    }
    options.observer = nullptr;
    watch.raise();
    return account(summary);
  }

  py::array points()
  {
    const FFM::Positions<D>& x = m_deformation->positions();
    for(std::size_t v = 0; v < m_numbers.size(); ++v)
      for(int k = 0; k < D; ++k)
        m_points[m_numbers[v]][k] = x(k, v);
    return array_of(m_points);
  }

private:
  std::vector<std::size_t> m_numbers;
  std::vector<Result> m_points;
  std::unique_ptr<FFM::Deformation<D, FFM::Any_map_traits>> m_deformation;
  std::unique_ptr<FFM::Any_map_traits> m_traits;
  FFM::Map_options m_options; // of a move without limits of its own
};

template <int D>
struct Loaded
{
  FFM::Simplicial_domain<D> domain;
  FFM::Positions<D> start;
  std::vector<std::int32_t> handles;
  std::vector<std::size_t> numbers;
  std::vector<std::array<double, D>> points;
  FFM::Outcome outcome{FFM::Status::success, ""};
};

template <int D>
void set_start(const py::dict& given, Loaded<D>& loaded)
{
  if(!given.contains("start"))
    return;
  const Rows<double, D> start(given["start"], "start");
  for(std::size_t v = 0; v < loaded.numbers.size(); ++v)
    for(int k = 0; k < D; ++k)
      loaded.start(k, v) = start[loaded.numbers[v]][k];
}

template <int D>
void refuse_handle(std::int64_t handle, Loaded<D>& loaded)
{
  loaded.outcome = FFM::Outcome(FFM::Status::invalid_option, "handle " + std::to_string(handle) + " is not a vertex of an element");
}

py::tuple planar_session(const py::array& points, const py::array& triangles, const py::array& handles, const py::dict& given)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const Numbers h(handles, "handles");
  const std::string reason = why_not_available(method_choice(given), 2);
  if(!reason.empty())
    return refusal(reason);
  Loaded<2> loaded;
  {
    const py::gil_scoped_release unlocked;
    using Surface = FFM::internal::Triangle_surface;
    Surface surface;
    FFM::Face_graph_domain<Surface> graph;
    loaded.outcome.status = surface.load(p, t, loaded.outcome.message);
    if(loaded.outcome.is_success())
      loaded.outcome.status = graph.load_planar(surface, get(CGAL::vertex_point, surface), loaded.start, loaded.outcome.message);
    if(loaded.outcome.is_success()) {
      for(const auto v : graph.vertices())
        loaded.numbers.push_back(static_cast<std::size_t>(v.number));
      for(const auto& handle : h) {
        const std::int32_t v = graph.number_of(FFM::internal::vertex_of_index(handle[0], p.size()));
        loaded.handles.push_back(v);
        if(v < 0)
          refuse_handle(handle[0], loaded);
      }
      for(const auto& point : p)
        loaded.points.push_back({{point[0], point[1]}});
      loaded.domain = graph.domain();
      loaded.start = (loaded.domain.scale * loaded.start).colwise() + loaded.domain.origin;
    }
  }
  if(!loaded.outcome.is_success())
    return py::make_tuple(py::none(), account(loaded.outcome));
  set_start(given, loaded);
  return py::make_tuple(std::make_unique<Session<2>>(loaded, given), account(loaded.outcome));
}

py::tuple solid_session(const py::array& points, const py::array& tetrahedra, const py::array& handles, const py::dict& given)
{
  const Points p(points, "points");
  const Tetrahedra t(tetrahedra, "tetrahedra");
  const Numbers h(handles, "handles");
  const std::string reason = why_not_available(method_choice(given), 3);
  if(!reason.empty())
    return refusal(reason);
  Loaded<3> loaded;
  {
    const py::gil_scoped_release unlocked;
    FFM::Tetrahedral_domain volume;
    loaded.outcome.status = volume.load(p, t, loaded.outcome.message);
    if(loaded.outcome.is_success()) {
      for(const auto& handle : h) {
        const std::int32_t v = volume.number(static_cast<std::size_t>(handle[0]));
        loaded.handles.push_back(v);
        if(v < 0)
          refuse_handle(handle[0], loaded);
      }
      loaded.numbers = volume.vertices();
      loaded.points.assign(p.begin(), p.end());
      loaded.domain = volume.domain();
      loaded.start = (loaded.domain.scale * loaded.domain.rest_points).colwise() + loaded.domain.origin;
    }
  }
  if(!loaded.outcome.is_success())
    return py::make_tuple(py::none(), account(loaded.outcome));
  set_start(given, loaded);
  return py::make_tuple(std::make_unique<Session<3>>(loaded, given), account(loaded.outcome));
}

} // namespace

void add_deformations(py::module_& module)
{
  py::class_<Session<2>>(module, "Planar_session").def("move", &Session<2>::move).def("points", &Session<2>::points);
  py::class_<Session<3>>(module, "Solid_session").def("move", &Session<3>::move).def("points", &Session<3>::points);
  module.def("planar_session", &planar_session);
  module.def("solid_session", &solid_session);
}

} // namespace python
