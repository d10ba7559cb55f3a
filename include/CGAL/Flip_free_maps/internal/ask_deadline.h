// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// How work that may take long asks whether it has to end.

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_ASK_DEADLINE_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_ASK_DEADLINE_H

#include <CGAL/Flip_free_maps/report/Deadline.h>
#include <CGAL/Flip_free_maps/report/Status.h>

#include <cstddef>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// `time_limit` or `stopped_by_observer` if whatever only improves a map has to end, otherwise `success`.
inline Status deadline_status()
{
  const Deadline* deadline = Deadline::state().deadline;
  return deadline != nullptr ? deadline->status() : Status::success;
}

// Throws if the work has to end. It takes some ten nanoseconds, hardly one where there is no deadline.
inline void ask_deadline()
{
  const Deadline::Binding& binding = Deadline::state();
  if(binding.deadline == nullptr)
    return;
  const Status status = binding.deadline->status(binding.is_improving);
  if(status != Status::success)
    throw Interruption(status);
}

// The same for each so many calls with successive numbers.
inline void ask_deadline_sometimes(std::size_t i)
{
  if(i % 1024 == 0)
    ask_deadline();
}

// Binds the work of a scope. A task in another thread takes the binding of the thread that it works for.
class Bound_work
{
public:
  explicit Bound_work(const Deadline::Binding& binding) : m_before(Deadline::state()) { Deadline::state() = binding; }

  ~Bound_work() { Deadline::state() = m_before; }

  Bound_work(const Bound_work&) = delete;
  Bound_work& operator=(const Bound_work&) = delete;

private:
  Deadline::Binding m_before;
};

// For work on a map that is valid already.
class Improving_work : public Bound_work
{
public:
  Improving_work() : Bound_work({Deadline::state().deadline, true}) {}
};

// For work that leads to the first valid map, be it a small one of its own.
class Needed_work : public Bound_work
{
public:
  Needed_work() : Bound_work({Deadline::state().deadline, false}) {}
};

// For work that is always finished, such as the certificate of a result.
class Unbound_work : public Bound_work
{
public:
  Unbound_work() : Bound_work({}) {}
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_ASK_DEADLINE_H
