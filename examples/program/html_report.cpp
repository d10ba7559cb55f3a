// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "html_report.h"

#include "files.h"
#include "formats/Polygon_file.h"
#include "formats/packed_bytes.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace program {

namespace {

std::string escaped(const std::string& text)
{
  std::string result;
  for(const char c : text)
    switch(c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

std::string number_text(const nlohmann::json& value)
{
  char text[32];
  if(!value.is_number_float())
    return value.dump();
  std::snprintf(text, sizeof text, "%.6g", value.get<double>());
  return text;
}

bool is_histogram(const std::string& name, const nlohmann::json& value)
{
  const std::string end = "histogram";
  return value.is_array() && !value.empty() && value.front().is_number() && name.size() >= end.size() &&
         name.compare(name.size() - end.size(), end.size(), end) == 0;
}

std::string histogram_figure(const std::string& name, const nlohmann::json& counts)
{
  const int width = 30, height = 120;
  double most = 1;
  for(const nlohmann::json& count : counts)
    most = (std::max)(most, count.get<double>());
  std::string svg = "<figure><svg width=\"" + std::to_string(width * counts.size()) + "\" height=\"" + std::to_string(height + 16) + "\">";
  for(std::size_t i = 0; i < counts.size(); ++i) {
    const int bar = static_cast<int>(height * counts[i].get<double>() / most + 0.5), left = width * static_cast<int>(i);
    svg += "<rect x=\"" + std::to_string(left + 2) + "\" y=\"" + std::to_string(height - bar + 14) + "\" width=\"" +
           std::to_string(width - 4) + "\" height=\"" + std::to_string(bar) + "\"/><text x=\"" + std::to_string(left + width / 2) +
           "\" y=\"" + std::to_string(height - bar + 10) + "\">" + number_text(counts[i]) + "</text>";
  }
  return svg + "</svg><figcaption>" + escaped(name) + "</figcaption></figure>\n";
}

void add_fields(const std::string& prefix, const nlohmann::json& object, std::string& rows, std::string& figures)
{
  for(const auto& [key, value] : object.items()) {
    const std::string name = prefix + key;
    if(value.is_object())
      add_fields(name + ": ", value, rows, figures);
    else if(is_histogram(name, value))
      figures += histogram_figure(name, value);
    else if(value.is_array())
      rows += "<tr><td>" + escaped(name) + "</td><td>" + std::to_string(value.size()) + " entries</td></tr>\n";
    else
      rows += "<tr><td>" + escaped(name) + "</td><td>" +
              escaped(value.is_string() ? value.get<std::string>()
                      : value.is_null() ? "-"
                                        : number_text(value)) +
              "</td></tr>\n";
  }
}

} // namespace

std::string html_report(const std::string& heading, const nlohmann::json& summary, const std::vector<std::string>& pictures)
{
  std::string rows, figures, images;
  add_fields("", summary, rows, figures);
  for(const std::string& path : pictures) {
    const std::string type = small_extension(path) == ".svg" ? "svg+xml" : "png";
    std::string picture, message;
    check(FFM::internal::read_whole_file(path, picture, &message), message);
    images += "<img src=\"data:image/" + type + ";base64," + encode_base64(picture) + "\" alt=\"" + escaped(path) + "\">\n";
  }
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(heading) +
         "</title>\n<style>body{font:15px sans-serif;margin:2em auto;max-width:75em;color:#222}img{max-width:100%;display:block;margin:1em 0}"
         "figure{display:inline-block;margin:0 2em 1em 0}figcaption{text-align:center}rect{fill:#4878a8}text{font-size:9px;text-anchor:middle}"
         "table{border-collapse:collapse}td{padding:.2em 1.5em .2em 0;border-bottom:1px solid #ddd;vertical-align:top}</style></head>\n<body><h1>" +
         escaped(heading) + "</h1>\n" + images + figures + "<table>\n" + rows + "</table></body></html>\n";
}

} // namespace program
