// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "volume_formats.h"

#include <CGAL/Flip_free_maps/IO/internal/Word_reader.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace program {

namespace internal = CGAL::Flip_free_maps::internal;

namespace {

std::string_view trimmed(std::string_view text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string in_capitals(std::string_view text)
{
  std::string result;
  for(const char c : text)
    if(c != ' ' && c != '\t')
      result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return result;
}

// The cell of an element's type; foreign solids are -1 and other elements, which stay where they are, 0.
int cell_of(const std::string& type)
{
  const std::size_t family = type.find("C3D");
  if(family != std::string::npos && family <= 1) {
    const std::string_view digits = std::string_view(type).substr(family + 3);
    const std::size_t length = (std::min)(digits.find_first_not_of("0123456789"), digits.size());
    return digits.substr(0, length) == "4"    ? cell_type::TETRAHEDRON
           : digits.substr(0, length) == "10" ? cell_type::QUADRATIC_TETRAHEDRON
                                              : -1;
  }
  for(const char* name : {"COH3D", "CIN3D", "SC6", "SC8", "GK3D", "CSS8"})
    if(type.rfind(name, 0) == 0)
      return -1;
  for(const char* name : {"S3", "S3R", "STRI3", "CPS3", "CPE3", "CPEG3", "M3D3", "SFM3D3", "DS3", "R3D3"})
    if(type == name)
      return cell_type::TRIANGLE;
  return 0;
}

class Abaqus_reader
{
public:
  Abaqus_reader(std::string_view text, Volume_file& file) : m_text(text), m_file(file) {}

  std::string read()
  {
    while(m_position < m_text.size()) {
      const std::string error = read_line(next_line());
      if(!error.empty())
        return "line " + std::to_string(m_line) + ": " + error;
    }
    if(m_file.points.empty())
      return "the file has no *NODE";
    return add_regions();
  }

private:
  struct Element_set
  {
    std::string name;
    std::vector<std::array<long long, 3>> ranges; // first, last and step
    std::vector<std::size_t> cells;
  };

  std::string_view next_line()
  {
    const std::string_view line = m_text.substr(m_position, m_text.find('\n', m_position) - m_position);
    m_position = (std::min)(m_position + line.size() + 1, m_text.size());
    ++m_line;
    return line;
  }

  std::string read_line(std::string_view line)
  {
    const std::string_view text = trimmed(line);
    if(text.empty() || text.substr(0, 2) == "**")
      return "";
    if(text.front() == '*')
      return read_keyword(text);
    if(m_keyword == "*NODE")
      return read_point(line);
    if(m_keyword == "*ELEMENT")
      return read_element(line);
    return m_keyword == "*ELSET" ? read_set(line) : "";
  }

  // The parts of a line between its commas.
  static std::vector<std::string_view> fields_of(std::string_view line)
  {
    std::vector<std::string_view> fields;
    for(std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = (std::min)(line.find(',', begin), line.size());
      fields.push_back(trimmed(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    if(!fields.empty() && fields.back().empty())
      fields.pop_back();
    return fields;
  }

  // The word after an asterisk, and parameters, which go on in the next line behind a comma.
  std::string read_keyword(std::string_view text)
  {
    std::string all(text);
    while(all.back() == ',' && m_position < m_text.size())
      all += trimmed(next_line());
    const std::vector<std::string_view> fields = fields_of(all);
    m_keyword = in_capitals(fields[0]);
    m_parameters.clear();
    for(std::size_t i = 1; i < fields.size(); ++i) {
      const std::size_t sign = fields[i].find('=');
      m_parameters[in_capitals(fields[i].substr(0, sign))] =
        sign == std::string_view::npos ? std::string() : std::string(trimmed(fields[i].substr(sign + 1)));
    }
    m_rest.clear();
    for(const char* keyword : {"*INCLUDE", "*SYSTEM", "*NGEN", "*NFILL", "*NCOPY", "*NMAP", "*ELGEN", "*ELCOPY"})
      if(m_keyword == keyword)
        return "the keyword " + m_keyword + " is not supported; write the file with all its nodes and elements in place";
    if(m_keyword == "*NODE" && (m_parameters.count("SYSTEM") > 0 && in_capitals(m_parameters["SYSTEM"]) != "R"))
      return "only Cartesian coordinates are supported";
    if((m_keyword == "*NODE" || m_keyword == "*ELEMENT" || m_keyword == "*ELSET") && m_parameters.count("INPUT") > 0)
      return "numbers in other files are not supported";
    if(m_keyword == "*ELEMENT") {
      m_type = in_capitals(m_parameters["TYPE"]);
      m_cell = cell_of(m_type);
    }
    m_set = m_keyword == "*ELSET" || (m_keyword == "*ELEMENT" && m_parameters.count("ELSET") > 0) ? find_set(m_parameters["ELSET"]) : 0;
    return "";
  }

  std::size_t find_set(const std::string& name)
  {
    const auto entry = m_set_numbers.emplace(in_capitals(name), m_sets.size());
    if(entry.second)
      m_sets.push_back({name, {}, {}});
    return entry.first->second;
  }

  static std::string read_integer(std::string_view word, long long& value)
  {
    return internal::parse_number(word, value) == std::errc() ? "" : internal::quoted_word(word) + " is not an integer";
  }

  std::string read_point(std::string_view line)
  {
    const std::vector<std::string_view> fields = fields_of(line);
    if(fields.size() < 4)
      return "a node has a number and three coordinates";
    long long number = 0;
    const std::string error = read_integer(fields[0], number);
    if(!error.empty())
      return error;
    if(!m_numbers.emplace(number, static_cast<int>(m_file.points.size())).second)
      return "a second node " + std::to_string(number) + "; files of several parts are not supported";
    std::array<double, 3> point;
    for(int c = 0; c < 3; ++c) {
      if(internal::parse_number(fields[c + 1], point[c]) != std::errc() || !std::isfinite(point[c]))
        return internal::quoted_word(fields[c + 1]) + " is not a finite number";
      m_file.coordinate_places.push_back(static_cast<std::size_t>(fields[c + 1].data() - m_text.data()));
    }
    m_file.points.push_back(point);
    return "";
  }

  // Goes on in the next line behind a comma.
  std::string read_element(std::string_view line)
  {
    for(const std::string_view field : fields_of(line)) {
      long long number = 0;
      const std::string error = read_integer(field, number);
      if(!error.empty())
        return error;
      m_rest.push_back(number);
    }
    const std::size_t wanted = m_cell > 0 ? 1 + number_of_nodes(m_cell) : 0;
    if(trimmed(line).back() == ',' && (wanted == 0 || m_rest.size() < wanted))
      return "";
    const std::vector<long long> numbers = std::move(m_rest);
    m_rest.clear();
    if(m_cell < 0)
      ++m_file.foreign_cells[m_type + " (" + std::to_string(numbers.size() - 1) + " nodes each)"];
    if(m_cell <= 0)
      return "";
    if(numbers.size() != wanted)
      return "an element " + m_type + " has a number and " + std::to_string(wanted - 1) + " nodes";
    std::vector<int> nodes;
    for(std::size_t k = 1; k < numbers.size(); ++k) {
      const auto found = m_numbers.find(numbers[k]);
      if(found == m_numbers.end())
        return "there is no node " + std::to_string(numbers[k]);
      nodes.push_back(found->second);
    }
    if(!m_elements.emplace(numbers[0], m_file.cells.size()).second)
      return "a second element " + std::to_string(numbers[0]) + "; files of several parts are not supported";
    if(m_parameters.count("ELSET") > 0)
      m_sets[m_set].cells.push_back(m_file.cells.size());
    m_file.cells.add(m_cell, nodes);
    return "";
  }

  // Numbers of elements, names of other sets, or with GENERATE a first and a last number and a step.
  std::string read_set(std::string_view line)
  {
    const std::vector<std::string_view> fields = fields_of(line);
    std::vector<long long> numbers;
    for(const std::string_view field : fields) {
      long long number = 0;
      if(internal::parse_number(field, number) == std::errc())
        numbers.push_back(number);
      else if(m_set_numbers.count(in_capitals(field)) == 0) // the elements of a set that was there before have their region
        return "there is no set " + internal::quoted_word(field) + " before this one";
    }
    if(m_parameters.count("GENERATE") == 0)
      for(const long long number : numbers)
        m_sets[m_set].ranges.push_back({number, number, 1});
    else if(numbers.size() < 2 || numbers.size() > 3 || numbers.back() < 1)
      return "a set is generated from a first and a last number and a step";
    else
      m_sets[m_set].ranges.push_back({numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 1});
    return "";
  }

  // The region of an element is the number of the first set that holds it, from 1, those of *ELEMENT before those of *ELSET.
  std::string add_regions()
  {
    std::vector<std::int64_t> regions(m_file.cells.size(), 0);
    const auto add = [&](std::size_t cell, std::size_t set) {
      if(regions[cell] == 0)
        regions[cell] = static_cast<std::int64_t>(set + 1);
    };
    for(std::size_t s = 0; s < m_sets.size(); ++s)
      for(const std::size_t cell : m_sets[s].cells)
        add(cell, s);
    std::size_t work = 0; // bounded by the size of the file, however often it names all elements
    for(std::size_t s = 0; s < m_sets.size(); ++s)
      for(const auto& [first, last, step] : m_sets[s].ranges)
        for(auto element = m_elements.lower_bound(first); element != m_elements.end() && element->first <= last; ++element) {
          if(++work > 100 * (m_text.size() + m_elements.size()))
            return "the sets name all elements too often";
          if((element->first - first) % step == 0)
            add(element->second, s);
        }
    std::vector<int> dimensions(m_sets.size() + 1, 0); // 0 for those that are no region
    for(std::size_t i = 0; i < regions.size(); ++i)
      dimensions[regions[i]] = (std::max)(dimensions[regions[i]], m_file.cells.types[i] == cell_type::TRIANGLE ? 2 : 3);
    for(std::size_t s = 0; s < m_sets.size(); ++s)
      if(dimensions[s + 1] > 0)
        m_file.groups.push_back({dimensions[s + 1], static_cast<std::int64_t>(s + 1), m_sets[s].name});
    m_file.cell_data.push_back(integer_array(REGION, Number_type::int32, std::move(regions)));
    return "";
  }

  std::string_view m_text;
  Volume_file& m_file;
  std::size_t m_position = 0;
  long long m_line = 0;
  std::string m_keyword, m_type;
  std::map<std::string, std::string> m_parameters;
  int m_cell = 0;
  std::size_t m_set = 0;
  std::vector<long long> m_rest;                // of an element that goes on in the next line
  std::unordered_map<long long, int> m_numbers; // of nodes
  std::map<long long, std::size_t> m_elements;
  std::map<std::string, std::size_t> m_set_numbers;
  std::vector<Element_set> m_sets;
};

} // namespace

std::string read_Abaqus(std::string_view text, Volume_file& file) { return Abaqus_reader(text, file).read(); }

std::string Abaqus_text(const Volume_file& file)
{
  std::string text = "*HEADING\nwritten by flip_free_maps\n*NODE\n";
  const auto add_numbers = [&text](std::size_t number, const auto& values) {
    internal::append_number(text, static_cast<long long>(number));
    for(const auto value : values) {
      text += ", ";
      internal::append_number(text, value);
    }
    text += '\n';
  };
  for(std::size_t i = 0; i < file.points.size(); ++i)
    add_numbers(i + 1, file.points[i]);
  const Data_array* regions = find_regions(file);
  for(const auto& [type, name] :
      {std::pair<int, const char*>{cell_type::TETRAHEDRON, "C3D4"}, {cell_type::QUADRATIC_TETRAHEDRON, "C3D10"}}) {
    std::map<std::int64_t, std::vector<std::size_t>> cells;
    for(std::size_t i = 0; i < file.cells.size(); ++i)
      if(file.cells.types[i] == type)
        cells[regions == nullptr ? 0 : regions->integers[i]].push_back(i);
    for(const auto& [region, list] : cells) {
      const auto group = std::find_if(file.groups.begin(), file.groups.end(),
                                      [number = region](const Named_group& g) { return g.dimension == 3 && g.number == number; });
      text += std::string("*ELEMENT, TYPE=") + name +
              ", ELSET=" + (group == file.groups.end() ? "REGION_" + std::to_string(region) : group->name) + '\n';
      for(const std::size_t i : list) {
        std::vector<long long> nodes(file.cells.nodes.begin() + file.cells.begin(i), file.cells.nodes.begin() + file.cells.ends[i]);
        for(long long& node : nodes)
          ++node;
        add_numbers(i + 1, nodes);
      }
    }
  }
  return text;
}

} // namespace program
