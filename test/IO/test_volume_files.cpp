// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files of tetrahedral meshes: exact round trips, what other programs write, and messages for every kind of broken input.

#include "support/unit_test.h"

#include "support/generated_domains.h"
#include "support/volume_checks.h"

#include "program/formats/packed_bytes.h"
#include "program/formats/volume_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_volume_files)

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
  for(const std::string name : {"a.mesh", "a.MESH", "a.meshb", "a.vtu", "a.vtk", "a.msh", "a.inp", "a.node", "b.ele"}) {
    std::string message = "old";
    BOOST_TEST_REQUIRE(FFM::write_volume(directory.file(name), mesh, &message), message);
    BOOST_TEST(message == "");
    FFM::Tetrahedral_mesh copy;
    message = "old";
    BOOST_TEST_REQUIRE(FFM::read_volume(directory.file(name), copy, &message), message);
    BOOST_TEST(message == "");
    BOOST_TEST(are_same_points(mesh, copy));
    BOOST_TEST((mesh.tetrahedra == copy.tetrahedra));
    const bool has_triangles = name[2] == 'm' || name[2] == 'M' || name[2] == 'v';
    BOOST_TEST((copy.triangles == (has_triangles ? mesh.triangles : decltype(mesh.triangles)())));
  }
}

namespace {

// Arrays of all types with their extreme values, names of any characters, and regions.
program::Volume_file file_with_arrays()
{
  program::Volume_file file = program::make_volume_file(random_mesh());
  const std::size_t n = file.points.size();
  for(int t = 0; t < 10; ++t) {
    program::Data_array array;
    array.name = "of type <" + std::to_string(t) + "> & \"all\" 100% NumberOfComponents=";
    array.type = static_cast<program::Number_type>(t);
    array.number_of_components = 1 + t % 3;
    program::with_type(array.type, [&](auto number) {
      using Number = decltype(number);
      const Number extremes[] = {std::numeric_limits<Number>::lowest(), std::numeric_limits<Number>::max(), Number(1) / Number(3)};
      for(std::size_t i = 0; i < n * array.number_of_components; ++i)
        if(program::is_real(array.type))
          array.reals.push_back(static_cast<double>(extremes[i % 3]));
        else
          array.integers.push_back(static_cast<std::int64_t>(extremes[i % 3]));
    });
    file.point_data.push_back(array);
  }
  file.point_data[8].kind = "Vectors"; // of three components
  file.point_data[0].kind = "Scalars";
  std::vector<std::int64_t> regions;
  for(std::size_t i = 0; i < file.cells.size(); ++i)
    regions.push_back(static_cast<std::int64_t>(i * i % 7 + 1));
  file.cell_data.push_back(program::integer_array(program::REGION, program::Number_type::int32, regions));
  file.field_data.push_back(program::real_array("time", 1, {0.1, 0.2}));
  return file;
}

bool are_same_arrays(const std::vector<program::Data_array>& a, const std::vector<program::Data_array>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const program::Data_array& x, const program::Data_array& y) {
    return x.name == y.name && x.type == y.type && x.number_of_components == y.number_of_components && x.kind == y.kind &&
           x.integers == y.integers && x.reals.size() == y.reals.size() &&
           std::memcmp(x.reals.data(), y.reals.data(), x.reals.size() * sizeof(double)) == 0;
  });
}

bool are_same_cells(const program::Cells& a, const program::Cells& b)
{
  return a.types == b.types && a.ends == b.ends && a.nodes == b.nodes;
}

} // namespace

BOOST_AUTO_TEST_CASE(encodings_keep_everything)
{
  using program::Volume_encoding;
  const Directory directory;
  const program::Volume_file file = file_with_arrays();
  for(const auto& [name, encoding] : {std::pair<const char*, Volume_encoding>{"a.vtu", Volume_encoding::ascii},
                                      {"b.vtu", Volume_encoding::binary},
                                      {"c.vtu", Volume_encoding::base64},
                                      {"d.vtu", Volume_encoding::compressed},
                                      {"e.vtk", Volume_encoding::ascii},
                                      {"f.vtk", Volume_encoding::binary},
                                      {"g.msh", Volume_encoding::ascii},
                                      {"h.msh", Volume_encoding::binary}})
    BOOST_TEST_CONTEXT(name)
    {
      const std::string path = directory.file(name), other = directory.file(std::string("other_") + name);
      if(encoding == Volume_encoding::compressed && !program::can_compress()) {
        BOOST_TEST(contains(program::write_volume_file(path, file, encoding), "zlib"));
        continue;
      }
      program::Volume_file copy, again;
      BOOST_TEST(program::write_volume_file(path, file, encoding) == "");
      BOOST_TEST_REQUIRE(program::read_volume_file(path, copy) == "");
      BOOST_TEST((copy.encoding == encoding));
      // Written back with other points, and then with those that there were, it is the same file.
      const auto points = copy.points;
      for(auto& p : copy.points)
        p = {p[2] / 2, p[0], p[1] / 3};
      BOOST_TEST(program::write_volume_file(other, copy) == "");
      BOOST_TEST_REQUIRE(program::read_volume_file(other, again) == "");
      BOOST_TEST((again.points == copy.points));
      again.points = points;
      BOOST_TEST(program::write_volume_file(other, again) == "");
      BOOST_TEST((directory.read(std::string("other_") + name) == directory.read(name)));
      BOOST_TEST(are_same_cells(copy.cells, file.cells));
      BOOST_TEST((std::memcmp(points.data(), file.points.data(), points.size() * sizeof(points[0])) == 0));
      BOOST_TEST((program::find_regions(copy)->integers == program::find_regions(file)->integers));
      if(name[2] == 'v') {
        BOOST_TEST(are_same_arrays(copy.point_data, file.point_data) == (name[4] == 'u'));
        BOOST_TEST(copy.point_data.size() == file.point_data.size());
        for(const program::Data_array& array : file.point_data)
          BOOST_TEST(are_same_arrays({*program::find_array(copy.point_data, array.name)}, {array}), array.name);
        BOOST_TEST(are_same_arrays(copy.field_data, file.field_data));
        const program::Data_array* array = nullptr;
        BOOST_TEST(program::find_point_array(copy, file.point_data[7].name, array) == "");
        BOOST_TEST(are_same_arrays({*array}, {file.point_data[7]}));
        BOOST_TEST(contains(program::find_point_array(copy, "none", array), "of type <3>"));
        BOOST_TEST(array == nullptr);
      }
    }
}

// What a format does not have is refused before anything is written.
BOOST_AUTO_TEST_CASE(encodings_that_formats_do_not_have)
{
  using program::Volume_encoding;
  for(const std::string path : {"a.mesh", "a.inp", "a.node"}) {
    BOOST_TEST(program::why_volume_not_written(path, Volume_encoding::ascii) == "");
    BOOST_TEST(program::why_volume_not_written(path, Volume_encoding::binary) != "");
  }
  BOOST_TEST(program::why_volume_not_written("a.vtk", Volume_encoding::base64) != "");
  BOOST_TEST(program::why_volume_not_written("a.msh", Volume_encoding::compressed) != "");
  BOOST_TEST(program::why_volume_not_written("a.meshb", Volume_encoding::ascii) != "");
  BOOST_TEST(program::why_volume_not_written("a.vtu", Volume_encoding::base64) == "");
  BOOST_TEST(contains(program::why_volume_not_written("a.stl"), ".msh"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_written)
{
  const Directory directory;
  const FFM::Tetrahedral_mesh good = as_mesh(block());
  for(const std::string name : {"a.mesh", "a.meshb", "a.vtu", "a.vtk", "a.msh", "a.inp", "a.node"}) {
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
  const std::string ele = "1 4 1\n  1  1 2 3 4  -1\n";
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
  BOOST_TEST(contains(message_of(node, replaced(ele, "1 4 1", "1 8 1")), "8 nodes"));
  BOOST_TEST(contains(message_of(node, replaced(ele, "1 4 1", "1 10 1")), "1 tetrahedra of second order (10 nodes each)"));
  BOOST_TEST(contains(message_of(node, replaced(ele, "1 4 1", "2 4 1")), "ends too early"));
  BOOST_TEST(contains(message_of(node, ""), "ends too early"));
  const Directory directory;
  std::string message;
  BOOST_TEST(!FFM::read_volume(directory.write("a.node", node), mesh, &message));
  BOOST_TEST(contains(message, "a.ele"));
  // Written back as it was, wherever lines end.
  const std::string broken_header = "2\n3\n0 0 0 0\n1 1 0 0\n";
  directory.write("b.ele", "1 4\n0 0 1 0 1\n");
  program::Volume_file file;
  BOOST_TEST(program::read_volume_file(directory.write("b.node", broken_header), file) == "");
  BOOST_TEST(program::write_volume_file(directory.file("c.node"), file) == "");
  BOOST_TEST(directory.read("c.node") == broken_header);
}

BOOST_AUTO_TEST_CASE(vtu_with_values_and_broken_vtu_files)
{
  const Directory directory;
  const FFM::Tetrahedral_mesh mesh = as_mesh(block());
  program::Volume_file file = program::make_volume_file(mesh);
  file.point_data.push_back(program::real_array("start position", 3, std::vector<double>(3 * mesh.points.size(), 0.1)));
  file.cell_data.push_back(program::real_array("distortion", 1, std::vector<double>(file.cells.size(), 4.5)));
  BOOST_TEST_REQUIRE(program::write_volume_file(directory.file("a.vtu"), file, program::Volume_encoding::ascii) == "");
  const std::string text = directory.read("a.vtu");
  BOOST_TEST(contains(text, "<DataArray type=\"Float64\" Name=\"start position\" "
                            "NumberOfComponents=\"3\" format=\"ascii\">\n0.1 0.1 0.1\n"));
  BOOST_TEST(contains(text, "<CellData>\n        <DataArray type=\"Float64\" Name=\"distortion\" "
                            "NumberOfComponents=\"1\" format=\"ascii\">\n4.5\n"));
  FFM::Tetrahedral_mesh copy;
  std::string message;
  BOOST_TEST(message_for("a.vtu", text, &copy) == "");
  BOOST_TEST((copy.points == mesh.points && copy.tetrahedra == mesh.tetrahedra));
  // The second of two pieces counts its points anew.
  const std::size_t begin = text.find("    <Piece"), end = text.find("  </UnstructuredGrid>");
  BOOST_TEST(message_for("a.vtu", text.substr(0, end) + text.substr(begin), &copy) == "");
  BOOST_TEST(copy.points.size() == 2 * mesh.points.size());
  BOOST_TEST(copy.tetrahedra.back()[1] == mesh.tetrahedra.back()[1] + static_cast<int>(mesh.points.size()));

  // A tetrahedron, a triangle and a line, laid out as other programs do, with attributes in another order.
  const std::string other =
    "<?xml version='1.0'?>\n<!-- <Piece> -->\n<VTKFile type='UnstructuredGrid' version='1.0'>\n<UnstructuredGrid>\n"
    "<Piece NumberOfCells='3' NumberOfPoints='4'><Points><DataArray NumberOfComponents='3' format='ascii' type='Float32'>\n"
    "0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n<PointData><DataArray format='ascii' Name='x'>1 nan 3 4</DataArray></PointData>\n"
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
     "compressed by 'z'"},
    {replaced(other, "1 nan 3 4", "1 nan 3"), "the array 'x' has 3 values"},
    {replaced(other, "1 nan 3 4", "1 nan 3 x"), "in the array 'x', 'x' is not a number"},
    {replaced(other, "<DataArray format='ascii' Name='x'", "<DataArray format='appended' Name='x'"), "offset '' is not within"},
    {replaced(other, "0 0 0 1 0 0", "0 0 0 nan 0 0"), "coordinate of point 1 is not finite"},
    {replaced(other, "0 0 0 1 0 0", "0 0 1 0 0"), "11 coordinates for 4 points"},
    {replaced(other, "4 7 9", "4 7"), "2 offsets"},
    {replaced(other, "4 7 9", "4 7 10"), "offset of cell 2"},
    {replaced(other, "4 7 9", "4 3 9"), "offset of cell 1"},
    {replaced(other, "4 7 9", "5 7 9"), "cell 0 (from 0) has 5 corners"},
    {replaced(other, "10 5 3", "12 5 3"), "1 hexahedra (8 nodes each)"},
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

// Blocks of several sizes, in both byte orders.
BOOST_AUTO_TEST_CASE(compressed_vtu_files)
{
  if(!program::can_compress()) {
    skip_case("there is no zlib");
    return;
  }
  for(const bool is_big_endian : {false, true})
    for(const bool has_long_counts : {false, true})
      for(const std::string kind : {"binary", "base64", "raw"}) {
        std::string appended;
        const auto array = [&](const std::string& attributes, const std::string& bytes, std::size_t size) {
          std::string blocks;
          std::vector<double> head{double((bytes.size() + size - 1) / size), double(size), double(bytes.size() % size)};
          for(std::size_t i = 0; i < bytes.size(); i += size) {
            const std::string block = program::compress(bytes.substr(i, size));
            head.push_back(double(block.size()));
            blocks += block;
          }
          std::string start;
          for(const double number : head)
            has_long_counts ? append_bytes<std::uint64_t>(start, number, is_big_endian)
                            : append_bytes<std::uint32_t>(start, number, is_big_endian);
          const std::string all = kind == "raw" ? start + blocks : base64(start) + base64(blocks);
          const std::string tag = "<DataArray " + attributes;
          if(kind == "binary")
            return tag + " format='binary'>\n" + all + "\n</DataArray>";
          appended += all;
          return tag + " format='appended' offset='" + std::to_string(appended.size() - all.size()) + "'/>";
        };
        std::string coordinates, connectivity, offsets, types;
        for(const double x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
          append_bytes<double>(coordinates, x, is_big_endian);
        for(const double k : {0, 1, 2, 3})
          append_bytes<std::int16_t>(connectivity, k, is_big_endian);
        append_bytes<std::uint64_t>(offsets, 4, is_big_endian);
        append_bytes<std::int8_t>(types, 10, is_big_endian);
        std::string text = std::string("<VTKFile type='UnstructuredGrid' compressor='vtkZLibDataCompressor' byte_order='") +
                           (is_big_endian ? "Big" : "Little") + "Endian' header_type='" + (has_long_counts ? "UInt64" : "UInt32") +
                           "'><UnstructuredGrid><Piece NumberOfPoints='4' NumberOfCells='1'><Points>" +
                           array("type='Float64' NumberOfComponents='3'", coordinates, 40) + "</Points><Cells>" +
                           array("type='Int16' Name='connectivity'", connectivity, 4) + array("type='UInt64' Name='offsets'", offsets, 8) +
                           array("type='Int8' Name='types'", types, 100) + "</Cells></Piece></UnstructuredGrid>";
        if(kind != "binary")
          text += "<AppendedData encoding='" + kind + "'>_" + appended + "</AppendedData>";
        text += "</VTKFile>";
        BOOST_TEST_CONTEXT(kind << (is_big_endian ? ", big endian" : "") << (has_long_counts ? ", long counts" : ""))
        {
          FFM::Tetrahedral_mesh mesh;
          BOOST_TEST(message_for("a.vtu", text, &mesh) == "");
          BOOST_TEST((mesh.points == std::vector<std::array<double, 3>>{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}));
          BOOST_TEST((mesh.tetrahedra == std::vector<std::array<int, 4>>{{{0, 1, 2, 3}}}));
          BOOST_TEST(contains(message_for("a.vtu", replaced(text, "vtkZLib", "vtkLZ4")), "'vtkLZ4DataCompressor'"));
        }
      }
}

namespace {

// Reads a file with this content.
program::Volume_file read_content(const std::string& name, const std::string& content, std::string* error = nullptr)
{
  const Directory directory;
  program::Volume_file file;
  const std::string reason = program::read_volume_file(directory.write(name, content), file);
  if(error != nullptr)
    *error = reason;
  else
    BOOST_TEST(reason == "");
  return file;
}

// What write_volume_file() makes of it in a file of this name.
std::string written(const std::string& name, const program::Volume_file& file)
{
  const Directory directory;
  BOOST_TEST(program::write_volume_file(directory.file(name), file) == "");
  return directory.read(name);
}

std::vector<std::int64_t> regions_of(const program::Volume_file& file)
{
  const program::Data_array* regions = program::find_regions(file);
  return regions == nullptr ? std::vector<std::int64_t>() : regions->integers;
}

const std::vector<std::array<double, 3>> five_points{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 1}}};

} // namespace

// As Gmsh writes it: nodes of any numbers, physical groups, sections that are not known.
BOOST_AUTO_TEST_CASE(gmsh_files)
{
  const std::string old = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nby hand\n$EndComments\n$PhysicalNames\n2\n3 7 \"hard core\"\n"
                          "3 8 \"shell\"\n$EndPhysicalNames\n$Nodes\n5\n10 0 0 0\n2 1 0 0\n3 0 1 0\n44 0 0 1\n5 1 1 1\n$EndNodes\n"
                          "$Elements\n4\n1 15 2 0 1 10\n2 2 2 4 1 10 2 3\n3 4 2 7 1 10 2 3 44\n4 4 3 8 2 99 2 3 44 5\n$EndElements\n"
                          "$Periodic\n0\n$EndPeriodic\n";
  const std::string recent =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 7 \"hard core\"\n3 8 \"shell\"\n$EndPhysicalNames\n$Entities\n1 0 1 2\n"
    "9 0 0 0 0\n1 0 0 0 1 1 1 1 4 0\n1 0 0 0 1 1 1 1 7 1 1\n2 0 0 0 1 1 1 2 8 7 2 1 -1\n$EndEntities\n"
    "$Nodes\n2 5 1 44\n2 1 1 3\n10\n2\n3\n0 0 0 .5 .5\n1 0 0 .5 .5\n0 1 0 .5 .5\n3 1 0 2\n44\n5\n0 0 1\n1 1 1\n$EndNodes\n"
    "$Elements\n4 4 1 4\n0 9 15 1\n1 10\n2 1 2 1\n2 10 2 3\n3 1 4 1\n3 10 2 3 44\n3 2 4 1\n4 2 3 44 5\n$EndElements\n";
  for(const std::string& text : {old, recent}) {
    program::Volume_file file = read_content("a.msh", text);
    BOOST_TEST((file.points == five_points));
    BOOST_TEST((file.cells.types == std::vector<std::uint8_t>{1, 5, 10, 10}));
    BOOST_TEST((file.cells.nodes == std::vector<int>{0, 0, 1, 2, 0, 1, 2, 3, 1, 2, 3, 4}));
    BOOST_TEST((regions_of(file) == std::vector<std::int64_t>{0, 4, 7, 8}));
    BOOST_TEST_REQUIRE(file.groups.size() == 2u);
    BOOST_TEST(file.groups[0].name == "hard core");
    // Written back, only the coordinates change.
    BOOST_TEST(written("b.msh", file) == text);
    file.points[3] = {0.1, -0., 1e-300};
    BOOST_TEST(written("b.msh", file) ==
               replaced(text, text == old ? "44 0 0 1\n" : "5\n0 0 1\n", text == old ? "44 0.1 -0 1e-300\n" : "5\n0.1 -0 1e-300\n"));
  }
  const std::string with_vertical_space = replaced(old, "2 1 0 0\n3", "2 1 0 0\v3");
  BOOST_TEST(written("b.msh", read_content("a.msh", with_vertical_space)) == with_vertical_space);
  const std::pair<std::string, std::string> cases[] = {
    {"", "$MeshFormat"},
    {replaced(old, "2.2 0 8", "4 0 8"), "line 2: the version '4' is not supported"},
    {replaced(old, "2.2 0 8", "2.2 0 9"), "line 2"},
    {replaced(old, "$Nodes\n5", "$Nodes\n6"), "line 19: '$EndNodes' is not an integer"},
    {replaced(old, "$Nodes\n5", "$Nodes\n4"), "line 18: found '5' instead of '$EndNodes'"},
    {replaced(old, "44 0 0 1\n", "3 0 0 1\n"), "line 17: a second node 3"},
    {replaced(old, "44 0 0 1\n", "44 0 0 nan\n"), "line 17: 'nan' is not a finite number"},
    {replaced(old, "10 2 3 44\n", "10 2 3 45\n"), "line 24: there is no node 45"},
    {replaced(old, "3 4 2 7", "3 104 2 7"), "line 24: elements of Gmsh's type 104"},
    {replaced(old, "3 4 2 7 1 10 2 3 44", "3 7 2 7 1 10 2 3 44 5"), "1 pyramids (5 nodes each)"},
    {old.substr(0, old.size() - 16), "without '$EndPeriodic'"},
    {old.substr(0, 200), "ends too early"},
    {replaced(recent, "$Nodes\n2 5", "$Nodes\n2 6"), "5 nodes where there should be 6"},
    {replaced(recent, "$Nodes\n2 5", "$Nodes\n4000000000 4000000000"), "is not"}};
  for(const auto& broken : cases) {
    const std::string message = message_for("a.msh", broken.first);
    BOOST_TEST(contains(message, broken.second), "expected '" << broken.second << "', got '" << message << "'");
  }
}

// The same in bytes of both orders, version 4.1.
BOOST_AUTO_TEST_CASE(binary_gmsh_files)
{
  for(const bool is_big : {false, true}) {
    std::string text = "$MeshFormat\n4.1 1 8\n";
    const auto ints = [&](std::initializer_list<int> numbers) {
      for(const int number : numbers)
        append_bytes<std::int32_t>(text, number, is_big);
    };
    const auto sizes = [&](std::initializer_list<int> numbers) {
      for(const int number : numbers)
        append_bytes<std::uint64_t>(text, number, is_big);
    };
    const auto reals = [&](const std::array<double, 3>& numbers) {
      for(const double number : numbers)
        append_bytes<double>(text, number, is_big);
    };
    ints({1});
    text += "\n$EndMeshFormat\n$Entities\n";
    sizes({0, 0, 0, 1});
    ints({5});
    reals({0, 0, 0});
    reals({1, 1, 1});
    sizes({1});
    ints({9});
    sizes({0});
    text += "\n$EndEntities\n$Nodes\n";
    sizes({1, 5, 1, 5});
    ints({3, 5, 0});
    sizes({5, 1, 2, 3, 4, 5});
    for(const auto& point : five_points)
      reals(point);
    text += "\n$EndNodes\n$Elements\n";
    sizes({1, 2, 1, 2});
    ints({3, 5, 4});
    sizes({2, 1, 1, 2, 3, 4, 2, 2, 3, 4, 5});
    text += "\n$EndElements\n";
    program::Volume_file file = read_content("a.msh", text);
    BOOST_TEST((file.points == five_points));
    BOOST_TEST((file.cells.nodes == std::vector<int>{0, 1, 2, 3, 1, 2, 3, 4}));
    BOOST_TEST((regions_of(file) == std::vector<std::int64_t>{9, 9}));
    BOOST_TEST((written("b.msh", file) == text));
    file.points[2][1] = 0.1;
    BOOST_TEST((read_content("c.msh", written("b.msh", file)).points == file.points));
    BOOST_TEST(contains(message_for("a.msh", text.substr(0, 300)), "byte "));
  }
}

// The layout of cells of version 5.1, as VTK writes it, and attributes with sections of their own.
BOOST_AUTO_TEST_CASE(old_vtk_files)
{
  const std::string recent =
    "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n0 0 0 1 0 0 0 1 0 \n0 0 1 1 1 1 \n"
    "METADATA\nINFORMATION 0\n\nCELLS 3 8\nOFFSETS vtktypeint64\n0 4 8 \nCONNECTIVITY vtktypeint64\n0 1 2 3 1 2 3 4 \n\n"
    "CELL_TYPES 2\n10\n10\n\nCELL_DATA 2\nSCALARS mat int\nLOOKUP_TABLE default\n3 4 \nFIELD FieldData 2\n"
    "region 1 2 vtkIdType\n7 8 \nMETADATA\nINFORMATION 0\n\nname%20of 1 2 string\nfirst\nsecond%20one\nPOINT_DATA 5\n"
    "VECTORS v double\n1 2 3 1 2 3 1 2 3 1 2 3 nan 2 3\nLOOKUP_TABLE table 1\n0 0 0 1\n";
  const std::string old =
    "# vtk DataFile Version 2.0\r\nby hand\r\nASCII\r\nDATASET UNSTRUCTURED_GRID\r\nPOINTS 5 double\r\n0 0 0 1 0 0 0 1 0\r\n0 0 1 1 1 1\r\n"
    "CELLS 2 10\r\n4 0 1 2 3\r\n4 1 2 3 4\r\nCELL_TYPES 2\r\n10 10\r\nCELL_DATA 2\r\nSCALARS region int 1\r\nLOOKUP_TABLE default\r\n7 8\r\n";
  for(const std::string& text : {recent, old}) {
    const program::Volume_file file = read_content("a.vtk", text);
    BOOST_TEST((file.points == five_points));
    BOOST_TEST((file.cells.nodes == std::vector<int>{0, 1, 2, 3, 1, 2, 3, 4}));
    BOOST_TEST((regions_of(file) == std::vector<std::int64_t>{7, 8}));
    const program::Volume_file copy = read_content("b.vtk", written("b.vtk", file));
    BOOST_TEST(are_same_arrays(copy.cell_data, file.cell_data));
    BOOST_TEST(are_same_arrays(copy.point_data, file.point_data));
  }
  const std::pair<std::string, std::string> cases[] = {
    {"", "does not begin"},
    {replaced(old, "ASCII", "ascci"), "line 3: neither ASCII nor BINARY"},
    {replaced(old, "UNSTRUCTURED_GRID", "POLYDATA"), "line 4: the file holds 'POLYDATA'"},
    {replaced(old, "POINTS 5", "POINTS 4"), "'1' is not supported"},
    {replaced(old, "POINTS 5", "POINTS 2000000000"), "'CELLS' is not a number"},
    {replaced(old, "5 double", "5 bit"), "line 5: the type of numbers 'bit'"},
    {replaced(old, "4 1 2 3 4", "5 1 2 3 4"), "corners of cell 1 is out of range"},
    {replaced(old, "4 1 2 3 4", "4 1 2 3 5"), "cell 1 (from 0) has the point 5"},
    {replaced(old, "10 10", "10 13"), "1 wedges (6 nodes each)"},
    {replaced(old, "CELL_TYPES 2", "CELL_TYPES 3"), "'CELL_DATA' is not an integer"},
    {replaced(old, "CELL_DATA 2", "CELL_DATA 3"), "but there are 2"},
    {replaced(old, "7 8", "7"), "ends too early"},
    {replaced(recent, "0 4 8 ", "0 9 8 "), "the offset of cell 1 is out of range"},
    {replaced(recent, "CELLS 3 8", "CELLS 3 9"), "'CELL_TYPES' is not an integer"},
    {old.substr(0, old.find("CELL_TYPES")), "ends too early, without CELL_TYPES"}};
  for(const auto& broken : cases) {
    const std::string message = message_for("a.vtk", broken.first);
    BOOST_TEST(contains(message, broken.second), "expected '" << broken.second << "', got '" << message << "'");
  }
}

BOOST_AUTO_TEST_CASE(abaqus_files)
{
  const std::string text =
    "*Heading\n** by hand\n*Part, name=Part-1\n*Node, nset=all\n 10, 0., 0., 0.\n 2, 1., 0., 0.\n3,0,1,0\n44,0,0,1.\n5, 1,1,1\n"
    "*Element, type=C3D4,\n elset=core\n1, 10, 2, 3, 44\n*ELEMENT, TYPE=C3D4H\n2, 2, 3,\n 44, 5\n*Element, type=S4\n9, 10, 2, 3, 44\n"
    "*Elset, elset=Rest, generate\n1, 9, 1\n*Elset, elset=both\ncore, 2\n*Solid Section, elset=core, material=steel\n,\n*End Part\n";
  program::Volume_file file = read_content("a.inp", text);
  BOOST_TEST((file.points == five_points));
  BOOST_TEST((file.cells.nodes == std::vector<int>{0, 1, 2, 3, 1, 2, 3, 4}));
  BOOST_TEST((regions_of(file) == std::vector<std::int64_t>{1, 2}));
  BOOST_TEST_REQUIRE(file.groups.size() == 2u);
  BOOST_TEST(file.groups[1].name == "Rest");
  BOOST_TEST(
    (written("b.inp", file) == replaced(replaced(replaced(text, "0., 0., 0.", "0, 0, 0"), "1., 0., 0.", "1, 0, 0"), "0,0,1.", "0,0,1")));
  // Names of sets become those of physical groups, and come back.
  const program::Volume_file gmsh = read_content("b.msh", written("b.msh", file));
  BOOST_TEST(gmsh.groups[1].name == "Rest");
  const program::Volume_file back = read_content("c.inp", written("c.inp", gmsh));
  BOOST_TEST((back.cells.nodes == file.cells.nodes && back.points == file.points));
  BOOST_TEST(back.groups[1].name == "Rest");
  const std::pair<std::string, std::string> cases[] = {
    {"", "no *NODE"},
    {replaced(text, "3,0,1,0", "2,0,1,0"), "line 7: a second node 2"},
    {replaced(text, "3,0,1,0", "3,0,1"), "line 7: a node has a number and three coordinates"},
    {replaced(text, "3,0,1,0", "3,0,1,inf"), "line 7: 'inf' is not a finite number"},
    {replaced(text, "2, 3, 44\n", "2, 3, 45\n"), "line 12: there is no node 45"},
    {replaced(text, "2, 3, 44\n", "2, 3\n"), "line 12: an element C3D4 has a number and 4 nodes"},
    {replaced(text, "type=S4", "type=C3D8R"), "1 C3D8R (4 nodes each)"},
    {replaced(text, "core, 2", "cores, 2"), "line 21: there is no set 'cores'"},
    {replaced(text, "1, 9, 1", "1, 9, 0"), "line 19: a set is generated"},
    {replaced(text, "*Part, name=Part-1", "*Include, input=x"), "*INCLUDE"}};
  for(const auto& broken : cases) {
    const std::string message = message_for("a.inp", broken.first);
    BOOST_TEST(contains(message, broken.second), "expected '" << broken.second << "', got '" << message << "'");
  }
}

// References of Medit files and attributes of TetGen files come out as regions everywhere, and back again.
BOOST_AUTO_TEST_CASE(regions_go_from_format_to_format)
{
  const std::string medit =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n1 1 1 5\nTriangles\n1\n1 2 3 6\n"
    "Tetrahedra\n2\n1 2 3 4 7\n2 3 4 5 8\nEnd\n";
  program::Volume_file file = read_content("a.mesh", medit);
  BOOST_TEST((regions_of(file) == std::vector<std::int64_t>{6, 7, 8}));
  for(const std::string name : {"b.meshb", "b.vtu", "b.vtk", "b.msh", "b.mesh"}) {
    file = read_content(name, written(name, file));
    BOOST_TEST((regions_of(file) == std::vector<std::int64_t>{6, 7, 8}), name);
  }
  file = read_content("a.mesh", medit);
  BOOST_TEST((written("c.mesh", read_content("b.vtu", written("b.vtu", file))) == medit));
  BOOST_TEST((written("c.mesh", read_content("b.meshb", written("b.meshb", file))) == medit));
  // Bytes in the other order, and written back.
  std::string binary = written("b.meshb", file), turned;
  for(std::size_t i = 0; i < binary.size();) {
    const bool is_real = i >= 32 && i < 32 + 5 * 28 && (i - 32) % 28 < 24;
    const std::size_t size = is_real ? 8 : 4;
    turned.append(binary.rbegin() + (binary.size() - i - size), binary.rbegin() + (binary.size() - i));
    i += size;
  }
  const program::Volume_file other = read_content("c.meshb", turned);
  BOOST_TEST((other.points == five_points && regions_of(other) == regions_of(file)));
  BOOST_TEST((written("d.meshb", other) == turned));
  BOOST_TEST(contains(message_for("a.meshb", binary.substr(0, 100)), "the file ends too early"));

  const Directory directory;
  directory.write("a.node", "5 3 1 1\n1 0 0 0 .5 3\n2 1 0 0 .5 3\n3 0 1 0 .5 3\n4 0 0 1 .5 3\n5 1 1 1 .5 4\n");
  BOOST_TEST(program::read_volume_file(directory.write("a.ele", "2 4 1\n1 1 2 3 4 7\n2 2 3 4 5 8\n"), file) == "");
  BOOST_TEST((regions_of(file) == std::vector<std::int64_t>{7, 8}));
  BOOST_TEST(program::write_volume_file(directory.file("b.ele"), read_content("b.vtu", written("b.vtu", file))) == "");
  BOOST_TEST(directory.read("b.ele") == "2 4 1\n0 0 1 2 3 7\n1 1 2 3 4 8\n");
  BOOST_TEST(directory.read("b.node").substr(0, 27) == "5 3 0 1\n0 0 0 0 3\n1 1 0 0 3");
}

// Tetrahedra of ten nodes are refused unless asked for, and their other nodes are put into the middles of edges, in the order of each
// format.
BOOST_AUTO_TEST_CASE(tetrahedra_of_second_order)
{
  program::Volume_file file;
  file.points = {five_points.begin(), five_points.begin() + 4};
  std::vector<int> nodes{0, 1, 2, 3};
  for(const auto& edge : program::TETRAHEDRON_EDGES) {
    std::array<double, 3> middle;
    for(int c = 0; c < 3; ++c)
      middle[c] = (file.points[edge[0]][c] + file.points[edge[1]][c]) / 2;
    nodes.push_back(static_cast<int>(file.points.size()));
    file.points.push_back(middle);
  }
  file.cells.add(program::cell_type::QUADRATIC_TETRAHEDRON, nodes);
  const auto places = file.points;
  for(const std::string name : {"a.vtu", "a.vtk", "a.msh", "a.inp"}) {
    const std::string text = written(name, file);
    BOOST_TEST(contains(message_for(name, text), "1 tetrahedra of second order (10 nodes each); --second-order"));
    program::Volume_file copy = read_content(name, text);
    program::Solid solid;
    BOOST_TEST(program::take_solid(copy, true, solid) == "");
    BOOST_TEST(solid.has_second_order);
    BOOST_TEST((solid.mesh.tetrahedra == std::vector<std::array<int, 4>>{{{0, 1, 2, 3}}}));
    BOOST_TEST((copy.cells.nodes == nodes));
    for(std::size_t v = 4; v < copy.points.size(); ++v)
      copy.points[v] = {9, 9, 9};
    program::center_mid_nodes(copy.cells, copy.points);
    BOOST_TEST((copy.points == places), name);
  }
  // Gmsh has the last two nodes the other way round.
  file.points[8] = {8, 8, 8};
  const std::string text = written("a.msh", file);
  BOOST_TEST((read_content("a.msh", text).points == file.points));
  for(const std::string name : {"a.mesh", "a.meshb", "a.node"})
    BOOST_TEST(contains(program::why_volume_not_written(name, file), "second order"));
}

// What a header claims neither takes memory nor time; files with any bytes wrong are read or refused.
BOOST_AUTO_TEST_CASE(readers_trust_nothing)
{
  program::Volume_file file = file_with_arrays();
  file.points.resize(12);
  file.cells = program::Cells();
  file.cell_data.clear();
  for(int i = 0; i < 8; ++i) {
    file.points[i] = {double(i % 2), double(i / 2 % 2), double(i / 4) / 3};
    file.cells.add(program::cell_type::TETRAHEDRON, std::array<int, 4>{i, i + 1, i + 2, i + 3});
  }
  file.cell_data.push_back(program::integer_array(program::REGION, program::Number_type::int32, {1, 1, 1, 2, 2, 2, 3, 3}));
  for(program::Data_array& array : file.point_data) {
    array.reals.resize(program::is_real(array.type) ? 12 * array.number_of_components : 0);
    array.integers.resize(program::is_real(array.type) ? 0 : 12 * array.number_of_components);
  }
  std::mt19937 generator(5);
  const Directory directory;
  int read = 0, refused = 0;
  for(const auto& [name, encoding] : {std::pair<const char*, const char*>{"a.vtu", "ascii"},
                                      {"a.vtu", "binary"},
                                      {"a.vtu", "base64"},
                                      {"a.vtu", "compressed"},
                                      {"a.vtk", "ascii"},
                                      {"a.vtk", "binary"},
                                      {"a.msh", "ascii"},
                                      {"a.msh", "binary"},
                                      {"a.mesh", "ascii"},
                                      {"a.meshb", "binary"},
                                      {"a.inp", "ascii"},
                                      {"a.node", "ascii"}}) {
    if(encoding == std::string("compressed") && !program::can_compress())
      continue;
    BOOST_TEST(program::write_volume_file(directory.file(name), file, program::volume_encoding(encoding)) == "");
    const std::string text = directory.read(name);
    for(int i = 0; i < 300; ++i) {
      std::string broken = text;
      for(int k = static_cast<int>(generator() % 3); k >= 0; --k) {
        const std::size_t at = generator() % broken.size();
        switch(generator() % 5) {
        case 0:
          broken[at] = static_cast<char>(generator());
          break;
        case 1:
          broken.erase(at, 1 + generator() % 20);
          break;
        case 2:
          broken.insert(at, broken.substr(generator() % broken.size(), generator() % 50));
          break;
        case 3: // a digit of a number, often a large one
          if(const std::size_t digit = broken.find_first_of("0123456789", at); digit != std::string::npos)
            broken.insert(digit, generator() % 2 == 0 ? "99999999" : "-");
          break;
        default:
          broken.resize(at + 1);
        }
      }
      program::Volume_file result;
      program::Solid solid;
      const std::string reason = program::read_volume_file(directory.write(name, broken), result);
      ++(reason.empty() ? read : refused);
      if(reason.empty() && program::take_solid(result, true, solid).empty())
        BOOST_TEST(program::write_volume_file(directory.file("again.vtk"), result) == "");
      else
        BOOST_TEST(result.points.size() <= broken.size());
    }
  }
  BOOST_TEST(read > 100);
  BOOST_TEST(refused > 1000);
}

// meshio reads what is written here, and what it writes is read.
BOOST_AUTO_TEST_CASE(meshio_understands)
{
  const std::string python = std::filesystem::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
  if(std::system((python + " -c 'import meshio' 2> /dev/null").c_str()) != 0) {
    BOOST_TEST_MESSAGE("skipped, there is no meshio (Debian: python3-meshio)");
    return;
  }
  const Directory directory;
  program::Volume_file file = program::make_volume_file(as_mesh(block()));
  std::vector<std::int64_t> regions;
  for(std::size_t i = 0; i < file.cells.size(); ++i)
    regions.push_back(static_cast<std::int64_t>(i % 3 + 1));
  file.cell_data.push_back(program::integer_array(program::REGION, program::Number_type::int32, regions));
  file.point_data.push_back(program::real_array("weights", 3, std::vector<double>(3 * file.points.size(), 0.1)));
  for(const std::string name : {"ascii.vtu", "binary.vtu", "base64.vtu", "compressed.vtu", "ascii.vtk", "binary.vtk", "ascii.msh",
                                "binary.msh", "ascii.mesh", "binary.meshb", "ascii.inp"}) {
    const std::string encoding = name.substr(0, name.find('.'));
    if(encoding != "compressed" || program::can_compress())
      BOOST_TEST(program::write_volume_file(directory.file("our_" + name), file, program::volume_encoding(encoding)) == "");
  }
  const std::string script = std::string(FLIP_FREE_MAPS_SOURCE_DIR) + "/test/IO/exchange_with_meshio.py";
  BOOST_TEST_REQUIRE(std::system((python + " '" + script + "' '" + directory.file("") + "' 1>&2").c_str()) == 0);
  int number = 0;
  for(const auto& entry : std::filesystem::directory_iterator(directory.file(""))) {
    const std::string name = entry.path().filename().string();
    if(name.rfind("their_", 0) != 0 || (contains(name, "zlib") && !program::can_compress()))
      continue;
    BOOST_TEST_CONTEXT(name)
    {
      ++number;
      program::Volume_file theirs;
      program::Solid solid;
      BOOST_TEST_REQUIRE(program::read_volume_file(entry.path().string(), theirs) == "");
      BOOST_TEST(program::take_solid(theirs, false, solid) == "");
      BOOST_TEST((solid.mesh.points == file.points));
      BOOST_TEST((solid.mesh.tetrahedra == as_mesh(block()).tetrahedra));
      if(contains(name, ".vt")) {
        BOOST_TEST_REQUIRE((program::find_array(theirs.point_data, "weights") != nullptr));
        BOOST_TEST((program::find_array(theirs.point_data, "weights")->reals == file.point_data[0].reals));
      }
      if(!contains(name, ".inp"))
        BOOST_TEST((regions_of(theirs) == regions));
    }
  }
  BOOST_TEST(number >= 10);
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

BOOST_AUTO_TEST_SUITE_END() // test_volume_files
