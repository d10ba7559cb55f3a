// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files that are written back with other texture coordinates or points, and with nothing else changed.

#include "support/unit_test.h"

#include "program/formats/Polygon_document.h"
#include "program/formats/Polygon_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_polygon_document)

namespace {

program::Polygon_file read(const std::string& content, const std::string& extension)
{
  const std::string path = "polygon_document" + extension;
  std::ofstream(path, std::ios::binary) << content;
  program::Polygon_file file;
  const std::string error = program::read_polygon_file(path, file, true);
  std::filesystem::remove(path);
  BOOST_TEST(error.empty(), error << "\n" << content);
  return file;
}

// Images that differ from corner to corner, with numbers that no decimal fraction of few digits is.
program::Corner_images some_images(const program::Polygon_file& file)
{
  program::Corner_images images;
  for(const auto& polygon : file.polygons) {
    images.emplace_back();
    for(const std::size_t v : polygon)
      images.back().push_back({(static_cast<double>(images.size()) + 1) / 3, static_cast<double>(v) / 7});
  }
  return images;
}

// The text without its vt lines and texture indices, and without slashes that nothing follows: what is left must not change.
std::string without_texture(const std::string& text)
{
  const std::regex corner("(-?[0-9]+)/(?:-?[0-9]*)(?:/(-?[0-9]*))?");
  std::string result;
  for(std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    // A backslash joins the next line.
    end = begin;
    do {
      end = text.find_first_of("\r\n", end);
      end = end == std::string::npos ? text.size() : end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    } while(end < text.size() && text[text.find_last_not_of("\r\n", end - 1)] == '\\');
    const std::string line = text.substr(begin, end - begin);
    const std::size_t word = line.find_first_not_of(" \t");
    if(word != std::string::npos && line.compare(word, 2, "vt") == 0)
      continue;
    if(word == std::string::npos || (line[word] != 'f' && line[word] != 'l') || line.compare(word, 5, "fancy") == 0) {
      result += line;
      continue;
    }
    std::size_t copied = 0;
    for(std::sregex_iterator match(line.begin(), line.end(), corner), none; match != none; ++match) {
      result += line.substr(copied, match->position() - copied) + match->str(1) + (match->length(2) > 0 ? "//" + match->str(2) : "");
      copied = match->position() + match->length();
    }
    result += line.substr(copied);
  }
  return result;
}

const std::vector<std::string> OBJ_files = {
  // everything that a modelling program writes
  "# Made by hand\nmtllib a.mtl b.mtl\no chair\nv 0 0 0\nv 1 0 0\nv 1 1 .25\nv 0 1 0\nvn 0 0 1\nvt .1 .1\ng seat\nusemtl red\ns 1\n"
  "f 1/1/1 2/1/1 3/1/1\n\ng back\nusemtl blue\ns off\nf 1/1/1 3/1/1 4/1/1\n# the end",
  // without any texture coordinates, normals with and without, a quad and a pentagon
  "usemtl x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 2 0\nvn 0 0 1\nf 1 2 3 4\nf 4//1 3//1 5//1\nf 1 2 3 5 4\n",
  // line ends of Windows, tabs, spaces, colours and weights
  "usemtl x\r\nv\t0 0  0 1 .5 .25\r\nv 1 0 0 1\r\nv 0 1 0\r\nvt 0 0 0\r\n  f\t1/1  2/1\t3/1  \r\n",
  // of the old Macintosh, with a byte order mark
  "\xEF\xBB\xBF# saved\rusemtl x\rv 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
  // continued lines, numbers from the end, comments behind
  "usemtl x\nv 0 \\\n0 0\nv 1 0 0 # second\nv 0 1 0\nvt 0 \\\n 0\nf -3/-1 \\\n-2/-1 \\\n -1/-1 # a face\nv 2 2 0\nf -1/-1/ 1/1/ 2/-1/\n",
  // faces before vertices, no line end at the end
  "usemtl x\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 3/1 2/1 1/1\nvt 5 5",
  // several objects, elements of other kinds, unknown keywords, a vertex of no face
  "mtllib x.mtl\no a\nv 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nl 2/1 3/1\np 2\nvt 1 1\nf 2/1 3/1 4/1\no b\nv 0 0 1\nv 1 0 1\nv 0 1 1\nvp 1 2\n"
  "f 5/1 6/1 7/1\nfancy 1/2\nvw 1\n"};

template <typename Number>
void append(std::string& bytes, Number number, bool is_big_endian)
{
  for(std::size_t i = 0; i < sizeof(Number); ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof(Number)); // of little endian machines, as those that the tests run on
    bytes += static_cast<char>(bits >> 8 * (is_big_endian ? sizeof(Number) - 1 - i : i) & 255);
  }
}

// A header and a body in three parts: before, within and after the face element's numbers of texture.
struct Binary_PLY
{
  std::string text, first, last, items[2];
};

Binary_PLY binary_PLY(bool is_big_endian, bool has_texcoord)
{
  Binary_PLY ply;
  ply.first = std::string("ply\nformat binary_") + (is_big_endian ? "big" : "little") +
              "_endian 1.0\ncomment kept\nobj_info too\nelement vertex 3\nproperty float x\nproperty double y\nproperty short z\n"
              "property uchar red\nelement face 2\nproperty int flags\nproperty list ushort uint vertex_indices\n";
  ply.last = "property uchar shade\nelement tag 2\nproperty list uchar char letters\nend_header\n";
  ply.text = ply.first + (has_texcoord ? "property list uchar float texcoord\n" : "") + ply.last;
  for(int v = 0; v < 3; ++v) {
    append(ply.text, v == 1 ? 1.f : 0.f, is_big_endian);
    append(ply.text, v == 2 ? 1. : 0., is_big_endian);
    append(ply.text, static_cast<std::int16_t>(v), is_big_endian);
    append(ply.text, static_cast<std::uint8_t>(200 + v), is_big_endian);
  }
  for(int i = 0; i < 2; ++i) {
    append(ply.items[i], static_cast<std::int32_t>(-7 - i), is_big_endian);
    append(ply.items[i], static_cast<std::uint16_t>(3), is_big_endian);
    for(int k = 0; k < 3; ++k)
      append(ply.items[i], static_cast<std::uint32_t>(i == 0 ? k : 2 - k), is_big_endian);
    ply.text += ply.items[i];
    if(has_texcoord) {
      append(ply.text, static_cast<std::uint8_t>(2), is_big_endian);
      append(ply.text, .5f, is_big_endian);
      append(ply.text, .5f, is_big_endian);
    }
    append(ply.text, static_cast<std::uint8_t>(77), is_big_endian);
  }
  ply.text += std::string("\2ab\0", 4);
  return ply;
}

} // namespace

BOOST_AUTO_TEST_CASE(OBJ_files_get_texture_coordinates_and_nothing_else)
{
  for(const std::string& text : OBJ_files) {
    BOOST_TEST_CONTEXT(text)
    {
      const program::Polygon_file before = read(text, ".obj");
      program::Corner_images images = some_images(before);
      images.back().clear(); // a face that gets none
      const auto document = program::make_document(".obj", text);
      BOOST_TEST(document->has_material());
      const std::string result = document->with_images(images, "");
      BOOST_TEST(without_texture(result) == without_texture(text));
      const program::Polygon_file after = read(result, ".obj");
      BOOST_TEST((after.points == before.points));
      BOOST_TEST((after.polygons == before.polygons));
      BOOST_TEST((after.images == images));
    }
  }
}

BOOST_AUTO_TEST_CASE(OBJ_corners_share_texture_coordinates)
{
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
  const program::Image a{0, 0}, b{1, 0}, c{1, 1}, d{0, 1};
  // The second vertex and the fourth have the same image, but they are different vertices.
  const std::string result = program::make_document(".obj", text)->with_images({{a, b, c}, {a, c, b}}, "");
  BOOST_TEST(result == "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 1 0\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  const std::string seam = program::make_document(".obj", text)->with_images({{a, b, c}, {a, d, b}}, "");
  BOOST_TEST(seam.find("f 1/1 2/2 3/3\nf 1/1 3/4 4/5\n") != std::string::npos, seam);
}

BOOST_AUTO_TEST_CASE(OBJ_checkerboard)
{
  const program::Corner_images images{{{0, 0}, {1, 0}, {0, 1}}};
  const std::string vertices = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\n";
  const auto plain = program::make_document(".obj", vertices + "f 1 2 3\r\n");
  BOOST_TEST(!plain->has_material());
  BOOST_TEST(plain->with_images(images, "c.mtl") ==
             vertices + "mtllib c.mtl\r\nvt 0 0\r\nvt 1 0\r\nvt 0 1\r\nusemtl checkerboard\r\nf 1/1 2/2 3/3\r\n");
  const auto own = program::make_document(".obj", "mtllib a.mtl\r\n" + vertices + "usemtl red\r\nf 1 2 3\r\n");
  BOOST_TEST(own->has_material());
  const std::string checkered = own->with_images(images, "c.mtl");
  BOOST_TEST(checkered.find("red") == std::string::npos);
  BOOST_TEST(checkered.find("mtllib a.mtl") == 0u);
  BOOST_TEST(program::make_document(".obj", checkered)->with_images(images, "c.mtl") == checkered);
}

BOOST_AUTO_TEST_CASE(OBJ_points_are_replaced)
{
  for(const std::string& text : OBJ_files)
    BOOST_TEST_CONTEXT(text)
    {
      const program::Polygon_file before = read(text, ".obj");
      const auto document = program::make_document(".obj", text);
      auto points = before.points;
      for(auto& p : points)
        p = {{p[0] + 1. / 3, p[1] * 1e-30, p[2] - 2. / 7}};
      const std::string result = document->with_points(points);
      const program::Polygon_file after = read(result, ".obj");
      BOOST_TEST((after.points == points));
      BOOST_TEST((after.polygons == before.polygons));
      BOOST_TEST((after.images == before.images));
      // Back again, nothing else has changed but how numbers are written.
      const auto again = program::make_document(".obj", result);
      BOOST_TEST(again->with_points(before.points) == document->with_points(before.points));
    }
  BOOST_TEST(program::make_document(".obj", "v\t0 0 0 .5 # red\nf 1 1 1\n")->with_points({{{1, 2, 3}}}) == "v\t1 2 3 .5 # red\nf 1 1 1\n");
}

BOOST_AUTO_TEST_CASE(PLY_files_keep_everything)
{
  for(const bool is_big_endian : {false, true})
    for(const bool has_texcoord : {false, true}) {
      const Binary_PLY ply = binary_PLY(is_big_endian, has_texcoord);
      const program::Polygon_file before = read(ply.text, ".ply");
      program::Corner_images images = some_images(before);
      images[1].clear();
      const auto document = program::make_document(".ply", ply.text);
      const std::string result = document->with_images(images, "");
      const program::Polygon_file after = read(result, ".ply");
      BOOST_TEST((after.points == before.points));
      BOOST_TEST((after.polygons == before.polygons));
      BOOST_TEST((after.images == images));

      std::string added[2];
      append(added[0], static_cast<std::uint8_t>(6), is_big_endian);
      for(const auto& image : images[0])
        for(const double x : image)
          append(added[0], x, is_big_endian);
      append(added[1], static_cast<std::uint8_t>(0), is_big_endian);
      // Where there was a list, it is replaced; otherwise it is the last property of faces.
      std::string expected = binary_PLY(is_big_endian, false).text;
      const std::string line = "property list uchar double texcoord\n";
      expected.insert(has_texcoord ? ply.first.size() : expected.find("element tag"), line);
      for(int i = 0; i < 2; ++i)
        expected.insert(expected.find(ply.items[i]) + ply.items[i].size() + (has_texcoord ? 0 : 1), added[i]);
      BOOST_TEST((result == expected));

      auto points = before.points;
      for(auto& p : points)
        p = {{p[0] + 1. / 3, p[1] - 1e30, p[2] * .1}};
      const program::Polygon_file moved = read(document->with_points(points), ".ply");
      BOOST_TEST((moved.points == points)); // in double precision, whatever they were
      BOOST_TEST((moved.polygons == before.polygons));
      BOOST_TEST((moved.images == before.images));
    }
}

BOOST_AUTO_TEST_CASE(PLY_in_words)
{
  const std::string head = "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
                           "element face 1\r\nproperty list uchar int vertex_indices\r\n";
  const std::string vertices = "0 0 0\r\n1  0 0\r\n0 1 0\r\n";
  const auto document = program::make_document(".ply", head + "end_header\r\n" + vertices + "3 0 1 2 \r\n");
  BOOST_TEST(document->with_images({{{0, 0}, {.5, 0}, {0, .25}}}, "") ==
             head + "property list uchar double texcoord\r\nend_header\r\n" + vertices + "3 0 1 2 6 0 0 0.5 0 0 0.25 \r\n");
  BOOST_TEST(!program::make_document(".stl", "solid"));

  // A byte does not count the numbers of a polygon with so many corners.
  std::string polygon = "200";
  program::Corner_images images(1);
  for(int k = 0; k < 200; ++k) {
    polygon += " " + std::to_string(k % 3);
    images[0].push_back({k / 3., 1});
  }
  const std::string large = program::make_document(".ply", head + "end_header\r\n" + vertices + polygon + "\r\n")->with_images(images, "");
  BOOST_TEST((read(large, ".ply").images == images));
}

BOOST_AUTO_TEST_SUITE_END() // test_polygon_document
