// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_SVG_PLOTS_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_SVG_PLOTS_H

#include "Table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace benchmark_support {

// How a method is drawn. Methods with progressive references have the colour of those without and dashes; projected Newton is
// dotted, since it often coincides with composite majorization.
struct Style
{
  std::string color;
  std::string dashes;
  double width;
};

inline Style style_of(const std::string& method)
{
  static const std::map<std::string, std::string> colors = {{"default", "#111827"}, {"pp", "#d62728"},     {"cm", "#1f77b4"},
                                                            {"slim", "#2ca02c"},    {"akvf", "#8e44ad"},   {"projected-newton", "#17a2b8"},
                                                            {"aqp", "#e67e00"},     {"newton", "#8c564b"}, {"sobolev", "#7f7f7f"}};
  const bool is_progressive = method.compare(0, 2, "p-") == 0;
  const auto found = colors.find(is_progressive ? method.substr(2) : method);
  const std::string dashes = is_progressive ? "6 3" : method == "projected-newton" ? "1.5 4" : "";
  return {found != colors.end() ? found->second : "#999999", dashes,
          dashes == "1.5 4" || method == "default" || method == "pp" ? 2.4 : 1.6};
}

inline std::string stroke(const Style& style)
{
  return "fill='none' stroke='" + style.color + "' stroke-width='" + format(style.width) + "'" +
         (style.dashes.empty() ? "" : " stroke-dasharray='" + style.dashes + "'");
}

// How one of several series without names of methods is drawn.
inline Style style_of_series(std::size_t number)
{
  static const char* const COLORS[] = {"#1f77b4", "#e67e00", "#2ca02c", "#8e44ad", "#d62728", "#17a2b8", "#8c564b", "#7f7f7f", "#bcbd22"};
  return {COLORS[number % (sizeof(COLORS) / sizeof(COLORS[0]))], "", 1.6};
}

inline std::string legend(const std::vector<std::pair<std::string, Style>>& series)
{
  std::string text = "<div class='legend'>";
  for(const auto& entry : series)
    text += "<span><svg width='34' height='12'><path d='M1 6H33' " + stroke(entry.second) + "/></svg>" + entry.first + "</span>";
  return text + "</div>\n";
}

inline std::string legend(const std::vector<std::string>& methods)
{
  std::vector<std::pair<std::string, Style>> series;
  for(const std::string& method : methods)
    series.push_back({method, style_of(method)});
  return legend(series);
}

// A linear or logarithmic axis of `length` pixels.
class Axis
{
public:
  Axis(double low, double high, bool is_logarithmic, double length)
    : m_low(low), m_high(high > low ? high : low + 1), m_is_logarithmic(is_logarithmic), m_length(length)
  {}

  double operator()(double value) const
  {
    const double t = m_is_logarithmic ? (std::log10(value) - std::log10(m_low)) / (std::log10(m_high) - std::log10(m_low))
                                      : (value - m_low) / (m_high - m_low);
    return m_length * t;
  }

  // Values with labels: powers of ten, with 2 and 5 between them on short axes, or tenths.
  std::vector<double> ticks() const
  {
    std::vector<double> result;
    if(!m_is_logarithmic) {
      for(int i = 0; i <= 5; ++i)
        result.push_back(m_low + (m_high - m_low) * i / 5);
      return result;
    }
    const int first = static_cast<int>(std::floor(std::log10(m_low))), last = static_cast<int>(std::ceil(std::log10(m_high)));
    const int decades = last - first, stride = (std::max)(1, (decades + 5) / 7);
    for(int k = first; k <= last; k += stride)
      for(double factor : {1., 2., 5.})
        if((factor == 1 || decades <= 2) && factor * std::pow(10., k) >= 0.999 * m_low && factor * std::pow(10., k) <= 1.001 * m_high)
          result.push_back(factor * std::pow(10., k));
    return result;
  }

  std::string label(double value) const
  {
    const double exponent = std::floor(std::log10(value) + 1e-9);
    if(!m_is_logarithmic || (value >= 0.001 && value < 9999))
      return format(value);
    const double mantissa = value / std::pow(10., exponent);
    return (std::abs(mantissa - 1) < 1e-6 ? "" : format(mantissa) + "&#183;") + "10<tspan dy='-5' font-size='8.5'>" + format(exponent) +
           "</tspan>";
  }

private:
  double m_low;
  double m_high;
  bool m_is_logarithmic;
  double m_length;
};

// Lines and dots over two axes, the first of them logarithmic.
class Line_plot
{
public:
  struct Line
  {
    Style style;
    std::vector<std::pair<double, double>> points;
  };

  struct Dot
  {
    double x;
    double y;
    std::string color;
    std::string title; // shown when the mouse is over it
    bool is_filled;
  };

  std::string x_label;
  std::string y_label;
  double x_low = 1, x_high = 10, y_low = 0, y_high = 1;
  bool y_is_logarithmic = true;
  bool is_staircase = false;
  double height = 250;
  std::vector<Line> lines;
  std::vector<Dot> dots;

  std::string svg() const
  {
    constexpr double LEFT = 58, TOP = 10, WIDTH = 400, RIGHT = 14, BOTTOM = 44;
    static int number = 0;
    const std::string clip = "clip" + std::to_string(++number);
    const Axis x(x_low, x_high, true, WIDTH), y(y_low, y_high, y_is_logarithmic, height);
    std::ostringstream out;
    out.precision(5);
    out << "<svg class='plot' viewBox='0 0 " << LEFT + WIDTH + RIGHT << ' ' << TOP + height + BOTTOM
        << "' xmlns='http://www.w3.org/2000/svg'"
        << " font-family='Helvetica, Arial, sans-serif' font-size='11'>\n<defs><clipPath id='" << clip << "'><rect x='" << LEFT << "' y='"
        << TOP << "' width='" << WIDTH << "' height='" << height << "'/></clipPath></defs>\n";
    for(double tick : x.ticks())
      out << "<path d='M" << LEFT + x(tick) << ' ' << TOP << 'v' << height << "' stroke='#e5e7eb'/><text x='" << LEFT + x(tick) << "' y='"
          << TOP + height + 16 << "' text-anchor='middle' fill='#4b5563'>" << x.label(tick) << "</text>\n";
    for(double tick : y.ticks())
      out << "<path d='M" << LEFT << ' ' << TOP + height - y(tick) << 'h' << WIDTH << "' stroke='#e5e7eb'/><text x='" << LEFT - 6 << "' y='"
          << TOP + height - y(tick) + 4 << "' text-anchor='end' fill='#4b5563'>" << y.label(tick) << "</text>\n";
    out << "<rect x='" << LEFT << "' y='" << TOP << "' width='" << WIDTH << "' height='" << height << "' fill='none' stroke='#9ca3af'/>\n"
        << "<text x='" << LEFT + WIDTH / 2 << "' y='" << TOP + height + 36 << "' text-anchor='middle' fill='#111827'>" << x_label
        << "</text>\n<text transform='translate(13 " << TOP + height / 2 << ") rotate(-90)' text-anchor='middle' fill='#111827'>" << y_label
        << "</text>\n<g clip-path='url(#" << clip << ")' stroke-linejoin='round'>\n";
    for(const Line& line : lines) {
      out << "<path " << stroke(line.style) << " d='";
      double last_x = -1e9, last_y = -1e9;
      for(std::size_t i = 0; i < line.points.size(); ++i) {
        const double px = LEFT + x(line.points[i].first), py = TOP + height - y(line.points[i].second);
        if(i > 0 && i + 1 < line.points.size() && std::hypot(px - last_x, py - last_y) < 0.7)
          continue;
        if(i > 0 && is_staircase)
          out << 'H' << px << 'V' << py;
        else
          out << (i == 0 ? 'M' : 'L') << px << ' ' << py;
        last_x = px;
        last_y = py;
      }
      out << "'/>\n";
    }
    for(const Dot& dot : dots)
      out << "<circle cx='" << LEFT + x(dot.x) << "' cy='" << TOP + height - y(dot.y) << "' r='3.2' stroke='" << dot.color << "' fill='"
          << (dot.is_filled ? dot.color : "#ffffff") << "' fill-opacity='0.75'>"
          << (dot.title.empty() ? std::string() : "<title>" + dot.title + "</title>") << "</circle>\n";
    out << "</g></svg>\n";
    return out.str();
  }
};

// For each name a box from quartile to quartile with a line at the median, whiskers to the extremes, and a dot for each value,
// over a logarithmic axis.
inline std::string box_plot(const std::vector<std::string>& names, const std::map<std::string, std::vector<double>>& values,
                            const std::string& label)
{
  constexpr double LEFT = 118, TOP = 8, WIDTH = 340, ROW = 24, RIGHT = 16, BOTTOM = 42;
  double low = std::numeric_limits<double>::infinity(), high = 1;
  for(const auto& entry : values)
    for(double v : entry.second)
      if(std::isfinite(v) && v > 0) {
        low = (std::min)(low, v);
        high = (std::max)(high, v);
      }
  if(!(low < high))
    low = high / 10;
  const Axis x(0.9 * low, 1.1 * high, true, WIDTH);
  const double height = ROW * static_cast<double>(names.size());
  std::ostringstream out;
  out.precision(5);
  out << "<svg class='plot' viewBox='0 0 " << LEFT + WIDTH + RIGHT << ' ' << TOP + height + BOTTOM << "' xmlns='http://www.w3.org/2000/svg'"
      << " font-family='Helvetica, Arial, sans-serif' font-size='11'>\n";
  for(double tick : x.ticks())
    out << "<path d='M" << LEFT + x(tick) << ' ' << TOP << 'v' << height << "' stroke='#e5e7eb'/><text x='" << LEFT + x(tick) << "' y='"
        << TOP + height + 16 << "' text-anchor='middle' fill='#4b5563'>" << x.label(tick) << "</text>\n";
  for(std::size_t i = 0; i < names.size(); ++i) {
    const double y = TOP + ROW * (static_cast<double>(i) + 0.5);
    const Style style = style_of(names[i]);
    out << "<text x='" << LEFT - 8 << "' y='" << y + 4 << "' text-anchor='end' fill='#111827'>" << names[i] << "</text>\n";
    const auto found = values.find(names[i]);
    if(found == values.end() || !(quantile(found->second, 0) > 0))
      continue;
    const std::vector<double>& v = found->second;
    const auto at = [&](double p) { return LEFT + x(quantile(v, p)); };
    out << "<path d='M" << at(0) << ' ' << y << 'H' << at(0.25) << 'M' << at(0.75) << ' ' << y << 'H' << at(1) << "' stroke='"
        << style.color << "'/><rect x='" << at(0.25) << "' y='" << y - 7 << "' width='" << (std::max)(1., at(0.75) - at(0.25))
        << "' height='14' fill='" << style.color << "' fill-opacity='0.18' stroke='" << style.color << "'"
        << (style.dashes.empty() ? "" : " stroke-dasharray='4 2'") << "/><path d='M" << at(0.5) << ' ' << y - 7 << "v14' stroke='"
        << style.color << "' stroke-width='3'/>\n";
    for(double value : v)
      if(std::isfinite(value) && value > 0)
        out << "<circle cx='" << LEFT + x(value) << "' cy='" << y << "' r='1.7' fill='" << style.color << "' fill-opacity='0.7'/>";
    out << '\n';
  }
  out << "<rect x='" << LEFT << "' y='" << TOP << "' width='" << WIDTH << "' height='" << height << "' fill='none' stroke='#9ca3af'/>\n"
      << "<text x='" << LEFT + WIDTH / 2 << "' y='" << TOP + height + 34 << "' text-anchor='middle' fill='#111827'>" << label
      << "</text>\n</svg>\n";
  return out.str();
}

// For each name a bar of coloured parts one after the other, with their sum at its end, over an axis that begins at 0. `values`
// has the parts of each bar.
inline std::string stacked_bars(const std::vector<std::string>& names, const std::vector<std::vector<double>>& values,
                                const std::vector<Style>& styles, const std::string& label)
{
  constexpr double LEFT = 170, TOP = 8, WIDTH = 640, ROW = 19, RIGHT = 44, BOTTOM = 42;
  double largest = 0;
  for(const std::vector<double>& parts : values)
    largest = (std::max)(largest, std::accumulate(parts.begin(), parts.end(), 0.));
  const double power = std::pow(10., std::floor(std::log10((std::max)(largest, 1e-9) / 5)));
  double step = power;
  for(double factor : {1.2, 1.6, 2., 3., 4., 6., 8., 10., 12.})
    if(5 * step < 1.06 * largest)
      step = factor * power;
  const Axis x(0, 5 * step, false, WIDTH);
  const double height = ROW * static_cast<double>(names.size());
  std::ostringstream out;
  out.precision(5);
  out << "<svg class='plot' viewBox='0 0 " << LEFT + WIDTH + RIGHT << ' ' << TOP + height + BOTTOM
      << "' xmlns='http://www.w3.org/2000/svg' font-family='Helvetica, Arial, sans-serif' font-size='11'>\n";
  for(double tick : x.ticks())
    out << "<path d='M" << LEFT + x(tick) << ' ' << TOP << 'v' << height << "' stroke='#e5e7eb'/><text x='" << LEFT + x(tick) << "' y='"
        << TOP + height + 16 << "' text-anchor='middle' fill='#4b5563'>" << x.label(tick) << "</text>\n";
  for(std::size_t i = 0; i < names.size(); ++i) {
    const double y = TOP + ROW * (static_cast<double>(i) + 0.5);
    out << "<text x='" << LEFT - 8 << "' y='" << y + 4 << "' text-anchor='end' fill='#111827'>" << names[i] << "</text>\n";
    double sum = 0;
    for(std::size_t j = 0; j < values[i].size(); ++j) {
      out << "<rect x='" << LEFT + x(sum) << "' y='" << y - 6 << "' width='" << x(values[i][j]) << "' height='12' fill='" << styles[j].color
          << "'/>";
      sum += values[i][j];
    }
    out << "<text x='" << LEFT + x(sum) + 5 << "' y='" << y + 4 << "' fill='#4b5563'>" << format(sum, 3) << "</text>\n";
  }
  out << "<rect x='" << LEFT << "' y='" << TOP << "' width='" << WIDTH << "' height='" << height
      << "' fill='none' stroke='#9ca3af'/>\n<text x='" << LEFT + WIDTH / 2 << "' y='" << TOP + height + 34
      << "' text-anchor='middle' fill='#111827'>" << label << "</text>\n</svg>\n";
  return out.str();
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_SVG_PLOTS_H
