// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "../commands.h"
#include "../layout.h"
#include "../report.h"
#include "../splitting.h"

#include <CGAL/Flip_free_maps/internal/Timer.h>
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
  std::vector<Kernel::Point_2> images;
};

// Points are scaled by `scale`.
Island make_island(const FFM::Textured_mesh& mesh, const std::vector<std::size_t>& triangles, double scale)
{
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
    }
    island.triangles.push_back(triangle);
  }
  return island;
}

// The scale of a map that most of its triangles have: those that have flipped may have any.
double usual_scale(const Island& island)
{
  std::vector<double> scales;
  for(const auto& t : island.triangles) {
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
  return std::all_of(island.triangles.begin(), island.triangles.end(), [&](const std::array<std::size_t, 3>& t) {
    return CGAL::orientation(images[t[0]], images[t[1]], images[t[2]]) == CGAL::LEFT_TURN;
  });
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
    app->add_flag("--no-polish", m_no_polish, "stop at the first map without flips; some elements are almost collapsed then");
    add_limit_options(*app, m_method);
    add_picture_options(*app, m_layout.pictures);
  }

  int run() override
  {
    m_files = files_of(m_layout, m_method.json, m_method.trace);
    std::string reason = why_not_written(m_layout.input, m_layout.output);
    if(reason.empty())
      reason = why_files_collide({{"the input", m_layout.input}}, m_files);
    if(!reason.empty())
      return refuse(reason);
    return run_reported(m_method, [this](FFM::Summary& summary) { repair(summary); });
  }

private:
  void repair(FFM::Summary& summary)
  {
    check_folders(m_files);
    const double begin = FFM::internal::wall_seconds();
    Surface surface;
    surface.uv_set = m_layout.output.uv_set;
    read_surface(m_layout.input, true, surface);
    Atlas atlas = make_atlas(surface, surface.images);
    check(!atlas.mesh.triangles.empty(), m_layout.input + ": no face with an area has texture coordinates");
    const auto reporter = std::make_shared<Reporter>(m_method);
    const auto all_islands = islands(atlas);
    std::size_t repaired = 0, largest = 0;
    std::int64_t flips = 0;
    for(const auto& triangles : all_islands) {
      if(std::all_of(triangles.begin(), triangles.end(),
                     [&](std::size_t i) { return image_orientation(atlas.mesh, i) == CGAL::LEFT_TURN; }))
        continue;
      Island island = make_island(atlas.mesh, triangles, 1);
      island = make_island(atlas.mesh, triangles, usual_scale(island));
      FFM::Summary part = repair(island, reporter, FFM::internal::wall_seconds() - begin);
      if(!part.is_valid()) {
        if(all_islands.size() > 1)
          part.message += ", in the island of face number " + std::to_string(atlas.polygons[triangles[0]]);
        summary = part;
        return;
      }
      for(std::size_t v = 0; v < island.texture.size(); ++v)
        atlas.mesh.texture[island.texture[v]] = {{island.images[v].x(), island.images[v].y()}};
      ++repaired;
      flips += part.flips;
      if(triangles.size() > largest) {
        largest = triangles.size();
        summary = part;
      }
    }
    reporter->finish();
    summary.flips = flips;
    if(repaired == 0) {
      summary.status = Status::success;
      summary.message = "no face is flipped, nothing had to be repaired";
    } else if(all_islands.size() > 1)
      summary.message += "; repaired " + std::to_string(repaired) + " of " + std::to_string(all_islands.size()) +
                         " islands, the largest of which has these figures";
    Corner_images images = surface.images;
    copy_images(atlas, images);
    add_note(summary.message, write_layout(m_layout, surface, std::move(images), summary));
  }

  // Islands keep their scale and, as nearly as they can, their place.
  FFM::Summary repair(Island& island, const std::shared_ptr<Reporter>& reporter, double seconds) const
  {
    Method_arguments limits = m_method;
    if(limits.time_limit > 0)
      limits.time_limit = (std::max)(1e-6, limits.time_limit - seconds);
    FFM::Repair_options options;
    options.polish = !m_no_polish;
    options.fix_border = m_fix_border;
    FFM::Flip_free_map_traits<> traits;
    set_limits(limits, options);
    set_options(limits, reporter, traits.options);
    std::vector<Kernel::Point_2> images = island.images;
    const FFM::Summary summary = FFM::repair_map(island.points, island.triangles, images,
                                                 FFM::parameters::repair_options(options, FFM::parameters::map_traits(traits)));
    if(!summary.is_valid())
      return summary;
    const std::vector<Kernel::Point_2> moved = m_fix_border ? images : laid_upon(images, island.images);
    island.images = is_positive(island, moved) ? moved : images;
    return summary;
  }

  Method_arguments m_method;
  Layout_arguments m_layout;
  std::vector<File_argument> m_files;
  bool m_fix_border = false, m_no_polish = false;
};

} // namespace

std::unique_ptr<Command> repair_command(CLI::App& app) { return std::make_unique<Repair>(app); }

} // namespace program
