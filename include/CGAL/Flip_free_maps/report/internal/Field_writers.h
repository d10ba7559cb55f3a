// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_FIELD_WRITERS_H
#define CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_FIELD_WRITERS_H

#include <CGAL/Flip_free_maps/report/Status.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// Where a field of an account is written.
enum class Field_role
{
  shown, ///< in JSON, and in the few lines of `operator<<`
  detail ///< in JSON only
};

namespace internal {

struct Any_visitor
{
  template <typename T>
  void operator()(const char*, const T&, Field_role = Field_role::shown) const
  {}
};

// Whether a type names its fields by a member `for_each_field(visit)`.
template <typename T, typename = void>
struct Has_fields : std::false_type
{};

template <typename T>
struct Has_fields<T, std::void_t<decltype(std::declval<const T&>().for_each_field(std::declval<const Any_visitor&>()))>> : std::true_type
{};

template <typename T>
struct Is_optional : std::false_type
{};

template <typename T>
struct Is_optional<std::optional<T>> : std::true_type
{};

// Enters fields into a JSON object with the interface of nlohmann::json.
template <typename Json>
class Json_fields
{
public:
  explicit Json_fields(Json& json) : m_json(json) {}

  template <typename T>
  void operator()(const char* name, const T& value, Field_role = Field_role::shown) const
  {
    m_json[name] = converted(value);
  }

private:
  template <typename T>
  static Json converted(const T& value)
  {
    if constexpr(std::is_same_v<T, Status>) {
      return Json(status_name(value));
    } else if constexpr(std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      return Json(value);
    } else if constexpr(Is_optional<T>::value) {
      return value.has_value() ? converted(*value) : Json(nullptr);
    } else if constexpr(Has_fields<T>::value) {
      Json object = Json::object();
      value.for_each_field(Json_fields(object));
      return object;
    } else {
      Json array = Json::array();
      for(std::size_t i = 0; i < static_cast<std::size_t>(value.size()); ++i)
        array.push_back(converted(value[i]));
      return array;
    }
  }

  Json& m_json;
};

// Writes fields as lines of "name value" with commas between them. Those that were not reached, and lists, are left out.
class Text_fields
{
public:
  explicit Text_fields(std::ostream& os) : m_os(os) {}

  template <typename T>
  void operator()(const char* name, const T& value, Field_role role = Field_role::shown)
  {
    if(role == Field_role::detail)
      return;
    if constexpr(Is_optional<T>::value) {
      if(value.has_value())
        (*this)(name, *value);
    } else if constexpr(std::is_same_v<T, bool>) {
      add(name, value ? "yes" : "no");
    } else if constexpr(std::is_arithmetic_v<T>) {
      if(value != T(-1)) {
        std::ostringstream text;
        text << value;
        add(name, text.str());
      }
    } else if constexpr(std::is_same_v<T, std::string>) {
      if(!value.empty())
        add(name, value);
    } else if constexpr(Has_fields<T>::value) {
      end_line();
      m_line = std::string("  ") + name + ':';
      m_separator = " ";
      value.for_each_field(*this);
      end_line();
    }
  }

  void end_line()
  {
    if(!m_line.empty())
      m_os << m_line << '\n';
    m_line.clear();
  }

private:
  void add(const char* name, const std::string& value)
  {
    constexpr std::size_t WIDTH = 120;
    std::string entry = name;
    for(char& c : entry)
      c = c == '_' ? ' ' : c;
    entry += ' ' + value;
    if(m_line.size() + entry.size() > WIDTH)
      end_line();
    m_line += m_line.empty() ? "  " + entry : m_separator + entry;
    m_separator = ", ";
  }

  std::ostream& m_os;
  std::string m_line;
  std::string m_separator; // between what the line has and the next entry
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_INTERNAL_FIELD_WRITERS_H
