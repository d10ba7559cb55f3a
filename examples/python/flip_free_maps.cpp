// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The functions of the Python module, on arrays of numpy. Accounts become dictionaries; flip_free_maps/__init__.py makes objects
// and exceptions of them.

#include <CGAL/Flip_free_maps/Any_map_traits.h>
#include <CGAL/Flip_free_maps/bijective.h>
#include <CGAL/Flip_free_maps/is_bijective.h>
#include <CGAL/Flip_free_maps/measure_distortion.h>
#include <CGAL/Flip_free_maps/parameterize.h>
#include <CGAL/Flip_free_maps/unwrap.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace FFM = CGAL::Flip_free_maps;

namespace {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::int64_t, 3>>;
using Uv = std::vector<std::array<double, 2>>;
using Corners = std::vector<std::array<std::array<double, 2>, 3>>;

// Copies an array of shape (n, N), whatever its type and layout.
template <typename T, std::size_t N>
std::vector<std::array<T, N>> rows(const py::array& array, const char* name)
{
  const auto numbers = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(array);
  if(!numbers)
    throw py::error_already_set();
  if(numbers.ndim() != 2 || numbers.shape(1) != static_cast<py::ssize_t>(N))
    throw py::value_error(std::string(name) + " must have the shape (n, " + std::to_string(N) + ")");
  std::vector<std::array<T, N>> result(static_cast<std::size_t>(numbers.shape(0)));
  if(!result.empty())
    std::memcpy(result.data(), numbers.data(), result.size() * sizeof(result[0]));
  return result;
}

Triangles triangles_of(const py::array& array)
{
  const char kind = array.dtype().kind();
  if(array.size() > 0 && kind != 'i' && kind != 'u')
    throw py::type_error("triangles must be an array of integers");
  return rows<std::int64_t, 3>(array, "triangles");
}

// An array that owns a copy of the rows.
template <typename T, typename Row>
py::array_t<T> array_of(const std::vector<Row>& rows, std::vector<py::ssize_t> shape)
{
  py::array_t<T> result(std::move(shape));
  if(!rows.empty())
    std::memcpy(result.mutable_data(), rows.data(), rows.size() * sizeof(Row));
  return result;
}

// Makes a dictionary of the fields of an account.
class Dictionary
{
public:
  template <typename T>
  void operator()(const char* name, const T& value, FFM::Field_role = FFM::Field_role::detail)
  {
    m_dictionary[name] = object_of(value);
  }

  template <typename Account>
  static py::dict of(const Account& account)
  {
    Dictionary result;
    account.for_each_field(result);
    return result.m_dictionary;
  }

private:
  template <typename T>
  static py::object object_of(const T& value)
  {
    if constexpr(std::is_same_v<T, FFM::Status>)
      return py::str(FFM::status_name(value));
    else if constexpr(FFM::internal::Has_fields<T>::value)
      return of(value);
    else
      return py::cast(value);
  }

  template <typename T>
  static py::object object_of(const std::vector<T>& values)
  {
    py::list list;
    for(const T& value : values)
      list.append(object_of(value));
    return std::move(list);
  }

  py::dict m_dictionary;
};

// Lets Python's signals and a function of the caller's stop a run; what they raise is raised again at its end.
class Watch
{
public:
  explicit Watch(const py::object& progress) : m_progress(progress) {}

  // Whether the run may go on. Called without the interpreter's lock.
  template <typename Report>
  bool operator()(Report&& report)
  {
    if(m_error)
      return false;
    const py::gil_scoped_acquire lock;
    try {
      if(PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      if(m_progress.is_none())
        return true;
      const py::object answer = m_progress(report());
      return answer.is_none() || answer.cast<bool>();
    } catch(py::error_already_set& error) {
      m_error.emplace(error);
      return false;
    }
  }

  void raise()
  {
    if(m_error)
      throw py::error_already_set(*m_error);
  }

private:
  py::object m_progress;
  std::optional<py::error_already_set> m_error;
};

py::tuple parameterize(const py::array& points, const py::array& triangles, const std::string& method, int max_iterations,
                       double time_limit, bool bijective, const py::object& progress)
{
  const Points p = rows<double, 3>(points, "points");
  const Triangles t = triangles_of(triangles);
  FFM::Any_map_traits traits;
  if(!traits.use_method(method))
    throw py::value_error("there is no method '" + method + "'");
  Watch watch(progress);
  FFM::Map_options options = traits.options;
  if(max_iterations >= 0)
    options.max_iterations = max_iterations;
  options.max_seconds = time_limit;
  options.observer = [&watch](const FFM::Iteration_report& report) {
    return watch([&report] {
      py::dict dictionary;
      dictionary["iteration"] = report.iteration;
      dictionary["energy"] = report.energy;
      return dictionary;
    });
  };
  Uv uv;
  FFM::Summary summary;
  {
    const py::gil_scoped_release unlocked;
    if(method == "default") {
      const auto np = FFM::parameters::map_options(options);
      summary = bijective ? FFM::parameterize(p, t, uv, FFM::parameters::bijective(true, np)) : FFM::parameterize(p, t, uv, np);
    } else {
      traits.options = options;
      const auto np = FFM::parameters::map_traits(traits);
      summary = bijective ? FFM::parameterize(p, t, uv, FFM::parameters::bijective(true, np)) : FFM::parameterize(p, t, uv, np);
    }
  }
  watch.raise();
  return py::make_tuple(array_of<double>(uv, {static_cast<py::ssize_t>(uv.size()), 2}), Dictionary::of(summary));
}

py::tuple unwrap(const py::array& points, const py::array& triangles, double max_distortion, double margin, int resolution,
                 double padding, bool rotate, double time_limit, const py::object& progress)
{
  const Points p = rows<double, 3>(points, "points");
  const Triangles t = triangles_of(triangles);
  Watch watch(progress);
  FFM::Unwrap_options options;
  options.max_distortion = max_distortion;
  options.packing.margin = margin;
  options.packing.resolution = resolution;
  options.packing.padding = padding;
  options.packing.rotate = rotate;
  options.max_seconds = time_limit;
  options.observer = [&watch](const FFM::Unwrap_progress& report) {
    return watch([&report] {
      py::dict dictionary;
      dictionary["charts_done"] = report.charts_done;
      dictionary["charts"] = report.charts;
      dictionary["faces_done"] = report.faces_done;
      dictionary["faces"] = report.faces;
      dictionary["seconds"] = report.seconds;
      return dictionary;
    });
  };
  Corners corners;
  FFM::Unwrap_summary summary;
  {
    const py::gil_scoped_release unlocked;
    summary = FFM::unwrap(p, t, corners, FFM::parameters::unwrap_options(options));
  }
  watch.raise();
  return py::make_tuple(array_of<double>(corners, {static_cast<py::ssize_t>(corners.size()), 3, 2}), Dictionary::of(summary));
}

// Vertices of a file or a graphics card, of which each has one point and one image: what corners share both are one.
py::tuple join_corners(const py::array& triangles, const py::array_t<double, py::array::c_style | py::array::forcecast>& uv)
{
  const Triangles t = triangles_of(triangles);
  if(uv.ndim() != 3 || uv.shape(0) != static_cast<py::ssize_t>(t.size()) || uv.shape(1) != 3 || uv.shape(2) != 2)
    throw py::value_error("uv must have the shape (number of triangles, 3, 2)");
  std::map<std::tuple<std::int64_t, double, double>, std::uint32_t> numbers;
  std::vector<std::uint32_t> vertices;
  std::vector<std::array<std::uint32_t, 3>> indices(t.size());
  std::vector<std::array<float, 2>> images;
  const auto image = uv.unchecked<3>();
  for(std::size_t f = 0; f < t.size(); ++f)
    for(int k = 0; k < 3; ++k) {
      const double u = image(f, k, 0), v = image(f, k, 1);
      const auto entry = numbers.emplace(std::make_tuple(t[f][k], u, v), static_cast<std::uint32_t>(vertices.size()));
      if(entry.second) {
        vertices.push_back(static_cast<std::uint32_t>(t[f][k]));
        images.push_back({static_cast<float>(u), static_cast<float>(v)});
      }
      indices[f][k] = entry.first->second;
    }
  return py::make_tuple(array_of<std::uint32_t>(vertices, {static_cast<py::ssize_t>(vertices.size())}),
                        array_of<std::uint32_t>(indices, {static_cast<py::ssize_t>(indices.size()), 3}),
                        array_of<float>(images, {static_cast<py::ssize_t>(images.size()), 2}));
}

py::dict measure(const py::array& points, const py::array& triangles, const py::array& uv)
{
  return Dictionary::of(
    FFM::measure_distortion(rows<double, 3>(points, "points"), triangles_of(triangles), rows<double, 2>(uv, "uv")));
}

py::tuple is_bijective(const py::array& triangles, const py::array& uv)
{
  std::string message;
  const bool answer = FFM::is_bijective(triangles_of(triangles), rows<double, 2>(uv, "uv"), &message);
  return py::make_tuple(answer, message);
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.def("parameterize", &parameterize);
  module.def("unwrap", &unwrap);
  module.def("join_corners", &join_corners);
  module.def("measure", &measure);
  module.def("is_bijective", &is_bijective);
}
