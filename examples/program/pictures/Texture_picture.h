// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_PICTURES_TEXTURE_PICTURE_H
#define FLIP_FREE_MAPS_PROGRAM_PICTURES_TEXTURE_PICTURE_H

#include "Layout_picture.h"
#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>

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
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/*!
  Settings of `write_textured_surface_PNG()`.
*/
struct Texture_picture_options
{
  /// Width of the picture in pixels, from 320 to 16000.
  int width = 1600;

  /// Number of squares of the checkerboard along the longer side of the texture's box, at least 1.
  int squares = 40;

  /// Direction that points upwards on the picture.
  std::array<double, 3> up = {{0, 1, 0}};
};

namespace internal {

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO

// Draws a surface from four sides with a checkerboard as its texture.
class Texture_picture
{
public:
  Texture_picture(const Textured_mesh& mesh, const Texture_picture_options& options) : m_mesh(mesh), m_options(options) {}

  // Returns the empty string, or what is wrong with the mesh or the options.
  std::string analyze()
  {
    if(m_options.width < 320 || m_options.width > 16000)
      return "the width of the picture must be from 320 to 16000";
    const Eigen::Vector3d up(m_options.up.data());
    if(m_options.squares < 1 || !up.allFinite() || !(up.norm() > 0))
      return "there must be a square, and the direction of up must be finite and not zero";
    if(m_mesh.triangles.empty())
      return "there is no triangle";
    if(m_mesh.triangles.size() != m_mesh.texture_triangles.size())
      return "the number of triangles is not that of their images";
    for(std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
      if(!is_finite(m_mesh.points, m_mesh.triangles[i]) || !is_finite(m_mesh.texture, m_mesh.texture_triangles[i]))
        return "triangle " + std::to_string(i) + " has an index out of range, or a coordinate that is not finite, or too large";
    find_square();
    find_seams();
    find_views(up.normalized());
    return std::string();
  }

  int width() const { return m_options.width; }
  int height() const { return m_options.width * 3 / 4; }

  void draw(cairo_t* context) const
  {
    cairo_set_source_rgb(context, 1, 1, 1);
    cairo_paint(context);
    // As large as the views fit side by side, or in two rows.
    double best = -1;
    int best_columns = 4;
    for(const int columns : {4, 2}) {
      const double scale = scale_in(width() / columns, height() * columns / 4);
      if(scale > best) {
        best = scale;
        best_columns = columns;
      }
    }
    const int cell_width = width() / best_columns, cell_height = height() * best_columns / 4;
    for(int i = 0; i < 4; ++i)
      draw_view(context, m_views[i], best, (i % best_columns) * cell_width, (i / best_columns) * cell_height, cell_width, cell_height);
  }

private:
  struct View
  {
    Eigen::Matrix3d axes; // rows: right, up, towards the viewer
    Eigen::Vector3d low, high;
  };

  template <typename Points>
  static bool is_finite(const Points& points, const std::array<int, 3>& triangle)
  {
    for(const int index : triangle) {
      if(index < 0 || std::size_t(index) >= points.size())
        return false;
      for(const double coordinate : points[index])
        if(!(std::abs(coordinate) < 1e150))
          return false;
    }
    return true;
  }

  Eigen::Vector3d point(std::size_t i, int k) const { return Eigen::Vector3d(m_mesh.points[m_mesh.triangles[i][k]].data()); }

  Eigen::Vector2d image(std::size_t i, int k) const { return Eigen::Vector2d(m_mesh.texture[m_mesh.texture_triangles[i][k]].data()); }

  void find_square()
  {
    Eigen::Vector2d low = image(0, 0), high = low;
    for(std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
      for(int k = 0; k < 3; ++k) {
        low = low.cwiseMin(image(i, k));
        high = high.cwiseMax(image(i, k));
      }
    m_origin = low;
    m_square = (high - low).maxCoeff() / m_options.squares;
  }

  // An edge is no seam where two triangles share its ends and their images.
  void find_seams()
  {
    struct Side
    {
      std::array<int, 4> ends; // smaller and larger index into `points`, and their indices into `texture`
      std::size_t triangle;
      int corner; // opposite
    };
    std::vector<Side> sides;
    for(std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
      for(int k = 0; k < 3; ++k) {
        int from = (k + 1) % 3, to = (k + 2) % 3;
        const auto& t = m_mesh.triangles[i];
        if(t[to] < t[from])
          std::swap(from, to);
        sides.push_back({{{t[from], t[to], m_mesh.texture_triangles[i][from], m_mesh.texture_triangles[i][to]}}, i, k});
      }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.ends < b.ends; });
    m_is_seam.assign(m_mesh.triangles.size(), {{false, false, false}});
    for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while(end < sides.size() && sides[end].ends == sides[begin].ends)
        ++end;
      if(end - begin == 1)
        m_is_seam[sides[begin].triangle][sides[begin].corner] = true;
    }
  }

  // From a little above, and 30 degrees beside the axes, so that boxes show three sides.
  void find_views(const Eigen::Vector3d& up)
  {
    for(int i = 0; i < 4; ++i) {
      View& view = m_views[i];
      view.axes = view_axes(direction_from_above(up, 60 - 90 * i), up);
      view.low = view.high = view.axes * point(0, 0);
      for(std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
        for(int k = 0; k < 3; ++k) {
          const Eigen::Vector3d p = view.axes * point(t, k);
          view.low = view.low.cwiseMin(p);
          view.high = view.high.cwiseMax(p);
        }
    }
  }

  double scale_in(int cell_width, int cell_height) const
  {
    double extents[2] = {0, 0};
    for(const View& view : m_views)
      for(int c = 0; c < 2; ++c)
        extents[c] = (std::max)(extents[c], view.high[c] - view.low[c]);
    const double inverse = (std::max)(extents[0] / cell_width, extents[1] / cell_height);
    return inverse > 0 ? 0.94 / inverse : 0;
  }

  void draw_view(cairo_t* context, const View& view, double scale, int left, int top, int cell_width, int cell_height) const
  {
    const int factor = 3;
    Surface_raster raster(factor * cell_width, factor * cell_height);
    const Eigen::Vector3d middle(factor * cell_width / 2., factor * cell_height / 2., 0), center = (view.low + view.high) / 2;
    const double seam_width = factor * (std::max)(2., m_options.width / 500.);
    for(std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
      Eigen::Matrix3d corners;
      for(int k = 0; k < 3; ++k) {
        const Eigen::Vector3d p = factor * scale * (view.axes * point(i, k) - center);
        corners.col(k) = middle + Eigen::Vector3d(p[0], -p[1], p[2]);
      }
      const double light = brightness(view.axes * (point(i, 1) - point(i, 0)).cross(point(i, 2) - point(i, 0)).normalized());
      const Eigen::Vector2d a = image(i, 0), b = image(i, 1) - a, c = image(i, 2) - a;
      const bool is_flipped = !(b[0] * c[1] - b[1] * c[0] > 0);
      const std::array<bool, 3>& is_seam = m_is_seam[i];
      raster.draw(corners, [&](const Eigen::Vector3d& w, const Eigen::Vector3d& distances) {
        for(int k = 0; k < 3; ++k)
          if(is_seam[k] && distances[k] < seam_width / 2)
            return Rgb{{0.78, 0.10, 0.08}};
        Rgb color = is_flipped ? Rgb{{1, 0, 1}} : square_color(a + w[1] * b + w[2] * c);
        for(double& channel : color)
          channel *= light;
        return color;
      });
    }
    raster.paint(context, left, top, factor);
  }

  Rgb square_color(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d q = (p - m_origin) / m_square;
    return std::fmod(std::floor(q[0]) + std::floor(q[1]), 2.) == 0. ? Rgb{{0.96, 0.95, 0.91}} : Rgb{{0.36, 0.50, 0.64}};
  }

  const Textured_mesh& m_mesh;
  const Texture_picture_options& m_options;
  Eigen::Vector2d m_origin = Eigen::Vector2d::Zero();
  double m_square = 1;
  std::vector<std::array<bool, 3>> m_is_seam; // of each triangle, the edges opposite to its corners
  std::array<View, 4> m_views;
};

#endif

} // namespace internal

/*!
  writes a picture of a surface from four sides, with a checkerboard as its texture and its seams and borders in red, as a PNG image.
  Where all squares are squares of one size, the map has no distortion. Triangles whose image is not positive are drawn in magenta.

  \param path name of the file; an existing file is replaced
  \param mesh the surface and its map
  \param options settings of the picture
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `false` if the mesh or the options are invalid (no triangle, an index out of range, a coordinate that is not finite), if the
           file cannot be written, or always, with the message "built without Cairo", unless the macro
           `CGAL_FLIP_FREE_MAPS_USE_CAIRO` is defined.
           The cost is that of sorting the edges, and linear in the number of pixels that the triangles cover.
*/
inline bool write_textured_surface_PNG(const std::string& path, const Textured_mesh& mesh,
                                       const Texture_picture_options& options = Texture_picture_options(), std::string* message = nullptr)
{
#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO
  internal::Texture_picture picture(mesh, options);
  const std::string error = picture.analyze();
  if(!error.empty())
    return internal::fail(message, "cannot draw " + path + ": " + error);
  internal::Cairo_surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width(), picture.height()));
  internal::Cairo_context context(cairo_create(surface.get()));
  picture.draw(context.get());
  return internal::write_image_as_PNG(path, surface.get(), context, message);
#else
  static_cast<void>(mesh);
  static_cast<void>(options);
  return internal::fail_without_cairo(path, message);
#endif
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_PICTURES_TEXTURE_PICTURE_H
