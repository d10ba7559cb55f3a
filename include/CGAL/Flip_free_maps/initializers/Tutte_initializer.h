// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INITIALIZERS_TUTTE_INITIALIZER_H
#define CGAL_FLIP_FREE_MAPS_INITIALIZERS_TUTTE_INITIALIZER_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/domains/internal/Element_coloring.h>
#include <CGAL/Flip_free_maps/domains/internal/Unknowns.h>
#include <CGAL/Flip_free_maps/domains/internal/count_flips.h>
#include <CGAL/Flip_free_maps/initializers/internal/fill_holes.h>
#include <CGAL/Flip_free_maps/initializers/internal/solve_unsymmetric.h>
#include <CGAL/Flip_free_maps/linear_solvers/internal/Laplacian_matrix.h>
#include <CGAL/Flip_free_maps/method/Start_options.h>
#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

#include <CGAL/number_type_config.h>

#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsInitializers
/// Name of weights, as spelled in the enumeration.
inline const char* weights_name(Tutte_weights weights)
{
  return weights == Tutte_weights::uniform ? "uniform" : weights == Tutte_weights::mean_value ? "mean_value" : "cotangent";
}

/// \ingroup PkgFlipFreeMapsInitializers
/// Name of a border shape, as spelled in the enumeration.
inline const char* border_name(Border_shape border)
{
  return border == Border_shape::circle ? "circle" : border == Border_shape::square ? "square" : "polygon";
}

/// \ingroup PkgFlipFreeMapsInitializers
/// The embedding of a disk with its border on a convex curve and every other vertex at a weighted mean of its neighbours
/// (Tutte 1963, Floater 2003), certified by exact predicates. Holes are closed for it by triangles that lie nowhere in space, and
/// open again in the result. In exact arithmetic positive weights leave no element flipped; in double
/// precision long thin tubes shrink below the spacing of the numbers, and other weights are tried then.
///
/// \tparam Kernel must be a CGAL kernel with exact orientation predicates and number type `double`
/// \tparam LinearSolver must be a model of `SymmetricSparseSolver`
/// \tparam ConcurrencyTag as in `Flip_free_map_traits`
/// \tparam World_ must be a model of `World`. Where it is not sequential, all processes know the whole border, the disk has no
///   holes, and mean value weights, whose matrix is not symmetric, are not tried
///
/// \cgalModels{Initializer}
template <typename Kernel, typename LinearSolver, typename ConcurrencyTag, typename World_ = Sequential_world>
class Tutte_initializer
{
public:
  /// Settings are copied.
  explicit Tutte_initializer(const Start_options& options, const World_& world = World_()) : m_options(options), m_world(world) {}

  /// Computes the start.
  ///
  /// \param domain a disk with its border, which may have holes
  /// \param make_linear_solver makes a `LinearSolver`
  /// \param x the start, area about 1, positively oriented; undefined after a failure
  /// \param name which start it is, fallbacks included
  /// \param message why it failed
  /// \returns `Status::success`, `invalid_option` or `start_not_flip_free`
  ///
  /// Complexity: one factorization with an unknown for each vertex inside, for each kind of weights that is tried.
  template <typename MakeLinearSolver>
  Status operator()(const Simplicial_domain<2>& domain, MakeLinearSolver&& make_linear_solver, Positions<2>& x, std::string& name,
                    std::string& message) const
  {
    if(!m_options.is_valid(&message))
      return Status::invalid_option;
    std::vector<Border_shape> borders{m_options.border};
    if(m_options.fall_back && m_options.border != Border_shape::circle)
      borders.push_back(Border_shape::circle);
    std::string failed;
    for(Border_shape border : borders) {
      Positions<2> border_positions;
      place_border(domain, border, border_positions);
      const Status status = with_border(domain, border_positions, border_name(border), make_linear_solver, x, name, failed);
      if(status == Status::success)
        return status;
    }
    message = "no start without flipped elements was found; tried: " + failed;
    return Status::start_not_flip_free;
  }

  /// The same for a given convex border.
  ///
  /// \param domain a disk with its border
  /// \param border_positions a column for each vertex of `domain.border`, in its order; clockwise borders are mirrored
  /// \param border what to call it in `name`
  /// \param make_linear_solver makes a `LinearSolver`
  /// \param x the start, positively oriented; undefined after a failure
  /// \param name which start it is, fallbacks included
  /// \param failed what was tried without success is appended, be it in this call or before
  /// \returns `Status::success` or `start_not_flip_free`
  template <typename MakeLinearSolver>
  Status with_border(const Simplicial_domain<2>& domain, const Positions<2>& border_positions, const std::string& border,
                     MakeLinearSolver&& make_linear_solver, Positions<2>& x, std::string& name, std::string& failed) const
  {
    std::vector<Tutte_weights> weights{m_options.weights};
    if(m_options.fall_back)
      for(Tutte_weights w : {Tutte_weights::uniform, Tutte_weights::mean_value, Tutte_weights::cotangent})
        if(w != m_options.weights)
          weights.push_back(w);
    internal::Element_coloring schedule;
    schedule.build(domain.elements, domain.number_of_vertices, m_world.counted_elements(domain.number_of_elements()));
    const auto count = [&] {
      return static_cast<std::int64_t>(
        m_world.sum(static_cast<double>(internal::count_flips<Kernel, ConcurrencyTag>(domain, schedule, x))));
    };
    for(Tutte_weights w : weights) {
      if(!World_::is_sequential && w == Tutte_weights::mean_value)
        continue;
      const std::string tried = border + ", " + weights_name(w);
      std::int64_t flips = domain.number_of_elements();
      bool has_placed_flaps = false;
      if(embed(domain, border_positions, w, make_linear_solver, x)) {
        orient(domain, x);
        flips = count();
        // A triangle with all its vertices on one side of a polygon is flat; its flap has a better place outside.
        if(World_::is_sequential && (m_options.place_flaps || flips != 0)) {
          const Positions<2> embedded = x;
          const bool has_flaps = place_flaps(domain, x);
          const std::int64_t flips_after = count();
          has_placed_flaps = has_flaps && (flips_after == 0 || flips_after < flips);
          if(has_placed_flaps)
            flips = flips_after;
          else
            x = embedded;
        }
      }
      if(flips == 0) {
        name = "tutte (" + tried + (has_placed_flaps ? ", flaps placed" : "") + (failed.empty() ? "" : "; after " + failed) + ")";
        return Status::success;
      }
      failed += (failed.empty() ? "" : "; ") + tried + " with " + std::to_string(flips) + " flipped";
    }
    return Status::start_not_flip_free;
  }

private:
  // The border on a curve around the origin that encloses area 1.
  void place_border(const Simplicial_domain<2>& domain, Border_shape border, Positions<2>& positions) const
  {
    const std::size_t n = domain.border.size();
    positions.resize(2, n);
    std::vector<double> arc(n + 1, 0);
    for(std::size_t i = 0; i < n; ++i)
      arc[i + 1] = arc[i] + domain.border_lengths[i];
    if(border == Border_shape::circle) {
      const double radius = 1 / std::sqrt(CGAL_PI);
      for(std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * CGAL_PI * arc[i] / arc[n];
        positions.col(i) << radius * std::cos(angle), radius * std::sin(angle);
      }
      return;
    }
    std::vector<std::array<double, 2>> corners = m_options.polygon;
    if(border == Border_shape::square)
      corners = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    place_on_polygon(corners, arc, positions);
  }

  // Corners go to the vertices nearest by arc length, which must differ; the rest is spread by arc length along the sides.
  static void place_on_polygon(std::vector<std::array<double, 2>> corners, const std::vector<double>& arc, Positions<2>& positions)
  {
    const std::size_t n = arc.size() - 1;
    if(corners.size() > n)
      corners.resize(n);
    const std::size_t c = corners.size();
    std::vector<double> perimeter(c + 1, 0);
    double area = 0;
    for(std::size_t k = 0; k < c; ++k) {
      const auto &p = corners[k], &q = corners[(k + 1) % c];
      perimeter[k + 1] = perimeter[k] + std::hypot(q[0] - p[0], q[1] - p[1]);
      area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    }
    const double scale = 1 / std::sqrt(area);
    std::vector<std::size_t> places(c + 1, n);
    for(std::size_t k = 0; k < c; ++k) {
      const double wanted = perimeter[k] / perimeter[c] * arc[n];
      std::size_t place = std::lower_bound(arc.begin(), arc.end(), wanted) - arc.begin();
      if(place > 0 && wanted - arc[place - 1] < arc[place] - wanted)
        --place;
      // Every corner keeps a vertex of its own, and leaves one for each corner to come.
      place = (std::max)(place, k == 0 ? std::size_t(0) : places[k - 1] + 1);
      places[k] = (std::min)(place, n - (c - k));
    }
    for(std::size_t k = 0; k < c; ++k) {
      const auto &p = corners[k], &q = corners[(k + 1) % c];
      for(std::size_t i = places[k]; i < places[k + 1]; ++i) {
        const double t = (arc[i] - arc[places[k]]) / (arc[places[k + 1]] - arc[places[k]]);
        positions.col(i) << scale * ((1 - t) * p[0] + t * q[0]), scale * ((1 - t) * p[1] + t * q[1]);
      }
    }
  }

  // Weights of the three corners of an element: entry (i, j) is the part of the weight of edge i -> j, i != j,
  // that comes from it.
  static Eigen::Matrix3d corner_weights(const Simplicial_domain<2>& domain, std::int64_t e, Tutte_weights kind)
  {
    Eigen::Matrix3d w = Eigen::Matrix3d::Zero();
    if(kind == Tutte_weights::uniform) {
      // Half of each inner edge comes from either side, so that inner edges have weight 1; border edges do not matter.
      w.setConstant(0.5);
      w.diagonal().setZero();
      return w;
    }
    const Eigen::Matrix2d edges = domain.rest_inverses[e].inverse();
    const Eigen::Vector2d p[3] = {Eigen::Vector2d::Zero(), edges.col(0), edges.col(1)};
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Eigen::Vector2d a = p[j] - p[i], b = p[k] - p[i];
      const double cross = a[0] * b[1] - a[1] * b[0], dot = a.dot(b);
      if(kind == Tutte_weights::cotangent) {
        w(j, k) = w(k, j) = 0.5 * dot / cross;
      } else {
        const double half_angle = cross / (a.norm() * b.norm() + dot);
        w(i, j) = half_angle / a.norm();
        w(i, k) = half_angle / b.norm();
      }
    }
    return w;
  }

  template <typename MakeLinearSolver>
  bool embed(const Simplicial_domain<2>& domain, const Positions<2>& border_positions, Tutte_weights kind,
             MakeLinearSolver&& make_linear_solver, Positions<2>& x) const
  {
    if(!domain.holes.empty()) {
      const bool done = embed(internal::fill_holes(domain), border_positions, kind, make_linear_solver, x);
      x.conservativeResize(2, domain.number_of_vertices);
      return done;
    }
    x.setZero(2, domain.number_of_vertices);
    for(std::size_t i = 0; i < domain.border.size(); ++i)
      x.col(domain.border[i]) = border_positions.col(i);
    const internal::Unknowns unknowns(domain.number_of_vertices, domain.border);
    World_(m_world).number_unknowns(unknowns.numbers());
    if(!m_world.any(unknowns.size() > 0))
      return true;
    const bool solved = kind == Tutte_weights::mean_value ? solve_unsymmetric(domain, kind, unknowns, x)
                                                          : solve_symmetric(domain, kind, unknowns, make_linear_solver(), x);
    return !m_world.any(!solved || !x.allFinite());
  }

  // One vector for each coordinate.
  using Coordinates = std::array<Eigen::VectorXd, 2>;

  // Calls add(v, w, weight) for all weights that an element contributes to rows of unknowns. Returns the right-hand sides.
  template <typename Add>
  static Coordinates assemble(const Simplicial_domain<2>& domain, Tutte_weights kind, const internal::Unknowns& unknowns,
                              const Positions<2>& x, Add&& add)
  {
    Coordinates right{Eigen::VectorXd::Zero(unknowns.size()), Eigen::VectorXd::Zero(unknowns.size())};
    for(std::int64_t e = 0; e < domain.number_of_elements(); ++e) {
      const Eigen::Matrix3d weights = corner_weights(domain, e, kind);
      const auto& vertices = domain.elements[e];
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j) {
          const std::int32_t v = vertices[i], w = vertices[j];
          if(i == j || unknowns.is_fixed(v))
            continue;
          add(v, w, weights(i, j));
          if(unknowns.is_fixed(w))
            for(int c = 0; c < 2; ++c)
              right[c][unknowns[v]] += weights(i, j) * x(c, w);
        }
    }
    return right;
  }

  static void spread(const Coordinates& left, const internal::Unknowns& unknowns, Positions<2>& x)
  {
    unknowns.for_each([&](std::int32_t v, std::int32_t i) { x.col(v) << left[0][i], left[1][i]; });
  }

  template <typename Solver>
  bool solve_symmetric(const Simplicial_domain<2>& domain, Tutte_weights kind, const internal::Unknowns& unknowns, Solver&& solver,
                       Positions<2>& x) const
  {
    internal::Laplacian_matrix matrix(unknowns, domain.elements);
    Coordinates right =
      assemble(domain, kind, unknowns, x, [&](std::int32_t v, std::int32_t w, double weight) { matrix.add_neighbor(v, w, weight); });
    for(Eigen::VectorXd& side : right)
      m_world.keep_owned(side);
    Coordinates left;
    if(!matrix.factorize(solver) || !solver.solve(right[0], left[0]) || !solver.solve(right[1], left[1]))
      return false;
    if constexpr(!World_::is_sequential)
      for(Eigen::VectorXd& side : left)
        side = Eigen::VectorXd(m_world.with_ghosts(side));
    spread(left, unknowns, x);
    return true;
  }

  static bool solve_unsymmetric(const Simplicial_domain<2>& domain, Tutte_weights kind, const internal::Unknowns& unknowns, Positions<2>& x)
  {
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(12 * domain.elements.size());
    const Coordinates right = assemble(domain, kind, unknowns, x, [&](std::int32_t v, std::int32_t w, double weight) {
      triplets.emplace_back(unknowns[v], unknowns[v], weight);
      if(!unknowns.is_fixed(w))
        triplets.emplace_back(unknowns[v], unknowns[w], -weight);
    });
    Coordinates left;
    if(!internal::solve_unsymmetric(triplets, right, left))
      return false;
    spread(left, unknowns, x);
    return true;
  }

  static void orient(const Simplicial_domain<2>& domain, Positions<2>& x)
  {
    double doubled = 0;
    for(std::size_t i = 0; i < domain.border.size(); ++i) {
      const auto p = x.col(domain.border[i]), q = x.col(domain.border[(i + 1) % domain.border.size()]);
      doubled += p[0] * q[1] - p[1] * q[0];
    }
    if(doubled < 0)
      x.row(0) *= -1;
  }

  // The optimum of a border vertex of a single triangle for isometric distortions, with the opposite edge as it is. Returns
  // whether there is such a vertex.
  static bool place_flaps(const Simplicial_domain<2>& domain, Positions<2>& x)
  {
    std::vector<std::int32_t> degree(domain.number_of_vertices, 0);
    for(const auto& element : domain.elements)
      for(std::int32_t v : element)
        ++degree[v];
    bool has_flaps = false;
    for(std::int64_t e = 0; e < domain.number_of_elements(); ++e)
      for(int k = 0; k < 3; ++k) {
        const auto& v = domain.elements[e];
        if(degree[v[k]] != 1)
          continue;
        has_flaps = true;
        const Eigen::Matrix2d edges = domain.rest_inverses[e].inverse();
        const Eigen::Vector2d rest[3] = {Eigen::Vector2d::Zero(), edges.col(0), edges.col(1)};
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const Eigen::Vector2d side = rest[j] - rest[i], apex = rest[k] - rest[i];
        const double beta = apex.dot(side) / side.squaredNorm();
        const double gamma = (apex - beta * side).norm();
        const Eigen::Vector2d p = x.col(v[i]), q = x.col(v[j]);
        const Eigen::Vector2d normal = Eigen::Vector2d(p[1] - q[1], q[0] - p[0]).normalized();
        x.col(v[k]) = (1 - beta) * p + beta * q + gamma * normal;
        break;
      }
    return has_flaps;
  }

  Start_options m_options;
  World_ m_world;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INITIALIZERS_TUTTE_INITIALIZER_H
