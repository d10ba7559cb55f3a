// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Maps of surfaces that are cut open, whose seams fit together.

#include "Joined_corners.h"
#include "Rows.h"
#include "Watch.h"
#include "account.h"
#include "functions.h"
#include "options.h"

#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterize_with_seams.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace python {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;
using Vertex_map = Mesh::Property_map<Vertex, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map>;

Vertex vertex(std::int64_t number) { return Vertex(static_cast<Mesh::size_type>(number)); }

// Flattens; faces of the mesh have the numbers of the triangles.
void flatten(const Points& points, const Triangles& triangles, const Edges& seams, const FFM::Seam_options& options,
             const FFM::Flip_free_map_traits<>& traits, Joined_corners<double>& joined, FFM::Seam_summary& summary)
{
  // Whether this is a surface at all is found out by the reader of arrays, which says what is wrong.
  {
    FFM::internal::Triangle_surface surface;
    summary.status = surface.load(points, triangles, summary.message);
    if(summary.status != FFM::Status::success)
      return;
  }
  Mesh mesh;
  for(const auto& p : points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const auto& t : triangles)
    mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  const Edge_map seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:on_seam", false).first;
  const Vertex_map seam_vertices = mesh.add_property_map<Vertex, bool>("v:on_seam", false).first;
  Mesh::Halfedge_index border;
  const auto fail = [&summary](const std::string& message) {
    summary.status = FFM::Status::invalid_option;
    summary.message = message;
  };
  for(const auto& seam : seams) {
    const bool is_in_range = seam[0] >= 0 && seam[1] >= 0 && seam[0] < static_cast<std::int64_t>(points.size()) &&
                             seam[1] < static_cast<std::int64_t>(points.size());
    const Mesh::Halfedge_index h = is_in_range ? mesh.halfedge(vertex(seam[0]), vertex(seam[1])) : Mesh::null_halfedge();
    if(h == Mesh::null_halfedge())
      return fail("there is no edge from " + std::to_string(seam[0]) + " to " + std::to_string(seam[1]));
    if(mesh.is_border(mesh.edge(h)))
      continue;
    seam_edges[mesh.edge(h)] = seam_vertices[vertex(seam[0])] = seam_vertices[vertex(seam[1])] = true;
    border = h;
  }
  if(border == Mesh::null_halfedge())
    return fail("there is no seam within the surface");
  Seam_mesh seam_mesh(mesh, seam_edges, seam_vertices);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  summary = FFM::parameterize_with_seams(seam_mesh, boost::graph_traits<Seam_mesh>::halfedge_descriptor(border, true), uv, options, traits);
  if(!summary.is_valid())
    return;
  std::vector<std::array<std::array<double, 2>, 3>> corners(triangles.size());
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      // The map of a vertex stands at the halfedge of the cut surface that leads to it.
      const Mesh::Halfedge_index h = mesh.halfedge(vertex(triangles[f][(k + 2) % 3]), vertex(triangles[f][k]));
      const Kernel::Point_2 p = get(uv, target(boost::graph_traits<Seam_mesh>::halfedge_descriptor(h), seam_mesh));
      corners[f][k] = {{p.x(), p.y()}};
    }
  joined.join(triangles, points.size(), corners);
}

} // namespace

py::tuple parameterize_with_seams(const py::array& points, const py::array& triangles, const py::array& seams, const py::dict& given,
                                  const py::object& progress)
{
  const Points p(points, "points");
  const Triangles t(triangles, "faces");
  const Edges s(seams, "seams");
  FFM::Seam_options options;
  bool is_similar = false;
  read(given, "similar", is_similar);
  if(is_similar)
    options.relation = FFM::Seam_relation::similarity;
  read(given, "seam_tolerance", options.tolerance);
  read(given, "cone_curvature", options.cone_curvature);
  Watch watch(progress);
  FFM::Flip_free_map_traits<> traits;
  set_limits(method_choice(given), traits.options);
  traits.options.observer = watch.observer<FFM::Iteration_report>();
  Joined_corners<double> joined;
  FFM::Seam_summary summary;
  {
    const py::gil_scoped_release unlocked;
    const auto run = [&] { flatten(p, t, s, options, traits, joined, summary); };
    FFM::internal::catch_out_of_memory(run, summary);
  }
  watch.raise();
  return py::make_tuple(array_of(joined.vertices),
                        array_of<std::int64_t>(joined.faces, {static_cast<py::ssize_t>(joined.faces.size() / 3), 3}), array_of(joined.uv),
                        account(summary));
}

} // namespace python
