// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_atlas.h>
#include <CGAL/Flip_free_maps/atlas/internal/chart_contacts.h>
#include <CGAL/Flip_free_maps/atlas/internal/pack_flat_charts.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_planner.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/inline.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

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

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_atlas::has_valid_options()
{
  if(m_options.is_valid(&m_summary.message) && has_valid_method(m_summary.message))
    return true;
  m_summary.status = Status::invalid_option;
  return false;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_atlas::run(const Rounding& rounded)
{
  m_rounded = rounded;
  if(!has_valid_options())
    return false;
  m_area = m_surface.area();
  std::vector<std::int32_t> all(m_surface.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  m_faces = number_of_polygons(all);
  m_image.assign(all.size(), Image::Constant(std::numeric_limits<double>::quiet_NaN()));
  m_chart_image = m_image;
  const std::vector<std::int32_t> others = keep_what_needs_no_seam(all);
  cut_open(others);
  if(!m_summary.cut.is_valid())
    return fail(m_summary.cut.status, "the surface was not cut open: " + m_summary.cut.message);
  {
    const Phase_timer timer(m_summary.flatten_seconds);
    m_phase = Unwrap_phase::flatten;
    enqueue_parts(others);
    while(!m_queue.empty())
      if(!process_some())
        return false;
    join_crumbs();
  }
  {
    const Phase_timer timer(m_summary.pack_seconds);
    m_phase = Unwrap_phase::pack;
    watch(); // a chart alone is packed before anyone would ask
    split_for_packing([this] { return must_stop(); });
    sort_charts();
    if(!m_options.pack)
      scale_back();
    else if(!pack())
      return false;
  }
  count();
  return certify();
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_atlas::finish()
{
  say_how_it_ended();
  if(m_summary.status == Status::success || m_summary.status == Status::iteration_limit)
    return;
  if(!(m_summary.energy < (std::max)(WORST_ENERGY, std::isfinite(m_options.max_distortion) ? m_options.max_distortion : 0.)))
    fail(Status::interrupted, m_summary.message + ", but the mean energy of the atlas is still " + std::to_string(m_summary.energy));
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<std::int32_t> Chart_atlas::keep_what_needs_no_seam(const std::vector<std::int32_t>& all)
{
  const Phase_timer timer(m_summary.flatten_seconds);
  std::vector<std::int32_t> others;
  cut_sharp_edges();
  m_is_given = m_is_cut;
  ask_deadline();
  enqueue_parts(all);
  std::deque<Piece> parts;
  parts.swap(m_queue);
  if(m_options.is_bounded()) {
    while(!parts.empty())
      for(const auto& part : work_on_some<Seams>(parts, [this](const Piece&piece, Seams&seams) { seams = creases(piece); }))
        for(const std::int32_t h : part.second)
          mark_seam(h);
    enqueue_parts(all);
    parts.swap(m_queue);
  }
  while(!parts.empty())
    for(auto& part : work_on_some<Flat_piece>(parts, [this](const Piece&piece, Flat_piece&flat) { keep_holes(piece, flat); })) {
      if(part.second.is_mapped)
        keep(part.first, part.second.open, part.second.x, part.second.chart);
      else
        others.insert(others.end(), part.first.faces.begin(), part.first.faces.end());
    }
  return others;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_atlas::cut_open(const std::vector<std::int32_t>& faces)
{
  const Phase_timer timer(m_summary.cut_seconds);
  Cut_summary& summary = m_summary.cut;
  const Phase_timer cut_timer(summary.seconds);
  Cut_options options = m_options.cut;
  options.target_energy = first_target();
  options.cut_disks = options.cut_disks || m_options.is_bounded();
  Cut_surface whole;
  summary.status = load_cut_surface(m_surface, m_is_cut, m_is_feature, whole, summary.message);
  if(summary.is_valid())
    describe_surface(whole, summary);
  if(!summary.is_valid())
    return;
  summary.message = "no piece needed seams";
  double area = 0, energy = 0;
  enqueue_parts(faces);
  std::deque<Piece> parts;
  parts.swap(m_queue);
  while(!parts.empty())
    for(const auto& part : work_on_some<Piece_cuts>(
          parts, [&](const Piece&piece, Piece_cuts&cuts) { cuts = cut(piece, open_surface(piece.faces), options); })) {
      const Piece_cuts& cuts = part.second;
      summary.status = cuts.summary.status;
      summary.message = cuts.summary.message;
      if(!summary.is_valid())
        return;
      for(const std::int32_t h : cuts.seams)
        mark_seam(h);
      summary.points += cuts.summary.points;
      if(cuts.summary.expected_energy >= 0) {
        area += cuts.area;
        energy += cuts.area * cuts.summary.expected_energy;
      }
    }
  if(area > 0)
    summary.expected_energy = energy / area;
  std::vector<char> is_cut(whole.number_of_edges());
  for(std::int32_t e = 0; e < whole.number_of_edges(); ++e)
    is_cut[e] = m_is_cut[whole.edge_halfedge[e]];
  describe_seams(whole, is_cut, summary);
  summary.seam_length = std::ldexp(summary.seam_length, m_surface.exponent);
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_atlas::process_some()
{
  std::vector<std::pair<Piece, Flat_piece>> pieces = work_on_some<Flat_piece>(m_queue, [this](Piece& piece, Flat_piece& flat) {
    flatten_and_decide(piece, flat);
    count_ahead(flat);
  });
  for(auto& [piece, flat] : pieces) {
    --m_charts_at_work;
    if(flat.is_ahead) {
      --m_charts_ahead;
      m_faces_ahead -= flat.chart.faces;
    }
    if(flat.failure != Status::success)
      return fail(flat.failure, flat.failure_message);
    if(flat.reason != nullptr)
      ++(m_summary.*flat.reason);
    if(flat.is_cut) {
      for(const std::int32_t h : flat.seams)
        mark_seam(h);
      enqueue_parts(piece.faces, piece);
    } else
      keep(piece, flat.open, flat.x, flat.chart);
  }
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE std::vector<Chart_atlas::Join> Chart_atlas::next_joins(std::vector<int>& trials) const
{
  std::vector<std::int32_t> chart_of(m_surface.triangles.size(), -1);
  std::vector<std::size_t> crumbs;
  for(std::size_t c = 0; c < m_charts.size(); ++c) {
    for(const std::int32_t f : m_charts[c].faces)
      chart_of[f] = static_cast<std::int32_t>(c);
    const Chart_summary& chart = m_summary.charts[c];
    if(!m_charts[c].faces.empty() && chart.faces <= MOST_CRUMB_FACES && chart.area <= MOST_CRUMB_AREA * m_area && trials[c] < MOST_TRIALS)
      crumbs.push_back(c);
  }
  std::stable_sort(crumbs.begin(), crumbs.end(),
                   [this](std::size_t a, std::size_t b) { return m_summary.charts[a].area < m_summary.charts[b].area; });
  std::vector<char> is_busy(m_charts.size(), 0);
  std::vector<Join> joins;
  for(const std::size_t c : crumbs) {
    if(is_busy[c])
      continue;
    double perimeter;
    const std::vector<Chart_contact> contacts = chart_contacts(
      m_surface, m_charts[c].faces, chart_of, [this](std::int32_t h) { return !m_is_given[h]; }, perimeter);
    while(trials[c] < MOST_TRIALS) {
      const std::size_t k = static_cast<std::size_t>(trials[c]);
      if(k >= contacts.size() || contacts[k].length < LEAST_CONTACT * perimeter) {
        trials[c] = MOST_TRIALS;
        break;
      }
      const std::size_t neighbor = static_cast<std::size_t>(contacts[k].neighbor);
      if(is_busy[neighbor])
        break; // in a later round
      ++trials[c];
      if(m_charts[neighbor].faces.size() <= FEW_FACES && m_summary.charts[c].area <= MOST_OF_NEIGHBOR * m_summary.charts[neighbor].area) {
        is_busy[c] = is_busy[neighbor] = 1;
        joins.push_back({c, neighbor, contacts[k].halfedges, {}});
        break;
      }
    }
  }
  return joins;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_atlas::is_good_enough(const Join& join, const Piece& piece, const Flat_piece& flat) const
{
  const Chart_summary &crumb = m_summary.charts[join.crumb], &neighbor = m_summary.charts[join.neighbor];
  const auto loss = [](const Chart_summary& chart) { return (chart.energy - 1) * chart.area; };
  return flat.is_mapped && !flat.is_overlapping && !is_too_distorted(flat.chart) && !is_too_long(piece, flat.x) &&
         loss(flat.chart) <= loss(neighbor) + (m_options.max_distortion - 1) * crumb.area;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_atlas::join_crumbs()
{
  if(!m_options.is_bounded())
    return;
  std::vector<int> trials(m_charts.size(), 0);
  while(!is_late()) {
    std::vector<Join> joins = next_joins(trials);
    if(joins.empty())
      break;
    std::deque<Piece> unions;
    for(Join& join : joins) {
      for(const std::int32_t h : join.seams)
        close_seam(h);
      Piece piece;
      for(const std::size_t c : {join.neighbor, join.crumb})
        piece.faces.insert(piece.faces.end(), m_charts[c].faces.begin(), m_charts[c].faces.end());
      std::sort(piece.faces.begin(), piece.faces.end());
      for(const std::int32_t f : piece.faces)
        join.images.push_back(m_image[f]);
      lay_beside(m_charts[join.crumb].faces, join.seams);
      unions.push_back(std::move(piece));
    }
    for(auto join = joins.begin(); !unions.empty();)
      for(auto& [piece, flat] : work_on_some<Flat_piece>(unions, [this](Piece&p, Flat_piece&f) { flatten_union(p, f); })) {
        if(is_good_enough(*join, piece, flat)) {
          m_charts[join->neighbor] = {flat.open.surface.triangles, std::move(flat.x), std::move(piece.faces)};
          m_summary.charts[join->neighbor] = flat.chart;
          m_charts[join->crumb].faces.clear();
          ++m_summary.joined_charts;
        } else {
          for(const std::int32_t h : join->seams)
            mark_seam(h);
          for(std::size_t i = 0; i < piece.faces.size(); ++i)
            m_image[piece.faces[i]] = join->images[i];
        }
        ++join;
      }
    m_charts_at_work = 0;
  }
  std::size_t kept = 0;
  for(std::size_t c = 0; c < m_charts.size(); ++c)
    if(!m_charts[c].faces.empty()) {
      if(c != kept) {
        m_charts[kept] = std::move(m_charts[c]);
        m_summary.charts[kept] = std::move(m_summary.charts[c]);
      }
      ++kept;
    }
  m_charts.resize(kept);
  m_summary.charts.resize(kept);
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_atlas::count_ahead(Flat_piece& flat)
{
  flat.is_ahead = !flat.is_cut && flat.failure == Status::success;
  if(!flat.is_ahead)
    return;
  ++m_charts_ahead;
  m_faces_ahead += flat.chart.faces;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_atlas::pack()
{
  // Half the distance of the numbers below 1.
  const Positions<2> third = Positions<2>::Constant(2, 1, 1. / 3);
  const double precision = (std::max)((m_rounded(third) - third).cwiseAbs().maxCoeff(), 0.5 * std::numeric_limits<double>::epsilon());
  std::vector<int> attempts(m_charts.size(), 0);
  Packing_summary packing;
  for(;;) {
    std::size_t chart = 0;
    pack_flat_charts(m_charts, m_options.packing, m_obstacles, m_rounded, packing, &chart, [this] { return must_stop(); });
    if(packing.is_valid())
      break;
    if(packing.status != Status::result_not_representable || ++attempts[chart] > 3 ||
       !thicken(chart, precision * std::pow(30., attempts[chart]) / packing.scale))
      return fail(packing.status, "the charts were not packed: " + packing.message);
  }
  m_summary.scale = std::ldexp(packing.scale, -m_surface.exponent);
  m_summary.occupancy = packing.occupancy;
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_atlas::scale_back()
{
  m_summary.scale = 1;
  double right = 0;
  for(Flat_chart& chart : m_charts) {
    chart.x = chart.x.unaryExpr([this](double c) { return std::ldexp(c, m_surface.exponent); }).eval();
    const Vector<2> size = extent(chart.x);
    Positions<2> moved = chart.x.colwise() - Vector<2>(chart.x.rowwise().minCoeff());
    moved.row(0).array() += right;
    right += size[0] + 0.01 * size.norm();
    moved = m_rounded(moved);
    // Far from the origin numbers may be too coarse.
    chart.x = is_bijective(chart.elements, moved) ? moved : m_rounded(chart.x);
  }
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_atlas::certify()
{
  const Unbound_work certificate;
  const Phase_timer timer(m_summary.certify_seconds);
  std::vector<Positions<2>> positions;
  std::string message;
  for(const Flat_chart& chart : m_charts) {
    if(!m_options.pack && !is_bijective(chart.elements, chart.x, &message))
      return fail(Status::result_not_representable, "in the number type of the result " + message);
    positions.push_back(chart.x);
  }
  std::vector<std::array<std::int32_t, 3>> elements;
  const Positions<2> all = joined_charts(m_charts, positions, elements);
  if(m_options.pack && !is_bijective(elements, all, &message))
    return fail(Status::result_not_representable, "in the number type of the result " + message);
  m_summary.flips = 0;
  return true;
}

CGAL_FLIP_FREE_MAPS_INLINE void Chart_atlas::say_how_it_ended()
{
  const auto ended = [this](Status status) {
    return std::any_of(m_summary.charts.begin(), m_summary.charts.end(), [=](const Chart_summary& c) { return c.status == status; });
  };
  m_summary.status = Status::success;
  m_summary.message = "all charts converged; none overlaps another or itself";
  if(m_is_stopped) {
    m_summary.status = Status::stopped_by_observer;
    m_summary.message = "the observer asked to stop; charts without overlaps were made of what there was";
  } else if(ended(Status::stopped_by_observer) || deadline_status() == Status::stopped_by_observer) {
    m_summary.status = Status::stopped_by_observer;
    m_summary.message = "the run was cancelled; charts without overlaps were made of what there was";
  } else if(ended(Status::time_limit) || m_is_cut_short || has_made_haste()) {
    m_summary.status = Status::time_limit;
    m_summary.message = "the time was up before all charts were as good as can be; none overlaps another or itself";
  } else if(ended(Status::iteration_limit)) {
    m_summary.status = Status::iteration_limit;
    m_summary.message = "not all charts converged within the limit of iterations; none overlaps another or itself";
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_IMPL_H
