// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "../commands.h"
#include "../layout.h"
#include "../number_files.h"
#include "../report.h"
#include "../splitting.h"

#include <CGAL/Flip_free_maps/bijective.h>
#include <CGAL/Flip_free_maps/parameterize.h>

#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

namespace program {

namespace {

using Soft_position = std::tuple<std::size_t, Kernel::Point_2, double>;

// An array as a property map.
template <typename Values>
auto by_number(const Values& values)
{
  return boost::make_iterator_property_map(values.begin(), boost::typed_identity_property_map<std::size_t>());
}

class Parameterize : public Command
{
public:
  explicit Parameterize(CLI::App& application)
  {
    app = application.add_subcommand("parameterize", "Flatten a surface patch, a disk that may have holes, into the plane");
    add_layout_options(*app, m_layout, "mesh: OFF, OBJ, PLY, STL, GLB or glTF",
                       "the mesh with texture coordinates, in the units of the surface");
    add_method_options(*app, m_method);
    app
      ->add_option(
        "--start", m_start.start,
        "Tutte embedding, from coarse to fine, or an OBJ, PLY or glTF of the same mesh with the texture coordinates to begin with; 'auto' is from "
        "coarse to fine for the default method on large meshes, and either where the other fails")
      ->capture_default_str();
    app->add_option("--border", m_start.border, "border of the start")->check(CLI::IsMember(border_names()))->capture_default_str();
    app->add_option("--weights", m_start.weights, "weights of the start")->check(CLI::IsMember(weight_names()))->capture_default_str();
    app->add_flag("--flaps", m_place_flaps, "begin with border vertices of a single triangle at their optimum");
    app->add_option("--fixed", m_fixed,
                    "file with the number of a vertex of the input per line, from 0: these keep their places in the start");
    app->add_flag("--fix-border", m_fix_border, "the vertices of all borders keep their places in the start");
    app->add_option("--soft", m_soft,
                    "file with lines 'vertex u v weight': vertices that are pulled to places, in the units of the surface");
    app->add_flag("--bijective", m_bijective, "the image must not overlap itself");
    app->add_flag("--strict", m_strict,
                  "refuse polygons that are no triangles, faces without area, and points or faces that are there twice");
    add_picture_options(*app, m_layout.pictures);
    add_surface_picture(*app, m_layout.pictures);
  }

  int run() override
  {
    std::string reason = why_not_available(m_method, 2);
    if(m_bijective && m_method.is_splitting())
      reason = "the splitting scheme makes no bijective maps";
    m_files = files_of(m_layout, m_method);
    if(reason.empty())
      reason = why_not_written(m_layout.input, m_layout.output);
    if(reason.empty())
      reason = why_files_collide(
        {{"the input", m_layout.input}, {"--fixed", m_fixed}, {"--soft", m_soft}, {"--start", is_named_start() ? "" : m_start.start}},
        m_files);
    if(!reason.empty())
      return refuse(reason);
    return run_reported(
      m_method, [this](FFM::Summary& summary) { flatten(summary); }, patch_hints(), pictures_of(m_layout.pictures));
  }

private:
  bool is_named_start() const { return m_start.start == "auto" || m_start.start == "tutte" || m_start.start == "multilevel"; }

  void flatten(FFM::Summary& summary)
  {
    check_folders(m_files);
    Surface surface;
    read_piece(m_layout.input, m_strict, surface);
    std::vector<Kernel::Point_2> uv;
    const auto reporter = std::make_shared<Reporter>(m_method);
    if(m_method.is_default()) {
      FFM::Flip_free_map_traits<> traits;
      set_options(m_method, reporter, traits.options);
      summary = flatten(surface, traits, uv);
    } else {
      FFM::Any_map_traits traits = make_traits(m_method);
      set_options(m_method, reporter, traits.options);
      if(m_method.is_splitting()) {
        FFM::Splitting_map_traits<FFM::Any_map_traits> splitting = splitting_traits(m_method, traits);
        summary = flatten(surface, splitting, uv);
      } else {
        summary = flatten(surface, traits, uv);
        traits.name_choices(summary);
      }
    }
    reporter->finish();
    explain_failure(surface, m_strict, summary);
    if(summary.is_valid())
      add_note(summary.message, write_layout(m_layout, surface, corner_images(surface, uv), summary));
  }

  template <typename Traits>
  FFM::Summary flatten(const Surface& surface, Traits& traits, std::vector<Kernel::Point_2>& uv)
  {
    FFM::Start_options& start = traits.start;
    set_start(m_start, m_fix_border || !m_fixed.empty(), start);
    start.place_flaps = start.place_flaps || m_place_flaps;

    std::vector<char> is_fixed(surface.points.size(), 0);
    if(!m_fixed.empty())
      for(const Number_row& row : read_number_rows(m_fixed, 1))
        is_fixed[vertex_of(row, 0, is_fixed.size())] = 1;
    std::vector<Soft_position> soft;
    if(!m_soft.empty())
      for(const Number_row& row : read_number_rows(m_soft, 4))
        soft.emplace_back(vertex_of(row, 0, is_fixed.size()), Kernel::Point_2(row.numbers[1], row.numbers[2]), row.numbers[3]);

    namespace parameters = FFM::parameters;
    const auto constraints = parameters::map_traits(
      traits, parameters::strict(m_strict, parameters::border_is_fixed(
                                             m_fix_border, parameters::soft_positions(
                                                             soft, CGAL::parameters::vertex_is_constrained_map(by_number(is_fixed))))));
    if constexpr(std::is_same<Traits, FFM::Splitting_map_traits<FFM::Any_map_traits>>::value)
      return parameterize(surface, uv, constraints);
    else
      return parameterize(surface, uv, parameters::bijective(m_bijective, constraints));
  }

  template <typename Parameters>
  FFM::Summary parameterize(const Surface& surface, std::vector<Kernel::Point_2>& uv, const Parameters& constraints) const
  {
    if(is_named_start())
      return FFM::parameterize(surface.points, surface.polygons, uv, constraints);
    const std::vector<Kernel::Point_2> given = vertex_texture(m_start.start, surface);
    return FFM::parameterize(surface.points, surface.polygons, uv, FFM::parameters::start_map(by_number(given), constraints));
  }

  Method_arguments m_method;
  Layout_arguments m_layout;
  std::vector<File_argument> m_files;
  Start_choice m_start;
  std::string m_fixed, m_soft;
  bool m_place_flaps = false, m_fix_border = false, m_bijective = false, m_strict = false;
};

} // namespace

std::unique_ptr<Command> parameterize_command(CLI::App& app) { return std::make_unique<Parameterize>(app); }

} // namespace program
