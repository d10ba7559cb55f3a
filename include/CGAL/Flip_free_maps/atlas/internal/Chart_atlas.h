// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_H

#include <CGAL/Flip_free_maps/atlas/Unwrap_options.h>
#include <CGAL/Flip_free_maps/atlas/Unwrap_summary.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_splitter.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_surface.h>
#include <CGAL/Flip_free_maps/atlas/internal/pack_flat_charts.h>
#include <CGAL/Flip_free_maps/cutting/internal/cut_mesh.h>
#include <CGAL/Flip_free_maps/initializers/internal/make_start.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/measure/internal/Distortion_measure.h>
#include <CGAL/Flip_free_maps/parameterization/internal/parameterize_patch.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// From flat arrays of triangles to charts without overlaps.
template <typename Traits>
class Chart_atlas : public Chart_surface
{
public:
  Chart_atlas(const Traits& traits, const Unwrap_options& options, Unwrap_summary& summary)
    : Chart_surface(summary), m_traits(traits), m_options(options)
  {}

  // Cuts, flattens, packs, and tests the atlas in the numbers that points of the given type can hold.
  template <typename Point>
  bool run()
  {
    if(!m_options.is_valid(&m_summary.message) || !m_traits.options.is_valid(&m_summary.message)) {
      m_summary.status = Status::invalid_option;
      return false;
    }
    m_place.assign(m_triangles.size(), -1);
    m_is_unassigned.assign(m_triangles.size(), 0);
    m_image.assign(m_triangles.size(), Image::Constant(std::numeric_limits<double>::quiet_NaN()));
    std::vector<std::int32_t> others;
    {
      const Phase_timer timer(m_summary.flatten_seconds);
      std::vector<std::int32_t> all(m_triangles.size());
      std::iota(all.begin(), all.end(), 0);
      enqueue_parts(all);
      std::deque<Piece> parts;
      parts.swap(m_queue);
      for(Piece& piece : parts)
        if(!keep_holes(piece))
          others.insert(others.end(), piece.faces.begin(), piece.faces.end());
    }
    {
      const Phase_timer timer(m_summary.cut_seconds);
      std::vector<char> was_cut;
      for(const Mesh::Edge_index edge : m_mesh.edges())
        was_cut.push_back(m_is_cut[edge]);
      Cut_options cut = m_options.cut;
      cut.target_energy = (std::min)(cut.target_energy, m_options.max_distortion);
      cut.cut_disks = cut.cut_disks || std::isfinite(m_options.max_distortion);
      m_summary.cut = cut_mesh(
        m_mesh, m_mesh.points(), m_is_cut, [this](Mesh::Edge_index e) { return bool(m_is_feature[e]); }, cut);
      m_summary.cut.seam_length = std::ldexp(m_summary.cut.seam_length, m_exponent);
      for(const Flat_chart& chart : m_charts)
        for(const std::int32_t f : chart.faces)
          for(const Halfedge h : m_corners[f])
            m_is_cut[m_mesh.edge(h)] = was_cut[m_mesh.edge(h)] != 0;
    }
    if(!m_summary.cut.is_valid())
      return fail(m_summary.cut.status, "the surface was not cut open: " + m_summary.cut.message);
    {
      const Phase_timer timer(m_summary.flatten_seconds);
      enqueue_parts(others);
      while(!m_queue.empty()) {
        Piece piece = std::move(m_queue.front());
        m_queue.pop_front();
        if(!process(piece))
          return false;
      }
      sort_charts();
    }
    {
      const Phase_timer timer(m_summary.pack_seconds);
      if(!m_options.pack)
        scale_back<Point>();
      else if(!pack<Point>())
        return false;
    }
    count();
    return certify();
  }

  // Says how it ended when all is done.
  void finish()
  {
    const auto ended = [this](Status status) {
      return std::any_of(m_summary.charts.begin(), m_summary.charts.end(), [=](const Chart_summary& c) { return c.status == status; });
    };
    m_summary.seconds = wall_seconds() - m_begin;
    m_summary.status = Status::success;
    m_summary.message = "all charts converged; none overlaps another or itself";
    if(m_is_stopped) {
      m_summary.status = Status::stopped_by_observer;
      m_summary.message = "the observer asked to stop; charts without overlaps were made of what there was";
    } else if(ended(Status::time_limit)) {
      m_summary.status = Status::time_limit;
      m_summary.message = "the time was up before all charts converged; none overlaps another or itself";
    } else if(ended(Status::iteration_limit)) {
      m_summary.status = Status::iteration_limit;
      m_summary.message = "not all charts converged within the limit of iterations; none overlaps another or itself";
    }
  }

  const std::vector<Flat_chart>& charts() const { return m_charts; }

private:
  using Image = Eigen::Matrix<double, 2, 3>;

  template <typename Point>
  bool pack()
  {
    // Half the distance of the numbers below 1.
    const Positions<2> third = Positions<2>::Constant(2, 1, 1. / 3);
    const double precision =
      (std::max)((as_rounded_by<Point>(third) - third).cwiseAbs().maxCoeff(), 0.5 * std::numeric_limits<double>::epsilon());
    std::vector<int> attempts(m_charts.size(), 0);
    Packing_summary packing;
    for(;;) {
      std::size_t chart = 0;
      pack_flat_charts<Point>(m_charts, m_options.packing, packing, &chart);
      if(packing.is_valid())
        break;
      if(packing.status != Status::result_not_representable || ++attempts[chart] > 3 ||
         !thicken(chart, precision * std::pow(30., attempts[chart]) / packing.scale))
        return fail(packing.status, "the charts were not packed: " + packing.message);
    }
    m_summary.scale = std::ldexp(packing.scale, -m_exponent);
    m_summary.occupancy = packing.occupancy;
    return true;
  }

  // Flattens a chart anew after its vertices were moved in space by at most a length, to and fro:
  // hardly any triangle is much thinner than that then.
  bool thicken(std::size_t number, double length)
  {
    const Piece piece{m_charts[number].faces, true};
    const Open_piece open = this->open(piece.faces);
    Open_piece moved = open;
    std::uint32_t noise = 1;
    for(Eigen::Index v = 0; v < open.points.cols(); ++v) {
      for(int i = 0; i < 3; ++i) {
        noise = noise * 1664525u + 1013904223u;
        moved.points(i, v) += length * (noise / 2147483648. - 1);
      }
      moved.mesh.point(Vertex(static_cast<Mesh::size_type>(v))) = {moved.points(0, v), moved.points(1, v), moved.points(2, v)};
    }
    Positions<2> x;
    const Summary summary = flatten_piece(moved, x);
    std::pair<std::int32_t, std::int32_t> overlap;
    if(!summary.is_valid() || find_overlap(open, x, overlap))
      return false;
    Chart_summary& chart = m_summary.charts[number];
    const double area = chart.area;
    measure(piece, open, x, chart);
    chart.area = area;
    m_charts[number].x.swap(x);
    return true;
  }

  template <typename Point>
  void scale_back()
  {
    m_summary.scale = 1;
    for(Flat_chart& chart : m_charts) {
      chart.x = chart.x.unaryExpr([this](double c) { return std::ldexp(c, m_exponent); }).eval();
      chart.x = as_rounded_by<Point>(chart.x);
    }
  }

  // The last word on the numbers that the caller receives.
  bool certify()
  {
    const Phase_timer timer(m_summary.certify_seconds);
    Flat_chart all;
    Eigen::Index number = 0;
    for(const Flat_chart& chart : m_charts)
      number += chart.x.cols();
    all.x.resize(2, number);
    number = 0;
    std::string message;
    for(const Flat_chart& chart : m_charts) {
      if(!m_options.pack && !is_bijective(chart.elements, chart.x, &message))
        return fail(Status::result_not_representable, "in the number type of the result " + message);
      all.x.middleCols(number, chart.x.cols()) = chart.x;
      const std::int32_t n = static_cast<std::int32_t>(number);
      for(const auto& v : chart.elements)
        all.elements.push_back({{v[0] + n, v[1] + n, v[2] + n}});
      number += chart.x.cols();
    }
    if(m_options.pack && !is_bijective(all.elements, all.x, &message))
      return fail(Status::result_not_representable, "in the number type of the result " + message);
    m_summary.flips = 0;
    return true;
  }

  double remaining_seconds() const { return m_is_stopped ? 0 : (std::max)(0., m_options.max_seconds - (wall_seconds() - m_begin)); }

  bool report_progress()
  {
    if(!m_options.observer || m_is_stopped)
      return !m_is_stopped;
    Unwrap_progress progress;
    progress.charts_done = static_cast<int>(m_charts.size());
    progress.charts = progress.charts_done + 1 + static_cast<int>(m_queue.size());
    progress.faces_done = m_faces_done;
    progress.faces = m_summary.faces;
    progress.seconds = wall_seconds() - m_begin;
    m_is_stopped = !m_options.observer(progress);
    return !m_is_stopped;
  }

  Summary flatten_piece(const Open_piece& open, Positions<2>& x)
  {
    Summary summary;
    const Halfedge border = longest_border(open);
    Traits traits = m_traits;
    traits.options.max_seconds = (std::min)(traits.options.max_seconds, remaining_seconds());
    if(traits.options.max_seconds == 0)
      traits.start.multilevel_size = -1;
    traits.options.observer = [this, given = m_traits.options.observer](const Iteration_report& report) {
      m_is_stopped = m_is_stopped || (given && !given(report));
      return report_progress();
    };
    std::vector<Point_2> uv(open.points.cols());
    const auto uv_map = boost::make_iterator_property_map(uv.begin(), get(boost::vertex_index, open.mesh));
    summary = parameterize_patch(open.mesh, border, open.mesh.points(), uv_map, traits,
                                 [&traits](const Simplicial_domain<2>& domain, const auto&, Positions<2>& start, std::string& name,
                                           std::string& message) { return make_start(domain, traits, start, name, message); });
    x.resize(2, uv.size());
    if(summary.is_valid())
      for(std::size_t v = 0; v < uv.size(); ++v)
        x.col(v) << uv[v].x(), uv[v].y();
    return summary;
  }

  // The map that the piece has as a part of a larger one.
  bool inherit(const Piece& piece, const Open_piece& open, Positions<2>& x) const
  {
    x.resize(2, open.points.cols());
    for(std::size_t e = 0; e < piece.faces.size(); ++e)
      for(int k = 0; k < 3; ++k)
        x.col(open.elements[e][k]) = m_image[piece.faces[e]].col(k);
    return x.allFinite();
  }

  // Flattens a piece and keeps it as a chart, or splits it. False when neither is possible.
  bool process(Piece& piece)
  {
    report_progress();
    const double begin = wall_seconds();
    const Open_piece open = this->open(piece.faces);
    Chart_summary chart;
    chart.faces = static_cast<std::int64_t>(piece.faces.size());
    Positions<2> x;
    bool is_mapped = false;
    if(remaining_seconds() == 0 && inherit(piece, open, x)) {
      chart.status = m_is_stopped ? Status::stopped_by_observer : Status::time_limit;
      chart.message = "a part of a larger chart, as it was when the time was up";
      is_mapped = true;
    } else if(open.is_mesh) {
      const Summary summary = flatten_piece(open, x);
      chart.status = summary.status;
      chart.message = summary.message;
      chart.iterations = summary.iterations;
      is_mapped = summary.is_valid();
      if(summary.status == Status::out_of_memory || summary.status == Status::invalid_option)
        return fail(summary.status, summary.message);
      if((summary.status == Status::not_a_disk || summary.status == Status::no_border) && !piece.was_cut)
        return cut_again(piece, open);
      if(!is_mapped && inherit(piece, open, x)) {
        chart.status = Status::success;
        chart.message = "a part of a larger chart; not on its own: " + summary.message;
        is_mapped = true;
      }
    } else {
      chart.status = Status::non_manifold;
      chart.message = "two edges of the chart have the same vertices";
    }
    chart.seconds = wall_seconds() - begin;

    const Chart_splitter splitter(open.elements, open.neighbors, open.points);
    if(!is_mapped) {
      if(piece.faces.size() == 1)
        return fail(chart.status, "face number " + std::to_string(piece.faces[0]) + " cannot be flattened: " + chart.message);
      ++m_summary.splits_of_failures;
      return split(piece, open, splitter, splitter.far_apart());
    }
    const std::int32_t worst = measure(piece, open, x, chart);
    std::pair<std::int32_t, std::int32_t> overlap;
    if(find_overlap(open, x, overlap)) {
      ++m_summary.splits_of_overlaps;
      return split(piece, open, splitter, overlap);
    }
    // Without time for flattening a part is as distorted as the whole.
    if(chart.energy > m_options.max_distortion && piece.faces.size() > 1 && remaining_seconds() > 0) {
      ++m_summary.splits_of_distortion;
      return split(piece, open, splitter, {worst, splitter.farthest_from(worst)});
    }
    keep(piece, open, x, chart);
    return true;
  }

  // Enters the distortion of a map into the account of a chart, and remembers the map.
  // Returns the triangle that is distorted most.
  std::int32_t measure(const Piece& piece, const Open_piece& open, const Positions<2>& x, Chart_summary& chart)
  {
    Distortion_measure measure;
    std::pair<double, std::int32_t> worst(0, 0);
    for(std::size_t e = 0; e < piece.faces.size(); ++e) {
      Matrix<3> points;
      Image& image = m_image[piece.faces[e]];
      for(int k = 0; k < 3; ++k) {
        points.col(k) = open.points.col(open.elements[e][k]);
        image.col(k) = x.col(open.elements[e][k]);
      }
      const double energy = measure.add(points, image);
      if(energy > worst.first)
        worst = {energy, static_cast<std::int32_t>(e)};
    }
    const Distortion_report report = measure.report();
    chart.area = report.rest_area; // in the user's units after sort_charts()
    chart.energy = report.energy;
    chart.max_energy = report.max_energy;
    return worst.second;
  }

  void keep(Piece& piece, const Open_piece& open, Positions<2>& x, const Chart_summary& chart)
  {
    m_faces_done += chart.faces;
    m_charts.push_back({open.elements, std::move(x), std::move(piece.faces)});
    m_summary.charts.push_back(chart);
  }

  // Keeps a piece with its holes where joining the borders by seams gains nothing: where it is nearly flat.
  bool keep_holes(Piece& piece)
  {
    const double most_missing = 2 * CGAL_PI, most_energy = (std::min)(1.01, m_options.max_distortion);
    if(!m_options.cut.join_borders)
      return false;
    const Open_piece open = this->open(piece.faces);
    if(!open.is_mesh || !(missing_angles(open) <= most_missing))
      return false;
    const double begin = wall_seconds();
    Positions<2> x;
    const Summary summary = flatten_piece(open, x);
    if(!summary.is_valid())
      return false;
    Chart_summary chart;
    chart.status = summary.status;
    chart.message = summary.message;
    chart.faces = static_cast<std::int64_t>(piece.faces.size());
    chart.iterations = summary.iterations;
    measure(piece, open, x, chart);
    std::pair<std::int32_t, std::int32_t> overlap;
    if(!(chart.energy <= most_energy) || find_overlap(open, x, overlap)) {
      for(const std::int32_t f : piece.faces)
        m_image[f].setConstant(std::numeric_limits<double>::quiet_NaN());
      return false;
    }
    chart.seconds = wall_seconds() - begin;
    keep(piece, open, x, chart);
    return true;
  }

  bool split(const Piece& piece, const Open_piece& open, const Chart_splitter& splitter, std::pair<std::int32_t, std::int32_t> seeds)
  {
    if(seeds.first == seeds.second)
      seeds = splitter.far_apart();
    std::vector<Chart_splitter::Edge> edges = splitter.separate(seeds.first, seeds.second);
    // Triangles whose centres coincide have no distance.
    if(edges.empty())
      edges = splitter.around(seeds.first);
    for(const Chart_splitter::Edge& edge : edges)
      for(int k = 0; k < 3; ++k)
        if(open.neighbors[edge.elements[0]][k] == edge.elements[1])
          mark(m_is_cut, piece.faces[edge.elements[0]], (k + 1) % 3);
    enqueue_parts(piece.faces);
    return true;
  }

  // The parts of a split surface need not be disks.
  bool cut_again(const Piece& piece, const Open_piece& open)
  {
    Mesh mesh = open.mesh;
    Edge_map is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;
    Cut_options cut = m_options.cut;
    cut.branches = Cut_options::Branches::none;
    const Cut_summary summary = cut_mesh(
      mesh, mesh.points(), is_cut, [](Mesh::Edge_index) { return false; }, cut);
    if(!summary.is_valid())
      return fail(summary.status, "a part of the surface was not cut open: " + summary.message);
    for(std::size_t e = 0; e < piece.faces.size(); ++e)
      for(const Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(Face(static_cast<Mesh::size_type>(e))), mesh))
        if(is_cut[mesh.edge(h)])
          for(int k = 0; k < 3; ++k)
            if(open.elements[e][k] == static_cast<std::int32_t>(mesh.target(h)))
              mark(m_is_cut, piece.faces[e], k);
    const std::size_t queued = m_queue.size();
    enqueue_parts(piece.faces);
    for(std::size_t i = queued; i < m_queue.size(); ++i)
      m_queue[i].was_cut = true;
    return true;
  }

  // Sorts by areas in the units of `m_points`, since in the user's they may exceed the range of double precision.
  void sort_charts()
  {
    std::vector<std::size_t> order(m_charts.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return m_summary.charts[a].area > m_summary.charts[b].area; });
    std::vector<Flat_chart> charts;
    std::vector<Chart_summary> summaries;
    for(const std::size_t c : order) {
      charts.push_back(std::move(m_charts[c]));
      summaries.push_back(std::move(m_summary.charts[c]));
    }
    m_charts.swap(charts);
    m_summary.charts.swap(summaries);
    for(Chart_summary& chart : m_summary.charts) {
      m_areas.push_back(chart.area);
      chart.area = std::ldexp(chart.area, 2 * m_exponent);
    }
  }

  // Seams are the edges with two images: an edge that was cut alone, at both ends of which the surface is not, has one.
  void count()
  {
    std::vector<std::int32_t> chart_of(m_triangles.size());
    std::vector<std::array<std::int32_t, 3>> elements(m_triangles.size());
    double energy = 0, area = 0;
    for(std::size_t c = 0; c < m_charts.size(); ++c) {
      for(std::size_t e = 0; e < m_charts[c].faces.size(); ++e) {
        chart_of[m_charts[c].faces[e]] = static_cast<std::int32_t>(c);
        elements[m_charts[c].faces[e]] = m_charts[c].elements[e];
      }
      energy += m_areas[c] * m_summary.charts[c].energy;
      area += m_areas[c];
    }
    m_summary.energy = energy / area;
    m_summary.seam_edges = 0;
    m_summary.seam_length = 0;
    for(const Mesh::Edge_index edge : m_mesh.edges()) {
      const Halfedge h = m_mesh.halfedge(edge, 0), g = m_mesh.halfedge(edge, 1);
      m_is_cut[edge] = false;
      if(m_mesh.is_border(h) || m_mesh.is_border(g))
        continue;
      const std::int32_t e = static_cast<std::int32_t>(m_mesh.face(h)), f = static_cast<std::int32_t>(m_mesh.face(g));
      const auto image = [&](Halfedge to) { return elements[static_cast<std::int32_t>(m_mesh.face(to))][m_corner_of[to]]; };
      if(chart_of[e] == chart_of[f] && image(h) == image(m_mesh.prev(g)) && image(g) == image(m_mesh.prev(h)))
        continue;
      m_is_cut[edge] = true;
      ++m_summary.seam_edges;
      m_summary.seam_length += (m_points.col(m_mesh.target(h)) - m_points.col(m_mesh.target(g))).norm();
    }
    m_summary.seam_length = std::ldexp(m_summary.seam_length, m_exponent);
  }

  Traits m_traits;
  const Unwrap_options& m_options;
  std::vector<Image> m_image; // of each face in the last map of it
  std::vector<Flat_chart> m_charts;
  std::vector<double> m_areas; // of the charts on the surface, in the units of m_points
  std::int64_t m_faces_done = 0;
  bool m_is_stopped = false;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_H
