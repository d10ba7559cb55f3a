// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_DEADLINE_H
#define CGAL_FLIP_FREE_MAPS_REPORT_DEADLINE_H

#include <CGAL/Flip_free_maps/report/Status.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <limits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// What a function that returns no account throws when a `Deadline` ends it.
class Interruption : public std::exception
{
public:
  /// With the limit that was met.
  explicit Interruption(Status status) : m_status(status) {}

  /// `time_limit` or `stopped_by_observer`.
  Status status() const { return m_status; }

  /// A sentence.
  const char* what() const noexcept override
  {
    return m_status == Status::time_limit ? "the limit of time is reached" : "the run was cancelled";
  }

private:
  Status m_status;
};

/// \ingroup PkgFlipFreeMapsRef
/// While an object of this class lives, everything that its thread does with this package, and the tasks that this starts in other
/// threads, ends when the time is up or `is_cancelled()` returns `true`: loading, cutting, starts, symbolic analysis, conjugate
/// gradients, line searches, splitting, packing and the search for overlaps ask it many times a second. A single numeric
/// factorization and the certificate of the result are finished.
///
/// What improves a map ends at once; the summary has the status `time_limit` or `stopped_by_observer` then, and the map is valid.
/// What leads to the first valid map may go on for `grace` seconds; if that does not suffice the status is `interrupted`, and the
/// caller's data are untouched.
///
/// The functions that take a limit of time make such an object themselves. Of several that live at the same time in a thread all
/// hold. They must be destroyed in the reverse order, and in the thread that made them.
class Deadline
{
public:
  /// \param seconds wall-clock time from now on; infinite for no limit
  /// \param is_cancelled asked by all threads of a run, until it returns `true`; none is given for runs that nobody cancels. It
  ///   may not throw.
  /// \param grace seconds for the first valid map
  explicit Deadline(double seconds, std::function<bool()> is_cancelled = nullptr, double grace = 0.8)
    : m_is_cancelled(std::move(is_cancelled)), m_end(now() + seconds), m_grace(grace), m_outer(state().deadline)
  {
    if(m_is_cancelled || seconds < std::numeric_limits<double>::infinity())
      state().deadline = this;
  }

  ~Deadline() { state().deadline = m_outer; }

  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// Whether the work has to end: `time_limit` or `stopped_by_observer`, otherwise `success`.
  ///
  /// \param is_improving whether there is a valid map already, so that the grace does not count
  Status status(bool is_improving = true) const
  {
    const double time = now(), grace = is_improving ? 0 : m_grace;
    double cancelled = m_cancelled;
    if(m_is_cancelled && !(cancelled < NEVER) && m_is_cancelled())
      m_cancelled = cancelled = time;
    if(time >= cancelled + grace)
      return Status::stopped_by_observer;
    if(time >= m_end + grace)
      return Status::time_limit;
    return m_outer != nullptr ? m_outer->status(is_improving) : Status::success;
  }

  /// What the work of a thread is bound to.
  struct Binding
  {
    const Deadline* deadline = nullptr; ///< the innermost one, null if there is none
    bool is_improving = false;          ///< whether there is a valid map
  };

  /// That of the calling thread.
  static Binding& state()
  {
    static thread_local Binding binding;
    return binding;
  }

private:
  static constexpr double NEVER = std::numeric_limits<double>::infinity();

  static double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

  std::function<bool()> m_is_cancelled;
  mutable std::atomic<double> m_cancelled{NEVER}; // when it was seen
  double m_end;
  double m_grace;
  const Deadline* m_outer;
};

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_DEADLINE_H
