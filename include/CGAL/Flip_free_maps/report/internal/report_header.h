// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_REPORT_HEADER_H
#define CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_REPORT_HEADER_H

#include <CGAL/Flip_free_maps/report/Status.h>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Makes a JSON value an object with what all summaries begin with.
template <typename Json, typename Summary>
void report_header(Json& json, const Summary& summary)
{
  json = Json::object();
  json["status"] = status_name(summary.status);
  json["message"] = summary.message;
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_REPORT_HEADER_H
