// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Atlas.h"

#include <CGAL/Flip_free_maps/domains/internal/give_area.h>
#include <CGAL/Flip_free_maps/domains/internal/weld_points.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace program {

namespace {

CGAL::Orientation orientation(const Image& p, const Image& q, const Image& r)
{
  return CGAL::orientation(Kernel::Point_2(p[0], p[1]), Kernel::Point_2(q[0], q[1]), Kernel::Point_2(r[0], r[1]));
}

// Triangles of a polygon by the ears of its image, with a fan of what has none.
class Ear_clipper
{
public:
  explicit Ear_clipper(const std::vector<Image>& images) : m_images(images)
  {
    double area = 0;
    for(std::size_t k = 0; k < images.size(); ++k) {
      const Image &p = images[k], &q = images[(k + 1) % images.size()];
      area += (p[0] - images[0][0]) * (q[1] - images[0][1]) - (q[0] - images[0][0]) * (p[1] - images[0][1]);
      m_left.push_back(k);
    }
    m_positive = area >= 0 ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN;
  }

  std::vector<std::array<std::size_t, 3>> triangles()
  {
    std::vector<std::array<std::size_t, 3>> result;
    while(m_left.size() >= 3) {
      std::size_t ear = 1;
      for(std::size_t i = 0; i < m_left.size(); ++i)
        if(is_ear(i)) {
          ear = i;
          break;
        }
      const std::size_t n = m_left.size();
      result.push_back({m_left[(ear + n - 1) % n], m_left[ear], m_left[(ear + 1) % n]});
      m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return result;
  }

private:
  bool is_ear(std::size_t i) const
  {
    const std::size_t n = m_left.size(), a = m_left[(i + n - 1) % n], b = m_left[i], c = m_left[(i + 1) % n];
    if(orientation(m_images[a], m_images[b], m_images[c]) != m_positive)
      return false;
    for(const std::size_t d : m_left) {
      const Image& p = m_images[d];
      if(d == a || d == b || d == c || p == m_images[a] || p == m_images[b] || p == m_images[c])
        continue;
      if(orientation(m_images[a], m_images[b], p) != -m_positive && orientation(m_images[b], m_images[c], p) != -m_positive &&
         orientation(m_images[c], m_images[a], p) != -m_positive)
        return false;
    }
    return true;
  }

  const std::vector<Image>& m_images;
  std::vector<std::size_t> m_left;
  CGAL::Orientation m_positive;
};

// The first point at the same place as each, of the same mesh: files double points for reasons of their own, and what they part is no
// seam as long as the images agree.
std::vector<std::int32_t> first_at_same_place(const Surface& surface, const FFM::Positions<3>& points)
{
  std::vector<std::int32_t> first(points.cols());
  std::iota(first.begin(), first.end(), 0);
  FFM::internal::weld_points(points, first);
  if(!surface.are_objects_apart)
    return first;
  std::vector<std::size_t> mesh(points.cols(), 0);
  for(std::size_t i = 0; i < surface.objects.size(); ++i)
    for(const std::size_t v : surface.polygons[i])
      mesh[v] = surface.objects[i];
  std::map<std::pair<std::size_t, std::int32_t>, std::int32_t> firsts;
  for(std::size_t v = 0; v < mesh.size(); ++v)
    first[v] = firsts.emplace(std::make_pair(mesh[v], first[v]), static_cast<std::int32_t>(v)).first->second;
  return first;
}

// Coordinates in a unit of their own magnitude, in which areas neither overflow nor vanish.
FFM::Positions<3> scaled_points(const Surface& surface)
{
  FFM::Positions<3> points(3, surface.points.size());
  double most = 0;
  for(std::size_t v = 0; v < surface.points.size(); ++v)
    for(int c = 0; c < 3; ++c) {
      points(c, v) = surface.points[v][c];
      most = std::isfinite(points(c, v)) ? (std::max)(most, std::abs(points(c, v))) : most;
    }
  const int exponent = most > 0 ? std::ilogb(most) : 0;
  return points.unaryExpr([exponent](double x) { return std::ldexp(x, -exponent); });
}

} // namespace

std::vector<std::array<std::size_t, 3>> triangulation(const std::vector<Image>& images) { return Ear_clipper(images).triangles(); }

Atlas make_atlas(const Surface& surface, const Corner_images& images, bool with_flat_triangles)
{
  Atlas atlas;
  for(const auto& p : surface.points)
    atlas.mesh.points.push_back({p.x(), p.y(), p.z()});
  const FFM::Positions<3> points = scaled_points(surface);
  const std::vector<std::int32_t>& first = atlas.first = first_at_same_place(surface, points);
  FFM::internal::Corner_numbers<std::size_t> numbers;
  std::vector<std::pair<std::size_t, std::size_t>> others;
  for(std::size_t i = 0; i < surface.polygons.size(); ++i) {
    const auto& polygon = surface.polygons[i];
    if(images[i].empty()) {
      ++atlas.without_images;
      continue;
    }
    bool is_flat = true;
    std::vector<char> is_covered(polygon.size(), 0);
    for(const auto& corners : triangulation(images[i])) {
      std::array<std::int32_t, 3> triangle;
      std::array<int, 3> texture;
      for(int k = 0; k < 3; ++k)
        triangle[k] = first[polygon[corners[k]]];
      const bool has_area = FFM::internal::has_area(points, triangle);
      is_flat = is_flat && !has_area;
      if(!has_area && !with_flat_triangles)
        continue;
      for(int k = 0; k < 3; ++k)
        texture[k] = numbers(static_cast<std::size_t>(triangle[k]), images[i][corners[k]][0], images[i][corners[k]][1]);
      if(texture[0] == texture[1] || texture[1] == texture[2] || texture[2] == texture[0])
        continue;
      atlas.mesh.triangles.push_back({triangle[0], triangle[1], triangle[2]});
      atlas.mesh.texture_triangles.push_back(texture);
      atlas.polygons.push_back(i);
      atlas.corners.push_back(corners);
      atlas.has_area.push_back(has_area);
      for(const std::size_t c : corners)
        is_covered[c] = 1;
    }
    atlas.without_area += is_flat;
    for(std::size_t c = 0; c < polygon.size(); ++c)
      if(!is_covered[c])
        others.emplace_back(i, c);
  }
  for(const auto& [i, c] : others)
    atlas.other_corners.push_back(
      {i, c, numbers(static_cast<std::size_t>(first[surface.polygons[i][c]]), images[i][c][0], images[i][c][1])});
  const FFM::Positions<2> x = numbers.positions();
  for(Eigen::Index t = 0; t < x.cols(); ++t)
    atlas.mesh.texture.push_back({x(0, t), x(1, t)});
  return atlas;
}

bool stay_positive(const Atlas& atlas, const Corner_images& images)
{
  for(std::size_t i = 0; i < atlas.polygons.size(); ++i) {
    const auto& corners = images[atlas.polygons[i]];
    const auto& [a, b, c] = atlas.corners[i];
    if(image_orientation(atlas.mesh, i) == CGAL::LEFT_TURN && orientation(corners[a], corners[b], corners[c]) != CGAL::LEFT_TURN)
      return false;
  }
  return true;
}

void copy_images(const Atlas& atlas, Corner_images& images)
{
  for(std::size_t i = 0; i < atlas.polygons.size(); ++i)
    for(int k = 0; k < 3; ++k)
      images[atlas.polygons[i]][atlas.corners[i][k]] = atlas.mesh.texture[atlas.mesh.texture_triangles[i][k]];
  for(const Atlas::Corner& other : atlas.other_corners)
    images[other.polygon][other.corner] = atlas.mesh.texture[other.texture];
}

std::vector<std::vector<std::size_t>> islands(const Atlas& atlas)
{
  FFM::internal::Disjoint_sets sets(atlas.mesh.texture.size());
  for(const auto& triangle : atlas.mesh.texture_triangles)
    for(int k = 0; k < 2; ++k)
      sets.unite(triangle[k], triangle[k + 1]);
  std::vector<std::size_t> island_of(atlas.mesh.texture.size(), atlas.mesh.texture.size());
  std::vector<std::vector<std::size_t>> result;
  for(std::size_t i = 0; i < atlas.mesh.texture_triangles.size(); ++i) {
    std::size_t& island = island_of[sets.root(atlas.mesh.texture_triangles[i][0])];
    if(island == island_of.size()) {
      island = result.size();
      result.emplace_back();
    }
    result[island].push_back(i);
  }
  return result;
}

CGAL::Orientation image_orientation(const FFM::Textured_mesh& mesh, std::size_t triangle)
{
  const auto& t = mesh.texture_triangles[triangle];
  return orientation(mesh.texture[t[0]], mesh.texture[t[1]], mesh.texture[t[2]]);
}

} // namespace program
