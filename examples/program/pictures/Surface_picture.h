// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_PICTURES_SURFACE_PICTURE_H
#define FLIP_FREE_MAPS_PROGRAM_PICTURES_SURFACE_PICTURE_H

#include "Layout_picture.h"
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO
#include "Surface_painter.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cairo.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/*!
  One view of `write_surface_PNG()`: a surface in space with a value per triangle.
*/
struct Solid_view
{
  /// Positions in space; those that no triangle uses may have any value.
  std::vector<std::array<double, 3>> points;

  /// Corners of the triangles, as indices into `points`.
  std::vector<std::array<int, 3>> triangles;

  /// One value per triangle, not less than 1 (smaller values are drawn as 1); empty for a surface of one color.
  std::vector<double> values;

  /// Text in UTF-8 above the view.
  std::string caption;
};

/*!
  Settings of `write_surface_PNG()`.
*/
struct Surface_picture_options
{
  /// Width of the picture in pixels, from 320 to 8000.
  int width = 1600;

  /// Height of the picture in pixels, from 240 to 8000.
  int height = 800;

  /// Text in UTF-8 above the color bar.
  std::string label = "distortion";

  /// Value of the deepest color, finite and at least 1.01; 0 for the 98th percentile of the finite values of all views, at least
  /// 1.05.
  double upper_end = 0.;

  /// Direction from the surface to the viewer. If it is zero, one of four directions that look a little down on the surface
  /// is chosen: the one from which the first view shows most.
  std::array<double, 3> view_direction = {{0, 0, 0}};

  /// Direction that points upwards on the picture.
  std::array<double, 3> up = {{0, 1, 0}};
};

namespace internal {

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO

// Draws views side by side with one scale of lengths and one of colors.
class Surface_picture
{
public:
  Surface_picture(const std::vector<Solid_view>& views, const Surface_picture_options& options) : m_views(views), m_options(options) {}

  // Returns the empty string, or what is wrong with the views or the options.
  std::string analyze()
  {
    if(m_options.width < 320 || m_options.width > 8000 || m_options.height < 240 || m_options.height > 8000)
      return "the picture must be from 320 to 8000 pixels wide and from 240 to 8000 pixels high";
    if(m_options.upper_end != 0. && !(std::isfinite(m_options.upper_end) && m_options.upper_end >= 1.01))
      return "the upper end of the values must be 0, or finite and at least 1.01";
    const Eigen::Vector3d up = vector(m_options.up), direction = vector(m_options.view_direction);
    if(!up.allFinite() || !(up.norm() > 0) || !direction.allFinite())
      return "the directions of the view must be finite, and that of up not zero";
    if(m_views.empty())
      return "there is no view";
    for(const Solid_view& view : m_views) {
      const std::string error = view_error(view);
      if(!error.empty())
        return error;
    }
    choose_upper_end();
    m_axes = direction.norm() > 0 ? view_axes(direction, up) : default_axes(up.normalized());
    return std::string();
  }

  void draw(cairo_t* context)
  {
    const double font_size = (std::max)(10., (std::min)(m_options.width / 90., m_options.height / 26.));
    const double margin = 1.2 * font_size, legend_width = m_has_values ? 8.5 * font_size : 0.;
    const double plot_top = margin + 1.8 * font_size, plot_height = m_options.height - plot_top - margin;
    const double cell_width = (m_options.width - 2 * margin - legend_width) / m_views.size();
    cairo_set_source_rgb(context, 1, 1, 1);
    cairo_paint(context);

    double scale = std::numeric_limits<double>::infinity();
    std::vector<Eigen::Vector3d> centers;
    for(const Solid_view& view : m_views) {
      Eigen::Vector3d low, high;
      box(view, low, high);
      const Eigen::Vector3d size = high - low;
      centers.push_back((low + high) / 2);
      if(size[0] > 0)
        scale = (std::min)(scale, 0.94 * cell_width / size[0]);
      if(size[1] > 0)
        scale = (std::min)(scale, 0.98 * plot_height / size[1]);
    }
    for(std::size_t i = 0; i < m_views.size(); ++i) {
      const double left = std::floor(margin + i * cell_width), top = std::floor(plot_top);
      draw_view(context, m_views[i], centers[i], std::isfinite(scale) ? scale : 0., left, top, static_cast<int>(cell_width),
                static_cast<int>(plot_height), font_size);
      show_text(context, left + cell_width / 2, margin + font_size, 1.15 * font_size, printable_text(m_views[i].caption.substr(0, 200)),
                0.5);
    }
    if(m_has_values)
      draw_legend(context, m_options.width - margin - legend_width + font_size, plot_top, plot_height, font_size);
  }

private:
  static Eigen::Vector3d vector(const std::array<double, 3>& a) { return Eigen::Vector3d(a[0], a[1], a[2]); }

  static std::string view_error(const Solid_view& view)
  {
    if(view.triangles.empty())
      return "a view has no triangle";
    if(!view.values.empty() && view.values.size() != view.triangles.size())
      return "the number of values is not the number of triangles";
    for(std::size_t i = 0; i < view.triangles.size(); ++i) {
      for(const int index : view.triangles[i]) {
        if(index < 0 || std::size_t(index) >= view.points.size())
          return "triangle " + std::to_string(i) + " has an index out of range";
        for(const double coordinate : view.points[index])
          if(!(std::abs(coordinate) < 1e150))
            return "triangle " + std::to_string(i) + " has a coordinate that is not finite, or too large";
      }
    }
    return std::string();
  }

  void choose_upper_end()
  {
    std::vector<double> finite;
    for(const Solid_view& view : m_views) {
      m_has_values = m_has_values || !view.values.empty();
      for(const double value : view.values)
        if(std::isfinite(value))
          finite.push_back(value);
    }
    m_upper = m_options.upper_end;
    if(m_upper == 0.) {
      m_upper = 1.05;
      if(!finite.empty()) {
        const std::size_t rank = (finite.size() - 1) * 98 / 100;
        std::nth_element(finite.begin(), finite.begin() + rank, finite.end());
        m_upper = (std::max)(m_upper, finite[rank]);
      }
    }
  }

  static Eigen::Vector3d area_vector(const Solid_view& view, const std::array<int, 3>& t)
  {
    const Eigen::Vector3d a = vector(view.points[t[0]]);
    return (vector(view.points[t[1]]) - a).cross(vector(view.points[t[2]]) - a) / 2;
  }

  // A little from above and 30 degrees beside an axis, so that boxes show three sides.
  Eigen::Matrix3d default_axes(const Eigen::Vector3d& up) const
  {
    Eigen::Vector3d best = up;
    double most = -1;
    for(const double degrees : {30., 60., 120., 150.}) {
      const Eigen::Vector3d direction = direction_from_above(up, degrees);
      double shown = 0;
      for(const std::array<int, 3>& t : m_views[0].triangles)
        shown += std::abs(area_vector(m_views[0], t).dot(direction));
      if(shown > most * (1 + 1e-9)) {
        most = shown;
        best = direction;
      }
    }
    return view_axes(best, up);
  }

  void box(const Solid_view& view, Eigen::Vector3d& low, Eigen::Vector3d& high) const
  {
    low.setConstant(std::numeric_limits<double>::infinity());
    high = -low;
    for(const std::array<int, 3>& t : view.triangles) {
      for(const int index : t) {
        const Eigen::Vector3d p = m_axes * vector(view.points[index]);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
  }

  Rgb color(const Solid_view& view, std::size_t i) const
  {
    if(view.values.empty())
      return {{0.80, 0.84, 0.88}};
    const double value = view.values[i];
    return distortion_color(!(value < m_upper) ? 1. : value <= 1. ? 0. : std::log(value) / std::log(m_upper));
  }

  void draw_view(cairo_t* context, const Solid_view& view, const Eigen::Vector3d& center, double scale, double left, double top, int width,
                 int height, double font_size) const
  {
    const int factor = 2;
    Surface_raster raster(factor * width, factor * height);
    const Eigen::Vector3d middle(factor * width / 2., factor * height / 2., 0);
    const auto corners = [&](const std::array<int, 3>& t) {
      Eigen::Matrix3d result;
      for(int k = 0; k < 3; ++k) {
        const Eigen::Vector3d p = factor * scale * (m_axes * vector(view.points[t[k]]) - center);
        result.col(k) = middle + Eigen::Vector3d(p[0], -p[1], p[2]);
      }
      return result;
    };

    // Lines are left out when they would cover so much of the surface that the colors are falsified.
    const double line_width = factor * 0.06 * font_size;
    double area = 0, length = 0;
    for(const std::array<int, 3>& t : view.triangles) {
      const Eigen::Matrix3d c = corners(t);
      area += (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0)).norm() / 2;
      length += ((c.col(1) - c.col(0)).norm() + (c.col(2) - c.col(1)).norm() + (c.col(0) - c.col(2)).norm()) / 2;
    }
    const bool has_lines = length * line_width < 0.3 * area;
    for(std::size_t i = 0; i < view.triangles.size(); ++i) {
      const double light = brightness(m_axes * area_vector(view, view.triangles[i]).normalized());
      Rgb shaded = color(view, i);
      for(double& c : shaded)
        c *= light;
      raster.draw(corners(view.triangles[i]), shaded, has_lines ? line_width : 0.);
    }
    raster.paint(context, left, top, factor);
  }

  // `alignment` is the part of the text to the left of x.
  static void show_text(cairo_t* context, double x, double y, double font_size, const std::string& text, double alignment)
  {
    cairo_text_extents_t extents;
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, font_size);
    cairo_text_extents(context, text.c_str(), &extents);
    cairo_set_source_rgb(context, 0.11, 0.12, 0.17);
    cairo_move_to(context, x - alignment * extents.x_advance, y);
    cairo_show_text(context, text.c_str());
  }

  void draw_legend(cairo_t* context, double x, double top, double height, double f) const
  {
    show_text(context, x, top + f, f, printable_text(m_options.label.substr(0, 100)), 0.);
    const double bar_top = top + 2.2 * f, bar_bottom = top + (std::min)(height - 0.5 * f, 26 * f), bar_width = 1.5 * f;
    Cairo_pattern gradient(cairo_pattern_create_linear(0, bar_bottom, 0, bar_top));
    const int stops = 32;
    for(int i = 0; i <= stops; ++i) {
      const Rgb c = distortion_color(i / double(stops));
      cairo_pattern_add_color_stop_rgb(gradient.get(), i / double(stops), c[0], c[1], c[2]);
    }
    cairo_rectangle(context, x, bar_top, bar_width, bar_bottom - bar_top);
    cairo_set_source(context, gradient.get());
    cairo_fill(context);

    std::vector<double> ticks = tick_values(m_upper);
    ticks.push_back(m_upper);
    std::reverse(ticks.begin(), ticks.end());
    double previous = -std::numeric_limits<double>::infinity();
    for(const double value : ticks) {
      const double y = bar_bottom - (bar_bottom - bar_top) * std::log(value) / std::log(m_upper);
      if(y < previous + 1.5 * f)
        continue;
      show_text(context, x + bar_width + 0.5 * f, y + 0.36 * f, f, number_text(value), 0.);
      previous = y;
    }
  }

  const std::vector<Solid_view>& m_views;
  const Surface_picture_options& m_options;
  Eigen::Matrix3d m_axes = Eigen::Matrix3d::Identity();
  double m_upper = 1.05;
  bool m_has_values = false;
};

#endif

} // namespace internal

/*!
  writes a picture of one or more surfaces in space, side by side ("before" and "after"), as a PNG image: flat shaded triangles in
  orthographic projection, colored by their values on a logarithmic scale from pale (1) to deep colors. Values above the
  upper end, infinite and undefined ones take the last color. All views have the same direction and the same scales of lengths and
  of colors. The edges of the triangles are drawn where they cover a small part of the surface.

  \param path name of the file; an existing file is replaced
  \param views the surfaces, from left to right
  \param options settings of the picture
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `false` if the views or the options are invalid (no triangle, differing sizes, an index out of range,
           a coordinate that is not finite), if the file cannot be written, or always, with the message "built without Cairo",
           unless the macro `CGAL_FLIP_FREE_MAPS_USE_CAIRO` is defined.
           The cost is linear in the number of triangles and of pixels that they cover.
*/
inline bool write_surface_PNG(const std::string& path, const std::vector<Solid_view>& views,
                              const Surface_picture_options& options = Surface_picture_options(), std::string* message = nullptr)
{
#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO
  internal::Surface_picture picture(views, options);
  const std::string error = picture.analyze();
  if(!error.empty())
    return internal::fail(message, "cannot draw " + path + ": " + error);
  internal::Cairo_surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, options.width, options.height));
  internal::Cairo_context context(cairo_create(surface.get()));
  picture.draw(context.get());
  return internal::write_image_as_PNG(path, surface.get(), context, message);
#else
  static_cast<void>(views);
  static_cast<void>(options);
  return internal::fail_without_cairo(path, message);
#endif
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_PICTURES_SURFACE_PICTURE_H
