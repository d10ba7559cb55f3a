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

#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/repair_map.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace program {

namespace {

// A part of a map, cut along the seams of its own texture coordinates: points are numbered as these.
struct Island
{
  std::vector<std::size_t> texture; // the numbers of the texture coordinates in the atlas
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<char> has_area; // by triangle
  std::vector<Kernel::Point_2> images;
  std::vector<char> is_pinned; // by point

  bool has_pinned() const { return std::find(is_pinned.begin(), is_pinned.end(), 1) != is_pinned.end(); }
};

// Points are scaled by `scale`. `is_pinned` tells which points of the atlas are.
Island make_island(const Atlas& atlas, const std::vector<std::size_t>& triangles, const std::vector<char>& is_pinned, double scale)
{
  const FFM::Textured_mesh& mesh = atlas.mesh;
  Island island;
  std::map<int, std::size_t> numbers;
  for(const std::size_t i : triangles) {
    std::array<std::size_t, 3> triangle;
    for(int k = 0; k < 3; ++k) {
      const int t = mesh.texture_triangles[i][k];
      const auto entry = numbers.emplace(t, island.points.size());
      triangle[k] = entry.first->second;
      if(!entry.second)
        continue;
      const auto& p = mesh.points[mesh.triangles[i][k]];
      island.texture.push_back(t);
      island.points.emplace_back(scale * p[0], scale * p[1], scale * p[2]);
      island.images.emplace_back(mesh.texture[t][0], mesh.texture[t][1]);
      island.is_pinned.push_back(is_pinned[mesh.triangles[i][k]]);
    }
    island.triangles.push_back(triangle);
    island.has_area.push_back(atlas.has_area[i]);
  }
  return island;
}

// The scale of a map that most of its triangles have: those that have flipped may have any.
double usual_scale(const Island& island)
{
  std::vector<double> scales;
  for(std::size_t i = 0; i < island.triangles.size(); ++i) {
    if(!island.has_area[i])
      continue;
    const auto& t = island.triangles[i];
    const double area = std::sqrt(CGAL::squared_area(island.points[t[0]], island.points[t[1]], island.points[t[2]]));
    scales.push_back(std::sqrt(std::abs(CGAL::area(island.images[t[0]], island.images[t[1]], island.images[t[2]])) / area));
  }
  const std::size_t middle = (scales.size() - 1) / 2;
  std::nth_element(scales.begin(), scales.begin() + static_cast<std::ptrdiff_t>(middle), scales.end());
  const double scale = scales[middle];
  return scale > 0 && std::isfinite(scale) ? scale : 1;
}

bool is_positive(const Island& island, const std::vector<Kernel::Point_2>& images)
{
  for(std::size_t i = 0; i < island.triangles.size(); ++i) {
    const auto& t = island.triangles[i];
    if(island.has_area[i] && CGAL::orientation(images[t[0]], images[t[1]], images[t[2]]) != CGAL::LEFT_TURN)
      return false;
  }
  return true;
}

// The images, turned and moved to where others are, as near as they come.
std::vector<Kernel::Point_2> laid_upon(const std::vector<Kernel::Point_2>& images, const std::vector<Kernel::Point_2>& others)
{
  const auto center = [](const std::vector<Kernel::Point_2>& points) {
    double x = 0, y = 0;
    for(const auto& p : points) {
      x += p.x() / static_cast<double>(points.size());
      y += p.y() / static_cast<double>(points.size());
    }
    return Kernel::Point_2(x, y);
  };
  const Kernel::Point_2 from = center(images), to = center(others);
  double cosine = 0, sine = 0;
  for(std::size_t v = 0; v < images.size(); ++v) {
    const Kernel::Vector_2 p = images[v] - from, q = others[v] - to;
    cosine += p.x() * q.x() + p.y() * q.y();
    sine += p.x() * q.y() - p.y() * q.x();
  }
  const double length = std::hypot(cosine, sine);
  if(!(length > 0))
    return images;
  std::vector<Kernel::Point_2> result;
  for(const auto& image : images) {
    const Kernel::Vector_2 p = image - from;
    result.emplace_back(to.x() + (cosine * p.x() - sine * p.y()) / length, to.y() + (sine * p.x() + cosine * p.y()) / length);
  }
  return result;
}

class Repair : public Command
{
public:
  explicit Repair(CLI::App& application)
  {
    app = application.add_subcommand("repair", "Remove the flips of texture coordinates, and then minimise their distortion");
    add_layout_options(
      *app, m_layout,
      "OBJ, PLY, GLB or glTF with texture coordinates; each island is repaired for itself, and those without flips are left alone",
      "the mesh with the repaired texture coordinates");
    app->add_flag("--fix-border", m_fix_border, "the borders of islands keep their places");
    app->add_option("--pinned", m_pinned, "file with the number of a vertex of the input per line, from 0: these stay where they are");
    app->add_flag("--no-polish", m_no_polish, "stop at the first map without flips; some elements are almost collapsed then");
    add_limit_options(*app, m_method);
    add_picture_options(*app, m_layout.pictures);
    add_surface_picture(*app, m_layout.pictures);
  }

  int run() override
  {
    m_files = files_of(m_layout, m_method);
    std::string reason = why_not_written(m_layout.input, m_layout.output);
    if(reason.empty())
      reason = why_files_collide({{"the input", m_layout.input}, {"--pinned", m_pinned}}, m_files);
    if(!reason.empty())
      return refuse(reason);
    return run_reported(
      m_method, [this](FFM::Summary& summary) { repair(summary); }, {}, pictures_of(m_layout.pictures));
  }

private:
  void repair(FFM::Summary& summary)
  {
    check_folders(m_files);
    Surface surface;
    surface.uv_set = m_layout.output.uv_set;
    read_surface(m_layout.input, true, surface);
    Atlas atlas = make_atlas(surface, surface.images, true);
    const std::vector<char> is_pinned = pinned_places(surface, atlas);
    check(std::count(atlas.has_area.begin(), atlas.has_area.end(), 1) > 0,
          m_layout.input + ": no face with an area has texture coordinates");
    const auto reporter = std::make_shared<Reporter>(m_method);
    auto all_islands = islands(atlas);
    const auto has_area = [&](const std::vector<std::size_t>& triangles) {
      return std::any_of(triangles.begin(), triangles.end(), [&](std::size_t i) { return atlas.has_area[i]; });
    };
    all_islands.erase(std::stable_partition(all_islands.begin(), all_islands.end(), has_area), all_islands.end());
    std::size_t repaired = 0, largest = 0;
    std::int64_t flips = 0;
    bool is_cut_short = false;
    Status limit = Status::success;
    for(const auto& triangles : all_islands) {
      // Of what has no area in space, no image is wrong.
      if(std::all_of(triangles.begin(), triangles.end(),
                     [&](std::size_t i) { return !atlas.has_area[i] || image_orientation(atlas.mesh, i) == CGAL::LEFT_TURN; }))
        continue;
      Island island = make_island(atlas, triangles, is_pinned, 1);
      island = make_island(atlas, triangles, is_pinned, usual_scale(island));
      FFM::Summary part = repair(island, reporter);
      if(!part.is_valid()) {
        if(all_islands.size() > 1)
          part.message += ", in the island of face number " + std::to_string(atlas.polygons[triangles[0]]);
        summary = part;
        if(repaired == 0 || FFM::internal::deadline_status() == Status::success)
          return;
        is_cut_short = true;
        break;
      }
      for(std::size_t v = 0; v < island.texture.size(); ++v)
        atlas.mesh.texture[island.texture[v]] = {{island.images[v].x(), island.images[v].y()}};
      ++repaired;
      if(part.status != Status::success)
        limit = part.status;
      flips += part.flips;
      if(triangles.size() > largest) {
        largest = triangles.size();
        summary = part;
      }
    }
    reporter->finish();
    if(is_cut_short)
      summary.message += "; " + std::to_string(repaired) + " islands are repaired, the others as they were";
    else
      summary.flips = flips;
    if(!is_cut_short && repaired == 0) {
      summary.status = Status::success;
      summary.message = "no face is flipped, nothing had to be repaired";
    } else if(!is_cut_short && all_islands.size() > 1)
      summary.message += "; repaired " + std::to_string(repaired) + " of " + std::to_string(all_islands.size()) +
                         " islands, the largest of which has these figures";
    if(summary.is_valid() && limit != Status::success)
      summary.status = limit;
    Corner_images images = surface.images;
    copy_images(atlas, images);
    add_note(summary.message, write_layout(m_layout, surface, std::move(images), summary));
  }

  // By the points of the atlas, where those at the same place are one.
  std::vector<char> pinned_places(const Surface& surface, const Atlas& atlas) const
  {
    std::vector<char> is_pinned(surface.points.size(), 0);
    if(m_pinned.empty())
      return is_pinned;
    for(const Number_row& row : read_number_rows(m_pinned, 1))
      is_pinned[atlas.first[vertex_of(row, 0, is_pinned.size())]] = 1;
    return is_pinned;
  }

  // Islands keep their scale and, as nearly as they can, their place.
  FFM::Summary repair(Island& island, const std::shared_ptr<Reporter>& reporter) const
  {
    FFM::Repair_options options;
    options.polish = !m_no_polish;
    options.fix_border = m_fix_border;
    FFM::Flip_free_map_traits<> traits;
    set_limits(m_method, options);
    set_options(m_method, reporter, traits.options);
    std::vector<Kernel::Point_2> images = island.images;
    const auto is_pinned = boost::make_iterator_property_map(island.is_pinned.begin(), boost::typed_identity_property_map<std::size_t>());
    const FFM::Summary summary =
      FFM::repair_map(island.points, island.triangles, images,
                      FFM::parameters::repair_options(
                        options, FFM::parameters::map_traits(traits, CGAL::parameters::vertex_is_constrained_map(is_pinned))));
    if(!summary.is_valid())
      return summary;
    const std::vector<Kernel::Point_2> moved = m_fix_border || island.has_pinned() ? images : laid_upon(images, island.images);
    island.images = is_positive(island, moved) ? moved : images;
    return summary;
  }

  Method_arguments m_method;
  Layout_arguments m_layout;
  std::vector<File_argument> m_files;
  std::string m_pinned;
  bool m_fix_border = false, m_no_polish = false;
};

} // namespace

std::unique_ptr<Command> repair_command(CLI::App& app) { return std::make_unique<Repair>(app); }

} // namespace program
