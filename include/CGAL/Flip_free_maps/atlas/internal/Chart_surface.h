// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_H

#include <CGAL/Flip_free_maps/atlas/Unwrap_summary.h>
#include <CGAL/Flip_free_maps/elements/internal/rest_shape.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/measure/internal/Border_curves.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// A surface with seams, and its pieces. Works on meshes of its own, the same type for all meshes of users: one of the whole
// surface, and one of each piece, cut open. Faces and their corners have the numbers of the arrays everywhere.
class Chart_surface
{
public:
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  using Face = Mesh::Face_index;
  using Halfedge = Mesh::Halfedge_index;
  using Vertex = Mesh::Vertex_index;
  using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;

  explicit Chart_surface(Unwrap_summary& summary) : m_summary(summary), m_begin(wall_seconds()) {}

  // Takes the surface. False, and the summary says why, when it is not one that can be mapped.
  bool load(const Positions<3>& points, const std::vector<std::array<std::int32_t, 3>>& triangles);

  // Marks the edge to corner k of a face as a seam, or as one that seams are to follow.
  void mark_seam(std::int32_t face, int k) { mark(m_is_cut, face, k); }
  void mark_feature(std::int32_t face, int k) { mark(m_is_feature, face, k); }

  // Whether the edge to corner k of a face is within the surface and has two images.
  bool is_seam(std::int32_t face, int k) const { return m_is_cut[m_mesh.edge(m_corners[face][k])]; }

protected:
  struct Piece
  {
    std::vector<std::int32_t> faces;
    bool was_cut = false; // whether it has been cut to a disk once more
    int recuts = 0;       // how often it has been cut because of its distortion
    double target = 0;    // the energy that was expected of the last cut, 0 for that of all
    bool is_part = false; // of a chart whose map would do if it were smaller
  };

  // A piece, cut open along its seams.
  struct Open_piece
  {
    Mesh mesh;
    bool is_mesh = true;
    std::vector<std::array<std::int32_t, 3>> elements;
    std::vector<std::array<std::int32_t, 3>> neighbors;
    Positions<3> points;
  };

  bool fail(Status status, const std::string& message);

  // Whether the mark is new.
  bool mark(Edge_map& map, std::int32_t face, int k);

  // The face across the edge to corner k, -1 at borders and seams.
  std::int32_t neighbor(std::int32_t face, int k) const;

  // Queues the parts of some faces that are connected across edges that are not cut; they inherit all but the faces.
  void enqueue_parts(const std::vector<std::int32_t>& faces, const Piece& origin);

  void enqueue_parts(const std::vector<std::int32_t>& faces) { enqueue_parts(faces, Piece()); }

  Open_piece open(const std::vector<std::int32_t>& faces);

  // A halfedge of the border that becomes the outer one; null when the piece is closed.
  static Halfedge longest_border(const Open_piece& open);

  // Angles that are missing from a planar surface with holes, in all: at inner vertices those to 2 pi, and at each hole that of
  // its total turn to -2 pi. Infinite for surfaces that are no disks with holes, or have none.
  static double missing_angles(const Open_piece& open);

  // A map with the vertices of its border moved outwards.
  Positions<2> with_moved_border(const Open_piece& open, const Positions<2>& x, double distance) const;

  // Two faces at places of the border that cross, on different borders, or as far from each other along the border as any.
  bool find_overlap(const Open_piece& open, const Positions<2>& x, std::pair<std::int32_t, std::int32_t>& overlap) const;

  Unwrap_summary& m_summary;
  double m_begin;
  int m_exponent = 0; // binary logarithm of the unit of length
  std::vector<std::array<std::int32_t, 3>> m_triangles;
  Positions<3> m_points;
  Mesh m_mesh;
  Edge_map m_is_cut;
  Edge_map m_is_feature;
  std::vector<std::array<Halfedge, 3>> m_corners; // the halfedges to the corners of faces
  std::vector<int> m_corner_of;                   // the corner that a halfedge leads to
  std::vector<std::int32_t> m_place;              // of a face in the piece at hand
  std::vector<char> m_is_unassigned;              // whether a face still looks for its piece
  std::deque<Piece> m_queue;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_surface_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_H
