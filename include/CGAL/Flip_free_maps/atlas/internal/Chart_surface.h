// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_H

#include <CGAL/Flip_free_maps/atlas/Unwrap_summary.h>
#include <CGAL/Flip_free_maps/domains/internal/Linked_triangles.h>
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

// A surface with seams, and its pieces. Each piece is a mesh of its own, cut open, the same type for all meshes of users. Triangles
// and their halfedges have the numbers of the arrays everywhere.
class Chart_surface
{
public:
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  using Halfedge = Mesh::Halfedge_index;
  using Vertex = Mesh::Vertex_index;

  // `begin` is the time from which seconds are counted.
  Chart_surface(const Linked_triangles& surface, double begin, Unwrap_summary& summary);

  // Marks the edge of a halfedge as a seam, or as one that seams are to follow.
  void mark_seam(std::int32_t h) { mark(m_is_cut, h); }
  void mark_feature(std::int32_t h) { mark(m_is_feature, h); }

  // Closes a seam again that has two sides.
  void close_seam(std::int32_t h) { m_is_cut[h] = m_is_cut[m_surface.opposite[h]] = 0; }

  // Whether the edge of a halfedge has two images, or is on a border of the surface.
  bool is_seam(std::int32_t h) const { return m_surface.opposite[h] < 0 || m_is_cut[h]; }

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
    Linked_triangles surface;
    Border_curves border;
  };

  // Two edges of the border of a piece whose images cross, and how many edges are between them along it; as many as there are if
  // they are on different borders.
  struct Crossing
  {
    std::int32_t edges[2], way;
  };

  bool fail(Status status, const std::string& message);

  void mark(std::vector<char>& marks, std::int32_t h);

  // The triangle across a halfedge, -1 at borders and seams.
  std::int32_t neighbor(std::int32_t h) const { return is_seam(h) ? -1 : m_surface.opposite[h] / 3; }

  // The number of polygons that some triangles are parts of.
  std::int64_t number_of_polygons(const std::vector<std::int32_t>& faces) const;

  // Queues the parts of some faces that are connected across edges that are not cut; they inherit all but the faces.
  void enqueue_parts(const std::vector<std::int32_t>& faces, const Piece& origin);

  void enqueue_parts(const std::vector<std::int32_t>& faces) { enqueue_parts(faces, Piece()); }

  // Some faces, opened along their seams.
  Linked_triangles open_surface(const std::vector<std::int32_t>& faces);

  Open_piece open(const std::vector<std::int32_t>& faces);

  // A seam of a single edge opens nothing where no other seam meets it: both of its sides have the same vertices. They are joined.
  static void close_slits(Linked_triangles& open);

  // A halfedge of the border that becomes the outer one; null when the piece is closed.
  static Halfedge longest_border(const Open_piece& open);

  // Angles that are missing from a planar surface with holes, in all: at inner vertices those to 2 pi, and at each hole that of
  // its total turn to -2 pi. Infinite for surfaces that are no disks with holes, or have none.
  static double missing_angles(const Open_piece& open);

  // A map with the vertices of its border moved outwards.
  static Positions<2> with_moved_border(const Open_piece& open, const Positions<2>& x, double distance);

  // The crossings of the border, the farthest first. Of a great many some are left out.
  static std::vector<Crossing> crossings(const Open_piece& open, const Positions<2>& x);

  // Whether a map overlaps itself.
  static bool has_overlap(const Open_piece& open, const Positions<2>& x);

  Unwrap_summary& m_summary;
  double m_begin;
  const Linked_triangles& m_surface;
  std::vector<char> m_is_cut, m_is_feature; // by halfedge
  std::vector<char> m_is_given;             // likewise, the seams that were asked for
  std::vector<std::int32_t> m_place;        // of a face in the piece at hand
  std::vector<char> m_is_unassigned;        // whether a face still looks for its piece
  std::deque<Piece> m_queue;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_surface_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_SURFACE_H
