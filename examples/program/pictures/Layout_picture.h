// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_PICTURES_LAYOUT_PICTURE_H
#define FLIP_FREE_MAPS_PROGRAM_PICTURES_LAYOUT_PICTURE_H

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO
#include "Layout_painter.h"

#include <cairo-svg.h>
#include <cairo.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/*!
  Settings of `write_layout_SVG()` and `write_layout_PNG()`.
*/
struct Layout_picture_options
{
  /// Width of the picture in pixels (SVG: in points), from 320 to 16000.
  int width = 1600;

  /// Height of the picture in the same units, from 240 to 16000, or 0 for one between 0.35 and 1.25 times the width that suits
  /// the layout.
  int height = 0;

  /// Text in UTF-8 above the layout; no room is reserved when it is empty.
  std::string title;

  /// Text in UTF-8 above the color bar, to tell the distortion measure.
  std::string distortion_label = "distortion";

  /// Distortion of the deepest color, finite and at least 1.01, to compare several pictures on one scale; 0 for the 98th
  /// percentile of the finite distortions, at least 1.05.
  double distortion_upper_end = 0.;

  /// The edges of the triangles are drawn only up to this number of triangles, and only if they cover a small part of the
  /// layout on the picture.
  std::size_t max_triangles_with_lines = 20000;

  /// Color (red, green, blue) of flipped triangles.
  std::array<unsigned char, 3> warning_color = {{255, 0, 255}};
};

namespace internal {

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO

// Returns the empty string, or what is wrong with the options.
inline std::string layout_picture_options_error(const Layout_picture_options& options)
{
  if(options.width < 320 || options.width > 16000)
    return "the width of the picture must be from 320 to 16000";
  if(options.height != 0 && (options.height < 240 || options.height > 16000))
    return "the height of the picture must be 0 or from 240 to 16000";
  if(options.distortion_upper_end != 0. && !(std::isfinite(options.distortion_upper_end) && options.distortion_upper_end >= 1.01))
    return "the upper end of the distortion must be 0, or finite and at least 1.01";
  return std::string();
}

inline bool write_picture(const std::string& path, const std::string& content, cairo_status_t status, std::string* message)
{
  if(status != CAIRO_STATUS_SUCCESS)
    return fail(message, "cannot draw " + path + ": " + cairo_status_to_string(status));
  return write_whole_file(path, content, message);
}

// Ends a drawing with `context` on an image.
inline bool write_image_as_PNG(const std::string& path, cairo_surface_t* surface, Cairo_context& context, std::string* message)
{
  std::string content;
  cairo_status_t status = cairo_status(context.get());
  context.reset();
  if(status == CAIRO_STATUS_SUCCESS)
    status = cairo_surface_write_to_png_stream(surface, &append_to_string, &content);
  return write_picture(path, content, status, message);
}

inline bool write_layout(const std::string& path, const std::vector<std::array<double, 2>>& uv,
                         const std::vector<std::array<int, 3>>& triangles, const std::vector<double>& distortion,
                         const Layout_picture_options& options, bool is_SVG, std::string* message)
{
  Layout_painter painter(uv, triangles, distortion);
  std::string error = layout_picture_options_error(options);
  if(error.empty())
    error = painter.analyze(options.distortion_upper_end);
  if(!error.empty())
    return fail(message, "cannot draw " + path + ": " + error);
  painter.set_title(options.title);
  painter.set_label(options.distortion_label);
  painter.set_warning_color(options.warning_color);
  painter.arrange(options.width, options.height);

  const std::size_t max_vector_triangles = 100000;
  std::string content;
  Cairo_surface surface(is_SVG ? cairo_svg_surface_create_for_stream(&append_to_string, &content, painter.width(), painter.height())
                               : cairo_image_surface_create(CAIRO_FORMAT_RGB24, painter.width(), painter.height()));
  Cairo_context context(cairo_create(surface.get()));
  painter.draw(context.get(), !is_SVG || triangles.size() > max_vector_triangles, options.max_triangles_with_lines);
  if(!is_SVG)
    return write_image_as_PNG(path, surface.get(), context, message);

  cairo_status_t status = cairo_status(context.get());
  context.reset();
  cairo_surface_finish(surface.get());
  if(status == CAIRO_STATUS_SUCCESS)
    status = cairo_surface_status(surface.get());
  return write_picture(path, content, status, message);
}

#else

inline bool fail_without_cairo(const std::string& path, std::string* message)
{
  return fail(message, "cannot draw " + path + ": built without Cairo");
}

inline bool write_layout(const std::string& path, const std::vector<std::array<double, 2>>&, const std::vector<std::array<int, 3>>&,
                         const std::vector<double>&, const Layout_picture_options&, bool, std::string* message)
{
  return fail_without_cairo(path, message);
}

#endif

} // namespace internal

/*!
  writes a picture of a planar layout, colored by distortion, as an SVG file.

  The triangles are filled from pale (distortion 1) to deep colors on a logarithmic scale with uniform perceptual steps; values
  above the upper end, infinite and undefined ones take the last color. Triangles of negative orientation, decided with exact
  predicates, are drawn last, in the warning color, and outlined so that also those smaller than a pixel are seen. The border of
  the layout (edges with one incident triangle) is a thick dark line. The legend gives the color bar, the maximum of the
  distortion, and the numbers of triangles, of flipped ones, and of degenerate ones if there are any.
  The v axis points upwards, and u and v have the same scale.

  Above 100000 triangles the fills are embedded as an image, so that the file remains small enough to be edited and printed.

  \param path name of the file; an existing file is replaced
  \param uv points of the layout in any unit
  \param triangles corners of the triangles, as indices into `uv`
  \param distortion one value per triangle, not less than 1 (smaller values are drawn as 1)
  \param options settings of the picture
  \param message if not null, receives the reason of a failure, and the empty string on success

  \returns `false` if the arrays or the options are invalid (no triangle, differing sizes, an index out of range, a coordinate
           that is not finite), if the file cannot be written, or always, with the message "built without Cairo", unless the
           macro `CGAL_FLIP_FREE_MAPS_USE_CAIRO` is defined. The cost is \f$ O(n \log n) \f$ for \f$ n \f$ triangles.
*/
inline bool write_layout_SVG(const std::string& path, const std::vector<std::array<double, 2>>& uv,
                             const std::vector<std::array<int, 3>>& triangles, const std::vector<double>& distortion,
                             const Layout_picture_options& options = Layout_picture_options(), std::string* message = nullptr)
{
  return internal::write_layout(path, uv, triangles, distortion, options, true, message);
}

/*!
  writes a picture of a planar layout, colored by distortion, as a PNG image; content and parameters are those of
  `write_layout_SVG()`.
*/
inline bool write_layout_PNG(const std::string& path, const std::vector<std::array<double, 2>>& uv,
                             const std::vector<std::array<int, 3>>& triangles, const std::vector<double>& distortion,
                             const Layout_picture_options& options = Layout_picture_options(), std::string* message = nullptr)
{
  return internal::write_layout(path, uv, triangles, distortion, options, false, message);
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_PICTURES_LAYOUT_PICTURE_H
