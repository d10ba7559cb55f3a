// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_HANDLE_GROUPS_H
#define CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_HANDLE_GROUPS_H

#include <CGAL/Flip_free_maps/domains/Simplicial_domain.h>
#include <CGAL/Flip_free_maps/elements/Signed_svd.h>
#include <CGAL/Flip_free_maps/internal/Disjoint_sets.h>

#include <CGAL/number_type_basic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Handles that share elements are a group, and turn together: on straight lines a group that turns by half a turn would shrink to
// a point on its way.
template <int D>
class Handle_groups
{
public:
  Handle_groups(const Simplicial_domain<D>& domain, const std::function<bool(std::int32_t)>& is_handle);

  // Puts the handles where they are to go.
  void place(const Positions<D>& targets, Positions<D>& x) const
  {
    for(const auto& group : m_groups)
      for(std::int32_t v : group)
        x.col(v) = targets.col(v);
  }

  // Where the handles turn by much as a whole: the shape `x`, turned with them. Isometries cost nothing, and on the ways of the
  // groups they might have to pass through each other. `false` if that leaves much to turn for one of the groups.
  bool carry(const Positions<D>& x, const Positions<D>& targets, Positions<D>& carried) const;

  // The displacement of the handles from `x` to their targets (`is_last`) or, if a group is to turn by much, to places on the
  // way. `false` if a target is not finite.
  bool next_displacement(const Positions<D>& x, const Positions<D>& targets, Positions<D>& displacement, bool& is_last) const;

  // Joins the groups of which several processes have a part, in an order that all have. Every process knows all handles.
  template <typename World>
  void join(const World& world);

  // Puts the handles where those that own them have them.
  template <typename World>
  void share(const World& world, Positions<D>& x) const;

private:
  // A rotation around the group's centre, and the translation of the centre.
  struct Motion
  {
    Vector<D> from, to;
    double angle = 0; // not negative
    Vector<3> axis{0, 0, 1};

    Matrix<D> rotation(double fraction) const
    {
      return Eigen::AngleAxisd(fraction * angle, axis).toRotationMatrix().template topLeftCorner<D, D>();
    }

    // Half a turn may go to either side: a group that moves around a centre turns in the same sense.
    void choose_side(const Vector<D>& centre)
    {
      Vector<3> arm = Vector<3>::Zero(), path = Vector<3>::Zero();
      arm.template head<D>() = from - centre;
      path.template head<D>() = to - from;
      if(angle > 3.04 && arm.cross(path).dot(axis) < -1e-6 * arm.squaredNorm()) {
        angle = 2 * CGAL_PI - angle;
        axis = -axis;
      }
    }

    Vector<D> place(const Vector<D>& p, const Vector<D>& target, double fraction) const
    {
      const Vector<D> arm = p - from, change = rotation(1).transpose() * (target - to) - arm;
      return from + fraction * (to - from) + rotation(fraction) * (arm + fraction * change);
    }
  };

  std::vector<std::int32_t> all() const
  {
    std::vector<std::int32_t> result;
    for(const auto& group : m_groups)
      result.insert(result.end(), group.begin(), group.end());
    return result;
  }

  // The rotation by the least angle that takes a unit vector to another: half a turn about the first, which keeps it, and another one
  // about the middle of both. (Eigen's quaternions compute it by a decomposition that takes seconds to compile.)
  static Matrix<3> least_turn(const Vector<3>& a, const Vector<3>& b)
  {
    const Vector<3> sum = a + b, middle = sum.norm() > 1e-8 ? Vector<3>(sum.normalized()) : Vector<3>(a.unitOrthogonal());
    const Matrix<3> one = Matrix<3>::Identity();
    return (2 * middle * middle.transpose() - one) * (2 * a * a.transpose() - one);
  }

  // The rotation that maximises the product with the decomposed matrix; where many do, the one with the least angle.
  static Matrix<3> nearest_rotation(const Signed_svd<D>& svd)
  {
    // Handles on a line, or such targets, say nothing of a rotation around it: what there is of it is rounding.
    if constexpr(D == 3) {
      if(svd.s[1] <= RANK_TOLERANCE * svd.s[0])
        return least_turn(svd.V.col(0), svd.U.col(0));
    }
    Matrix<3> rotation = Matrix<3>::Identity();
    rotation.template topLeftCorner<D, D>() = svd.U * svd.V.transpose();
    return rotation;
  }

  // The rigid motion that leads the group nearest to its targets.
  static Motion motion(const std::vector<std::int32_t>& group, const Positions<D>& x, const Positions<D>& targets)
  {
    Motion result;
    result.from.setZero();
    result.to.setZero();
    for(std::int32_t v : group) {
      result.from += x.col(v) / group.size();
      result.to += targets.col(v) / group.size();
    }
    Matrix<D> covariance = Matrix<D>::Zero();
    for(std::int32_t v : group)
      covariance += (targets.col(v) - result.to) * (x.col(v) - result.from).transpose();
    if(!covariance.allFinite() || !result.to.allFinite()) {
      result.angle = std::numeric_limits<double>::quiet_NaN();
      return result;
    }
    if(!(covariance.norm() > 0))
      return result;
    Signed_svd<D> svd;
    signed_svd(covariance, svd);
    const Eigen::AngleAxisd turn(nearest_rotation(svd));
    result.angle = std::abs(turn.angle());
    result.axis = turn.angle() < 0 ? Vector<3>(-turn.axis()) : Vector<3>(turn.axis());
    return result;
  }

  static constexpr double LARGEST_TURN = 0.5;     // in one round, in radians
  static constexpr double RANK_TOLERANCE = 1e-12; // the square of what a line may be wide, in parts of its length

  std::vector<std::vector<std::int32_t>> m_groups;
};

template <int D>
Handle_groups<D>::Handle_groups(const Simplicial_domain<D>& domain, const std::function<bool(std::int32_t)>& is_handle)
{
  Disjoint_sets sets(domain.number_of_vertices);
  for(const auto& element : domain.elements) {
    std::int32_t first = -1;
    for(std::int32_t v : element) {
      if(!is_handle(v))
        continue;
      if(first >= 0)
        sets.unite(v, first);
      first = v;
    }
  }
  std::map<std::int32_t, std::vector<std::int32_t>> groups;
  for(std::int32_t v = 0; v < domain.number_of_vertices; ++v)
    if(is_handle(v))
      groups[sets.root(v)].push_back(v);
  for(auto& group : groups)
    m_groups.push_back(std::move(group.second));
}

template <int D>
bool Handle_groups<D>::carry(const Positions<D>& x, const Positions<D>& targets, Positions<D>& carried) const
{
  const Motion whole = motion(all(), x, targets);
  if(!(whole.angle > LARGEST_TURN))
    return false;
  carried = (whole.rotation(1) * (x.colwise() - whole.from)).colwise() + whole.to;
  for(const auto& group : m_groups)
    if(!(motion(group, carried, targets).angle <= LARGEST_TURN))
      return false;
  return true;
}

template <int D>
bool Handle_groups<D>::next_displacement(const Positions<D>& x, const Positions<D>& targets, Positions<D>& displacement,
                                         bool& is_last) const
{
  std::vector<Motion> motions;
  double largest_angle = 0;
  const Vector<D> centre = motion(all(), x, targets).from;
  for(const auto& group : m_groups) {
    motions.push_back(motion(group, x, targets));
    if(!std::isfinite(motions.back().angle))
      return false;
    motions.back().choose_side(centre);
    largest_angle = (std::max)(largest_angle, motions.back().angle);
  }
  is_last = largest_angle <= LARGEST_TURN;
  const double fraction = is_last ? 1 : LARGEST_TURN / largest_angle;
  for(std::size_t g = 0; g < m_groups.size(); ++g)
    for(std::int32_t v : m_groups[g])
      displacement.col(v) =
        is_last ? Vector<D>(targets.col(v) - x.col(v)) : Vector<D>(motions[g].place(x.col(v), targets.col(v), fraction) - x.col(v));
  return true;
}

template <int D>
template <typename World>
void Handle_groups<D>::join(const World& world)
{
  std::map<std::int64_t, std::int32_t> local;
  std::vector<std::int64_t> links; // pairs
  for(const auto& group : m_groups)
    for(std::int32_t v : group) {
      local[world.global_numbers()[v]] = v;
      links.push_back(world.global_numbers()[group.front()]);
      links.push_back(world.global_numbers()[v]);
    }
  std::vector<std::int32_t> handles;
  std::map<std::int64_t, std::int32_t> place;
  for(const auto& [number, v] : local) {
    place[number] = static_cast<std::int32_t>(handles.size());
    handles.push_back(v);
  }
  Disjoint_sets sets(static_cast<std::int32_t>(handles.size()));
  links = world.gather(links);
  for(std::size_t i = 0; i < links.size(); i += 2)
    if(links[i] != links[i + 1])
      sets.unite(place[links[i]], place[links[i + 1]]);
  std::map<std::int32_t, std::size_t> group_of;
  m_groups.clear();
  for(std::size_t i = 0; i < handles.size(); ++i) {
    const auto found = group_of.emplace(sets.root(static_cast<std::int32_t>(i)), m_groups.size());
    if(found.second)
      m_groups.emplace_back();
    m_groups[found.first->second].push_back(handles[i]);
  }
}

template <int D>
template <typename World>
void Handle_groups<D>::share(const World& world, Positions<D>& x) const
{
  std::map<std::int64_t, std::int32_t> local;
  std::vector<std::pair<std::int64_t, std::array<double, D>>> owned;
  for(std::int32_t v : all()) {
    local[world.global_numbers()[v]] = v;
    if(v >= world.owned_vertices(static_cast<std::int32_t>(x.cols())))
      continue;
    owned.emplace_back(world.global_numbers()[v], std::array<double, D>());
    for(int i = 0; i < D; ++i)
      owned.back().second[i] = x(i, v);
  }
  for(const auto& [number, place] : world.gather(owned))
    for(int i = 0; i < D; ++i)
      x(i, local[number]) = place[i];
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CORE
extern template class Handle_groups<2>;
extern template class Handle_groups<3>;
#endif

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_MINIMIZER_INTERNAL_HANDLE_GROUPS_H
