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
#include <CGAL/Flip_free_maps/atlas/internal/Chart_creases.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_maps.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_splitter.h>
#include <CGAL/Flip_free_maps/atlas/internal/Chart_zipper.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_planner.h>
#include <CGAL/Flip_free_maps/cutting/internal/Cut_surface.h>
#include <CGAL/Flip_free_maps/cutting/internal/cut_mesh.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/for_each_index.h>
#include <CGAL/Flip_free_maps/internal/for_each_index_watched.h>
#include <CGAL/Flip_free_maps/measure/internal/Distortion_measure.h>
#include <CGAL/Flip_free_maps/minimizer/Map_minimizer.h>
#include <CGAL/Flip_free_maps/parameterization/internal/parameterize_patch.h>
#include <CGAL/Flip_free_maps/parameterization/internal/solve_planar.h>
#include <CGAL/Flip_free_maps/report/Deadline.h>

#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// From flat arrays of triangles to charts without overlaps.
template <typename Traits>
class Chart_atlas : public Chart_maps
{
public:
  Chart_atlas(const Linked_triangles& surface, double begin, const Traits& traits, const Unwrap_options& options, Unwrap_summary& summary)
    : Chart_maps(surface, begin, options, summary), m_traits(traits)
  {}

  // Cuts, flattens, packs, and tests the atlas in the numbers that points of the given type can hold.
  template <typename Point>
  bool run()
  {
    if(!m_options.is_valid(&m_summary.message) || !m_traits.options.is_valid(&m_summary.message)) {
      m_summary.status = Status::invalid_option;
      return false;
    }
    m_area = m_surface.area();
    std::vector<std::int32_t> all(m_surface.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    m_faces = number_of_polygons(all);
    m_image.assign(all.size(), Image::Constant(std::numeric_limits<double>::quiet_NaN()));
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
    }
    {
      const Phase_timer timer(m_summary.pack_seconds);
      m_phase = Unwrap_phase::pack;
      split_for_packing([this] { return must_stop(); });
      sort_charts();
      if(!m_options.pack)
        scale_back<Point>();
      else if(!pack<Point>())
        return false;
    }
    count();
    return certify();
  }

  // Says how it ended when all is done. An atlas that was cut short and is of no use is none.
  void finish()
  {
    say_how_it_ended();
    if(m_summary.status == Status::success || m_summary.status == Status::iteration_limit)
      return;
    if(!(m_summary.energy < (std::max)(WORST_ENERGY, std::isfinite(m_options.max_distortion) ? m_options.max_distortion : 0.)))
      fail(Status::interrupted, m_summary.message + ", but the mean energy of the atlas is still " + std::to_string(m_summary.energy));
  }

private:
  // Does the same for each of the first pieces of a queue, which leave it, at the same time if there are threads. The results are in
  // the pieces' order, and effects are the caller's part, so that nothing depends on threads.
  template <typename Result, typename Work>
  std::vector<std::pair<Piece, Result>> work_on_some(std::deque<Piece>& queue, const Work& work)
  {
    // The method's observer sees pieces one by one. The numbers bound the memory for open pieces.
    const bool is_parallel = !m_traits.options.observer && std::is_convertible<typename Traits::Concurrency_tag, CGAL::Parallel_tag>::value;
    const std::size_t most = is_parallel ? MOST_PIECES : 1;
    std::vector<std::pair<Piece, Result>> done;
    for(std::size_t faces = 0; !queue.empty() && done.size() < most && faces < MOST_FACES; queue.pop_front()) {
      faces += queue.front().faces.size();
      done.emplace_back(std::move(queue.front()), Result());
    }
    m_charts_at_work = static_cast<int>(done.size());
    report_progress();
    const auto work_on_one = [&, binding = Deadline::state()](std::size_t i) {
      const Bound_work bound(binding);
      work(done[i].first, done[i].second);
    };
    if(m_options.observer)
      for_each_index_watched<typename Traits::Concurrency_tag>(done.size(), work_on_one, [this] { watch(); });
    else
      for_each_index<typename Traits::Concurrency_tag>(done.size(), work_on_one);
    return done;
  }

  // Cuts sharp edges and creases, makes charts of pieces that need no seam, and returns the faces of all others.
  std::vector<std::int32_t> keep_what_needs_no_seam(const std::vector<std::int32_t>& all)
  {
    const Phase_timer timer(m_summary.flatten_seconds);
    std::vector<std::int32_t> others;
    cut_sharp_edges();
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

  // The seams of a piece, as halfedges of the surface, and what is said of them.
  using Seams = std::vector<std::int32_t>;
  struct Piece_cuts
  {
    Seams seams;
    Cut_summary summary;
    double area = 0;
  };

  // Cuts pieces open, and describes the surface as a whole.
  void cut_open(const std::vector<std::int32_t>& faces)
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

  // Plans seams of a piece.
  Piece_cuts cut(const Piece& piece, const Linked_triangles& open, const Cut_options& options)
  {
    const std::int32_t size = static_cast<std::int32_t>(open.opposite.size());
    std::vector<char> is_cut(size, 0), is_feature(size);
    for(std::int32_t h = 0; h < size; ++h)
      is_feature[h] = m_is_feature[original_halfedge(piece, h)];
    Piece_cuts cuts;
    cuts.area = open.area();
    cuts.summary = cut_triangles(open, is_cut, is_feature, options, [this] { return must_stop(); });
    for(std::int32_t h = 0; h < size && cuts.summary.is_valid(); ++h)
      if(is_cut[h])
        cuts.seams.push_back(original_halfedge(piece, h));
    return cuts;
  }

  void say_how_it_ended()
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
    } else if(ended(Status::time_limit) || m_is_cut_short || m_late_since != 0) {
      m_summary.status = Status::time_limit;
      m_summary.message = "the time was up before all charts were as good as can be; none overlaps another or itself";
    } else if(ended(Status::iteration_limit)) {
      m_summary.status = Status::iteration_limit;
      m_summary.message = "not all charts converged within the limit of iterations; none overlaps another or itself";
    }
  }

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
      pack_flat_charts<Point>(m_charts, m_options.packing, packing, &chart, [this] { return must_stop(); });
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

  // Flattens a chart anew after its vertices were moved in space by at most a length, to and fro:
  // hardly any triangle is much thinner than that then.
  bool thicken(std::size_t number, double length)
  {
    const Piece piece{m_charts[number].faces, true};
    const Open_piece open = this->open(piece.faces);
    Open_piece moved = open;
    std::uint32_t noise = 1;
    Positions<3>& points = moved.surface.points;
    for(Eigen::Index v = 0; v < points.cols(); ++v) {
      for(int i = 0; i < 3; ++i) {
        noise = noise * 1664525u + 1013904223u;
        points(i, v) += length * (noise / 2147483648. - 1);
      }
      moved.mesh.point(Vertex(static_cast<Mesh::size_type>(v))) = {points(0, v), points(1, v), points(2, v)};
    }
    Positions<2> x;
    const Summary summary = flatten_piece(moved, x);
    if(!summary.is_valid() || !draw_apart(open, x))
      return false;
    Chart_summary& chart = m_summary.charts[number];
    const double area = chart.area;
    measure(piece, open, x, chart);
    chart.area = area;
    m_charts[number].x.swap(x);
    return true;
  }

  // Charts in the units of the surface, side by side.
  template <typename Point>
  void scale_back()
  {
    m_summary.scale = 1;
    double right = 0;
    for(Flat_chart& chart : m_charts) {
      chart.x = chart.x.unaryExpr([this](double c) { return std::ldexp(c, m_surface.exponent); }).eval();
      const Vector<2> size = extent(chart.x);
      Positions<2> moved = chart.x.colwise() - Vector<2>(chart.x.rowwise().minCoeff());
      moved.row(0).array() += right;
      right += size[0] + 0.01 * size.norm();
      moved = as_rounded_by<Point>(moved);
      // Far from the origin numbers may be too coarse.
      chart.x = is_bijective(chart.elements, moved) ? moved : as_rounded_by<Point>(chart.x);
    }
  }

  // The last word on the numbers that the caller receives.
  bool certify()
  {
    const Unbound_work certificate;
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

  // Asks the observer and looks at the clock, while seams are planned and charts are packed; remembers that it cut them short.
  bool must_stop()
  {
    report_progress();
    if(is_late())
      m_is_cut_short = true;
    return m_is_cut_short;
  }

  // Asks the observer, on the caller's thread only. False once it has asked to stop.
  bool report_progress()
  {
    if(!m_options.observer || m_is_stopped || std::this_thread::get_id() != m_thread)
      return !m_is_stopped;
    Unwrap_progress progress;
    progress.phase = m_phase;
    progress.faces_done = m_faces_done + m_faces_ahead;
    progress.faces = m_faces;
    const int kept = static_cast<int>(m_charts.size());
    progress.charts_done = kept + m_charts_ahead;
    progress.charts = kept + (std::max)(m_charts_at_work, m_faces_done < m_faces ? 1 : 0) + static_cast<int>(m_queue.size());
    progress.seconds = wall_seconds() - m_begin;
    if(!m_options.observer(progress))
      m_is_stopped = true;
    return !m_is_stopped;
  }

  // Asks the observer while others are at work, who end soon when it throws.
  void watch()
  {
    try {
      report_progress();
    } catch(...) {
      m_is_stopped = true;
      throw;
    }
  }

  // What is asked of the map of a piece.
  struct Map_request
  {
    bool is_convex = false;                               // whether the start will do, which has a convex border
    bool has_start = false;                               // whether to begin with the given map
    std::function<bool(const Positions<2>&)> is_hopeless; // whether a rough map is enough; see `Planar_request`
  };

  // A piece that has no map when the time is up gets one that is good enough, or none if that takes long.
  Summary flatten_piece(const Open_piece& open, Positions<2>& x, const Map_request& request = Map_request())
  {
    if(!is_late())
      return flatten_piece(open, x, request, m_traits);
    double late_since = m_late_since;
    if(late_since == 0)
      m_late_since = late_since = wall_seconds();
    const Unbound_work work;
    const Deadline last(late_since + GRACE - wall_seconds(), nullptr, 0);
    Traits traits = m_traits;
    traits.start.multilevel_size = -1;
    traits.options.target_energy = (std::max)(traits.options.target_energy, GOOD_ENOUGH);
    // A limit for each chart is one for charts that come in time.
    traits.options.max_seconds = std::numeric_limits<double>::infinity();
    return flatten_piece(open, x, request, traits);
  }

  Summary flatten_piece(const Open_piece& open, Positions<2>& x, const Map_request& request, Traits traits)
  {
    Summary summary;
    const Halfedge border = longest_border(open);
    if(request.is_convex)
      traits.options.max_iterations = 0;
    if(m_is_stopped || request.is_convex)
      traits.start.multilevel_size = -1;
    traits.start.unfold = traits.start.unfold && !request.is_convex;
    traits.options.observer = [this, given = m_traits.options.observer](const Iteration_report& report) {
      if(given && !m_is_stopped && !given(report))
        m_is_stopped = true;
      return report_progress();
    };
    if(m_is_stopped)
      traits.options.observer = nullptr; // who has said all
    std::vector<Point_2> uv(open.surface.points.cols());
    const auto uv_map = boost::make_iterator_property_map(uv.begin(), get(boost::vertex_index, open.mesh));
    const auto prepare = [&](const auto& graph, Planar_request& planar, std::string&) {
      const auto* vertices = &graph.vertices();
      const double scale = graph.domain().scale;
      if(request.has_start)
        planar.make_start = [vertices, scale, given = x](Positions<2>& y, std::string& name, std::string&) {
          name = "the map of a larger chart";
          y.resize(2, vertices->size());
          for(std::size_t v = 0; v < vertices->size(); ++v)
            y.col(v) = given.col((*vertices)[v]) / scale;
          return Status::success;
        };
      if(request.is_hopeless)
        planar.is_hopeless = [vertices, scale, &request](const Positions<2>& y) {
          Positions<2> z(2, y.cols());
          for(std::size_t v = 0; v < vertices->size(); ++v)
            z.col((*vertices)[v]) = scale * y.col(v);
          return request.is_hopeless(z);
        };
      return Status::success;
    };
    Planar_solver<Traits> solver{traits};
    summary = parameterize_patch(
      open.mesh, border, open.mesh.points(), uv_map, traits.options, true, prepare, [](Vertex, Vector<2>&) { return false; }, solver);
    x.resize(2, uv.size());
    if(summary.is_valid())
      for(std::size_t v = 0; v < uv.size(); ++v)
        x.col(v) << uv[v].x(), uv[v].y();
    return summary;
  }

  // Leads the sides of seams that lie over each other back to where they do not. Returns whether the map was changed.
  bool zip(const Piece& piece, const Open_piece& open, Positions<2>& x) const
  {
    bool is_changed = false;
    if constexpr(IS_ZIPPING) {
      const std::vector<std::int32_t> twins = this->twins(piece, open);
      const Chart_zipper zipper(open.surface, open.border, twins, ZIPPED_GAPS * gap());
      for(int round = 0; round < MOST_ROUNDS && !is_late(); ++round) {
        bool is_changed_now = false;
        std::vector<char> is_done(twins.size(), 0);
        for(const Crossing& crossing : crossings(open, with_moved_border(open, x, gap()))) {
          const std::int32_t i = crossing.edges[0], j = crossing.edges[1];
          if(is_done[i] || is_done[j] || !zipper.is_zippable(i, j))
            continue;
          is_done[i] = is_done[j] = 1;
          const Chart_zipper::Stretch stretch = zipper.stretch(x, i, j);
          for(const std::int32_t e : stretch)
            is_done[e] = is_done[twins[e]] = 1;
          Chart_zipper::Patch patch;
          if(!stretch.empty() && zipper.make_patch(x, stretch, patch) && relax(patch))
            is_changed_now = put(patch, x) || is_changed_now;
        }
        if(!is_changed_now)
          break;
        is_changed = true;
      }
    }
    return is_changed;
  }

  // Moves a part of a map to its targets.
  bool relax(Chart_zipper::Patch& patch) const
  {
    Traits traits = m_traits;
    // Whoever does not get there soon would be distorted too much.
    traits.options.observer = [steps = 0](const Iteration_report&) mutable { return ++steps <= MOST_STEPS; };
    traits.options.relative_energy_tolerance = (std::max)(traits.options.relative_energy_tolerance, ROUGH);
    Map_minimizer<2, Traits> minimizer(patch.domain, traits, patch.constraints);
    const Summary summary = minimizer.move_fixed_vertices(patch.x, patch.targets);
    return summary.is_valid() && (patch.x - patch.targets)(Eigen::all, patch.constraints.fixed_vertices).isZero(0) &&
           summary.energy - summary.energy_initial <= MOST_INCREASE;
  }

  // Puts a part of a map into the whole if nothing flips.
  static bool put(const Chart_zipper::Patch& patch, Positions<2>& x)
  {
    for(const auto& v : patch.domain.elements)
      if(CGAL::orientation(exact_point(patch.x, v[0]), exact_point(patch.x, v[1]), exact_point(patch.x, v[2])) != CGAL::LEFT_TURN)
        return false;
    for(std::size_t v = 0; v < patch.vertices.size(); ++v)
      x.col(patch.vertices[v]) = patch.unit * patch.x.col(v);
    return true;
  }

  // A piece and its map, if it has one, how good that is, and what becomes of it: seams, along which it is cut, or a failure; else a
  // chart.
  struct Flat_piece
  {
    Open_piece open;
    Positions<2> x;
    Chart_summary chart;
    bool is_mapped = false, is_inherited = false, is_overlapping = false;
    bool is_ahead = false;   // a chart, as it seems, that waits for its turn
    std::int32_t worst = -1; // the triangle that is distorted most
    Seams seams;
    int Unwrap_summary::*reason = nullptr; // for a split
    bool is_cut = false;
    Status failure = Status::success; // any other one is
    std::string failure_message;
  };

  // Flattens some pieces of the queue, and keeps them as charts, cuts or splits them one by one. False when none of that is possible.
  bool process_some()
  {
    std::vector<std::pair<Piece, Flat_piece>> pieces = work_on_some<Flat_piece>(m_queue, [this](Piece& piece, Flat_piece& flat) {
      flatten(piece, flat);
      decide(piece, flat);
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

  void flatten(const Piece& piece, Flat_piece& flat)
  {
    const double begin = wall_seconds();
    flat.open = this->open(piece.faces);
    const Open_piece& open = flat.open;
    Chart_summary& chart = flat.chart;
    chart.faces = number_of_polygons(piece.faces);
    Map_request request;
    request.has_start = piece.is_part && open.is_mesh && inherit(piece, open, flat.x);
    if(request.has_start) {
      chart.message = "a part of a larger chart";
      settle(piece, flat);
      flat.is_mapped = flat.is_overlapping ? can_be_split(piece) : !is_too_distorted(chart);
    }
    if(flat.is_mapped) {
      chart.seconds = wall_seconds() - begin;
      return;
    }
    if(is_late() && inherit(piece, open, flat.x)) {
      chart.status = m_is_stopped ? Status::stopped_by_observer : deadline_status();
      chart.message = "a part of a larger chart, as it was when the time was up";
      flat.is_mapped = true;
    } else if(open.is_mesh) {
      if(can_be_split(piece) && m_options.is_bounded() && piece.faces.size() > FEW_FACES)
        request.is_hopeless = [this, &piece, &open](const Positions<2>& x) { return has_far_crossing(piece, open, x); };
      Summary summary = flatten_piece(open, flat.x, request);
      // Rounding may flip a thin triangle of a map that is scaled.
      if(summary.status == Status::start_not_flip_free && request.has_start) {
        request.has_start = false;
        summary = flatten_piece(open, flat.x, request);
      }
      chart.status = summary.status;
      chart.message = summary.message;
      chart.iterations = summary.iterations;
      flat.is_mapped = summary.is_valid();
      flat.is_inherited = !flat.is_mapped && inherit(piece, open, flat.x);
    } else {
      chart.status = Status::non_manifold;
      chart.message = "two edges of the chart have the same vertices";
    }
    if(flat.is_mapped || flat.is_inherited) {
      settle(piece, flat);
      if(flat.is_overlapping && !can_be_split(piece)) {
        request = Map_request();
        request.is_convex = true;
        flat.is_mapped = flatten_piece(open, flat.x, request).is_valid();
        flat.is_overlapping = flat.is_mapped && !draw_apart(open, flat.x);
        flat.worst = measure(piece, open, flat.x, chart);
      }
    }
    chart.seconds = wall_seconds() - begin;
  }

  // Measures a map, and removes overlaps where the map need not become much worse for that.
  void settle(const Piece& piece, Flat_piece& flat)
  {
    flat.is_overlapping = !draw_apart(flat.open, flat.x);
    flat.worst = measure(piece, flat.open, flat.x, flat.chart);
    if(!flat.is_overlapping || !can_be_split(piece) || !m_options.is_bounded() || is_too_distorted(flat.chart))
      return;
    Positions<2> x = flat.x;
    if(has_far_crossing(piece, flat.open, x) || !zip(piece, flat.open, x))
      return;
    Chart_summary chart = flat.chart;
    const bool is_overlapping = !draw_apart(flat.open, x);
    const std::int32_t worst = measure(piece, flat.open, x, chart);
    if(is_too_distorted(chart)) {
      measure(piece, flat.open, flat.x, flat.chart);
      return;
    }
    flat.is_overlapping = is_overlapping;
    flat.worst = worst;
    flat.chart = chart;
    flat.x.swap(x);
  }

  // Whether a map overlaps itself elsewhere than at the sides of a seam.
  bool has_far_crossing(const Piece& piece, const Open_piece& open, const Positions<2>& x) const
  {
    const std::vector<Crossing> all = crossings(open, x);
    if(all.empty())
      return false;
    const std::vector<std::int32_t> twins = this->twins(piece, open);
    const Chart_zipper zipper(open.surface, open.border, twins, gap());
    return std::any_of(all.begin(), all.end(), [&](const Crossing& c) { return !zipper.is_zippable(c.edges[0], c.edges[1]); });
  }

  // For the observer a piece is a chart as soon as that is decided.
  void count_ahead(Flat_piece& flat)
  {
    flat.is_ahead = !flat.is_cut && flat.failure == Status::success;
    if(!flat.is_ahead)
      return;
    ++m_charts_ahead;
    m_faces_ahead += flat.chart.faces;
  }

  // What becomes of a piece.
  void decide(Piece& piece, Flat_piece& flat)
  {
    const Open_piece& open = flat.open;
    Chart_summary& chart = flat.chart;
    const auto face = [&] { return "face number " + std::to_string(m_surface.polygons[piece.faces[0]]); };
    if(chart.status == Status::out_of_memory || chart.status == Status::invalid_option ||
       (chart.status == Status::interrupted && !flat.is_inherited))
      return give_up(flat, chart.status, chart.message);
    if((chart.status == Status::not_a_disk || chart.status == Status::no_border) && !piece.was_cut) {
      Cut_options cut = m_options.cut;
      cut.branches = Cut_options::Branches::none;
      piece.was_cut = true;
      cut_again(piece, flat, cut);
      flat.is_cut = true;
      return;
    }
    if(flat.is_inherited) {
      chart.status = Status::success;
      chart.message = "a part of a larger chart; not on its own: " + chart.message;
    }
    if(!flat.is_mapped && !flat.is_inherited) {
      if(!can_be_split(piece))
        return give_up(flat, chart.status, face() + " cannot be flattened: " + chart.message);
      return split(piece, flat, {{0, 0}}, &Unwrap_summary::splits_of_failures);
    }
    if(flat.is_overlapping) {
      if(!can_be_split(piece))
        return give_up(flat, Status::result_not_representable, face() + " was not laid flat without overlaps");
      piece.is_part = m_options.is_bounded() && excess(chart) < (piece.faces.size() > FEW_FACES ? WORST_EXCESS : 1);
      return split(piece, flat, overlaps(piece, open, flat.x), &Unwrap_summary::splits_of_overlaps);
    }
    // Without time for flattening a part is as distorted as the whole.
    if(is_too_distorted(chart) && can_be_split(piece) && !is_late()) {
      if(cut_for_less_distortion(piece, flat))
        return;
      piece.is_part = false;
      return split(piece, flat, {{flat.worst, -1}}, &Unwrap_summary::splits_of_distortion);
    }
    if(is_too_long(piece, flat.x)) {
      piece.is_part = true;
      split(piece, flat, {{0, 0}}, &Unwrap_summary::splits_of_length);
    }
  }

  static void give_up(Flat_piece& flat, Status status, const std::string& message)
  {
    flat.failure = status;
    flat.failure_message = message;
  }

  // Cuts a piece by more seams where less distortion is expected of them, and tells whether it found any, or failed.
  bool cut_for_less_distortion(Piece& piece, Flat_piece& flat)
  {
    if(piece.recuts >= MOST_RECUTS || !flat.open.is_mesh || m_options.cut.branches != Cut_options::Branches::extremities)
      return false;
    Cut_options cut = m_options.cut;
    cut.cut_disks = true;
    cut.target_energy = piece.target > 0 ? piece.target : first_target();
    ++piece.recuts;
    // Less is expected in the proportion of what is wanted to what came out, and less again if that was so already.
    double factor = CAUTION / excess(flat.chart);
    for(int i = 0; i < MOST_RECUTS && !flat.is_cut && flat.failure == Status::success; ++i, factor = 0.5) {
      cut.target_energy = 1 + factor * (cut.target_energy - 1);
      cut_again(piece, flat, cut);
    }
    piece.target = cut.target_energy;
    if(flat.is_cut)
      piece.is_part = piece.faces.size() > FEW_FACES && excess(flat.chart) < WORST_EXCESS;
    return flat.is_cut || flat.failure != Status::success;
  }

  // The energy that is expected when the surface is cut for the first time. Maps turn out better than that, since their borders
  // are free; those that do not are cut again.
  double first_target() const { return (std::min)(m_options.cut.target_energy, 1 + HOPE * (m_options.max_distortion - 1)); }

  // Flattens a piece with its holes where joining the borders by seams gains nothing: where it is nearly flat. It has no map else.
  void keep_holes(const Piece& piece, Flat_piece& flat)
  {
    ask_deadline();
    const double most_missing = 2 * CGAL_PI, most_energy = (std::min)(1.01, m_options.max_distortion);
    if(!m_options.cut.join_borders)
      return;
    flat.open = this->open(piece.faces);
    if(!flat.open.is_mesh || !(missing_angles(flat.open) <= most_missing))
      return;
    const double begin = wall_seconds();
    const Summary summary = flatten_piece(flat.open, flat.x);
    if(!summary.is_valid())
      return;
    Chart_summary& chart = flat.chart;
    chart.status = summary.status;
    chart.message = summary.message;
    chart.faces = number_of_polygons(piece.faces);
    chart.iterations = summary.iterations;
    const bool overlaps = !draw_apart(flat.open, flat.x);
    measure(piece, flat.open, flat.x, chart);
    flat.is_mapped = chart.energy <= most_energy && !overlaps;
    if(!flat.is_mapped)
      for(const std::int32_t f : piece.faces)
        m_image[f].setConstant(std::numeric_limits<double>::quiet_NaN());
    chart.seconds = wall_seconds() - begin;
  }

  // Pairs of triangles that lie over each other where the border crosses itself, but only those that are no sides of a seam there, if
  // there are any; the same one twice if it crosses itself nowhere.
  std::vector<std::pair<std::int32_t, std::int32_t>> overlaps(const Piece& piece, const Open_piece& open, const Positions<2>& x) const
  {
    std::vector<Crossing> all = crossings(open, x), far = all;
    const std::vector<std::int32_t> twins = this->twins(piece, open);
    const Chart_zipper zipper(open.surface, open.border, twins, gap());
    far.erase(std::remove_if(far.begin(), far.end(), [&](const Crossing& c) { return zipper.is_zippable(c.edges[0], c.edges[1]); }),
              far.end());
    std::vector<std::pair<std::int32_t, std::int32_t>> result;
    for(const Crossing& crossing : far.empty() ? all : far)
      result.emplace_back(open.border.edges()[crossing.edges[0]].element, open.border.edges()[crossing.edges[1]].element);
    if(result.empty())
      result.emplace_back(0, 0);
    return result;
  }

  // Splits between pairs of triangles; the second is far from the first if there is none, and both from each other if they are the
  // same. Parts that will have new maps may not need more than the first split.
  void split(const Piece& piece, Flat_piece& flat, std::vector<std::pair<std::int32_t, std::int32_t>> seeds, int Unwrap_summary::*reason)
  {
    Chart_splitter splitter(flat.open.surface);
    std::pair<std::int32_t, std::int32_t>& first = seeds.front();
    if(first.second < 0)
      first.second = splitter.farthest_from(first.first);
    if(first.first == first.second)
      first = splitter.far_apart();
    std::vector<Chart_splitter::Edge> edges = splitter.separate(seeds, piece.is_part ? MOST_SPLITS : 1);
    // Polygons whose centres coincide have no distance, and those of the same polygon none from anything.
    if(edges.empty())
      edges = splitter.around(seeds.front().first);
    for(const Chart_splitter::Edge& edge : edges)
      flat.seams.push_back(original_halfedge(piece, edge.halfedge));
    flat.is_cut = true;
    flat.reason = reason;
  }

  // Cuts the surface along the edges that are to be seams because of their angle.
  void cut_sharp_edges()
  {
    if(!std::isfinite(m_options.seam_angle))
      return;
    for(std::int32_t h = 0; h < static_cast<std::int32_t>(m_surface.opposite.size()); ++h)
      if(h < m_surface.opposite[h] && turns_by(h, m_options.seam_angle))
        mark_seam(h);
  }

  // Whether the surface turns by at least an angle across the edge of a halfedge, which has two triangles.
  bool turns_by(std::int32_t h, double angle) const
  {
    return !m_surface.is_diagonal(h) &&
           turning_angle(m_surface.triangles[h / 3], m_surface.triangles[m_surface.opposite[h] / 3], m_surface.points) >= angle;
  }

  // The creases along which a piece of flat and rolled regions is to be cut.
  Seams creases(const Piece& piece)
  {
    ask_deadline();
    Seams seams;
    bool is_any = false;
    for(std::size_t i = 0; i < piece.faces.size() && !is_any; ++i)
      for(std::int32_t h = 3 * piece.faces[i]; h < 3 * piece.faces[i] + 3; ++h)
        is_any = is_any || (neighbor(h) >= 0 && turns_by(h, m_options.crease_angle));
    if(is_any) {
      const Linked_triangles open = open_surface(piece.faces);
      for(const std::int32_t h : Chart_creases(open, m_options.crease_angle).cuts())
        seams.push_back(original_halfedge(piece, h));
    }
    return seams;
  }

  // Cuts a piece by more seams if there are any: the parts of a split surface need not be disks, and the distortion that was expected
  // is not the true one.
  void cut_again(const Piece& piece, Flat_piece& flat, const Cut_options& options)
  {
    Piece_cuts cuts = cut(piece, flat.open.surface, options);
    if(!cuts.summary.is_valid())
      return give_up(flat, cuts.summary.status, "a part of the surface was not cut open: " + cuts.summary.message);
    flat.seams.swap(cuts.seams);
    flat.is_cut = !flat.seams.empty();
  }

  // Pieces at work at the same time, and their triangles.
  static constexpr std::size_t MOST_PIECES = 256, MOST_FACES = 100000;
  static constexpr int MOST_RECUTS = 3;
  // Splits of a piece before its parts are looked at, and rounds in which the sides of seams are led apart.
  static constexpr int MOST_SPLITS = 64, MOST_ROUNDS = 3;
  // The excess of distortion below which what is left of a piece begins with its map: what is distorted a little too much as a whole
  // may be good enough in parts.
  static constexpr double WORST_EXCESS = 2;
  // New maps of pieces with at most so many triangles take no time, and a good map overlaps itself less than a rough one.
  static constexpr std::size_t FEW_FACES = 20000;
  // Half the distance between sides of a seam that were led apart, over the least one.
  static constexpr double ZIPPED_GAPS = 5;
  // Steps of a part of a map on its way, and the most by which its energy may increase.
  static constexpr int MOST_STEPS = 20;
  static constexpr double MOST_INCREASE = 0.1;
  // Only such minimizers lead vertices along.
  static constexpr bool IS_ZIPPING = std::is_same<typename Traits::template Minimizer<2, Traits>, Map_minimizer<2, Traits>>::value;
  // Mean energies: of an atlas that is cut short, and at which a chart that is made when the time is up ends.
  static constexpr double WORST_ENERGY = 2, GOOD_ENOUGH = 1.5;
  // Seconds for charts that have no map when the time is up.
  static constexpr double GRACE = 0.8;
  // What is expected over what comes out, of energies above 1; and the part of what is wanted that is asked for the second time.
  static constexpr double HOPE = 3, CAUTION = 0.8;

  Traits m_traits;
  std::int64_t m_faces = 0; // polygons of the user's
  Unwrap_phase m_phase = Unwrap_phase::cut;
  int m_charts_at_work = 0; // pieces that are neither charts nor in the queue
  std::atomic<int> m_charts_ahead{0};
  std::atomic<std::int64_t> m_faces_ahead{0};
  const std::thread::id m_thread = std::this_thread::get_id();
  std::atomic<bool> m_is_cut_short{false};
  std::atomic<double> m_late_since{0};
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_ATLAS_H
