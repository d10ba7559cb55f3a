// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_PROGRESS_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_PROGRESS_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_maps.h>

#include <atomic>
#include <cstdint>
#include <thread>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Tells the observer how far the charts are, and whether there is time left.
class Chart_progress : public Chart_maps
{
public:
  using Chart_maps::Chart_maps;

protected:
  // Asks the observer and looks at the clock, while seams are planned and charts are packed; remembers that it cut them short.
  bool must_stop();

  // Asks the observer, on the caller's thread only. False once it has asked to stop.
  bool report_progress();

  // Asks the observer while others are at work, who end soon when it throws.
  void watch();

  std::int64_t m_faces = 0; // polygons of the user's
  Unwrap_phase m_phase = Unwrap_phase::cut;
  int m_charts_at_work = 0; // pieces that are neither charts nor in the queue
  std::atomic<int> m_charts_ahead{0};
  std::atomic<std::int64_t> m_faces_ahead{0};
  std::atomic<bool> m_is_cut_short{false};

private:
  const std::thread::id m_thread = std::this_thread::get_id();
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#ifndef CGAL_FLIP_FREE_MAPS_USE_CORE
#include <CGAL/Flip_free_maps/atlas/internal/Chart_progress_impl.h>
#endif

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_PROGRESS_H
