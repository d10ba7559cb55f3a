// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_TABLE_H
#define CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_TABLE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace benchmark_support {

// A table of text with named columns, as a CSV or TSV file holds it. Lines that begin with # are comments.
class Table
{
public:
  Table() = default;
  explicit Table(std::vector<std::string> columns) : m_columns(std::move(columns)) {}

  std::size_t number_of_rows() const { return m_rows.size(); }
  const std::vector<std::string>& columns() const { return m_columns; }
  const std::vector<std::string>& row(std::size_t i) const { return m_rows[i]; }
  std::vector<std::string>& comments() { return m_comments; }
  const std::vector<std::string>& comments() const { return m_comments; }

  void add_row(std::vector<std::string> cells)
  {
    cells.resize(m_columns.size());
    m_rows.push_back(std::move(cells));
  }

  bool has_column(const std::string& name) const { return index(name) < m_columns.size(); }

  // The text of a cell, empty if there is no such column.
  std::string text(std::size_t row, const std::string& column) const
  {
    const std::size_t i = index(column);
    return i < m_columns.size() ? m_rows[row][i] : std::string();
  }

  // The number at the beginning of a cell, NaN if there is none.
  double number(std::size_t row, const std::string& column) const
  {
    const std::string cell = text(row, column);
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return end == cell.c_str() ? std::numeric_limits<double>::quiet_NaN() : value;
  }

  void set(std::size_t row, const std::string& column, const std::string& cell)
  {
    const std::size_t i = index(column);
    if(i < m_columns.size())
      m_rows[row][i] = cell;
  }

  // Adds the rows and comments of another table with the same columns.
  void append(const Table& other)
  {
    if(m_columns.empty())
      m_columns = other.m_columns;
    for(const std::string& comment : other.m_comments)
      if(std::find(m_comments.begin(), m_comments.end(), comment) == m_comments.end())
        m_comments.push_back(comment);
    for(std::size_t i = 0; i < other.number_of_rows(); ++i) {
      std::vector<std::string> cells;
      for(const std::string& column : m_columns)
        cells.push_back(other.text(i, column));
      add_row(cells);
    }
  }

  bool read(const std::string& path, char separator = ',')
  {
    std::ifstream file(path);
    if(!file)
      return false;
    for(std::string line; std::getline(file, line);) {
      if(!line.empty() && line.back() == '\r')
        line.pop_back();
      if(line.empty())
        continue;
      if(line[0] == '#')
        m_comments.push_back(line.substr(std::min<std::size_t>(2, line.size())));
      else if(m_columns.empty())
        m_columns = split(line, separator);
      else
        add_row(split(line, separator));
    }
    return !m_columns.empty();
  }

  bool write(const std::string& path) const
  {
    std::ofstream file(path);
    write(file);
    return bool(file);
  }

  void write(std::ostream& out) const
  {
    for(const std::string& comment : m_comments)
      out << "# " << comment << '\n';
    write_line(out, m_columns);
    for(const auto& row : m_rows)
      write_line(out, row);
  }

private:
  std::size_t index(const std::string& name) const { return std::find(m_columns.begin(), m_columns.end(), name) - m_columns.begin(); }

  static void write_line(std::ostream& out, const std::vector<std::string>& cells)
  {
    for(std::size_t i = 0; i < cells.size(); ++i) {
      const bool quote = cells[i].find_first_of(",\"") != std::string::npos;
      out << (i == 0 ? "" : ",") << (quote ? "\"" : "");
      for(char c : cells[i])
        out << (c == '"' ? "\"\"" : std::string(1, c));
      out << (quote ? "\"" : "");
    }
    out << '\n';
  }

  static std::vector<std::string> split(const std::string& line, char separator)
  {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for(std::size_t i = 0; i < line.size(); ++i) {
      if(line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
        cells.back() += line[i++];
      else if(line[i] == '"')
        is_quoted = !is_quoted;
      else if(line[i] == separator && !is_quoted)
        cells.emplace_back();
      else
        cells.back() += line[i];
    }
    return cells;
  }

  std::vector<std::string> m_columns;
  std::vector<std::vector<std::string>> m_rows;
  std::vector<std::string> m_comments;
};

// The name of a mesh up to the first underscore.
inline std::string set_of(const std::string& mesh) { return mesh.substr(0, mesh.find('_')); }

// A number as short as `digits` significant digits allow; a dash for what is no finite number.
inline std::string format(double value, int digits = 4)
{
  if(!std::isfinite(value))
    return "-";
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

// The value below which the fraction `p` of the values lies, by linear interpolation. NaN without values; NaNs do not count.
inline double quantile(std::vector<double> values, double p)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }), values.end());
  if(values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const double position = p * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(position);
  const std::size_t above = (std::min)(below + 1, values.size() - 1);
  if(std::isinf(values[above]))
    return position == static_cast<double>(below) ? values[below] : values[above];
  return values[below] + (position - static_cast<double>(below)) * (values[above] - values[below]);
}

} // namespace benchmark_support

#endif // CGAL_FLIP_FREE_MAPS_BENCHMARK_SUPPORT_TABLE_H
