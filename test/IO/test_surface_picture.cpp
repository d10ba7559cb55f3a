// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Pictures of surfaces in space, read back and looked at.

#include "support/unit_test.h"

#include "support/volume_checks.h"

#include "program/pictures/Surface_picture.h"
#include "program/pictures/Texture_picture.h"

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO
#include <cairo.h>
#endif

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_surface_picture)

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// A square of the given half side at the given depth, seen from +z, with one value.
FFM::Solid_view square(double size, double depth, double value)
{
  FFM::Solid_view view;
  view.points = {{{-size, -size, depth}}, {{size, -size, depth}}, {{size, size, depth}}, {{-size, size, depth}}};
  view.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  view.values.assign(2, value);
  return view;
}

FFM::Solid_view merged(FFM::Solid_view a, const FFM::Solid_view& b)
{
  const int shift = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const auto& t : b.triangles)
    a.triangles.push_back({{t[0] + shift, t[1] + shift, t[2] + shift}});
  a.values.insert(a.values.end(), b.values.begin(), b.values.end());
  return a;
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO

struct Picture
{
  explicit Picture(const std::string& path)
  {
    cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
    BOOST_TEST_REQUIRE(cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS);
    width = cairo_image_surface_get_width(surface);
    height = cairo_image_surface_get_height(surface);
    const unsigned char* bytes = cairo_image_surface_get_data(surface);
    for(int j = 0; j < height; ++j)
      for(int i = 0; i < width; ++i) {
        std::uint32_t pixel;
        std::memcpy(&pixel, bytes + j * cairo_image_surface_get_stride(surface) + 4 * i, 4);
        pixels.push_back(pixel & 0xFFFFFF);
      }
    cairo_surface_destroy(surface);
  }

  std::uint32_t at(double x, double y) const { return pixels[static_cast<int>(y * height) * width + static_cast<int>(x * width)]; }
  static int brightness(std::uint32_t pixel) { return (pixel >> 16) + (pixel >> 8 & 255) + (pixel & 255); }

  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
};

Picture draw(const std::vector<FFM::Solid_view>& views, const FFM::Surface_picture_options& options)
{
  const Directory directory;
  std::string message = "old";
  BOOST_TEST_REQUIRE(FFM::write_surface_PNG(directory.file("a.png"), views, options, &message), message);
  BOOST_TEST(message == "");
  return Picture(directory.file("a.png"));
}

#endif

} // namespace

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO

BOOST_AUTO_TEST_CASE(nearer_triangles_hide_others_from_either_side)
{
  FFM::Surface_picture_options options;
  options.width = 640;
  options.height = 480;
  options.upper_end = 10;
  const FFM::Solid_view both = merged(square(1, 0, 1), square(0.3, 0.5, 10));
  options.view_direction = {{0, 0, 1}};
  const Picture front = draw({both}, options);
  options.view_direction = {{0, 0, -1}};
  const Picture back = draw({both}, options);
  BOOST_TEST((front.width == 640 && front.height == 480));
  // The legend is on the right: the middle of the view is to the left of that of the picture, beside the diagonals.
  const double x = 0.42, y = 0.56;
  BOOST_TEST(Picture::brightness(front.at(x, y)) < Picture::brightness(back.at(x, y)) - 150);
  BOOST_TEST(Picture::brightness(back.at(x, y)) == Picture::brightness(front.at(0.3, 0.8)), boost::test_tools::tolerance(0.1));
  BOOST_TEST(front.at(0.01, 0.5) == 0xFFFFFFu);
}

BOOST_AUTO_TEST_CASE(views_share_the_scale_of_lengths)
{
  FFM::Surface_picture_options options;
  options.width = 800;
  options.height = 400;
  options.view_direction = {{0, 0, 1}};
  std::vector<FFM::Solid_view> views = {square(1, 0, 1), square(0.5, 0, 1)};
  for(FFM::Solid_view& view : views)
    view.values.clear();
  const Picture picture = draw(views, options);
  std::array<int, 2> covered = {{0, 0}};
  for(int j = 0; j < picture.height; ++j)
    for(int i = 0; i < picture.width; ++i)
      covered[i < picture.width / 2 ? 0 : 1] += picture.pixels[j * picture.width + i] != 0xFFFFFF;
  BOOST_TEST(covered[1] > 1000);
  BOOST_TEST(std::abs(covered[0] / double(covered[1]) - 4) < 0.1);
}

BOOST_AUTO_TEST_CASE(surfaces_without_holes_and_strange_values)
{
  // Thousands of triangles, none of whose common edges may shine through.
  FFM::Solid_view view;
  const int n = 60;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      view.points.push_back({{i + 0.3 * std::sin(j), j + 0.3 * std::cos(3. * i), 0.}});
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      view.triangles.push_back({{a, a + 1, a + n + 2}});
      view.triangles.push_back({{a, a + n + 2, a + n + 1}});
    }
  view.values.assign(view.triangles.size(), 100);
  view.values[0] = std::numeric_limits<double>::infinity();
  view.values[1] = std::numeric_limits<double>::quiet_NaN();
  view.values[2] = -5;
  FFM::Surface_picture_options options;
  options.width = 640;
  options.height = 480;
  options.view_direction = {{0, 0, 1}};
  const Picture picture = draw({view}, options);
  int pale = 0;
  for(double x = 0.25; x < 0.6; x += 0.001)
    for(double y = 0.3; y < 0.8; y += 0.002)
      pale += Picture::brightness(picture.at(x, y)) > 400;
  BOOST_TEST(pale == 0);

  // Whatever is degenerate still gives a picture.
  FFM::Solid_view point;
  point.points = {{{1, 1, 1}}};
  point.triangles = {{{0, 0, 0}}};
  draw({point, view}, options);
  options.view_direction = {{0, 5, 0}};
  draw({view}, options);
  options.view_direction = {{0, 0, 0}};
  draw({view}, options);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_drawn)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  const FFM::Solid_view good = square(1, 0, 2);
  const auto fails = [&](const std::vector<FFM::Solid_view>& views, const FFM::Surface_picture_options& options, const char* part) {
    std::string message;
    return !FFM::write_surface_PNG(path, views, options, &message) && contains(message, part) && !std::filesystem::exists(path);
  };
  FFM::Surface_picture_options options;
  BOOST_TEST(fails({}, options, "no view"));
  BOOST_TEST(fails({good, FFM::Solid_view()}, options, "no triangle"));
  FFM::Solid_view bad = good;
  bad.values.pop_back();
  BOOST_TEST(fails({bad}, options, "number of values"));
  bad = good;
  bad.triangles[1][2] = 4;
  BOOST_TEST(fails({bad}, options, "triangle 1 has an index out of range"));
  bad = good;
  bad.points[2][1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(fails({bad}, options, "not finite"));
  options.width = 10;
  BOOST_TEST(fails({good}, options, "pixels wide"));
  options = FFM::Surface_picture_options();
  options.up = {{0, 0, 0}};
  BOOST_TEST(fails({good}, options, "up"));
  options = FFM::Surface_picture_options();
  options.upper_end = 0.5;
  BOOST_TEST(fails({good}, options, "upper end"));
  std::string message;
  BOOST_TEST(!FFM::write_surface_PNG(directory.file("no/a.png"), {good}, FFM::Surface_picture_options(), &message));
  BOOST_TEST(!message.empty());
}

namespace {

// A square of n x n, whose two halves have separate images if asked for, with the map (x, y) -> (u, v).
template <typename Map>
FFM::Textured_mesh textured_square(int n, bool has_seam, const Map& map)
{
  FFM::Textured_mesh mesh;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i) {
      mesh.points.push_back({{2. * i / n - 1, 2. * j / n - 1, 0.}});
      mesh.texture.push_back(map(mesh.points.back()[0], mesh.points.back()[1]));
    }
  const int size = static_cast<int>(mesh.points.size());
  for(int k = 0; k < size && has_seam; ++k)
    mesh.texture.push_back(mesh.texture[k]);
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, shift = has_seam && 2 * i >= n ? size : 0;
      for(const std::array<int, 3>& t : {std::array<int, 3>{{a, a + 1, a + n + 2}}, std::array<int, 3>{{a, a + n + 2, a + n + 1}}}) {
        mesh.triangles.push_back(t);
        mesh.texture_triangles.push_back({{t[0] + shift, t[1] + shift, t[2] + shift}});
      }
    }
  return mesh;
}

struct Colors
{
  int light = 0, dark = 0, red = 0, magenta = 0;
};

Colors colors_of(const FFM::Textured_mesh& mesh)
{
  const Directory directory;
  FFM::Texture_picture_options options;
  options.width = 800;
  options.squares = 10;
  std::string message;
  BOOST_TEST_REQUIRE(FFM::write_textured_surface_PNG(directory.file("a.png"), mesh, options, &message), message);
  const Picture picture(directory.file("a.png"));
  BOOST_TEST((picture.width == 800 && picture.height == 600));
  Colors colors;
  for(const std::uint32_t pixel : picture.pixels) {
    const int r = pixel >> 16, g = pixel >> 8 & 255, b = pixel & 255;
    if(pixel == 0xFFFFFF)
      continue;
    if(2 * r > 3 * g && 2 * r > 3 * b)
      ++colors.red;
    else if(g < r / 3 && b > r / 2)
      ++colors.magenta;
    else
      ++(r > b ? colors.light : colors.dark);
  }
  return colors;
}

} // namespace

BOOST_AUTO_TEST_CASE(checkerboards_on_surfaces)
{
  using Place = std::array<double, 2>;
  const auto same = [](double x, double y) { return Place{{x, y}}; };
  const Colors whole = colors_of(textured_square(10, false, same));
  BOOST_TEST(whole.magenta == 0);
  BOOST_TEST(whole.light + whole.dark > 20000);
  // Ten squares by ten are half light, half dark; but for what the lines along the border cover of them.
  BOOST_TEST(std::abs(whole.light / double(whole.dark) - 1) < 0.1);
  // The border is red, and so is the seam, a fourth as long.
  const Colors halves = colors_of(textured_square(10, true, same));
  BOOST_TEST(whole.red > 1000);
  BOOST_TEST(halves.red > 1.2 * whole.red);
  // Two lines of pixels, one for each side: twice as wide as the border's.
  BOOST_TEST(halves.red < 1.7 * whole.red);
  const Colors mirrored = colors_of(textured_square(10, false, [](double x, double y) { return Place{{-x, y}}; }));
  BOOST_TEST(mirrored.light + mirrored.dark < 0.02 * (whole.light + whole.dark));
  BOOST_TEST(mirrored.magenta > 0.9 * (whole.light + whole.dark));
}

BOOST_AUTO_TEST_CASE(textures_that_cannot_be_drawn)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  const auto fails = [&](const FFM::Textured_mesh& mesh, const FFM::Texture_picture_options& options, const char* part) {
    std::string message;
    return !FFM::write_textured_surface_PNG(path, mesh, options, &message) && contains(message, part) && !std::filesystem::exists(path);
  };
  const FFM::Textured_mesh good = textured_square(2, false, [](double x, double y) { return std::array<double, 2>{{x, y}}; });
  FFM::Texture_picture_options options;
  BOOST_TEST(fails(FFM::Textured_mesh(), options, "no triangle"));
  FFM::Textured_mesh bad = good;
  bad.texture_triangles.pop_back();
  BOOST_TEST(fails(bad, options, "that of their images"));
  bad = good;
  bad.texture_triangles[3][1] = 9;
  BOOST_TEST(fails(bad, options, "triangle 3"));
  bad = good;
  bad.texture[0][1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(fails(bad, options, "triangle 0"));
  options.squares = 0;
  BOOST_TEST(fails(good, options, "square"));
  options = FFM::Texture_picture_options();
  options.width = 0;
  BOOST_TEST(fails(good, options, "width"));
}

#else

BOOST_AUTO_TEST_CASE(needs_cairo) { test_support::skip_case("built without Cairo"); }

BOOST_AUTO_TEST_CASE(without_cairo)
{
  std::string message;
  BOOST_TEST(!FFM::write_surface_PNG("a.png", {square(1, 0, 2)}, FFM::Surface_picture_options(), &message));
  BOOST_TEST(contains(message, "built without Cairo"));
  BOOST_TEST(merged(square(1, 0, 1), square(1, 0, 1)).triangles.size() == 4u);
}

#endif

BOOST_AUTO_TEST_SUITE_END() // test_surface_picture
