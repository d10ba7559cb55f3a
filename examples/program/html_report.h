// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_HTML_REPORT_H
#define FLIP_FREE_MAPS_PROGRAM_HTML_REPORT_H

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace program {

// A page that needs no other file: a heading, the pictures (PNG and SVG files, which it contains), the histograms of the summary as bars,
// and all its other figures in a table.
std::string html_report(const std::string& heading, const nlohmann::json& summary, const std::vector<std::string>& pictures);

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_HTML_REPORT_H
