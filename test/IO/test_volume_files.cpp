// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files of tetrahedral meshes: exact round trips, what other programs write, and messages for every kind of broken input.

#define BOOST_TEST_MODULE volume_files
#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/volume_checks.h"

#include "program/formats/volume_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace FFM = CGAL::Flip_free_maps;
using namespace test_support;

namespace {

// Any finite bit patterns as coordinates, and random indices.
FFM::Tetrahedral_mesh random_mesh()
{
  std::mt19937_64 generator(1);
  FFM::Tetrahedral_mesh mesh;
  while(mesh.points.size() < 1000) {
    std::array<double, 3> point;
    for(double& coordinate : point)
      do {
        const std::uint64_t bits = generator();
        std::memcpy(&coordinate, &bits, sizeof(coordinate));
      } while(!std::isfinite(coordinate));
    mesh.points.push_back(point);
  }
  mesh.points.push_back({{-0., std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max()}});
  const auto index = [&] { return static_cast<int>(generator() % mesh.points.size()); };
  for(int i = 0; i < 2000; ++i)
    mesh.tetrahedra.push_back({{index(), index(), index(), index()}});
  for(int i = 0; i < 500; ++i)
    mesh.triangles.push_back({{index(), index(), index()}});
  return mesh;
}

bool are_same_points(const FFM::Tetrahedral_mesh& a, const FFM::Tetrahedral_mesh& b)
{
  return a.points.size() == b.points.size() && std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(a.points[0])) == 0;
}

// The message for a file with this content; "" when it is read.
std::string message_for(const std::string& name, const std::string& content, FFM::Tetrahedral_mesh* mesh = nullptr)
{
  const Directory directory;
  FFM::Tetrahedral_mesh result;
  result.points.push_back({{1, 2, 3}});
  std::string message;
  if(FFM::read_volume(directory.write(name, content), result, &message)) {
    if(mesh != nullptr)
      *mesh = result;
    return message;
  }
  BOOST_TEST(!message.empty());
  BOOST_TEST(result.points.size() == 1u);
  return message;
}

const std::string medit_points = "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
const std::string medit_tetrahedron = "Tetrahedra\n1\n1 2 3 4 0\n";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

} // namespace

BOOST_AUTO_TEST_CASE(round_trips_are_exact)
{
  const Directory directory;
  const FFM::Tetrahedral_mesh mesh = random_mesh();
  for(const std::string name : {"a.mesh", "a.vtu", "a.node", "b.ele", "a.MESH"}) {
    std::string message = "old";
    BOOST_TEST_REQUIRE(FFM::write_volume(directory.file(name), mesh, &message), message);
    BOOST_TEST(message == "");
    FFM::Tetrahedral_mesh copy;
    message = "old";
    BOOST_TEST_REQUIRE(FFM::read_volume(directory.file(name), copy, &message), message);
    BOOST_TEST(message == "");
    BOOST_TEST(are_same_points(mesh, copy));
    BOOST_TEST((mesh.tetrahedra == copy.tetrahedra));
    BOOST_TEST((copy.triangles == (name[2] == 'm' || name[2] == 'M' ? mesh.triangles : decltype(mesh.triangles)())));
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_written)
{
  const Directory directory;
  const FFM::Tetrahedral_mesh good = as_mesh(block());
  for(const std::string name : {"a.mesh", "a.vtu", "a.node"}) {
    std::string message;
    FFM::Tetrahedral_mesh mesh = good;
    mesh.points[3][1] = std::numeric_limits<double>::infinity();
    BOOST_TEST(!FFM::write_volume(directory.file(name), mesh, &message));
    BOOST_TEST(contains(message, "point 3 is not finite"));
    mesh = good;
    mesh.tetrahedra[2][1] = static_cast<int>(mesh.points.size());
    BOOST_TEST(!FFM::write_volume(directory.file(name), mesh, &message));
    BOOST_TEST(contains(message, "tetrahedron number 2"));
    BOOST_TEST(!std::filesystem::exists(directory.file(name)));
    BOOST_TEST(!FFM::write_volume(directory.file("no/" + name), good, &message));
    BOOST_TEST(!message.empty());
    BOOST_TEST(!FFM::write_volume(directory.file("no/" + name), good));
  }
  std::string message;
  BOOST_TEST(!FFM::write_volume(directory.file("a.stl"), good, &message));
  FFM::Tetrahedral_mesh mesh;
  BOOST_TEST(!FFM::read_volume(directory.file("a.stl"), mesh, &message));
  BOOST_TEST(contains(message, ".mesh"));
  BOOST_TEST(!FFM::read_volume(directory.file("absent.mesh"), mesh, &message));
  BOOST_TEST(contains(message, "absent.mesh"));
}

BOOST_AUTO_TEST_CASE(medit_variants)
{
  FFM::Tetrahedral_mesh mesh;
  const std::string plain = medit_points + medit_tetrahedron + "End\n";
  BOOST_TEST(message_for("a.mesh", plain, &mesh) == "");
  BOOST_TEST((mesh.points[3] == std::array<double, 3>{{0, 0, 1}}));
  BOOST_TEST((mesh.tetrahedra[0] == std::array<int, 4>{{0, 1, 2, 3}}));

  std::string windows, comments;
  for(char c : plain) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    comments += c == '\n' ? " # Vertices 7\n" : std::string(1, c);
  }
  const std::string variants[] = {
    windows, comments,
    // another order, no End, no references, other sections
    "MeshVersionFormatted 1\nDimension\n3\nTetrahedra\n1\n1 2 3 4\nCorners 2\n1\n2\nVertices 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1",
    medit_points + "Edges\n1\n1 2 7\nRequiredVertices\n1\n2\nQuadrilaterals\n0\n" + medit_tetrahedron + "Normals\n1\n0 0 1\nEnd\nrubbish",
    // all in one line
    "MeshVersionFormatted 2 Dimension 3 Vertices 4 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 Tetrahedra 1 1 2 3 4 0 End"};
  for(const std::string& variant : variants) {
    FFM::Tetrahedral_mesh other;
    BOOST_TEST(message_for("a.mesh", variant, &other) == "");
    BOOST_TEST((other.points == mesh.points));
    BOOST_TEST((other.tetrahedra == mesh.tetrahedra));
  }
}

BOOST_AUTO_TEST_CASE(broken_medit_files)
{
  const std::string plain = medit_points + medit_tetrahedron + "End\n";
  const std::pair<std::string, std::string> cases[] = {
    {"", "MeshVersionFormatted"},
    {"OFF\n3 1 0\n", "MeshVersionFormatted"},
    {"MeshVersionFormatted 2\nDimension 3\nEnd\n", "no section 'Vertices'"},
    {replaced(plain, "Dimension 3", "Dimension 2"), "line 2: the dimension is 2"},
    {replaced(plain, "1 0 0 0", "nan 0 0 0"), "line 6: 'nan' is not a finite number"},
    {replaced(plain, "1 0 0 0", "inf 0 0 0"), "line 6"},
    {replaced(plain, "1 0 0 0", "1e999 0 0 0"), "line 6: '1e999' is not in the range"},
    {replaced(plain, "1 0 0 0", "1,5 0 0 0"), "line 6: '1,5' is not a number"},
    {replaced(plain, "Vertices\n4", "Vertices\n5"), "'Tetrahedra' is not a number"},
    {replaced(plain, "Vertices\n4", "Vertices\n3"), "line 8: found '0' where a section begins"},
    {replaced(plain, "Vertices\n4", "Vertices\n-4"), "line 4: -4 is no number of items"},
    {replaced(plain, "Vertices\n4", "Vertices\n99999999999"), "no number of items"},
    {replaced(plain, "Vertices\n4", "Vertices\n2000000000"), "'Tetrahedra' is not a number"},
    {replaced(plain, "1 2 3 4", "0 1 2 3"), "line 11: vertex index 0"},
    {replaced(plain, "1 2 3 4", "1 2 3 5"), "line 11: vertex index 5 is not from 1 to 4"},
    {replaced(plain, "1 2 3 4", "1 2 3.5 4"), "line 11: '3.5' is not an integer"},
    {"MeshVersionFormatted 2\n" + medit_tetrahedron + "Dimension 3\nVertices\n1\n0 0 0 0\nEnd\n", "there are 1 points"},
    {plain.substr(0, plain.find("3 4 0")), "ends too early"},
    {medit_points.substr(0, medit_points.size() - 9), "ends too early"},
    {medit_points + "Hexahedra\n1\n1 2 3 4 1 2 3 4 0\nEnd\n", "line 9: elements other than tetrahedra are not supported: Hexahedra"},
    {medit_points + medit_points.substr(medit_points.find("Vertices")), "second section"}};
  for(const auto& broken : cases) {
    const std::string message = message_for("a.mesh", broken.first);
    BOOST_TEST(contains(message, broken.second), "expected '" << broken.second << "', got '" << message << "'");
  }
}

BOOST_AUTO_TEST_CASE(tetgen_files)
{
  const auto message_of = [](const std::string& node, const std::string& ele, FFM::Tetrahedral_mesh* mesh = nullptr) {
    const Directory directory;
    directory.write("a.node", node);
    FFM::Tetrahedral_mesh result;
    std::string message;
    if(FFM::read_volume(directory.write("a.ele", ele), result, &message) && mesh != nullptr)
      *mesh = result;
    return message;
  };
  const std::string node = "# made by hand\n4 3 1 1\n1 0 0 0 9.5 1\n2 1 0 0 9.5 1 # corner\n3 0 1 0 9.5 0\n4 0 0 1 9.5 0\n";
  const std::string ele = "1 10 1\n  1  1 2 3 4  5 6 7 8 9 10  -1\n";
  FFM::Tetrahedral_mesh mesh;
  BOOST_TEST(message_of(node, ele, &mesh) == "");
  BOOST_TEST((mesh.points.size() == 4 && mesh.points[3] == std::array<double, 3>{{0, 0, 1}}));
  BOOST_TEST((mesh.tetrahedra.size() == 1 && mesh.tetrahedra[0] == std::array<int, 4>{{0, 1, 2, 3}}));
  BOOST_TEST(message_of("2 3 0 0\r\n0 0 0 0\r\n1 1 0 0\r\n", "1 4 0\r\n0 0 1 0 1\r\n", &mesh) == "");
  BOOST_TEST((mesh.tetrahedra[0] == std::array<int, 4>{{0, 1, 0, 1}}));

  BOOST_TEST(contains(message_of(replaced(node, "4 3", "4 2"), ele), "dimension"));
  BOOST_TEST(contains(message_of(replaced(node, "4 3", "5 3"), ele), "ends too early"));
  BOOST_TEST(contains(message_of(replaced(node, "\n3 0", "\n5 0"), ele), "line 5: point 5"));
  BOOST_TEST(contains(message_of(replaced(node, "2 1 0 0", "2 nan 0 0"), ele), "line 4"));
  BOOST_TEST(contains(message_of(node, replaced(ele, "1 2 3 4", "0 1 2 3")), "a.ele: line 2: point index 0 is out of range"));
  BOOST_TEST(contains(message_of(node, replaced(ele, "1 2 3 4", "1 2 3 5")), "point index 5"));
  BOOST_TEST(contains(message_of(node, replaced(ele, "1 10 1", "1 8 1")), "8 nodes"));
  BOOST_TEST(contains(message_of(node, replaced(ele, "1 10 1", "2 10 1")), "ends too early"));
  BOOST_TEST(contains(message_of(node, ""), "ends too early"));
  const Directory directory;
  std::string message;
  BOOST_TEST(!FFM::read_volume(directory.write("a.node", node), mesh, &message));
  BOOST_TEST(contains(message, "a.ele"));
}

BOOST_AUTO_TEST_CASE(vtu_with_values_and_broken_vtu_files)
{
  const Directory directory;
  const FFM::Tetrahedral_mesh mesh = as_mesh(block());
  std::vector<FFM::VTU_array> points(1), cells(1);
  points[0] = {"start position", 3, std::vector<double>(3 * mesh.points.size(), 0.1)};
  cells[0] = {"distortion", 1, std::vector<double>(mesh.tetrahedra.size(), 4.5)};
  std::string message;
  BOOST_TEST_REQUIRE(FFM::write_VTU(directory.file("a.vtu"), mesh, points, cells, &message), message);
  const std::string text = directory.read("a.vtu");
  BOOST_TEST(contains(text, "<DataArray type=\"Float64\" Name=\"start position\" "
                            "NumberOfComponents=\"3\" format=\"ascii\">\n0.1 0.1 0.1\n"));
  BOOST_TEST(contains(text, "<CellData>\n        <DataArray type=\"Float64\" Name=\"distortion\" "
                            "NumberOfComponents=\"1\" format=\"ascii\">\n4.5\n"));
  FFM::Tetrahedral_mesh copy;
  BOOST_TEST(message_for("a.vtu", text, &copy) == "");
  BOOST_TEST((copy.points == mesh.points && copy.tetrahedra == mesh.tetrahedra));
  // The second of two pieces counts its points anew.
  const std::size_t begin = text.find("    <Piece"), end = text.find("  </UnstructuredGrid>");
  BOOST_TEST(message_for("a.vtu", text.substr(0, end) + text.substr(begin), &copy) == "");
  BOOST_TEST(copy.points.size() == 2 * mesh.points.size());
  BOOST_TEST(copy.tetrahedra.back()[1] == mesh.tetrahedra.back()[1] + static_cast<int>(mesh.points.size()));

  points[0].values.pop_back();
  BOOST_TEST(!FFM::write_VTU(directory.file("b.vtu"), mesh, points, cells, &message));
  BOOST_TEST(!FFM::write_VTU(directory.file("b.vtu"), mesh, {}, {{"<a>", 1, cells[0].values}}, &message));
  cells[0].values[2] = std::numeric_limits<double>::infinity();
  BOOST_TEST(!FFM::write_VTU(directory.file("b.vtu"), mesh, {}, cells, &message));
  BOOST_TEST(!std::filesystem::exists(directory.file("b.vtu")));

  // A tetrahedron, a triangle and a line, laid out as other programs do, with attributes in another order.
  const std::string other =
    "<?xml version='1.0'?>\n<!-- <Piece> -->\n<VTKFile type='UnstructuredGrid' version='1.0'>\n<UnstructuredGrid>\n"
    "<Piece NumberOfCells='3' NumberOfPoints='4'><Points><DataArray NumberOfComponents='3' format='ascii' type='Float32'>\n"
    "0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n<PointData><DataArray format='appended' Name='x' offset='0'/></PointData>\n"
    "<Cells><DataArray Name='offsets' format='ascii'>4 7 9</DataArray><DataArray Name='types' format='ascii'>10 5 3</DataArray>\n"
    "<DataArray format='ascii' Name='connectivity'>0 1 2 3 0 2 1\n 1 2</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
  BOOST_TEST(message_for("a.vtu", other, &copy) == "");
  BOOST_TEST((copy.points.size() == 4 && copy.tetrahedra.size() == 1 && copy.triangles.size() == 1));
  BOOST_TEST((copy.triangles[0] == std::array<int, 3>{{0, 2, 1}}));

  const std::pair<std::string, std::string> cases[] = {
    {"", "'VTKFile'"},
    {"solid", "'VTKFile'"},
    {replaced(other, "UnstructuredGrid", "PolyData"), "'PolyData'"},
    {replaced(other, "format='ascii' type", "format='appended' offset='7' type"), "offset '7' is not within"},
    {replaced(other, "Name='types' format='ascii'", "Name='types' format='binary'"), "in the array 'types', the file ends too early"},
    {replaced(other, "Name='types' format='ascii'", "Name='types' format='strange'"), "'strange' is unknown"},
    {replaced(replaced(other, "Name='types' format='ascii'", "Name='types' format='binary'"), "<VTKFile", "<VTKFile compressor='z'"),
     "compressed"},
    {replaced(other, "0 0 0 1 0 0", "0 0 0 nan 0 0"), "'nan'"},
    {replaced(other, "0 0 0 1 0 0", "0 0 1 0 0"), "11 coordinates for 4 points"},
    {replaced(other, "4 7 9", "4 7"), "2 offsets"},
    {replaced(other, "4 7 9", "4 7 10"), "offset of cell 2"},
    {replaced(other, "4 7 9", "4 3 9"), "offset of cell 1"},
    {replaced(other, "4 7 9", "5 7 9"), "cell 0 has 5 corners"},
    {replaced(other, "10 5 3", "12 5 3"), "cell 0 is of type 12"},
    {replaced(other, "0 1 2 3 0", "0 1 2 4 0"), "cell 0 has the point 4"},
    {replaced(other, "NumberOfPoints='4'", ""), "numbers of points and cells"},
    {other.substr(0, other.size() - 20), "ends too early"},
    {other.substr(0, other.find("<!--") + 10), "'VTKFile'"}};
  for(const auto& broken : cases) {
    message = message_for("a.vtu", broken.first);
    BOOST_TEST(contains(message, broken.second), "expected '" << broken.second << "', got '" << message << "'");
  }
}

namespace {

template <typename Number>
void append_bytes(std::string& bytes, double value, bool is_big_endian)
{
  const Number number = static_cast<Number>(value);
  std::string word(reinterpret_cast<const char*>(&number), sizeof(Number));
  if(is_big_endian)
    std::reverse(word.begin(), word.end());
  bytes += word;
}

std::string base64(const std::string& bytes)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for(std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

// An array with its number of bytes in front.
template <typename Number>
std::string with_size(const std::vector<double>& values, bool is_big_endian, bool has_long_counts, std::string& head)
{
  std::string bytes;
  for(const double value : values)
    append_bytes<Number>(bytes, value, is_big_endian);
  head.clear();
  if(has_long_counts)
    append_bytes<std::uint64_t>(head, static_cast<double>(bytes.size()), is_big_endian);
  else
    append_bytes<std::uint32_t>(head, static_cast<double>(bytes.size()), is_big_endian);
  return bytes;
}

} // namespace

BOOST_AUTO_TEST_CASE(binary_vtu_files)
{
  const std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, connectivity{0, 1, 2, 3}, offsets{4}, types{10};
  for(const bool is_big_endian : {false, true})
    for(const bool has_long_counts : {false, true})
      for(const std::string kind : {"inline", "inline apart", "appended base64", "appended raw"}) {
        std::string appended, arrays[4], head;
        const auto array = [&](int i, const std::string& attributes, const std::string& bytes) {
          arrays[i] = "<DataArray " + attributes + " format='" + (kind[0] == 'i' ? "binary'>" : "appended' offset='");
          if(kind == "inline")
            arrays[i] += "\n  " + base64(head + bytes) + "\n";
          else if(kind == "inline apart")
            arrays[i] += base64(head) + base64(bytes);
          else {
            arrays[i] += std::to_string(appended.size()) + "'>";
            appended += kind == "appended raw" ? head + bytes : base64(head + bytes);
          }
          arrays[i] += "</DataArray>";
        };
        array(0, "type='Float32' NumberOfComponents='3'", with_size<float>(points, is_big_endian, has_long_counts, head));
        array(1, "type='Int64' Name='connectivity'", with_size<std::int64_t>(connectivity, is_big_endian, has_long_counts, head));
        array(2, "type='Int32' Name='offsets'", with_size<std::int32_t>(offsets, is_big_endian, has_long_counts, head));
        array(3, "type='UInt8' Name='types'", with_size<std::uint8_t>(types, is_big_endian, has_long_counts, head));
        std::string text = std::string("<VTKFile type='UnstructuredGrid' byte_order='") + (is_big_endian ? "Big" : "Little") +
                           "Endian' header_type='" + (has_long_counts ? "UInt64" : "UInt32") +
                           "'><UnstructuredGrid><Piece NumberOfPoints='4' NumberOfCells='1'><Points>" + arrays[0] + "</Points><Cells>" +
                           arrays[1] + arrays[2] + arrays[3] + "</Cells></Piece></UnstructuredGrid>";
        if(!appended.empty())
          text +=
            std::string("<AppendedData encoding='") + (kind == "appended raw" ? "raw" : "base64") + "'>_" + appended + "</AppendedData>";
        text += "</VTKFile>";
        FFM::Tetrahedral_mesh mesh;
        BOOST_TEST_CONTEXT(kind << (is_big_endian ? ", big endian" : "") << (has_long_counts ? ", long counts" : ""))
        {
          BOOST_TEST(message_for("a.vtu", text, &mesh) == "");
          BOOST_TEST((mesh.points == std::vector<std::array<double, 3>>{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}));
          BOOST_TEST((mesh.tetrahedra == std::vector<std::array<int, 4>>{{{0, 1, 2, 3}}}));
        }
      }
}

// As many triangles as there are on the sides of a bar; each belongs to its owner, and outwards they enclose the volume.
BOOST_AUTO_TEST_CASE(boundary_of_a_bar)
{
  const int n = 4, m = 3, l = 2;
  const Volume volume = bar(n, m, l, [](const Eigen::Vector3d& p) { return p; });
  const FFM::Tetrahedral_mesh mesh = as_mesh(volume);
  std::vector<std::size_t> owners;
  const std::vector<std::array<int, 3>> triangles = FFM::boundary_triangles(mesh, &owners);
  BOOST_TEST_REQUIRE(triangles.size() == 4u * (n * m + m * l + l * n));
  BOOST_TEST_REQUIRE(owners.size() == triangles.size());
  double enclosed = 0;
  for(std::size_t i = 0; i < triangles.size(); ++i) {
    Eigen::Matrix3d corners;
    for(int k = 0; k < 3; ++k) {
      corners.col(k) = volume.points[triangles[i][k]];
      BOOST_TEST((std::count(mesh.tetrahedra[owners[i]].begin(), mesh.tetrahedra[owners[i]].end(), triangles[i][k]) == 1));
    }
    enclosed += corners.determinant() / 6;
  }
  BOOST_TEST(enclosed == n * m * l, boost::test_tools::tolerance(1e-12));
}

// Files of the collection carry the boundary of their tetrahedra; the package finds the same.
BOOST_AUTO_TEST_CASE(boundary_of_real_meshes, *boost::unit_test::label("needs_data"))
{
  for(const std::string name : {"spot", "bar_twist"}) {
    const std::string path = std::string(FLIP_FREE_MAPS_SHARED_DATA_DIR) + "/cases/tet/" + name + ".mesh";
    if(!std::filesystem::exists(path)) {
      skip_case("there is no " + path);
      continue;
    }
    FFM::Tetrahedral_mesh mesh;
    std::string message;
    BOOST_TEST_REQUIRE(FFM::read_volume(path, mesh, &message), message);
    std::vector<std::size_t> owners;
    std::vector<std::array<int, 3>> triangles = FFM::boundary_triangles(mesh, &owners);
    BOOST_TEST_REQUIRE(owners.size() == triangles.size());
    for(std::size_t i = 0; i < triangles.size(); ++i)
      for(int v : triangles[i])
        BOOST_TEST((std::count(mesh.tetrahedra[owners[i]].begin(), mesh.tetrahedra[owners[i]].end(), v) == 1));
    // The same triangles with the same orientation: each turned so that its smallest index comes first.
    const auto normalize = [](std::vector<std::array<int, 3>>& list) {
      for(auto& t : list)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      std::sort(list.begin(), list.end());
    };
    normalize(triangles);
    normalize(mesh.triangles);
    BOOST_TEST((triangles == mesh.triangles));
  }
}
