// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_HTML_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_HTML_H

#include <string>
#include <vector>

namespace benchmark_support {

// What reports have in common: pages that need nothing from anywhere else.

inline std::string escape(const std::string& text)
{
  std::string result;
  for(char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

inline std::string html_head(const std::string& title)
{
  return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>" + escape(title) +
         "</title>\n<style>\n"
         "body{font:15px/1.5 Helvetica,Arial,sans-serif;color:#111827;background:#fff;max-width:1400px;margin:2em auto;padding:0 1.5em}\n"
         "h1{font-size:1.7em;font-weight:600}h2{font-size:1.25em;font-weight:600;margin-top:2.2em;border-bottom:1px solid #d1d5db}\n"
         "h3{font-size:1em;font-weight:600;margin:1.6em 0 .3em}.muted{color:#6b7280;font-size:.9em}\n"
         "table{border-collapse:collapse;font-size:12.5px;font-variant-numeric:tabular-nums;margin:.6em 0}\n"
         "th,td{padding:2px 7px;text-align:right;border-bottom:1px solid #e5e7eb;white-space:nowrap}\n"
         "th{font-weight:600;border-bottom:2px solid #9ca3af;vertical-align:bottom;white-space:normal}th:first-child,td:first-child{text-align:left}\n"
         "tr.set td{border-top:2px solid #9ca3af}.scroll{overflow-x:auto}.best{font-weight:700}.worse{color:#b91c1c}.off{color:#9ca3af}\n"
         ".pair{display:flex;flex-wrap:wrap;gap:18px}.pair>div{flex:1 1 480px;max-width:680px}svg.plot{width:100%;height:auto}\n"
         ".legend{display:flex;flex-wrap:wrap;gap:4px 16px;font-size:12.5px;margin:.3em 0}.legend svg{vertical-align:middle;margin-right:5px}\n"
         "</style></head><body>\n<h1>" +
         escape(title) + "</h1>\n";
}

// The name of a mesh up to the first underscore.
inline std::string set_of(const std::string& mesh) { return mesh.substr(0, mesh.find('_')); }

inline std::string cell(const std::string& text, const std::string& style = std::string())
{
  return "<td" + (style.empty() ? "" : " class='" + style + "'") + ">" + text + "</td>";
}

// The beginning of a table, which "</table></div>" ends. Columns are HTML.
inline std::string header(const std::vector<std::string>& columns)
{
  std::string text = "<div class='scroll'><table><tr>";
  for(const std::string& column : columns)
    text += "<th>" + column + "</th>";
  return text + "</tr>\n";
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_HTML_H
