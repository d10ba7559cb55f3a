// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_PROGRESS_IMPL_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_PROGRESS_IMPL_H

#include <CGAL/Flip_free_maps/atlas/internal/Chart_progress.h>
#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/inline.h>

#include <algorithm>
#include <thread>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_progress::must_stop()
{
  report_progress();
  if(is_late())
    m_is_cut_short = true;
  return m_is_cut_short;
}

CGAL_FLIP_FREE_MAPS_INLINE bool Chart_progress::report_progress()
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

CGAL_FLIP_FREE_MAPS_INLINE void Chart_progress::watch()
{
  try {
    report_progress();
  } catch(...) {
    m_is_stopped = true;
    throw;
  }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_CHART_PROGRESS_IMPL_H
