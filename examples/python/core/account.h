// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The account of a run for Python: what JSON has of it, the names of the fields that text shows, and the text.

#ifndef FLIP_FREE_MAPS_PYTHON_ACCOUNT_H
#define FLIP_FREE_MAPS_PYTHON_ACCOUNT_H

#include <CGAL/Flip_free_maps/report/Outcome.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <sstream>
#include <string>

namespace python {

namespace py = pybind11;
namespace FFM = CGAL::Flip_free_maps;

// What `FFM::to_json()` asks of a value.
class Value
{
public:
  Value() : m_value(py::none()) {}
  explicit Value(std::nullptr_t) : m_value(py::none()) {}
  template <typename T>
  explicit Value(const T& value) : m_value(py::cast(value))
  {}

  static Value object() { return Value(py::dict(), 0); }
  static Value array() { return Value(py::list(), 0); }

  void push_back(const Value& value) { m_value.attr("append")(value.m_value); }

  class Entry
  {
  public:
    Entry(const py::object& dictionary, const char* name) : m_dictionary(dictionary), m_name(name) {}
    void operator=(const Value& value) { m_dictionary[m_name] = value.m_value; }

  private:
    const py::object& m_dictionary;
    const char* m_name;
  };
  Entry operator[](const char* name) { return Entry(m_value, name); }

  const py::object& get() const { return m_value; }

private:
  Value(const py::object& value, int) : m_value(value) {}

  py::object m_value;
};

// The names of the fields that text shows.
struct Shown_names
{
  template <typename T>
  void operator()(const char* name, const T&, FFM::Field_role role = FFM::Field_role::shown)
  {
    if(role == FFM::Field_role::shown)
      names.append(name);
  }

  py::list names;
};

template <typename Account>
py::tuple account(const Account& outcome)
{
  Value value = Value::object();
  FFM::to_json(value, outcome);
  Shown_names shown;
  outcome.for_each_field(shown);
  std::ostringstream text;
  text << outcome;
  return py::make_tuple(value.get(), shown.names, text.str());
}

// The account of a run that could not begin.
inline py::tuple refusal(const std::string& reason)
{
  return py::make_tuple(py::none(), account(FFM::Outcome(FFM::Status::invalid_option, reason)));
}

} // namespace python

#endif // FLIP_FREE_MAPS_PYTHON_ACCOUNT_H
