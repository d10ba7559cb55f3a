// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_XML_SCANNER_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_XML_SCANNER_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace program {

// Elements of an XML text one after the other, as far as VTU files need it: no CDATA, and no '>' within attributes.
class XML_scanner
{
public:
  explicit XML_scanner(std::string_view text) : m_text(text) {}

  // Goes to the next tag; false at the end of the text or when it does not end properly, see is_broken().
  bool next()
  {
    for(;;) {
      const std::size_t begin = m_text.find('<', m_end);
      if(begin == std::string_view::npos)
        return false;
      if(m_text.substr(begin, 4) == "<!--") {
        const std::size_t end = m_text.find("-->", begin);
        m_is_broken = end == std::string_view::npos;
        if(m_is_broken)
          return false;
        m_end = end + 3;
        continue;
      }
      const std::size_t end = m_text.find('>', begin);
      m_is_broken = end == std::string_view::npos;
      if(m_is_broken)
        return false;
      m_tag = m_text.substr(begin + 1, end - begin - 1);
      m_end = end + 1;
      if(m_tag.empty() || m_tag.front() == '?' || m_tag.front() == '!')
        continue;
      return true;
    }
  }

  bool is_broken() const { return m_is_broken; }

  // The name, with the slash of a closing tag.
  std::string_view name() const
  {
    std::string_view name = m_tag.substr(0, m_tag.find_first_of(" \t\r\n"));
    if(name.size() > 1 && name.back() == '/')
      name.remove_suffix(1);
    return name;
  }

  // The value of the attribute, as it is written; empty when there is none.
  std::string_view attribute(std::string_view key) const
  {
    // One after the other, since what looks like an attribute may be a part of the value of another one.
    const std::string_view space = " \t\r\n";
    for(std::size_t i = m_tag.find_first_of(space); (i = m_tag.find_first_not_of(space, i)) != std::string_view::npos;) {
      const std::size_t name_end = m_tag.find_first_of(" \t\r\n=", i);
      const std::size_t equals = m_tag.find_first_not_of(space, name_end);
      if(equals == std::string_view::npos)
        break;
      const bool is_key = m_tag.substr(i, name_end - i) == key;
      i = equals;
      if(m_tag[equals] != '=')
        continue;
      i = m_tag.find_first_not_of(space, equals + 1);
      if(i == std::string_view::npos || (m_tag[i] != '"' && m_tag[i] != '\''))
        continue;
      const std::size_t end = m_tag.find(m_tag[i], i + 1);
      if(end == std::string_view::npos)
        break;
      if(is_key)
        return m_tag.substr(i + 1, end - i - 1);
      i = end + 1;
    }
    return std::string_view();
  }

  // The text from here to the next tag.
  std::string_view content() const { return m_text.substr(m_end, m_text.find('<', m_end) - m_end); }

  // The line on which the tag ends, from 1.
  long long line() const { return 1 + std::count(m_text.begin(), m_text.begin() + m_end, '\n'); }

private:
  std::string_view m_text;
  std::string_view m_tag;
  std::size_t m_end = 0;
  bool m_is_broken = false;
};

// The characters that attributes cannot hold as they are, and what stands for them.
constexpr std::array<std::pair<char, std::string_view>, 5> XML_ENTITIES{
  {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}}};

inline std::string without_entities(std::string_view text)
{
  std::string result;
  while(!text.empty()) {
    std::size_t length = 1;
    char c = text.front();
    for(const auto& [character, entity] : XML_ENTITIES)
      if(text.substr(0, entity.size()) == entity) {
        c = character;
        length = entity.size();
      }
    result += c;
    text.remove_prefix(length);
  }
  return result;
}

inline std::string with_entities(std::string_view text)
{
  std::string result;
  for(const char c : text) {
    const auto found = std::find_if(XML_ENTITIES.begin(), XML_ENTITIES.end(), [c](const auto& entry) { return entry.first == c; });
    if(found == XML_ENTITIES.end())
      result += c;
    else
      result += found->second;
  }
  return result;
}

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_XML_SCANNER_H
