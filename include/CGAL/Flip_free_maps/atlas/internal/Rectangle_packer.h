// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_RECTANGLE_PACKER_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_RECTANGLE_PACKER_H

#include <array>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Where a rectangle of width and height w x h went: its lower left corner, and whether it was turned by a quarter.
struct Rectangle_place
{
  double x = 0;
  double y = 0;
  bool is_turned = false;
};

// Packs rectangles, scaled alike and each surrounded by half the margin, into the unit square. Rectangles are laid down by
// descending height, each where it ends lowest above the skyline of those before. The scale is the largest that was seen to fit;
// it is found by bisection, since all lengths but the margin are proportional to it.
class Rectangle_packer
{
public:
  Rectangle_packer(const std::vector<std::array<double, 2>>& sizes, double margin) : m_sizes(sizes), m_margin(margin) {}

  // False when not even rectangles without extent find room between the margins.
  bool pack();

  double scale() const { return m_scale; }
  const std::vector<Rectangle_place>& places() const { return m_places; }

private:
  enum class Turn
  {
    lying,
    standing,
    free
  };

  struct Step
  {
    double x, y; // the skyline has the height y from x to the next step
  };

  void search(Turn turn, double bound);

  // Keeps the places if the scale is the best so far.
  bool fits(Turn turn, double scale);

  // The place where a box' top is lowest, the left one of several. Returns the height of the top,
  // infinity when the box is too wide.
  double lowest(double width, double height, Rectangle_place& place) const;

  void raise(const Rectangle_place& place, const std::array<double, 2>& box);

  const std::vector<std::array<double, 2>>& m_sizes;
  double m_margin;
  double m_scale = -1;
  std::vector<Rectangle_place> m_places;
  std::vector<Step> m_skyline;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Rectangle_packer_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_RECTANGLE_PACKER_H
