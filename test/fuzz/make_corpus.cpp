// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// Writes small files of all formats, which fuzzing begins with: a folder for each target.
//
// usage: make_fuzz_corpus FOLDER

#include "program/formats/gltf/Gltf_container.h"
#include "program/formats/gltf/Gltf_document.h"
#include "program/formats/gltf/Gltf_surface.h"
#include "program/formats/volume_files.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

namespace fs = std::filesystem;

class Corpus
{
public:
  explicit Corpus(const std::string& folder) : m_folder(folder) {}

  // The name of another file for a target.
  std::string file(const std::string& target, const std::string& extension = "")
  {
    const fs::path folder = m_folder / target;
    fs::create_directories(folder);
    return (folder / ("seed_" + std::to_string(m_number++) + extension)).string();
  }

  void add(const std::string& target, const std::string& text) { std::ofstream(file(target), std::ios::binary) << text; }

private:
  fs::path m_folder;
  int m_number = 0;
};

std::string content(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

// Numbers with the lowest byte first.
template <typename Number, typename... Values>
std::string bytes(Values... values)
{
  std::string result;
  for(const Number number : {static_cast<Number>(values)...}) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof(Number));
    for(std::size_t i = 0; i < sizeof(Number); ++i)
      result += static_cast<char>(bits >> (8 * i) & 255);
  }
  return result;
}

void add_surfaces(Corpus& corpus)
{
  corpus.add("off", "OFF\n# a square\n4 2 0\n0 0 0\n1 0 0\n1 1 .5\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  corpus.add("off", "STNOFF 4 1 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n1 1 0 0 0 1 1 1\n0 1 0 0 0 1 0 1\n4 0 1 2 3 255 0 0\n");
  corpus.add("off", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2 3\n");
  corpus.add("off", "OFF BINARY\n" + std::string("\0\0\0\3\0\0\0\1\0\0\0\0", 12) + std::string(24, '\0') + std::string("\x3f\x80\0\0", 4) +
                      std::string(8, '\0') + std::string("\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\0", 20));

  for(const std::string target : {"obj", "library_obj"}) {
    corpus.add(target, "mtllib a.mtl\no square\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1 0\nvt 0 1\nvn 0 0 1\n"
                       "g one\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/3/1\nf -4/-4/-1 \\\n -2/-2/-1 -1/-1/-1\n");
    corpus.add(target, "\xEF\xBB\xBF# quads\r\nv\t0 0 0\r\nv 1e0 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1//1 2//1 3//1 4//1\r\nl 1 2\r\np 1\r\n");
  }

  const std::string vertices = "element vertex 4\nproperty float x\nproperty double y\nproperty float z\nproperty uchar red\n";
  corpus.add("ply", "ply\nformat ascii 1.0\ncomment a square\n" + vertices +
                      "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
                      "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 0\n");
  corpus.add("ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty int y\nproperty int z\nproperty float s\n"
                    "property float t\nelement face 1\nproperty list uint uint vertex_index\nelement edge 1\nproperty int vertex1\n"
                    "end_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n0\n");
  for(const bool is_big_endian : {false, true})
    corpus.add("ply", std::string("ply\nformat binary_") + (is_big_endian ? "big" : "little") +
                        "_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty uchar z\nelement face 1\n"
                        "property uchar flags\nproperty list uchar uchar vertex_indices\nend_header\n" +
                        std::string("\0\0\0\1\0\0\0\1\0\7\3\0\1\2", 14));

  corpus.add("stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
                    "solid b\nendsolid b\n");
  corpus.add("stl",
             std::string(80, ' ') + bytes<std::uint32_t>(1) + bytes<float>(0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0) + bytes<std::uint16_t>(0));
}

void add_solids(Corpus& corpus, const std::string& folder)
{
  CGAL::Flip_free_maps::Tetrahedral_mesh mesh;
  mesh.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 0.1}}};
  mesh.tetrahedra = {{{0, 1, 2, 3}}, {{1, 4, 2, 3}}};
  mesh.triangles = {{{0, 2, 1}}};
  program::Volume_file file = program::make_volume_file(mesh);
  file.cell_data.push_back(program::integer_array(program::REGION, program::Number_type::int32, {3, 1, 2}));
  file.point_data.push_back(program::real_array("warp", 3, std::vector<double>(15, 0.5)));
  file.groups.push_back({3, 1, "rock"});
  program::Volume_file second_order = file;
  second_order.points.resize(10);
  second_order.cells = program::Cells();
  second_order.cells.add(program::cell_type::QUADRATIC_TETRAHEDRON, std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  second_order.point_data.clear();
  second_order.cell_data.clear();
  for(const program::Volume_file& solid : {file, second_order})
    for(const std::string format : {"mesh", "meshb", "vtu", "vtk", "msh", "inp"})
      for(const std::string& encoding : program::volume_encoding_names())
        if(program::why_volume_not_written("a." + format, program::volume_encoding(encoding)).empty() &&
           program::why_volume_not_written("a." + format, solid).empty())
          program::write_volume_file(corpus.file(format, "." + format), solid, program::volume_encoding(encoding));
  program::write_volume_file(corpus.file("library_mesh", ".mesh"), file);

  const std::string path = folder + "/tetgen.node";
  program::write_volume_file(path, file);
  corpus.add("node", content(path) + "%" + content(folder + "/tetgen.ele"));
  fs::remove(path);
  fs::remove(folder + "/tetgen.ele");
  corpus.add("node", "# by hand\n4 3 1 1\n1 0 0 0 7 1\n2 1 0 0 7 1\n3 0 1 0 7 1\n4 0 0 1 7 1\n%1 4 1\n1 1 2 3 4 5\n");

  corpus.add("vtk",
             "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"
             "METADATA\nINFORMATION 0\n\nCELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\nCELL_TYPES 1\n10\n"
             "POINT_DATA 4\nSCALARS s float 1\nLOOKUP_TABLE default\n1 2 3 4\nVECTORS v double\n0 0 0 0 0 0 0 0 0 0 0 0\n"
             "CELL_DATA 1\nFIELD FieldData 1\nf 2 1 int\n1 2\n");
  corpus.add("msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"rock\"\n$EndPhysicalNames\n$Entities\n0 0 0 1\n"
                    "1 0 0 0 1 1 1 1 1 0\n$EndEntities\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"
                    "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n");
  corpus.add("inp", "*Heading\n** a comment\n*Node, nset=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n*Element, type=C3D4, "
                    "elset=rock\n1, 1, 2, 3, 4\n*Elset, elset=more, generate\n1, 1, 1\n*Elset, elset=again\nrock, 1\n*End\n");
}

void add_gltf(Corpus& corpus)
{
  program::Surface surface;
  for(const double x : {0., 1.})
    for(const double y : {0., 1.})
      surface.points.emplace_back(x, y, x * y);
  surface.polygons = {{0, 2, 3}, {0, 3, 1}};
  surface.objects = {0, 1};
  surface.object_names = {"one", "two"};
  // With a material, since a checkerboard is a thousand times as long as the rest.
  program::Gltf_container container("a.glb", program::gltf_text(surface));
  container.json["materials"] = program::Json::array({program::Json::object()});
  for(program::Json& mesh : container.json["meshes"])
    mesh["primitives"][0]["material"] = 0;
  const std::string bare = container.written("a.glb");
  const program::Corner_images images(2, {{0, 0}, {1, 0}, {1, 1}});
  std::string note;
  for(const std::string format : {"glb", "gltf"}) {
    corpus.add(format, program::with_gltf_images({"a.glb", bare, "a." + format, 0, false}, images, note));
    corpus.add(format, program::with_gltf_images({"a.glb", bare, "a." + format, 1, false}, images, note));
  }
  corpus.add("gltf",
             R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"children": [1], "scale": [2, 2, 2]},
{"mesh": 0, "skin": 0, "rotation": [0, 0, 0, 1], "translation": [1, 0, 0]}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0,
"TEXCOORD_0": 1}, "mode": 5, "material": 0, "targets": [{"POSITION": 0}]}], "weights": [0.5]}], "materials": [{"pbrMetallicRoughness":
{"baseColorTexture": {"index": 0, "texCoord": 0}}}], "accessors": [{"componentType": 5126, "count": 4, "type": "VEC3", "sparse":
{"count": 1, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 1}}, "min": [0, 0, 0], "max": [1, 1, 1]},
{"bufferView": 1, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC2"}], "bufferViews": [{"buffer": 0, "byteLength": 4},
{"buffer": 0, "byteOffset": 4, "byteLength": 16, "byteStride": 4}], "buffers": [{"byteLength": 20, "uri":
"data:application/octet-stream;base64,AQAAAAAAgD8AAIA/AACAPwAAgD8="}]})");
}

void add_lines(Corpus& corpus)
{
  corpus.add("handles", "# the plane\n0 0 0\n1 1.5 0 # further\n1 1 -> 2 2\n");
  corpus.add("handles", "0 0 0 0\n0 1 0 -> 0 2 0\n");
  corpus.add("numbers", "# seams\n0 1\n2 3\n");
  corpus.add("numbers", "0 1.5 -2e3\n4 0 0\n");
  corpus.add("options",
             "parameterize\na.off\n-o\nb.obj\n--json\nc.json\n--method\npp+\n--energy\namips\n--tolerance\n1e-6\n--threads\n2\n");
  corpus.add("options", "unwrap\na.glb\n--uv-set\n1\n-o\nb.glb\n--max-distortion\n1.5\n--seams\ns.txt\n--quiet\n--progress\njson\n");
  corpus.add("options", "deform\na.mesh\n--handles\nh.txt\n-o\nb.vtu\n--encoding\nbinary\n--time-limit\n1\n--second-order\n");
  corpus.add("options", "repair\na.obj\n-o\nb.obj\n--preconditioner\nslim\n--max-iterations\n10\n");
  corpus.add("options", "morph\na.vtu\n--from\ns.obj\n--to\nt.obj\n-o\nb.vtu\n");
  corpus.add("options", "map-volume\na.mesh\n-o\nb.mesh\n");
  corpus.add("options", "measure\na.obj\n--json\nb.json\n");
  corpus.add("options", "pack\na.obj\n-o\nb.obj\n");
}

} // namespace

int main(int argc, char** argv)
{
  if(argc != 2)
    return 2;
  Corpus corpus(argv[1]);
  add_surfaces(corpus);
  add_solids(corpus, argv[1]);
  add_gltf(corpus);
  add_lines(corpus);
  return 0;
}
