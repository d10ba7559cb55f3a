// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Atlas.h"

#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>
#include <CGAL/Flip_free_maps/measure/internal/Distortion_measure.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
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

// For each point the first one of the same mesh at the same place: files double points for reasons of their own, and what they part is
// no seam as long as the images agree.
std::vector<int> first_at_same_place(const Surface& surface, const std::vector<std::array<double, 3>>& points)
{
  std::vector<std::size_t> mesh(points.size(), 0);
  for(std::size_t i = 0; surface.are_objects_apart && i < surface.objects.size(); ++i)
    for(const std::size_t v : surface.polygons[i])
      mesh[v] = surface.objects[i];
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::tie(mesh[i], points[i]); };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); });
  for(std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

} // namespace

std::vector<std::array<std::size_t, 3>> triangulation(const std::vector<Image>& images) { return Ear_clipper(images).triangles(); }

Atlas make_atlas(const Surface& surface, const Corner_images& images)
{
  Atlas atlas;
  for(const auto& p : surface.points)
    atlas.mesh.points.push_back({p.x(), p.y(), p.z()});
  const std::vector<int> first = first_at_same_place(surface, atlas.mesh.points);
  FFM::internal::Corner_numbers<std::size_t> numbers;
  for(std::size_t i = 0; i < surface.polygons.size(); ++i) {
    if(images[i].empty()) {
      ++atlas.without_images;
      continue;
    }
    const std::size_t triangles_before = atlas.mesh.triangles.size();
    for(const auto& corners : triangulation(images[i])) {
      Eigen::Matrix3d points;
      Eigen::Matrix<double, 2, 3> image;
      std::array<int, 3> triangle, texture;
      for(int k = 0; k < 3; ++k) {
        const std::size_t v = surface.polygons[i][corners[k]];
        points.col(k) = Eigen::Map<const Eigen::Vector3d>(atlas.mesh.points[v].data());
        image.col(k) = Eigen::Map<const Eigen::Vector2d>(images[i][corners[k]].data());
        triangle[k] = first[v];
      }
      // NaN says that the triangle cannot be measured.
      if(std::isnan(FFM::internal::Distortion_measure().add(points, image)))
        continue;
      for(int k = 0; k < 3; ++k)
        texture[k] = numbers(static_cast<std::size_t>(triangle[k]), image(0, k), image(1, k));
      atlas.mesh.triangles.push_back(triangle);
      atlas.mesh.texture_triangles.push_back(texture);
      atlas.polygons.push_back(i);
      atlas.corners.push_back(corners);
    }
    atlas.without_area += atlas.mesh.triangles.size() == triangles_before;
  }
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
