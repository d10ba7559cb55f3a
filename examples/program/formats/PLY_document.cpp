// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "PLY_text.h"
#include "Polygon_document.h"

#include <cstring>
#include <utility>

namespace program {

namespace {

// Appends numbers as words, or as bytes of either order.
class PLY_writer
{
public:
  PLY_writer(const PLY_text& ply, std::string& text) : m_is_ascii(ply.is_ascii()), m_is_big_endian(ply.is_big_endian()), m_text(text) {}

  void append(double value)
  {
    if(m_is_ascii)
      internal::append_number(m_text, value);
    else
      append_bytes(value);
  }

  void append_count(std::size_t count, bool is_small)
  {
    if(m_is_ascii)
      internal::append_number(m_text, static_cast<long long>(count));
    else if(is_small)
      append_bytes(static_cast<std::uint8_t>(count));
    else
      append_bytes(static_cast<std::uint32_t>(count));
  }

  void append_space()
  {
    if(m_is_ascii)
      m_text += ' ';
  }

private:
  template <typename Number>
  void append_bytes(Number number)
  {
    char buffer[sizeof(Number)];
    std::memcpy(buffer, &number, sizeof(Number));
    if(m_is_big_endian == is_first_byte_lowest())
      std::reverse(buffer, buffer + sizeof(Number));
    m_text.append(buffer, sizeof(Number));
  }

  bool m_is_ascii, m_is_big_endian;
  std::string& m_text;
};

class PLY_document : public Polygon_document
{
public:
  explicit PLY_document(std::string text) : m_text(std::move(text)), m_ply(m_text) { m_ply.read_header(); }

  bool has_material() const override { return false; }

  // A list of the name texcoord for each face, as MeshLab reads and writes it, but in double precision, in which the map is certified.
  std::string with_images(const Corner_images& images, const std::string&) const override
  {
    const PLY_property* texcoord = nullptr;
    const PLY_element* faces = nullptr;
    for(const PLY_element& element : m_ply.elements())
      if(element.name == "face") {
        faces = &element;
        for(const PLY_property& property : element.properties)
          if(property.name == "texcoord")
            texcoord = &property;
      }
    if(faces == nullptr)
      return m_text;
    bool is_small = true; // whether a byte counts the numbers
    for(const auto& corners : images)
      is_small = is_small && corners.size() < 128;
    const std::string declaration = std::string("property list ") + (is_small ? "uchar" : "uint") + " double texcoord";
    std::string result;
    const std::size_t line = texcoord != nullptr ? texcoord->line_begin : faces->line_end;
    result.append(m_text, 0, line);
    result += declaration + std::string(m_ply.line_end());
    const std::size_t next = texcoord != nullptr ? m_text.find_first_of("\r\n", line) + m_ply.line_end().size() : line;
    result.append(m_text, next, m_ply.body() - next);

    PLY_writer writer(m_ply, result);
    std::size_t copied = 0;
    m_ply.for_each_property([&](const PLY_element& element, std::size_t i, const PLY_property& property, const std::vector<double>&,
                                std::size_t begin, std::size_t end) -> std::string {
      const bool is_added = texcoord == nullptr && &element == faces && &property == &element.properties.back();
      if(!is_added && &property != texcoord)
        return "";
      copy_body(copied, is_added ? end : begin, result);
      if(is_added)
        writer.append_space();
      writer.append_count(2 * images[i].size(), is_small);
      for(const Image& image : images[i])
        for(const double value : image) {
          writer.append_space();
          writer.append(value);
        }
      copied = end;
      return "";
    });
    copy_body(copied, m_text.size() - m_ply.body(), result);
    return result;
  }

  // Coordinates become double precision numbers, in which the map is certified.
  std::string with_points(const std::vector<std::array<double, 3>>& points) const override
  {
    std::string result;
    std::size_t copied_header = 0;
    const PLY_property* coordinates[3] = {};
    for(const PLY_element& element : m_ply.elements())
      for(const PLY_property& property : element.properties)
        if(element.name == "vertex" && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z') {
          coordinates[property.name[0] - 'x'] = &property;
          result.append(m_text, copied_header, property.line_begin - copied_header);
          result += "property double " + property.name;
          copied_header = m_text.find_first_of("\r\n", property.line_begin);
        }
    result.append(m_text, copied_header, m_ply.body() - copied_header);

    PLY_writer writer(m_ply, result);
    std::size_t copied = 0;
    m_ply.for_each_property([&](const PLY_element&, std::size_t i, const PLY_property& property, const std::vector<double>&,
                                std::size_t begin, std::size_t end) -> std::string {
      for(int c = 0; c < 3; ++c)
        if(&property == coordinates[c]) {
          copy_body(copied, begin, result);
          writer.append(points[i][c]);
          copied = end;
        }
      return "";
    });
    copy_body(copied, m_text.size() - m_ply.body(), result);
    return result;
  }

private:
  void copy_body(std::size_t begin, std::size_t end, std::string& result) const
  {
    result.append(m_text, m_ply.body() + begin, end - begin);
  }

  std::string m_text;
  PLY_text m_ply;
};

} // namespace

std::unique_ptr<Polygon_document> make_PLY_document(std::string text) { return std::make_unique<PLY_document>(std::move(text)); }

} // namespace program
