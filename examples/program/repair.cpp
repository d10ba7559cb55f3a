// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "common.h"

#include <CGAL/Flip_free_maps/repair_map.h>

#include <CGAL/Polygon_mesh_processing/border.h>

#include <iterator>

namespace program {

namespace {

class Repair
  : public Command
{
public:
  explicit Repair(CLI::App& application)
  {
    app = application.add_subcommand("repair", "Remove the flips of texture coordinates, and then minimise their distortion");
    app->add_option("input", m_input, "OBJ of a topological disk with one pair of texture coordinates per vertex")->required();
    app->add_option("-o,--output", m_output, "OBJ with the repaired texture coordinates");
    app->add_flag("--unit-square", m_unit_square, "scale the texture coordinates into the unit square");
    app->add_flag("--fix-border", m_fix_border, "border vertices keep their places");
    app->add_flag("--no-polish", m_no_polish, "stop at the first map without flips; some elements are almost collapsed then");
    app->add_option("--time-limit", m_method.time_limit, "seconds, for each method that is tried")->check(CLI::PositiveNumber);
    app->add_option("--threads", m_method.threads, "at most this many; results do not depend on it")->check(CLI::PositiveNumber);
    app->add_option("--json", m_method.json, "write the summary");
    app->add_flag("--quiet", m_method.quiet, "print nothing but errors");
    add_picture_options(*app, m_pictures);
  }

  int run() override
  {
    return run_reported(m_method, [this](FFM::Summary& summary) { repair(summary); });
  }

private:
  void repair(FFM::Summary& summary)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    Triangles triangles;
    read_triangles(m_input, triangles);
    Mesh& mesh = triangles.mesh;
    std::vector<Mesh::Halfedge_index> borders;
    PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
    if(borders.empty())
      throw Failure{Status::no_border, "the surface is closed"};
    UV_map uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
    const std::vector<Kernel::Point_2> given = vertex_texture(m_input, triangles);
    for(const auto v : mesh.vertices())
      uv[v] = given[v];

    FFM::Repair_options options;
    options.polish = !m_no_polish;
    options.fix_border = m_fix_border;
    FFM::Flip_free_map_traits<> traits;
    if(m_method.time_limit > 0)
      options.splitting.max_seconds = options.foldover_free.max_seconds = traits.options.max_seconds = m_method.time_limit;
    summary = FFM::repair_map(mesh, borders.front(), uv, options, traits);
    if(summary.is_valid())
      write_layout(triangles, uv, m_unit_square, m_output, m_pictures, m_input, summary);
  }

  Method_arguments m_method;
  Picture_arguments m_pictures;
  std::string m_input, m_output;
  bool m_unit_square = false, m_fix_border = false, m_no_polish = false;
};

} // namespace

std::unique_ptr<Command> repair_command(CLI::App& app)
{
  return std::make_unique<Repair>(app);
}

} // namespace program
