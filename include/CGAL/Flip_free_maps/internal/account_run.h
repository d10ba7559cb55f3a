// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_ACCOUNT_RUN_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_ACCOUNT_RUN_H

#include <CGAL/Flip_free_maps/internal/Timer.h>
#include <CGAL/Flip_free_maps/internal/ask_deadline.h>
#include <CGAL/Flip_free_maps/internal/catch_out_of_memory.h>
#include <CGAL/Flip_free_maps/report/Summary.h>
#include <CGAL/Flip_free_maps/worlds/Sequential_world.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Calls `run()`, which fills the summary or replaces it, and enters what all of it cost: wall-clock and CPU time, and memory. If
// memory does not suffice, the summary says so.
template <typename Account, typename Run>
void account_run(Account& summary, Run&& run)
{
  double seconds = 0, cpu_seconds = 0;
  {
    const Phase_timer total(seconds, &cpu_seconds);
    catch_out_of_memory(run, summary);
  }
  summary.seconds.total = seconds;
  summary.cpu_seconds = cpu_seconds;
  summary.peak_memory_mb = peak_memory_mb();
}

// The way of all maps from the user's mesh to the user's result: `load(message)` makes flat arrays and returns a status; `solve()`
// makes a start, minimises, and enters how it ended in the summary, which it may replace; `write()` certifies the map in the
// user's numbers and hands it out.
// Where several processes run it, all of them do so in `world`.
template <typename Account, typename Load, typename Solve, typename Write, typename World = Sequential_world>
void run_map(Account& summary, Load&& load, Solve&& solve, Write&& write, const World& world = World())
{
  const auto run = [&] {
    double seconds = 0;
    {
      const Phase_timer timer(seconds);
      summary.status = load(summary.message);
    }
    if(summary.status == Status::success) {
      ask_deadline();
      solve();
    }
    summary.seconds.load += seconds;
    if(!summary.is_valid())
      return;
    const Unbound_work certificate;
    const Phase_timer timer(summary.seconds.certify);
    write();
  };
  account_run(summary, [&] { world.together(run); });
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_ACCOUNT_RUN_H
