// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Surfaces in all dialects of OFF, OBJ, PLY and STL, and in files that claim what they do not hold.

#include "support/unit_test.h"

#include "program/formats/Polygon_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_polygon_file)

namespace {

const std::vector<std::array<double, 3>> points = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0.25}}, {{0, 1, 0}}};
const std::vector<std::vector<std::size_t>> triangles = {{0, 1, 2}, {0, 2, 3}};

// What is wrong with a file of this content; it is read into `file`.
std::string read(const std::string& content, const std::string& extension, program::Polygon_file& file)
{
  const std::string path = "polygon_file." + extension;
  std::ofstream(path, std::ios::binary) << content;
  const std::string error = program::read_polygon_file(path, file);
  std::filesystem::remove(path);
  return error;
}

bool is_read(const std::string& content, const std::string& extension)
{
  program::Polygon_file file;
  const std::string error = read(content, extension, file);
  BOOST_TEST_INFO(error);
  return error.empty() && file.points == points && file.polygons == triangles;
}

bool is_refused(const std::string& content, const std::string& extension, const std::string& reason)
{
  program::Polygon_file file;
  file.points = points;
  const std::string error = read(content, extension, file);
  BOOST_TEST_INFO(error);
  return error.find(reason) != std::string::npos && file.points == points && file.polygons.empty();
}

template <typename Number>
void append(std::string& bytes, double value, bool is_big_endian)
{
  const Number number = static_cast<Number>(value);
  char buffer[sizeof(Number)];
  std::memcpy(buffer, &number, sizeof(Number));
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  if(is_big_endian == (first == 1))
    std::reverse(buffer, buffer + sizeof(Number));
  bytes.append(buffer, sizeof(Number));
}

std::string binary_OFF(const std::string& keyword, bool is_big_endian, bool has_face_colors, int numbers_per_point = 0)
{
  std::string text = keyword + " BINARY\n";
  for(const int count : {4, 2, 0})
    append<std::uint32_t>(text, count, is_big_endian);
  for(const auto& point : points) {
    for(const double x : point)
      append<float>(text, x, is_big_endian);
    for(int k = 0; k < numbers_per_point; ++k)
      append<float>(text, 0.5, is_big_endian);
  }
  for(const auto& triangle : triangles) {
    append<std::uint32_t>(text, 3, is_big_endian);
    for(const std::size_t v : triangle)
      append<std::uint32_t>(text, static_cast<double>(v), is_big_endian);
    if(has_face_colors)
      append<std::uint32_t>(text, 0, is_big_endian);
  }
  return text;
}

// Other elements, and other properties before, between and after those that matter.
template <typename Index>
std::string binary_PLY(const std::string& index_type, bool is_big_endian)
{
  std::string text = "ply\nformat binary_" + std::string(is_big_endian ? "big" : "little") +
                     "_endian 1.0\ncomment element vertex 7\nelement camera 1\nproperty list uchar short weights\nelement vertex 4\n"
                     "property double x\nproperty uchar red\nproperty float y\nproperty float z\nproperty int quality\n"
                     "element face 2\nproperty uchar flags\nproperty list ushort " +
                     index_type + " vertex_indices\nproperty list uchar float texcoord\nend_header\n";
  append<std::uint8_t>(text, 2, is_big_endian);
  append<std::int16_t>(text, -1, is_big_endian);
  append<std::int16_t>(text, 7, is_big_endian);
  for(const auto& point : points) {
    append<double>(text, point[0], is_big_endian);
    append<std::uint8_t>(text, 10, is_big_endian);
    append<float>(text, point[1], is_big_endian);
    append<float>(text, point[2], is_big_endian);
    append<std::int32_t>(text, 13, is_big_endian);
  }
  for(const auto& triangle : triangles) {
    append<std::uint8_t>(text, 1, is_big_endian);
    append<std::uint16_t>(text, 3, is_big_endian);
    for(const std::size_t v : triangle)
      append<Index>(text, static_cast<double>(v), is_big_endian);
    append<std::uint8_t>(text, 2, is_big_endian);
    append<float>(text, 0.5, is_big_endian);
    append<float>(text, 0.25, is_big_endian);
  }
  return text;
}

std::string facets(const std::vector<std::vector<std::size_t>>& some)
{
  std::string text;
  for(const auto& triangle : some) {
    text += "facet normal 0 0 1\n outer loop\n";
    for(const std::size_t v : triangle)
      text += "  vertex " + std::to_string(points[v][0]) + " " + std::to_string(points[v][1]) + " " + std::to_string(points[v][2]) + "\n";
    text += " endloop\nendfacet\n";
  }
  return text;
}

std::string binary_STL(const std::string& header, std::uint32_t claimed)
{
  std::string text = header;
  text.resize(80, ' ');
  append<std::uint32_t>(text, claimed, false);
  for(const auto& triangle : triangles) {
    for(int k = 0; k < 3; ++k)
      append<float>(text, 0, false);
    for(const std::size_t v : triangle)
      for(const double x : points[v])
        append<float>(text, x, false);
    append<std::uint16_t>(text, 0, false);
  }
  return text;
}

} // namespace

BOOST_AUTO_TEST_CASE(OFF_dialects)
{
  const std::string faces = "3 0 1 2\n3 0 2 3\n";
  BOOST_TEST(is_read("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 .25\n0 1 0\n" + faces, "off"));
  BOOST_TEST(is_read("OFF 4 2\n0 0 0\n1 0 0\n1 1 .25\n0 1 0\n" + faces, "OFF"));
  BOOST_TEST(is_read("4 2 0\n0 0 0\n1 0 0\n1 1 .25\n0 1 0\n" + faces, "off"));
  BOOST_TEST(is_read("# by hand\n\nOFF # here\n4 2 5\r\n0 0 0\n# between\n1 0 0\n1 1 .25\n\n0 1 0\n" + faces, "off"));
  BOOST_TEST(is_read("COFF\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n1 1 .25 1 2 3 4\n0 1 0 1 1 1 1\n" + faces, "off"));
  BOOST_TEST(is_read(
    "STCNOFF\n4 2 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 1 0 0\n1 1 .25 0 0 1 1 1 1 1 0 0\n0 1 0 0 0 1 1 1 1 1 0 0\n" + faces,
    "off"));
  BOOST_TEST(is_read("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 .25\n0 1 0\n3\n0 1 2\n3\n0\n2\n3", "off"));
  BOOST_TEST(is_read("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 .25\n0 1 0\n3 0 1 2 0.5 0.5 1\n3 0 2 3 7\n", "off"));
  for(const bool is_big_endian : {true, false})
    for(const bool has_face_colors : {true, false}) {
      BOOST_TEST(is_read(binary_OFF("OFF", is_big_endian, has_face_colors), "off"));
      BOOST_TEST(is_read(binary_OFF("NOFF", is_big_endian, has_face_colors, 3), "off"));
      BOOST_TEST(is_read(binary_OFF("COFF", is_big_endian, has_face_colors, 4), "off"));
    }
}

BOOST_AUTO_TEST_CASE(OFF_broken_files)
{
  BOOST_TEST(is_refused("", "off", "empty"));
  BOOST_TEST(is_refused("letter", "off", "'letter'"));
  BOOST_TEST(is_refused("4OFF\n1 0 0\n0 0 0 1\n", "off", "'4OFF'"));
  for(const char* keyword : {"OFF", "COFF", "NOFF", "STCNOFF"}) {
    BOOST_TEST(is_refused(std::string(keyword) + "\n3 1 0\n", "off", "ends too early"));
    BOOST_TEST(is_refused(std::string(keyword) + " BINARY\n", "off", "ends too early"));
  }
  BOOST_TEST(is_refused("OFF\n3 400000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "off", "ends too early"));
  BOOST_TEST(is_refused("OFF\n2000000000 1 0\n0 0 0\n", "off", "ends too early"));
  BOOST_TEST(is_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", "off", "ends too early"));
  BOOST_TEST(is_refused("OFF\n3 1 0\n0 0 0\n1 0 x\n", "off", "line 4: 'x' is not a number"));
  BOOST_TEST(is_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "off", "line 6: face number 0"));
  const std::string bytes = binary_OFF("OFF", true, true);
  for(std::size_t length = 11; length + 8 < bytes.size(); ++length)
    BOOST_TEST(is_refused(bytes.substr(0, length), "off", "cannot read"));
}

BOOST_AUTO_TEST_CASE(OBJ_dialects)
{
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 .25\nv 0 1 0\n";
  BOOST_TEST(is_read(vertices + "f 1 2 3\nf 1 3 4\n", "obj"));
  BOOST_TEST(is_read(vertices + "f 1/ 2//5 3/4/5\nf -4 -2 -1\n", "obj"));
  BOOST_TEST(is_read("f 1 2 3\nf 1 3 4\n" + vertices, "obj"));
  BOOST_TEST(is_read("\xEF\xBB\xBFv 0 0 0\rv\t1 0  0 1\rv 1 1 \\\r.25 0.5 0.5 0.5\rv 0 1 0\rf 1 2 3\rf\t1\t3\t4", "obj"));
  BOOST_TEST(is_read("mtllib a.mtl\no a b\ng\nl 1 2\np 1\nfancy 1 2 3\n" + vertices +
                       "s off\nvn 0 0 1\nvt 0 0\nf 1 2 \\\r\n3\r\nf 1 3 4\r\nl 1 2 3\n",
                     "obj"));
  program::Polygon_file file;
  BOOST_TEST(read(vertices + "f 1 2 3 4\n", "obj", file).empty());
  BOOST_TEST((file.polygons == std::vector<std::vector<std::size_t>>{{0, 1, 2, 3}}));

  BOOST_TEST(is_refused("v 0 0 0\nv 0,2 1 0\n", "obj", "line 2: '0,2' is not a number"));
  BOOST_TEST(is_refused("v 0 0\n", "obj", "line 1"));
  BOOST_TEST(is_refused("v 0 0 nan\n", "obj", "line 1"));
  BOOST_TEST(is_refused(vertices + "f 1 2 x\n", "obj", "line 5"));
  BOOST_TEST(is_refused(vertices + "f 1 2 0\n", "obj", "line 5"));
  BOOST_TEST(is_refused(vertices + "f 1 2 -5\n", "obj", "line 5"));
  BOOST_TEST(is_refused(vertices + "f 1 2 5\n", "obj", "line 5: v index 5 is out of range"));
  BOOST_TEST(is_refused("A letter.\n", "obj", "not an OBJ file"));
}

BOOST_AUTO_TEST_CASE(PLY_dialects)
{
  for(const bool is_big_endian : {true, false}) {
    BOOST_TEST(is_read(binary_PLY<std::int8_t>("char", is_big_endian), "ply"));
    BOOST_TEST(is_read(binary_PLY<std::uint16_t>("ushort", is_big_endian), "ply"));
    BOOST_TEST(is_read(binary_PLY<std::int32_t>("int32", is_big_endian), "ply"));
    BOOST_TEST(is_read(binary_PLY<std::uint32_t>("uint", is_big_endian), "ply"));
  }
  const std::string faces = "element face 2\nproperty list uchar int vertex_index\nend_header\n";
  BOOST_TEST(is_read("ply\nformat ascii 1.0\nelement vertex 4\nproperty uchar x\nproperty int y\nproperty double z\n" + faces +
                       "0 0 0 1 0 0 1 1 .25 0 1 0\n3 0 1 2\n3 0 2 3\n",
                     "ply"));
  program::Polygon_file file;
  for(const std::string type : {"char", "uchar", "short", "ushort", "int", "uint", "int8", "uint32"}) {
    const std::string text = "ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty " + type + " x\r\nproperty " + type +
                             " y\r\nproperty " + type + " z\r\nend_header\r\n1 2 3\r\n";
    BOOST_TEST(read(text, "ply", file).empty());
    BOOST_TEST((file.points == std::vector<std::array<double, 3>>{{{1, 2, 3}}}));
  }
}

BOOST_AUTO_TEST_CASE(PLY_broken_files)
{
  const std::string begin = "ply\nformat ascii 1.0\n", xyz = "property float x\nproperty float y\nproperty float z\n";
  BOOST_TEST(is_refused("plyx\n", "ply", "line 1"));
  BOOST_TEST(is_refused(begin + "property float x\nend_header\n", "ply", "line 3: a property precedes"));
  BOOST_TEST(is_refused(begin + "element vertex 1\nproperty list uchar float x\nproperty float y\nproperty float z\nend_header\n1 0 0 0\n",
                        "ply", "x of vertices is a list"));
  BOOST_TEST(is_refused(begin + "element vertex 1\nproperty half x\nend_header\n0\n", "ply", "unknown"));
  BOOST_TEST(is_refused(begin + "element vertex 1\nproperty float x\nend_header\n0\n", "ply", "x, y and z"));
  BOOST_TEST(is_refused(begin + "element vertex 1\n" + xyz, "ply", "does not end"));
  // What is there twice would be written back into one of both places.
  const std::string twice = "element vertex 1\n" + xyz;
  BOOST_TEST(is_refused(begin + twice + twice + "end_header\n0 0 0\n0 0 0\n", "ply", "line 7: there is a second element"));
  BOOST_TEST(is_refused(begin + twice + xyz + "end_header\n0 0 0 1 1 1\n", "ply", "two coordinates x"));
  BOOST_TEST(is_refused(begin + "format binary_big_endian 1.0\n" + twice + "end_header\n", "ply", "line 3: the header names a second"));
  BOOST_TEST(is_refused(begin + "element vertex 4000000000\n" + xyz + "end_header\n0 0 0\n", "ply", "ends too early"));
  BOOST_TEST(is_refused(begin + "element vertex 1\n" + xyz + "end_header\n0 0,5 0\n", "ply", "line 8: '0,5' is not a number"));
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
  for(const std::string corners : {"3 0 0 1", "3 0 0 -1", "3 0 0 0.5"})
    BOOST_TEST(is_refused(begin + "element vertex 1\n" + xyz + face + corners, "ply", "does not exist"));
  BOOST_TEST(is_refused(begin + "element vertex 1\n" + xyz + face + "4e9 0 0 0", "ply", "ends too early"));
  const std::string bytes = binary_PLY<std::int32_t>("int", false);
  for(std::size_t length = 1; length < bytes.size(); ++length)
    BOOST_TEST(is_refused(bytes.substr(0, length), "ply", "cannot read"));
}

BOOST_AUTO_TEST_CASE(STL_dialects)
{
  BOOST_TEST(is_read("solid\n" + facets(triangles) + "endsolid\n", "stl"));
  BOOST_TEST(
    is_read("solid a facet\n" + facets({triangles[0]}) + "endsolid a facet\nsolid b\n" + facets({triangles[1]}) + "endsolid b\n", "stl"));
  BOOST_TEST(is_read(binary_STL("solid of a program that calls binary files so", 2), "stl"));
  BOOST_TEST(is_read(binary_STL("exported", 2) + "more", "stl"));

  BOOST_TEST(is_refused("letter", "stl", "'letter'"));
  BOOST_TEST(is_refused(binary_STL("", 4000000000u), "stl", "ends after 2"));
  BOOST_TEST(is_refused("solid\n" + facets(triangles) + "facet normal 0 0 1\n", "stl", "within a facet"));
  BOOST_TEST(is_refused("solid\nvertex 0 0 0\n", "stl", "line 2"));
  BOOST_TEST(is_refused("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n", "stl", "line 4"));
  BOOST_TEST(is_refused("anything", "msh", "not an OFF, OBJ, PLY, STL, GLB or glTF file"));
}

BOOST_AUTO_TEST_CASE(texture_coordinates)
{
  using Images = program::Corner_images;
  const auto images = [](const std::string& content, const std::string& extension) {
    const std::string path = "polygon_file." + extension;
    std::ofstream(path, std::ios::binary) << content;
    program::Polygon_file file;
    const std::string error = program::read_polygon_file(path, file, true);
    std::filesystem::remove(path);
    BOOST_TEST(error.empty(), error);
    return file.images;
  };
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 .25\nv 0 1 0\n";
  // A face of which a corner has none has none; a third number does not matter.
  BOOST_TEST((images(vertices + "vt 0 .5 0\nvt 1 2\nf 1/1 2/2/ 3/-1\nf 1/1 3 4/2\nf 1//1 2//1 3//1\n", "obj") ==
              Images{{{0, .5}, {1, 2}, {1, 2}}, {}, {}}));
  BOOST_TEST((images("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "off") == Images{{}}));
  const std::string xyz = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
  BOOST_TEST((images(xyz + faces + "property list uchar float texcoord\nend_header\n0 0 0 1 0 0 0 1 0\n3 0 1 2 6 0 1 2 3 4 5\n3 0 1 2 0\n",
                     "ply") == Images{{{0, 1}, {2, 3}, {4, 5}}, {}}));
  BOOST_TEST(
    (images(xyz + "property float s\nproperty float t\n" + faces + "end_header\n0 0 0 .5 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n3 2 1 0\n",
            "ply") == Images{{{.5, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 0}, {.5, 0}}}));

  // Who does not ask for them does not stumble over them.
  BOOST_TEST(is_read(vertices + "vt nan 0\nf 1/9 2/9 3/x\nf 1/1/1/1 3 4\n", "obj"));
}

BOOST_AUTO_TEST_SUITE_END() // test_polygon_file
