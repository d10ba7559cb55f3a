// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_PICTURES_SURFACE_PAINTER_H
#define FLIP_FREE_MAPS_PROGRAM_PICTURES_SURFACE_PAINTER_H

#include "Layout_painter.h"
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Rows of the rotation to the axes of the picture: right, up, and towards the viewer.
inline Eigen::Matrix3d view_axes(const Eigen::Vector3d& direction, const Eigen::Vector3d& up)
{
  const Eigen::Vector3d toward = direction.normalized();
  Eigen::Vector3d right = up.cross(toward);
  if(!(right.norm() > 1e-6 * up.norm()))
    right = toward.unitOrthogonal();
  right.normalize();
  Eigen::Matrix3d axes;
  axes << right.transpose(), toward.cross(right).transpose(), toward.transpose();
  return axes;
}

// From a little above, and so many degrees beside an axis that is level. `up` has length 1.
inline Eigen::Vector3d direction_from_above(const Eigen::Vector3d& up, double degrees)
{
  const Eigen::Vector3d x = std::abs(up[0]) < 0.9 ? (Eigen::Vector3d::UnitX() - up * up[0]).normalized() : up.unitOrthogonal();
  const double angle = degrees * 3.14159265358979323846 / 180;
  return std::cos(angle) * x + std::sin(angle) * x.cross(up) + 0.3 * up;
}

// The light on a triangle with this normal in the axes of the picture. Both sides are lit alike: the orientation of the triangles is
// the user's choice.
inline double brightness(const Eigen::Vector3d& normal)
{
  const Eigen::Vector3d light = Eigen::Vector3d(-0.35, 0.5, 0.8).normalized();
  return (std::max)(0.25, 0.68 + 0.32 * (normal[2] < 0 ? -1 : 1) * normal.dot(light));
}

// Draws shaded triangles into an image with a depth buffer, by orthographic projection.
class Surface_raster
{
public:
  Surface_raster(int columns, int rows)
    : m_columns(columns),
      m_rows(rows),
      m_color(std::size_t(columns) * rows, 0xFFFFFF),
      m_depth(std::size_t(columns) * rows, -std::numeric_limits<float>::infinity())
  {}

  // Corners in pixels, x to the right, y downwards, z towards the viewer; edges are darkened over `line_width` pixels.
  void draw(const Eigen::Matrix3d& corners, const Rgb& color, double line_width)
  {
    const Rgb line{{0.62 * color[0], 0.62 * color[1], 0.62 * color[2]}};
    draw(corners,
         [&](const Eigen::Vector3d&, const Eigen::Vector3d& distances) { return distances.minCoeff() < line_width / 2 ? line : color; });
  }

  // The same; `color_at(weights, distances)` is the color of the point with these barycentric coordinates, that far from the three
  // edges, each opposite to its corner.
  template <typename ColorAt>
  void draw(const Eigen::Matrix3d& corners, const ColorAt& color_at)
  {
    const Eigen::Vector2d a = corners.col(0).head<2>(), b = corners.col(1).head<2>(), c = corners.col(2).head<2>();
    const double doubled_area = cross(b - a, c - a);
    if(!(std::abs(doubled_area) > 0))
      return;
    const Eigen::Vector2d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const int first_column = (std::max)(0, static_cast<int>(std::floor(low[0] - 0.5)));
    const int last_column = (std::min)(m_columns - 1, static_cast<int>(std::ceil(high[0] - 0.5)));
    const int first_row = (std::max)(0, static_cast<int>(std::floor(low[1] - 0.5)));
    const int last_row = (std::min)(m_rows - 1, static_cast<int>(std::ceil(high[1] - 0.5)));
    // A barycentric coordinate times these is the distance to an edge.
    const Eigen::Vector3d heights = std::abs(doubled_area) * Eigen::Vector3d((c - b).norm(), (a - c).norm(), (b - a).norm()).cwiseInverse();
    for(int j = first_row; j <= last_row; ++j) {
      for(int i = first_column; i <= last_column; ++i) {
        const Eigen::Vector2d p(i + 0.5, j + 0.5);
        const Eigen::Vector3d w = Eigen::Vector3d(cross(c - b, p - b), cross(a - c, p - c), cross(b - a, p - a)) / doubled_area;
        // The tolerance leaves no holes between neighbors.
        if(!(w.minCoeff() >= -1e-6))
          continue;
        const float depth = static_cast<float>(corners.row(2).dot(w));
        const std::size_t pixel = std::size_t(j) * m_columns + i;
        if(!(depth > m_depth[pixel]))
          continue;
        m_depth[pixel] = depth;
        m_color[pixel] = packed(color_at(w, heights.cwiseProduct(w)));
      }
    }
  }

  // Paints the image, scaled down by `factor`, with its upper left corner at (x, y).
  void paint(cairo_t* context, double x, double y, int factor)
  {
    const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_RGB24, m_columns);
    std::vector<unsigned char> bytes(std::size_t(stride) * m_rows);
    for(int j = 0; j < m_rows; ++j)
      std::copy_n(reinterpret_cast<const unsigned char*>(&m_color[std::size_t(j) * m_columns]), 4 * std::size_t(m_columns),
                  &bytes[std::size_t(j) * stride]);
    Cairo_surface image(cairo_image_surface_create_for_data(bytes.data(), CAIRO_FORMAT_RGB24, m_columns, m_rows, stride));
    cairo_save(context);
    cairo_translate(context, x, y);
    cairo_scale(context, 1. / factor, 1. / factor);
    cairo_set_source_surface(context, image.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_GOOD);
    cairo_paint(context);
    // The bytes end before the context does.
    cairo_set_source_rgb(context, 0, 0, 0);
    cairo_restore(context);
    cairo_surface_finish(image.get());
  }

private:
  static double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a[0] * b[1] - a[1] * b[0]; }

  static std::uint32_t packed(const Rgb& color)
  {
    std::uint32_t result = 0;
    for(const double c : color)
      result = (result << 8) | static_cast<std::uint32_t>(std::lround(255 * (std::min)(1., (std::max)(0., c))));
    return result;
  }

  int m_columns;
  int m_rows;
  std::vector<std::uint32_t> m_color;
  std::vector<float> m_depth;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_PICTURES_SURFACE_PAINTER_H
