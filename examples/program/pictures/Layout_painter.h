// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_PICTURES_LAYOUT_PAINTER_H
#define FLIP_FREE_MAPS_PROGRAM_PICTURES_LAYOUT_PAINTER_H

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

struct Cairo_deleter
{
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};

typedef std::unique_ptr<cairo_t, Cairo_deleter> Cairo_context;
typedef std::unique_ptr<cairo_surface_t, Cairo_deleter> Cairo_surface;
typedef std::unique_ptr<cairo_pattern_t, Cairo_deleter> Cairo_pattern;

// Receives the bytes of a picture; no exception may pass through the C library.
inline cairo_status_t append_to_string(void* target, const unsigned char* data, unsigned int length)
{
  try {
    static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
  } catch(const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

typedef std::array<double, 3> Rgb;

inline void set_color(cairo_t* context, const Rgb& color) { cairo_set_source_rgb(context, color[0], color[1], color[2]); }

// Pale yellow at 0, over green and blue, to dark violet blue at 1. Lightness falls linearly in the Oklab color space
// (B. Ottosson, "A perceptual color space for image processing", 2020), so that equal steps look equal, also in print.
// The chroma stays within what sRGB can show, and the hues away from the magenta of flipped triangles.
inline Rgb distortion_color(double t)
{
  const double pi = 3.14159265358979323846;
  const double lightness = 0.975 - 0.675 * t;
  const double hue = (108. + 172. * t) * pi / 180.;
  const double chroma = 0.035 + 0.05 * t + 0.35 * t * (1. - t) * (1. - t);
  const double a = chroma * std::cos(hue);
  const double b = chroma * std::sin(hue);

  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const Rgb linear = {{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                       -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s}};
  Rgb color;
  for(int i = 0; i < 3; ++i) {
    const double c = (std::min)(1., (std::max)(0., linear[i]));
    color[i] = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1. / 2.4) - 0.055;
  }
  return color;
}

// Text for the picture: control characters become spaces, and bytes that are no UTF-8 question marks, since one of them would
// put the whole drawing into an error state.
inline std::string printable_text(const std::string& text)
{
  std::string result;
  for(std::size_t i = 0; i < text.size();) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    const std::size_t length = c < 0x80 ? 1 : c < 0xC2 ? 0 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : c < 0xF5 ? 4 : 0;
    bool is_valid = length > 0 && i + length <= text.size();
    std::uint32_t code = length < 2 ? c : c & (0x7Fu >> length);
    for(std::size_t k = 1; is_valid && k < length; ++k) {
      const unsigned char next = static_cast<unsigned char>(text[i + k]);
      is_valid = (next & 0xC0) == 0x80;
      code = (code << 6) | (next & 0x3Fu);
    }
    is_valid = is_valid && !(length == 3 && (code < 0x800 || (code >= 0xD800 && code < 0xE000))) &&
               !(length == 4 && (code < 0x10000 || code > 0x10FFFF));
    if(!is_valid) {
      result += '?';
      ++i;
    } else if(code < 0x20 || code == 0x7F) {
      result += ' ';
      ++i;
    } else {
      result.append(text, i, length);
      i += length;
    }
  }
  return result;
}

inline std::string number_text(double value)
{
  if(!std::isfinite(value))
    return std::isnan(value) ? "undefined" : "infinite";
  const bool is_long = std::abs(value) >= 1e5;
  std::string text;
  append_number(text, value, is_long ? 3 : 4);
  const std::size_t exponent = text.find("e+");
  if(exponent != std::string::npos)
    text.erase(exponent + 1, text[exponent + 2] == '0' ? 2 : 1);
  return text;
}

// Digits in groups of three.
inline std::string count_text(std::size_t count)
{
  std::string text = std::to_string(count);
  for(std::size_t i = text.size(); i > 3;) {
    i -= 3;
    text.insert(i, 1, ' ');
  }
  return text;
}

// Values for the ticks of a logarithmic color bar from 1 to `upper`: equally spaced round values when the bar covers less than
// a factor of 4, else 1, 2, 5, 10, ..., and only some powers of ten when there would be too many of these.
inline std::vector<double> tick_values(double upper)
{
  std::vector<double> ticks;
  if(upper < 4.) {
    const double rough = (upper - 1.) / 8.;
    const double power = std::pow(10., std::floor(std::log10(rough)));
    const double ratio = rough / power;
    const double step = power * (ratio <= 1. ? 1. : ratio <= 2. ? 2. : ratio <= 5. ? 5. : 10.);
    for(int i = 0; 1. + i * step <= upper; ++i)
      ticks.push_back(1. + i * step);
  } else {
    const double decades = std::log10(upper);
    const int stride = (std::max)(1, static_cast<int>(std::ceil(decades / 8.)));
    for(int d = 0; d <= decades; d += stride) {
      for(const double factor : {1., 2., 5.}) {
        const double value = factor * std::pow(10., d);
        if(value <= upper && (factor == 1. || decades <= 4.))
          ticks.push_back(value);
      }
    }
  }
  return ticks;
}

/*
  Draws a layout on any surface. The members are computed by `analyze()`, the sizes by `arrange()`, and `draw()` serves vector
  and image surfaces alike.
*/
class Layout_painter
{
public:
  typedef std::array<double, 2> Point;
  typedef std::array<int, 3> Triangle;

  // The three arrays must outlive the painter.
  Layout_painter(const std::vector<Point>& uv, const std::vector<Triangle>& triangles, const std::vector<double>& distortion)
    : m_uv(uv), m_triangles(triangles), m_distortion(distortion)
  {}

  // Returns the empty string, or what is wrong with the arrays. An upper end of 0 asks for the automatic one.
  std::string analyze(double upper_end)
  {
    if(m_triangles.empty())
      return "the layout has no triangle";
    if(m_distortion.size() != m_triangles.size())
      return "the number of distortions is not the number of triangles";

    Point upper;
    m_lower.fill((std::numeric_limits<double>::max)());
    upper.fill(std::numeric_limits<double>::lowest());
    for(std::size_t i = 0; i < m_triangles.size(); ++i) {
      for(const int index : m_triangles[i]) {
        if(index < 0 || std::size_t(index) >= m_uv.size())
          return "triangle " + std::to_string(i) + " has an index out of range";
        for(int c = 0; c < 2; ++c) {
          if(!std::isfinite(m_uv[index][c]))
            return "triangle " + std::to_string(i) + " has a coordinate that is not finite";
          m_lower[c] = (std::min)(m_lower[c], m_uv[index][c]);
          upper[c] = (std::max)(upper[c], m_uv[index][c]);
        }
      }
    }
    m_extent = (std::max)(upper[0] - m_lower[0], upper[1] - m_lower[1]);
    if(!std::isfinite(m_extent))
      return "the layout is too large for double precision numbers";
    for(int c = 0; c < 2; ++c)
      m_ratio[c] = m_extent > 0. ? (upper[c] - m_lower[c]) / m_extent : 0.;

    classify_triangles();
    choose_color_scale(upper_end);
    find_edges();
    return std::string();
  }

  // Lays out the picture; a height of 0 asks for one that suits the layout.
  void arrange(int width, int height)
  {
    m_width = width;
    m_font_size = (std::max)(10., width / 76.);
    if(height > 0)
      m_font_size = (std::max)(8., (std::min)(m_font_size, height / 24.));
    m_margin = 1.6 * m_font_size;
    m_legend_width = 11. * m_font_size;
    m_plot_x = m_margin;
    m_plot_y = m_margin + (m_title.empty() ? 0. : 2.4 * m_font_size);
    m_plot_width = width - 2. * m_margin - m_legend_width - 1.5 * m_font_size;

    const double ratio = m_ratio[0] > 0. ? m_ratio[1] / m_ratio[0] : std::numeric_limits<double>::infinity();
    const double wanted = m_plot_y + m_margin + (std::min)(m_plot_width * ratio, 10. * width);
    const double least = (std::max)(0.35 * width, 24. * m_font_size);
    m_height = height > 0 ? height : static_cast<int>(std::ceil((std::min)((std::max)(wanted, least), 1.25 * width)));
    m_plot_height = m_height - m_plot_y - m_margin;

    const double tiny = (std::numeric_limits<double>::min)();
    m_scale = (std::min)(m_plot_width / (std::max)(m_ratio[0], tiny), m_plot_height / (std::max)(m_ratio[1], tiny));
    if(m_extent == 0.)
      m_scale = 0.;
    m_origin[0] = m_plot_x + (m_plot_width - m_scale * m_ratio[0]) / 2.;
    m_origin[1] = m_plot_y + (m_plot_height + m_scale * m_ratio[1]) / 2.;
  }

  // No picture has room for more than the first few hundred characters.
  void set_title(const std::string& title) { m_title = printable_text(title.substr(0, 500)); }
  void set_label(const std::string& label) { m_label = printable_text(label.substr(0, 500)); }

  void set_warning_color(const std::array<unsigned char, 3>& color)
  {
    for(int i = 0; i < 3; ++i)
      m_warning_color[i] = color[i] / 255.;
  }

  int width() const { return m_width; }
  int height() const { return m_height; }

  // With `use_raster` the fills go through an image of twice the resolution, drawn without antialiasing: neighboring triangles
  // then share their boundary pixels exactly, and scaling the image down smooths it without hairlines between them.
  void draw(cairo_t* context, bool use_raster, std::size_t max_triangles_with_lines) const
  {
    cairo_set_source_rgb(context, 1, 1, 1);
    cairo_paint(context);

    // Lines and flipped triangles are vectors too, unless there are so many that a vector file would be unusable.
    const std::size_t max_vector_items = 100000;
    const bool is_border_in_raster = use_raster && m_border.size() > max_vector_items;
    const bool are_flips_in_raster = use_raster && m_flipped.size() > max_vector_items;
    if(use_raster) {
      const int factor = (std::max)(m_plot_width, m_plot_height) > 8000. ? 1 : 2;
      const double left = std::floor(m_plot_x - m_margin / 2.);
      const double top = std::floor(m_plot_y - m_margin / 2.);
      const int columns = static_cast<int>(std::ceil(m_plot_width + m_margin)) + 1;
      const int rows = static_cast<int>(std::ceil(m_plot_height + m_margin)) + 1;
      Cairo_surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns * factor, rows * factor));
      Cairo_context raster(cairo_create(image.get()));
      cairo_set_source_rgb(raster.get(), 1, 1, 1);
      cairo_paint(raster.get());
      cairo_scale(raster.get(), factor, factor);
      cairo_translate(raster.get(), -left, -top);
      cairo_set_antialias(raster.get(), CAIRO_ANTIALIAS_NONE);
      draw_fills(raster.get(), false);
      if(is_border_in_raster)
        draw_border(raster.get());
      if(are_flips_in_raster)
        draw_flips(raster.get());
      cairo_surface_flush(image.get());

      cairo_save(context);
      cairo_translate(context, left, top);
      cairo_scale(context, 1. / factor, 1. / factor);
      cairo_set_source_surface(context, image.get(), 0, 0);
      cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_GOOD);
      cairo_paint(context);
      cairo_restore(context);
    } else
      draw_fills(context, true);
    if(m_triangles.size() <= max_triangles_with_lines)
      draw_mesh_lines(context);
    if(!is_border_in_raster)
      draw_border(context);
    if(!are_flips_in_raster)
      draw_flips(context);
    draw_title(context);
    draw_legend(context);
  }

private:
  typedef std::pair<int, int> Edge;

  static constexpr int COLORS = 256;

  void classify_triangles()
  {
    typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;
    m_flipped.clear();
    m_number_of_degenerate_triangles = 0;
    for(std::size_t i = 0; i < m_triangles.size(); ++i) {
      Point_2 p[3];
      for(int k = 0; k < 3; ++k) {
        const Point& uv = m_uv[m_triangles[i][k]];
        p[k] = Point_2(uv[0], uv[1]);
      }
      const CGAL::Orientation orientation = CGAL::orientation(p[0], p[1], p[2]);
      if(orientation == CGAL::RIGHT_TURN)
        m_flipped.push_back(i);
      else if(orientation == CGAL::COLLINEAR)
        ++m_number_of_degenerate_triangles;
    }
  }

  // Infinite and undefined distortions (those of flipped triangles, under many definitions) take the last color and do not count
  // for the percentile.
  void choose_color_scale(double upper_end)
  {
    std::vector<double> finite;
    finite.reserve(m_distortion.size());
    m_maximum = 0.;
    for(const double d : m_distortion) {
      if(std::isfinite(d))
        finite.push_back(d);
      m_maximum = (d > m_maximum || std::isnan(d)) && !std::isnan(m_maximum) ? d : m_maximum;
    }

    m_upper = upper_end;
    if(!(m_upper > 1.)) {
      m_upper = 1.05;
      if(!finite.empty()) {
        const std::size_t rank = (finite.size() - 1) * 98 / 100;
        std::nth_element(finite.begin(), finite.begin() + rank, finite.end());
        m_upper = (std::max)(m_upper, finite[rank]);
      }
    }

    std::array<std::size_t, COLORS + 1> begin{};
    std::vector<unsigned char> color(m_distortion.size());
    for(std::size_t i = 0; i < m_distortion.size(); ++i) {
      const double d = m_distortion[i];
      const double t = !(d < m_upper) ? 1. : d <= 1. ? 0. : std::log(d) / std::log(m_upper);
      color[i] = static_cast<unsigned char>(std::lround(t * (COLORS - 1)));
      ++begin[color[i] + 1];
    }
    for(int c = 0; c < COLORS; ++c)
      begin[c + 1] += begin[c];
    m_color_begin = begin;
    m_by_color.resize(m_triangles.size());
    for(std::size_t i = 0; i < m_triangles.size(); ++i)
      m_by_color[begin[color[i]]++] = i;
  }

  void find_edges()
  {
    std::vector<Edge> edges;
    edges.reserve(3 * m_triangles.size());
    for(const Triangle& triangle : m_triangles)
      for(int k = 0; k < 3; ++k)
        edges.push_back(std::minmax({triangle[k], triangle[(k + 1) % 3]}));
    std::sort(edges.begin(), edges.end());
    m_border.clear();
    m_interior.clear();
    for(std::size_t i = 0; i < edges.size();) {
      std::size_t j = i + 1;
      while(j < edges.size() && edges[j] == edges[i])
        ++j;
      (j == i + 1 ? m_border : m_interior).push_back(edges[i]);
      i = j;
    }
  }

  // Position on the picture, y up. Dividing by the extent first keeps every layout in range, however small or large.
  Point position(int index) const
  {
    const Point& uv = m_uv[index];
    if(m_extent == 0.)
      return {{m_origin[0], m_origin[1]}};
    return {{m_origin[0] + m_scale * ((uv[0] - m_lower[0]) / m_extent), m_origin[1] - m_scale * ((uv[1] - m_lower[1]) / m_extent)}};
  }

  void add_triangle(cairo_t* context, std::size_t i) const
  {
    const Point a = position(m_triangles[i][0]);
    const Point b = position(m_triangles[i][1]);
    const Point c = position(m_triangles[i][2]);
    cairo_move_to(context, a[0], a[1]);
    cairo_line_to(context, b[0], b[1]);
    cairo_line_to(context, c[0], c[1]);
    cairo_close_path(context);
  }

  void add_edges(cairo_t* context, const std::vector<Edge>& edges) const
  {
    // The cost of a stroke grows faster than the length of its path.
    const std::size_t block = 256;
    for(std::size_t i = 0; i < edges.size(); ++i) {
      const Point a = position(edges[i].first);
      const Point b = position(edges[i].second);
      cairo_move_to(context, a[0], a[1]);
      cairo_line_to(context, b[0], b[1]);
      if((i + 1) % block == 0 || i + 1 == edges.size())
        cairo_stroke(context);
    }
  }

  // One path holds all triangles of a color, which keeps vector files small; in a raster small paths are faster.
  void draw_fills(cairo_t* context, bool is_vector) const
  {
    cairo_set_line_width(context, 0.03 * m_font_size);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    for(int c = 0; c < COLORS; ++c) {
      if(m_color_begin[c] == m_color_begin[c + 1])
        continue;
      set_color(context, distortion_color(c / double(COLORS - 1)));
      for(std::size_t i = m_color_begin[c]; i < m_color_begin[c + 1]; ++i) {
        add_triangle(context, m_by_color[i]);
        if(!is_vector)
          cairo_fill(context);
      }
      if(is_vector) {
        // A thin line of the same color covers the hairlines that a viewer leaves between antialiased neighbors.
        cairo_fill_preserve(context);
        cairo_stroke(context);
      }
    }
  }

  // The outline makes visible also those that are smaller than a pixel.
  void draw_flips(cairo_t* context) const
  {
    set_color(context, m_warning_color);
    cairo_set_line_width(context, 0.08 * m_font_size);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    for(const std::size_t i : m_flipped) {
      add_triangle(context, i);
      cairo_fill_preserve(context);
      cairo_stroke(context);
    }
  }

  // The lines are left out when they would cover so much of the layout that the colors are falsified.
  void draw_mesh_lines(cairo_t* context) const
  {
    double length = 0.;
    for(const Edge& edge : m_interior) {
      const Point a = position(edge.first);
      const Point b = position(edge.second);
      length += std::hypot(a[0] - b[0], a[1] - b[1]);
    }
    double area = 0.;
    for(const Triangle& triangle : m_triangles) {
      const Point a = position(triangle[0]);
      const Point b = position(triangle[1]);
      const Point c = position(triangle[2]);
      area += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.;
    }
    const double line_width = 0.03 * m_font_size;
    if(length * line_width > 0.2 * area)
      return;
    cairo_set_source_rgba(context, 0.1, 0.12, 0.2, 0.45);
    cairo_set_line_width(context, line_width);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
    add_edges(context, m_interior);
  }

  void draw_border(cairo_t* context) const
  {
    set_color(context, m_ink);
    cairo_set_line_width(context, 0.09 * m_font_size);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    add_edges(context, m_border);
  }

  // Reduces the font size, and then the text, until it fits.
  void show_text(cairo_t* context, double x, double y, double font_size, double max_width, std::string text) const
  {
    cairo_text_extents_t extents;
    cairo_set_font_size(context, font_size);
    cairo_text_extents(context, text.c_str(), &extents);
    if(extents.x_advance > max_width) {
      cairo_set_font_size(context, (std::max)(0.7, max_width / extents.x_advance) * font_size);
      cairo_text_extents(context, text.c_str(), &extents);
    }
    std::string shown = text;
    while(extents.x_advance > max_width && !text.empty()) {
      do
        text.pop_back();
      while(!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80) != 0 && !is_complete(text));
      shown = text + "...";
      cairo_text_extents(context, shown.c_str(), &extents);
    }
    cairo_move_to(context, x, y);
    cairo_show_text(context, shown.c_str());
  }

  // Whether the text, valid but for its end, does not end within a character.
  static bool is_complete(const std::string& text) { return printable_text(text) == text; }

  void draw_title(cairo_t* context) const
  {
    if(m_title.empty())
      return;
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
    set_color(context, m_ink);
    show_text(context, m_margin, m_margin + 1.0 * m_font_size, 1.3 * m_font_size, m_width - 2. * m_margin, m_title);
  }

  void draw_legend(cairo_t* context) const
  {
    const double f = m_font_size;
    const double x = m_width - m_margin - m_legend_width;
    double y = m_plot_y + f;
    cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    set_color(context, m_ink);
    show_text(context, x, y, f, m_legend_width, m_label);

    const double line_height = 1.55 * f;
    const int number_of_lines = m_number_of_degenerate_triangles > 0 ? 5 : 4;
    const double tip = 1.1 * f;
    const double bar_width = 1.5 * f;
    const double bar_top = y + 0.9 * f + tip;
    const double bar_bottom = (std::min)(bar_top + 24. * f, m_height - m_margin - number_of_lines * line_height - 0.6 * f);
    draw_color_bar(context, x, bar_width, bar_top, bar_bottom, tip);

    const double value_x = x + 6.2 * f;
    y = bar_bottom + 0.6 * f;
    const auto show_line = [&](const std::string& name, const std::string& value) {
      y += line_height;
      set_color(context, m_ink);
      show_text(context, x, y, f, value_x - x - 0.5 * f, name);
      show_text(context, value_x, y, f, x + m_legend_width - value_x, value);
    };
    show_line("maximum", number_text(m_maximum));
    show_line("triangles", count_text(m_triangles.size()));
    if(m_number_of_degenerate_triangles > 0)
      show_line("degenerate", count_text(m_number_of_degenerate_triangles));
    show_line("flipped", count_text(m_flipped.size()));
    if(!m_flipped.empty()) {
      cairo_rectangle(context, value_x - 1.2 * f, y - 0.74 * f, 0.74 * f, 0.74 * f);
      set_color(context, m_warning_color);
      cairo_fill(context);
    }
  }

  // The pointed end stands for all values above the upper end.
  void draw_color_bar(cairo_t* context, double x, double bar_width, double top, double bottom, double tip) const
  {
    const double f = m_font_size;
    const auto add_outline = [&]() {
      cairo_move_to(context, x, bottom);
      cairo_line_to(context, x, top);
      cairo_line_to(context, x + bar_width / 2., top - tip);
      cairo_line_to(context, x + bar_width, top);
      cairo_line_to(context, x + bar_width, bottom);
      cairo_close_path(context);
    };

    Cairo_pattern gradient(cairo_pattern_create_linear(0, bottom, 0, top));
    const int stops = 32;
    for(int i = 0; i <= stops; ++i) {
      const Rgb color = distortion_color(i / double(stops));
      cairo_pattern_add_color_stop_rgb(gradient.get(), i / double(stops), color[0], color[1], color[2]);
    }
    add_outline();
    cairo_set_source(context, gradient.get());
    cairo_fill(context);

    set_color(context, m_ink);
    cairo_set_line_width(context, 0.06 * f);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_MITER);
    add_outline();
    cairo_stroke(context);

    const auto draw_tick = [&](double y, const std::string& text) {
      cairo_move_to(context, x + bar_width, y);
      cairo_line_to(context, x + bar_width + 0.35 * f, y);
      cairo_stroke(context);
      show_text(context, x + bar_width + 0.7 * f, y + 0.36 * f, f, m_legend_width - bar_width - 0.7 * f, text);
    };
    const double spacing = 1.5 * f;
    draw_tick(top, number_text(m_upper));
    double previous = std::numeric_limits<double>::infinity();
    for(const double value : tick_values(m_upper)) {
      const double y = bottom - (bottom - top) * std::log(value) / std::log(m_upper);
      if(y > previous - spacing || y < top + spacing)
        continue;
      draw_tick(y, number_text(value));
      previous = y;
    }
  }

  const std::vector<Point>& m_uv;
  const std::vector<Triangle>& m_triangles;
  const std::vector<double>& m_distortion;

  std::string m_title;
  std::string m_label;
  Rgb m_warning_color{};
  const Rgb m_ink = {{0.11, 0.12, 0.17}};

  // what is drawn
  Point m_lower{};
  double m_extent = 0.;
  Point m_ratio{}; // sides of the bounding box, the larger one being 1
  std::vector<std::size_t> m_flipped;
  std::size_t m_number_of_degenerate_triangles = 0;
  double m_upper = 1.05;
  double m_maximum = 0.;
  std::vector<std::size_t> m_by_color; // the triangles, sorted by color
  std::array<std::size_t, COLORS + 1> m_color_begin{};
  std::vector<Edge> m_border;
  std::vector<Edge> m_interior;

  // where, in pixels
  int m_width = 0;
  int m_height = 0;
  double m_font_size = 0.;
  double m_margin = 0.;
  double m_legend_width = 0.;
  double m_plot_x = 0.;
  double m_plot_y = 0.;
  double m_plot_width = 0.;
  double m_plot_height = 0.;
  double m_scale = 0.;
  Point m_origin{};
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // FLIP_FREE_MAPS_PROGRAM_PICTURES_LAYOUT_PAINTER_H
