// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Files: exact round trips, messages for every kind of broken input, and pictures that are read back and looked at.

#include "support/unit_test.h"

#include "program/pictures/Layout_picture.h"
#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>
#include <CGAL/Flip_free_maps/domains/Textured_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO
#include <cairo.h>

#include <memory>
#endif

BOOST_AUTO_TEST_SUITE(test_io)

namespace FFM = CGAL::Flip_free_maps;
namespace fs = std::filesystem;

using Points_2 = std::vector<std::array<double, 2>>;
using Triangles = std::vector<std::array<int, 3>>;

namespace {

struct Directory
{
  Directory()
  {
    std::random_device device;
    do
      path = fs::temp_directory_path() / ("flip_free_maps_io_" + std::to_string(device()) + std::to_string(device()));
    while(!fs::create_directory(path));
  }

  ~Directory()
  {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }

  std::string file(const std::string& name) const { return (path / name).string(); }

  fs::path path;
};

std::string read_file(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

void write_file(const std::string& path, const std::string& content)
{
  std::ofstream stream(path, std::ios::binary);
  stream << content;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Any finite bit pattern: all exponents, denormals and both zeros.
double random_double(std::mt19937_64& generator)
{
  double value;
  do {
    const std::uint64_t bits = generator();
    std::memcpy(&value, &bits, sizeof(value));
  } while(!std::isfinite(value));
  return value;
}

template <std::size_t N>
bool are_same_bits(const std::vector<std::array<double, N>>& a, const std::vector<std::array<double, N>>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

FFM::Textured_mesh square_mesh()
{
  FFM::Textured_mesh mesh;
  mesh.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}};
  mesh.texture = {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}};
  mesh.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  mesh.texture_triangles = mesh.triangles;
  return mesh;
}

bool read_text(const std::string& text, FFM::Textured_mesh& mesh, std::string& message)
{
  const Directory directory;
  write_file(directory.file("a.obj"), text);
  return FFM::read_textured_OBJ(directory.file("a.obj"), mesh, &message);
}

const std::string square_header = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

} // namespace

BOOST_AUTO_TEST_CASE(OBJ_round_trip_is_exact)
{
  const Directory directory;
  std::mt19937_64 generator(1);
  FFM::Textured_mesh mesh;
  for(int i = 0; i < 2000; ++i) {
    mesh.points.push_back({{random_double(generator), random_double(generator), random_double(generator)}});
    mesh.texture.push_back({{random_double(generator), random_double(generator)}});
  }
  const double denormal = std::numeric_limits<double>::denorm_min();
  mesh.points.push_back({{denormal, -denormal, 1e300}});
  mesh.points.push_back({{-0., 0.1, -(std::numeric_limits<double>::max)()}});
  mesh.texture.push_back({{1e300, 3 * denormal}});
  mesh.texture.push_back({{(std::numeric_limits<double>::min)(), -0.}});
  std::uniform_int_distribution<int> point(0, static_cast<int>(mesh.points.size()) - 1);
  for(int i = 0; i < 3000; ++i) {
    mesh.triangles.push_back({{point(generator), point(generator), point(generator)}});
    mesh.texture_triangles.push_back({{point(generator), point(generator), point(generator)}});
  }

  std::string message = "old";
  BOOST_REQUIRE_MESSAGE(FFM::write_textured_OBJ(directory.file("a.obj"), mesh, &message), message);
  FFM::Textured_mesh copy;
  BOOST_REQUIRE_MESSAGE(FFM::read_textured_OBJ(directory.file("a.obj"), copy, &message), message);
  BOOST_TEST(message.empty());
  BOOST_TEST(are_same_bits(mesh.points, copy.points));
  BOOST_TEST(are_same_bits(mesh.texture, copy.texture));
  BOOST_TEST((mesh.triangles == copy.triangles));
  BOOST_TEST((mesh.texture_triangles == copy.texture_triangles));
}

BOOST_AUTO_TEST_CASE(OBJ_material_and_texture)
{
  const Directory directory;
  const FFM::Textured_mesh mesh = square_mesh();
  std::string message;
  BOOST_REQUIRE(FFM::write_textured_OBJ(directory.file("name.obj"), mesh, &message));
  const std::string obj = read_file(directory.file("name.obj"));
  const std::string mtl = read_file(directory.file("name.mtl"));
  BOOST_TEST(contains(obj, "mtllib name.mtl\n"));
  BOOST_TEST(contains(obj, "usemtl checkerboard\n"));
  BOOST_TEST(contains(obj, "f 1/1 3/3 4/4\n"));
  BOOST_TEST(contains(mtl, "newmtl checkerboard\n"));
  BOOST_TEST(contains(mtl, "map_Kd name_checker.png\n"));
  BOOST_TEST(fs::exists(directory.file("name_checker.png")));
  BOOST_TEST(message.empty());
}

BOOST_AUTO_TEST_CASE(OBJ_texture_scale)
{
  const Directory directory;
  FFM::Textured_mesh mesh = square_mesh();
  for(std::array<double, 2>& coordinates : mesh.texture)
    for(double& coordinate : coordinates)
      coordinate *= 400.;
  BOOST_REQUIRE(FFM::write_textured_OBJ(directory.file("a.obj"), mesh, nullptr, 0.25));
  FFM::Textured_mesh copy;
  BOOST_REQUIRE(FFM::read_textured_OBJ(directory.file("a.obj"), copy));
  BOOST_TEST(copy.texture[2][0] == 100.);
  BOOST_TEST(copy.points[2][0] == 1.);
  // Two squares per unit are the fewest that tile: the pattern scale makes 40 squares of the 200 across the layout.
  BOOST_TEST(contains(read_file(directory.file("a.mtl")), "map_Kd -s 0.2 0.2 1 a_checker.png\n"));
}

BOOST_AUTO_TEST_CASE(OBJ_number_of_squares)
{
  for(const double extent : {1e-3, 0.1, 0.16, 0.3, 1., 1.7, 5., 19., 20., 21., 1e6}) {
    const FFM::internal::Checkerboard_choice choice = FFM::internal::choose_checkerboard(extent);
    BOOST_TEST(choice.squares % 2 == 0);
    BOOST_TEST(choice.squares >= 2);
    BOOST_TEST(choice.squares <= 256);
    const double across = extent * choice.pattern_scale * choice.squares;
    BOOST_TEST(across >= 27., "extent " << extent << " shows " << across << " squares");
    BOOST_TEST(across <= 58., "extent " << extent << " shows " << across << " squares");
  }
  BOOST_TEST(FFM::internal::choose_checkerboard(0.).squares == 8);
}

BOOST_AUTO_TEST_CASE(OBJ_writer_refuses_invalid_meshes)
{
  const Directory directory;
  const std::string path = directory.file("a.obj");
  std::string message;
  const auto is_refused = [&](const FFM::Textured_mesh& mesh, const std::string& reason, double scale = 1.) {
    message.clear();
    return !FFM::write_textured_OBJ(path, mesh, &message, scale) && contains(message, reason) && fs::is_empty(directory.path);
  };
  FFM::Textured_mesh mesh = square_mesh();
  BOOST_TEST(is_refused(FFM::Textured_mesh(), "no triangle"));
  BOOST_TEST(is_refused(mesh, "texture_scale", 0.));
  BOOST_TEST(is_refused(mesh, "texture_scale", std::nan("")));
  mesh.triangles[1][2] = 4;
  BOOST_TEST(is_refused(mesh, "triangle 1 has an index out of range"));
  mesh.triangles[1][2] = -1;
  BOOST_TEST(is_refused(mesh, "triangle 1 has an index out of range"));
  mesh = square_mesh();
  mesh.texture_triangles[0][0] = 4;
  BOOST_TEST(is_refused(mesh, "triangle 0 has an index out of range"));
  mesh = square_mesh();
  mesh.texture_triangles.pop_back();
  BOOST_TEST(is_refused(mesh, "differ in size"));
  mesh = square_mesh();
  mesh.points[3][1] = std::nan("");
  BOOST_TEST(is_refused(mesh, "point 3 is not finite"));
  mesh = square_mesh();
  mesh.texture[2][0] = 1e300;
  BOOST_TEST(is_refused(mesh, "texture coordinate 2 is not finite", 1e10));

  mesh = square_mesh();
  for(const std::string& bad_path :
      {directory.file("missing/a.obj"), directory.path.string(), directory.file("a.mtl"), directory.file("a\nb.obj"), std::string()}) {
    message.clear();
    BOOST_TEST(!FFM::write_textured_OBJ(bad_path, mesh, &message));
    BOOST_TEST(!message.empty());
    BOOST_TEST(!FFM::write_textured_OBJ(bad_path, mesh));
  }
}

BOOST_AUTO_TEST_CASE(OBJ_dialects)
{
  FFM::Textured_mesh mesh;
  std::string message;
  const Triangles expected = {{{0, 1, 2}}, {{0, 2, 3}}};
  const std::string texts[] = {square_header + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
                               square_header + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4",
                               square_header + "f -4/-4 -3/-3 -2/-2\nf -4/1 3/-2 -1/4\n",
                               square_header + "vn 0 0 1\nf 1/1/1 2/2/-1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n",
                               square_header + "f 1/1/ 2/2/ 3/3/\nf 1/1/ 3/3/ 4/4/\n",
                               "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n" + square_header,
                               "\xEF\xBB\xBF" + square_header + "f 1/1 2/2 \\\n 3/3\nf\\\r\n1/1\t3/3 4/4  # f 1 2 3 \\\n",
                               "# C:\\models\\\n" + square_header +
                                 "o a\ng b\ns off\nusemtl c\nl 1 2\nf +1/1 2/2 3/3\n\n  f 1/1 3/3 4/4\n"};
  for(const std::string& text : texts) {
    mesh = FFM::Textured_mesh();
    BOOST_TEST_REQUIRE(read_text(text, mesh, message), message << "\n" << text);
    BOOST_TEST(message.empty());
    BOOST_TEST((mesh.triangles == expected));
    BOOST_TEST((mesh.texture_triangles == expected));
    BOOST_TEST((mesh.points == square_mesh().points));
    BOOST_TEST((mesh.texture == square_mesh().texture));
  }

  // Line ends of Windows and of the old Macintosh.
  for(const std::string line_end : {"\r\n", "\r"}) {
    std::string text;
    for(const char c : texts[0])
      text += c == '\n' ? line_end : std::string(1, c);
    BOOST_TEST_REQUIRE(read_text(text, mesh, message), message);
    BOOST_TEST((mesh.triangles == expected));
    BOOST_TEST(!read_text(text + "f 1/1 2/2" + line_end, mesh, message));
    BOOST_TEST(contains(message, "line 11: "), message);
  }

  // Negative indices count from the place of the face.
  BOOST_TEST_REQUIRE(read_text("v 9 9 9\n" + square_header + "f -1/-1 -2/-2 -3/-3\nv 0 0 0\nvt 0 0\nf -1/-1 1/1 2/2\n", mesh, message),
                     message);
  BOOST_TEST((mesh.triangles == Triangles{{{4, 3, 2}}, {{5, 0, 1}}}));
  BOOST_TEST((mesh.texture_triangles == Triangles{{{3, 2, 1}}, {{4, 0, 1}}}));

  // Weights, colors and the third texture coordinate are not read.
  BOOST_TEST_REQUIRE(read_text("v 1 2 3 0.5\nv -1.5e2 +2 .5 1 0 0\nv 0 0 0\nvt 1 2 3\nf 1/1 2/1 3/1\n", mesh, message), message);
  BOOST_TEST((mesh.points[1] == std::array<double, 3>{{-150., 2., 0.5}}));
  BOOST_TEST((mesh.texture[0] == std::array<double, 2>{{1., 2.}}));
}

BOOST_AUTO_TEST_CASE(OBJ_broken_files)
{
  struct Broken
  {
    std::string text;
    std::string reason;
  };
  const std::string& h = square_header; // 8 lines
  const Broken list[] = {{"", "no triangle"},
                         {h, "no triangle"},
                         {h + "f 1/1 2/2 3/3 4/4\n", "line 9: the face has 4 corners"},
                         {h + "f 1/1 2/2 3/3\nf 1/1 2/2\n", "line 10: the face has 2 corners"},
                         {h + "f\n", "line 9: the face has 0 corners"},
                         {h + "f 1 2 3\n", "line 9: corner '1' has no texture"},
                         {h + "vn 0 0 1\nf 1//1 2//1 3//1\n", "line 10: corner '1//1' has no texture"},
                         {h + "f 1/1 2/ 3/3\n", "line 9: corner '2/' has no texture"},
                         {h + "f 1/1 2/2 5/3\n", "line 9: v index 5 is out of range"},
                         {h + "f 1/1 2/2 3/3\nf 1/1 2/2 3/5\n", "line 10: vt index 5 is out of range"},
                         {h + "f 0/1 2/2 3/3\n", "line 9: v index '0' is out of range"},
                         {h + "f 1/0 2/2 3/3\n", "line 9: vt index '0' is out of range"},
                         {h + "f -5/1 2/2 3/3\n", "line 9: v index '-5' is out of range"},
                         {"f -1/-1 -1/-1 -1/-1\n" + h, "line 1: v index '-1' is out of range"},
                         {h + "f 99999999999/1 2/2 3/3\n", "line 9: v index '99999999999' is out of range"},
                         {h + "f 99999999999999999999999/1 2/2 3/3\n", "is out of range"},
                         {h + "f -9223372036854775808/1 2/2 3/3\n", "is out of range"},
                         {h + "f 1/1 2/2 x/3\n", "line 9: corner 'x/3' has no valid v index"},
                         {h + "f 1/1 2/2 3.5/3\n", "has no valid v index"},
                         {h + "f 1/1 2/2 3/3/x\n", "has no valid vn index"},
                         {h + "f 1/1 2/2 3/3/1/1\n", "has no valid vn index"},
                         {h + "f /// 2/2 3/3\n", "has no valid v index"},
                         {"v 1 2\n" + h, "line 1: 'v' needs 3 numbers, found 2"},
                         {h + "vt 1\n", "line 9: 'vt' needs 2 numbers, found 1"},
                         {h + "v 0 nan 0\n", "line 9: 'nan' is not a finite number"},
                         {h + "vt inf 0\n", "line 9: 'inf' is not a finite number"},
                         {h + "vt 0 -infinity\n", "is not a finite number"},
                         {h + "v 1e999 0 0\n", "line 9: '1e999' is not in the range"},
                         {h + "v 1,5 0 0\n", "line 9: '1,5' is not a number"},
                         {h + "v 1.0x 0 0\n", "is not a number"},
                         {h + "v 0x10 0 0\n", "is not a number"},
                         {h + "v + - 0\n", "'+' is not a number"},
                         {h + "v +-1 0 0\n", "is not a number"},
                         {h + "\\\nv 1 \\\n2\n", "line 9: 'v' needs 3 numbers"},
                         {std::string("v \0 \x01\xFF 0\n", 10), "line 1: '?' is not a number"},
                         {h + "v " + std::string(100000, 'x') + " 0 0\n", "x...' is not a number"}};
  FFM::Textured_mesh mesh = square_mesh();
  for(const Broken& broken : list) {
    std::string message;
    BOOST_TEST(!read_text(broken.text, mesh, message), "accepted: " << broken.text);
    BOOST_TEST(contains(message, broken.reason), "'" << message << "' does not contain '" << broken.reason << "'");
    BOOST_TEST(message.size() < 400u);
  }
  BOOST_TEST((mesh.triangles == square_mesh().triangles), "a failure changed the mesh");

  const Directory directory;
  for(const std::string& path : {directory.file("missing.obj"), directory.path.string(), std::string()}) {
    std::string message;
    BOOST_TEST(!FFM::read_textured_OBJ(path, mesh, &message));
    BOOST_TEST(contains(message, "cannot "), message);
    BOOST_TEST(!FFM::read_textured_OBJ(path, mesh));
  }
}

BOOST_AUTO_TEST_CASE(files_appear_at_once)
{
  const Directory directory;
  const std::string path = directory.file("a.txt");
  std::string message;
  BOOST_TEST(FFM::internal::write_whole_file(path, "old", &message));
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_hard_link(path, directory.file("witness.txt"));
  BOOST_TEST(FFM::internal::write_whole_file(path, "new", &message));
  BOOST_TEST(read_file(path) == "new");
  // The old file was not opened for writing, but its place was taken.
  BOOST_TEST(read_file(directory.file("witness.txt")) == "old");
  BOOST_TEST((fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read)));

  fs::create_symlink("a.txt", directory.file("link.txt"));
  BOOST_TEST(FFM::internal::write_whole_file(directory.file("link.txt"), "newest", &message));
  BOOST_TEST(fs::is_symlink(directory.file("link.txt")));
  BOOST_TEST(read_file(path) == "newest");

  // A file with the name of the temporary one is no obstacle, and is left alone.
  write_file(directory.file("b.txt.0.tmp"), "mine");
  BOOST_TEST(FFM::internal::write_whole_file(directory.file("b.txt"), "b", &message));
  BOOST_TEST(read_file(directory.file("b.txt.0.tmp")) == "mine");

  fs::create_directory(directory.file("folder"));
  BOOST_TEST(!FFM::internal::write_whole_file(directory.file("folder"), "text", &message));
  BOOST_TEST(!FFM::internal::write_whole_file(directory.file("missing/a.txt"), "text", &message));
  BOOST_TEST(contains(message, "cannot open"), message);
  std::size_t files = 0;
  for(const auto& entry : fs::directory_iterator(directory.path))
    files += entry.is_regular_file() && !entry.is_symlink();
  BOOST_TEST(files == 4u); // a.txt, its witness, b.txt and what had the temporary name
}

BOOST_AUTO_TEST_CASE(OBJ_garbage)
{
  std::mt19937_64 generator(7);
  const std::string alphabet = "vvttffn 0123456789//--..eE+#\\\r\n\n\t \xFF";
  const std::string valid = square_header + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
  for(int i = 0; i < 2000; ++i) {
    std::string text = i % 2 == 0 ? std::string() : valid;
    if(text.empty())
      for(int k = 0; k < 200; ++k)
        text += alphabet[generator() % alphabet.size()];
    else
      for(int k = 0; k < 3; ++k)
        text[generator() % text.size()] = static_cast<char>(generator());
    FFM::Textured_mesh mesh;
    std::string message;
    if(!read_text(text, mesh, message))
      continue;
    // Whatever is accepted is a valid mesh.
    BOOST_TEST(FFM::internal::textured_mesh_error(mesh, 1.).empty(), text);
  }
}

#ifdef CGAL_FLIP_FREE_MAPS_USE_CAIRO

BOOST_AUTO_TEST_SUITE(pictures, *boost::unit_test::label("needs_cairo"))

namespace {

class Image
{
public:
  explicit Image(const std::string& path) : m_surface(cairo_image_surface_create_from_png(path.c_str()), &cairo_surface_destroy) {}

  bool is_valid() const { return cairo_surface_status(m_surface.get()) == CAIRO_STATUS_SUCCESS; }
  int width() const { return cairo_image_surface_get_width(m_surface.get()); }
  int height() const { return cairo_image_surface_get_height(m_surface.get()); }

  std::uint32_t color(int x, int y) const
  {
    std::uint32_t pixel;
    std::memcpy(&pixel,
                cairo_image_surface_get_data(m_surface.get()) + std::ptrdiff_t(cairo_image_surface_get_stride(m_surface.get())) * y + 4 * x,
                4);
    return pixel & 0xFFFFFFu;
  }

  // Luma (ITU-R BT.709), from 0 to 255.
  double brightness(int x, int y) const
  {
    const std::uint32_t c = color(x, y);
    return 0.2126 * (c >> 16) + 0.7152 * ((c >> 8) & 0xFF) + 0.0722 * (c & 0xFF);
  }

private:
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> m_surface;
};

// Place of the layout on a picture without title, found from the pixels that are not white left of the legend.
struct Placement
{
  explicit Placement(const Image& image)
  {
    for(int y = 0; y < image.height(); ++y) {
      for(int x = 0; x < image.width() * 825 / 1000; ++x) {
        if(image.color(x, y) == 0xFFFFFF)
          continue;
        left = (std::min)(left, x);
        right = (std::max)(right, x);
        top = (std::min)(top, y);
        bottom = (std::max)(bottom, y);
      }
    }
  }

  int x(double u) const { return static_cast<int>(std::lround(left + (right - left) * u)); }
  int y(double v) const { return static_cast<int>(std::lround(bottom - (bottom - top) * v)); }

  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

// The upper left half of the square is flipped.
const Points_2 square = {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}};
const Triangles half_flipped = {{{0, 1, 2}}, {{0, 3, 2}}};
const Triangles not_flipped = {{{0, 1, 2}}, {{0, 2, 3}}};

// Wavy grid of 2 * n * n triangles.
void make_grid(int n, Points_2& uv, Triangles& triangles)
{
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      uv.push_back({{i + 0.3 * std::sin(1.7 * j), j + 0.3 * std::cos(2.3 * i)}});
  for(int j = 0; j < n; ++j) {
    for(int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      triangles.push_back({{a, a + 1, a + n + 2}});
      triangles.push_back({{a, a + n + 2, a + n + 1}});
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(PNG_shows_the_flipped_triangle)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  std::string message = "old";
  BOOST_REQUIRE(FFM::write_layout_PNG(path, square, half_flipped, {1., 1.}, {}, &message));
  BOOST_TEST(message.empty());
  const Image image(path);
  BOOST_REQUIRE(image.is_valid());
  BOOST_TEST(image.width() == 1600);
  BOOST_TEST(image.height() > 560);
  BOOST_TEST(image.height() <= 2000);

  const Placement place(image);
  BOOST_TEST(std::abs((place.right - place.left) - (place.bottom - place.top)) <= 2);
  BOOST_TEST(place.right - place.left > 1000);
  BOOST_TEST(image.color(place.x(1. / 3), place.y(2. / 3)) == 0xFF00FFu);
  BOOST_TEST(image.color(place.x(2. / 3), place.y(1. / 3)) != 0xFF00FFu);
  BOOST_TEST(image.color(place.x(2. / 3), place.y(1. / 3)) != 0xFFFFFFu);
  BOOST_TEST(image.brightness(place.x(2. / 3), place.y(1. / 3)) > 225.);
  BOOST_TEST(image.brightness(place.x(2. / 3), place.bottom - 1) < 90.);
  for(const int x : {0, place.left - 3, image.width() - 1})
    for(const int y : {0, image.height() / 2, image.height() - 1})
      BOOST_TEST(image.color(x, y) == 0xFFFFFFu);

  FFM::Layout_picture_options options;
  options.warning_color = {{255, 0, 0}};
  BOOST_REQUIRE(FFM::write_layout_PNG(path, square, half_flipped, {1., 1.}, options));
  BOOST_TEST(Image(path).color(place.x(1. / 3), place.y(2. / 3)) == 0xFF0000u);
}

BOOST_AUTO_TEST_CASE(PNG_orientation_is_exact)
{
  // Point 3 is right of the line through points 1 and 2, by so little that the determinant evaluated in doubles is 0.
  const double h = std::numeric_limits<double>::epsilon();
  const Points_2 uv = {{{0.5, 0.5}}, {{12, 12}}, {{24, 24}}, {{0.5 + h / 2, 0.5}}, {{0, 24}}};
  const Directory directory;
  FFM::Layout_picture_options options;
  const auto has_magenta = [&](const Triangles& triangles) {
    BOOST_REQUIRE(FFM::write_layout_PNG(directory.file("a.png"), uv, triangles, std::vector<double>(2, 1.), options));
    const Image image(directory.file("a.png"));
    for(int y = 0; y < image.height(); ++y)
      for(int x = 0; x < image.width(); ++x)
        if(image.color(x, y) == 0xFF00FFu)
          return true;
    return false;
  };
  BOOST_TEST(!has_magenta({{{0, 1, 2}}, {{0, 2, 4}}}));
  BOOST_TEST(has_magenta({{{3, 1, 2}}, {{0, 2, 4}}}));
  BOOST_TEST(!has_magenta({{{3, 2, 1}}, {{0, 2, 4}}}));
}

BOOST_AUTO_TEST_CASE(PNG_colors_deepen_with_distortion)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  Points_2 uv;
  Triangles triangles;
  std::vector<double> distortion;
  const int n = 12;
  for(int i = 0; i <= n; ++i) {
    uv.push_back({{double(i), 0.}});
    uv.push_back({{double(i), 3.}});
  }
  for(int i = 0; i < n; ++i) {
    triangles.push_back({{2 * i, 2 * i + 2, 2 * i + 3}});
    triangles.push_back({{2 * i, 2 * i + 3, 2 * i + 1}});
    distortion.insert(distortion.end(), 2, std::pow(1.2, i));
  }
  FFM::Layout_picture_options options;
  options.distortion_upper_end = std::pow(1.2, n - 1);
  BOOST_REQUIRE(FFM::write_layout_PNG(path, uv, triangles, distortion, options));
  const Image image(path);
  const Placement place(image);
  BOOST_TEST((place.right - place.left) / double(place.bottom - place.top) == 4., boost::test_tools::tolerance(0.02));
  double previous = 256.;
  for(int i = 0; i < n; ++i) {
    const double current = image.brightness(place.x((i + 0.25) / n), place.y(0.7));
    BOOST_TEST(current < previous - 8.);
    previous = current;
  }

  // Above the upper end, infinite and undefined are all drawn as the upper end; below 1 as 1.
  const double infinity = std::numeric_limits<double>::infinity();
  distortion[0] = distortion[1] = infinity;
  distortion[2] = distortion[3] = std::nan("");
  distortion[4] = distortion[5] = 1e9;
  distortion[6] = distortion[7] = -infinity;
  distortion[8] = distortion[9] = 1.;
  BOOST_REQUIRE(FFM::write_layout_PNG(path, uv, triangles, distortion, options));
  const Image special(path);
  const auto color_of = [&](int i) { return special.color(place.x((i + 0.25) / n), place.y(0.7)); };
  for(int i = 0; i < 3; ++i)
    BOOST_TEST(color_of(i) == color_of(n - 1));
  BOOST_TEST(color_of(3) == color_of(4));
  BOOST_TEST(color_of(4) != color_of(n - 1));
}

BOOST_AUTO_TEST_CASE(PNG_without_gaps_between_triangles)
{
  Points_2 uv;
  Triangles triangles;
  make_grid(300, uv, triangles);
  const Directory directory;
  const std::string path = directory.file("a.png");
  BOOST_REQUIRE(FFM::write_layout_PNG(path, uv, triangles, std::vector<double>(triangles.size(), 3.)));
  const Image image(path);
  const Placement place(image);
  const std::uint32_t expected = image.color(place.x(0.5), place.y(0.5));
  int number_of_gaps = 0;
  for(int y = place.top + 20; y < place.bottom - 20; ++y)
    for(int x = place.left + 20; x < place.right - 20; ++x)
      number_of_gaps += image.color(x, y) != expected;
  BOOST_TEST(number_of_gaps == 0);
  BOOST_TEST(expected != 0xFFFFFFu);
}

BOOST_AUTO_TEST_CASE(pictures_of_extreme_layouts)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  const double denormal = std::numeric_limits<double>::denorm_min();
  const std::array<double, 2> sizes[] = {{{1, 1e-6}},      {{1e-6, 1}}, {{1e300, 1e300}}, {{1e-300, 1e-300}},
                                         {{1, 0}},         {{0, 1}},    {{0, 0}},         {{4 * denormal, 4 * denormal}},
                                         {{1e200, 1e-200}}};
  FFM::Layout_picture_options options;
  options.title = "bad \xFF utf-8, good \xC3\xBC\xE2\x89\xA5, cut \xE2\x89";
  for(const int width : {320, 1600}) {
    for(const std::array<double, 2>& size : sizes) {
      Points_2 uv = square;
      for(std::array<double, 2>& p : uv)
        for(int c = 0; c < 2; ++c)
          p[c] *= size[c];
      options.width = width;
      std::string message;
      BOOST_TEST_REQUIRE(FFM::write_layout_PNG(path, uv, not_flipped, {1., 2.}, options, &message), message);
      const Image image(path);
      BOOST_TEST(image.width() == width);
      BOOST_TEST(image.height() >= width * 35 / 100);
      BOOST_TEST(image.height() <= width * 125 / 100);
      BOOST_TEST_REQUIRE(FFM::write_layout_SVG(path, uv, not_flipped, {1., 2.}, options, &message), message);
    }
  }
  options.height = 240;
  options.title = std::string(100000, 'M');
  BOOST_REQUIRE(FFM::write_layout_PNG(path, square, half_flipped, {1., 1e300}, options));
  BOOST_TEST(Image(path).height() == 240);
}

BOOST_AUTO_TEST_CASE(SVG_is_complete)
{
  const Directory directory;
  const std::string path = directory.file("a.svg");
  std::string message = "old";
  BOOST_REQUIRE(FFM::write_layout_SVG(path, square, half_flipped, {1., 1.}, {}, &message));
  BOOST_TEST(message.empty());
  const std::string svg = read_file(path);
  BOOST_TEST(svg.compare(0, 5, "<?xml") == 0);
  BOOST_TEST(contains(svg, "</svg>"));
  BOOST_TEST(contains(svg, "rgb(100%,0%,100%)"));
  BOOST_TEST(!contains(svg, "<image"));

  BOOST_REQUIRE(FFM::write_layout_SVG(path, square, not_flipped, {1., 1.}));
  BOOST_TEST(!contains(read_file(path), "rgb(100%,0%,100%)"));

  // Above 100000 triangles the fills are an embedded image.
  Points_2 uv;
  Triangles many;
  make_grid(224, uv, many);
  BOOST_REQUIRE(FFM::write_layout_SVG(path, uv, many, std::vector<double>(many.size(), 1.)));
  const std::string large = read_file(path);
  BOOST_TEST(contains(large, "<image"));
  BOOST_TEST(contains(large, "</svg>"));
  BOOST_TEST(large.size() < 1000000u);
}

BOOST_AUTO_TEST_CASE(pictures_refuse_invalid_arguments)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  const auto is_refused = [&](const Points_2& uv, const Triangles& triangles, const std::vector<double>& distortion,
                              const FFM::Layout_picture_options& options, const std::string& reason) {
    bool result = true;
    for(const bool is_SVG : {false, true}) {
      std::string message;
      const auto write = is_SVG ? &FFM::write_layout_SVG : &FFM::write_layout_PNG;
      result = !write(path, uv, triangles, distortion, options, &message) && contains(message, reason) && result;
    }
    return result && fs::is_empty(directory.path);
  };
  BOOST_TEST(is_refused({}, {}, {}, {}, "no triangle"));
  BOOST_TEST(is_refused(square, not_flipped, {1.}, {}, "number of distortions"));
  BOOST_TEST(is_refused(square, {{{0, 1, 4}}}, {1.}, {}, "triangle 0 has an index out of range"));
  BOOST_TEST(is_refused(square, {{{0, -1, 2}}}, {1.}, {}, "triangle 0 has an index out of range"));
  BOOST_TEST(is_refused({{{0, 0}}, {{1, 0}}, {{0, std::nan("")}}}, {{{0, 1, 2}}}, {1.}, {}, "not finite"));
  BOOST_TEST(is_refused({{{-1.7e308, 0}}, {{1.7e308, 0}}, {{0, 1}}}, {{{0, 1, 2}}}, {1.}, {}, "too large"));
  FFM::Layout_picture_options options;
  options.width = 10;
  BOOST_TEST(is_refused(square, not_flipped, {1., 1.}, options, "width"));
  options = FFM::Layout_picture_options();
  options.height = 100000;
  BOOST_TEST(is_refused(square, not_flipped, {1., 1.}, options, "height"));
  options = FFM::Layout_picture_options();
  options.distortion_upper_end = 1.;
  BOOST_TEST(is_refused(square, not_flipped, {1., 1.}, options, "upper end"));
}

BOOST_AUTO_TEST_CASE(pictures_report_unwritable_paths)
{
  const Directory directory;
  std::vector<std::string> paths = {directory.file("missing/a.png"), directory.path.string(), ""};
  if(fs::is_character_file("/dev/full"))
    paths.push_back("/dev/full");
  for(const std::string& path : paths) {
    std::string message;
    BOOST_TEST(!FFM::write_layout_PNG(path, square, not_flipped, {1., 1.}, {}, &message));
    BOOST_TEST(contains(message, "cannot "), message);
    message.clear();
    BOOST_TEST(!FFM::write_layout_SVG(path, square, not_flipped, {1., 1.}, {}, &message));
    BOOST_TEST(contains(message, "cannot "), message);
    message.clear();
    BOOST_TEST(!FFM::write_checkerboard_PNG(path, 64, 8, &message));
    BOOST_TEST(contains(message, "cannot "), message);
    BOOST_TEST(!FFM::write_checkerboard_PNG(path, 64, 8));
  }
}

BOOST_AUTO_TEST_CASE(checkerboard_pixels)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  std::string message = "old";
  BOOST_REQUIRE(FFM::write_checkerboard_PNG(path, 64, 8, &message));
  BOOST_TEST(message.empty());
  const Image image(path);
  BOOST_REQUIRE(image.is_valid());
  BOOST_TEST(image.width() == 64);
  BOOST_TEST(image.height() == 64);
  const std::uint32_t colors[2] = {image.color(0, 0), image.color(8, 0)};
  BOOST_TEST(colors[0] != colors[1]);
  int number_of_errors = 0;
  for(int y = 0; y < 64; ++y)
    for(int x = 0; x < 64; ++x)
      number_of_errors += image.color(x, y) != colors[(x / 8 + y / 8) % 2];
  BOOST_TEST(number_of_errors == 0);

  // Neither whole bytes nor squares of one size, and more bytes than a block of the file holds.
  BOOST_REQUIRE(FFM::write_checkerboard_PNG(path, 1001, 6, &message));
  const Image odd(path);
  BOOST_REQUIRE(odd.is_valid());
  for(const int x : {0, 166, 167, 333, 334, 1000})
    BOOST_TEST((odd.color(x, 1000) == colors[0]) == ((x * 6 + 5) / 1001 % 2 == 1));

  for(const std::array<int, 2>& bad : {std::array<int, 2>{{0, 1}}, {{8, 0}}, {{8, 9}}, {{-5, 2}}, {{1 << 20, 8}}}) {
    message.clear();
    BOOST_TEST(!FFM::write_checkerboard_PNG(path, bad[0], bad[1], &message));
    BOOST_TEST(!message.empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()

#else

BOOST_AUTO_TEST_CASE(pictures, *boost::unit_test::label("needs_cairo")) { test_support::skip_case("built without Cairo"); }

BOOST_AUTO_TEST_CASE(pictures_without_cairo)
{
  const Directory directory;
  const std::string path = directory.file("a.png");
  const Points_2 uv = {{{0, 0}}, {{1, 0}}, {{1, 1}}};
  const Triangles triangles = {{{0, 1, 2}}};
  std::string message;
  BOOST_TEST(!FFM::write_layout_PNG(path, uv, triangles, {1.}, {}, &message));
  BOOST_TEST(contains(message, "built without Cairo"));
  message.clear();
  BOOST_TEST(!FFM::write_layout_SVG(path, uv, triangles, {1.}, {}, &message));
  BOOST_TEST(contains(message, "built without Cairo"));
  BOOST_TEST(fs::is_empty(directory.path));
}

#endif

// Standard libraries without std::from_chars() for doubles are served by streams, alike.
BOOST_AUTO_TEST_CASE(numbers_by_streams)
{
  using namespace FFM::internal;
  std::vector<std::string> words{"1",    "-2.25",     "1.5e3", "1E-3", ".5", "1.", "1e400", "-1e400", "1e-400", "4.9e-324",
                                 "inf",  "-Infinity", "nan",   "",     "-",  "+1", "1e",    "1e+",    "1 ",     " 1",
                                 "0x10", "abc",       "--1",   "1,5",  "0",  "-0", "0e9",   "1.2.3",  "e5",     "1e5e5"};
  std::mt19937_64 random(1);
  for(int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    if(!std::isfinite(value))
      continue;
    double read = 0;
    BOOST_TEST((parse_by_stream(text_by_stream(value, 0), read) == std::errc()));
    BOOST_TEST(read == value);
    std::string text;
    append_number(text, value, 9);
    BOOST_TEST(text_by_stream(value, 9) == text);
    words.push_back(text);
  }
  if constexpr(has_charconv_of_doubles)
    for(const std::string& word : words) {
      double by_stream = -7, by_charconv = -7;
      const std::errc streamed = parse_by_stream(word, by_stream), converted = parse_by_charconv(word, by_charconv);
      BOOST_TEST_CONTEXT("'" << word << "'")
      {
        BOOST_TEST((streamed == converted));
        if(converted == std::errc() && !std::isnan(by_charconv))
          BOOST_TEST(by_stream == by_charconv);
        float single_by_stream = -7, single_by_charconv = -7;
        const std::errc single_converted = parse_by_charconv(word, single_by_charconv);
        BOOST_TEST((parse_by_stream(word, single_by_stream) == single_converted));
        if(single_converted == std::errc() && !std::isnan(single_by_charconv))
          BOOST_TEST(single_by_stream == single_by_charconv);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END() // test_io
