// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_INTERNAL_ERROR_MESSAGE_H
#define CGAL_FLIP_FREE_MAPS_INTERNAL_ERROR_MESSAGE_H

#include <string>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Stores `text` when the caller wants messages; returns false so that a failure is one statement.
inline bool fail(std::string* message, const std::string& text)
{
  if(message != nullptr)
    *message = text;
  return false;
}

// The opposite: there is nothing to say.
inline bool succeed(std::string* message)
{
  if(message != nullptr)
    message->clear();
  return true;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_INTERNAL_ERROR_MESSAGE_H
