// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Polygon_document.h"

#include <CGAL/Flip_free_maps/IO/OBJ.h>
#include <CGAL/Flip_free_maps/measure/internal/is_bijective_on_arrays.h>

#include <cstdint>
#include <string_view>
#include <utility>

namespace program {

namespace {

namespace internal = CGAL::Flip_free_maps::internal;
using Words = std::vector<std::string_view>;

// Texture coordinates, numbered so that corners with the same vertex and the same image share them.
struct Numbered_images
{
  std::string lines; // vt
  std::vector<std::vector<std::int32_t>> numbers;
};

// The point of a corner.
std::string_view point_word(std::string_view corner) { return corner.substr(0, corner.find('/')); }

// What follows the texture index of a corner, its slash included.
std::string_view normal_part(std::string_view corner)
{
  const std::size_t first = corner.find('/');
  const std::size_t second = first == std::string_view::npos ? first : corner.find('/', first + 1);
  return second == std::string_view::npos ? "" : corner.substr(second);
}

class OBJ_document : public Polygon_document
{
public:
  explicit OBJ_document(std::string text) : m_text(std::move(text))
  {
    const std::size_t end = m_text.find_first_of("\r\n");
    if(end != std::string::npos)
      m_line_end = m_text.compare(end, 2, "\r\n") == 0 ? "\r\n" : m_text.substr(end, 1);
  }

  bool has_material() const override
  {
    internal::OBJ_tokenizer tokenizer(m_text);
    for(Words words; tokenizer.next_line(words);)
      if(!words.empty() && (words[0] == "usemtl" || words[0] == "mtllib"))
        return true;
    return false;
  }

  std::string with_images(const Corner_images& images, const std::string& material_file) const override
  {
    const Numbered_images numbered = number(images);
    std::string head = numbered.lines;
    if(!material_file.empty())
      head = "mtllib " + material_file + m_line_end + head + "usemtl checkerboard" + m_line_end;
    std::size_t face = 0;
    return rewritten([&](const Words& words, std::string_view line, std::string& result) {
      if(words[0] == "vt")
        return;
      if(words[0] == "f") {
        if(face == 0)
          result += head;
        append_face(words, line, numbered.numbers[face++], result);
      } else if(words[0] == "l" || words[0] == "surf") // their texture coordinates are gone
        append_face(words, line, {}, result);
      else if(!material_file.empty() && (words[0] == "usemtl" || (words[0] == "mtllib" && words.size() == 2 && words[1] == material_file)))
        return; // the head has one of each
      else
        result += line;
    });
  }

  std::string with_points(const std::vector<std::array<double, 3>>& points) const override
  {
    std::size_t i = 0;
    return rewritten([&](const Words& words, std::string_view line, std::string& result) {
      const char* copied = line.data();
      if(words[0] == "v") {
        for(int k = 0; k < 3; ++k) {
          result.append(copied, words[k + 1].data());
          internal::append_number(result, points[i][k]);
          copied = words[k + 1].data() + words[k + 1].size();
        }
        ++i;
      }
      result.append(copied, line.data() + line.size());
    });
  }

private:
  // The text with what `append_line` makes of each logical line that has words.
  template <typename AppendLine>
  std::string rewritten(AppendLine&& append_line) const
  {
    std::string result;
    result.reserve(m_text.size() + m_text.size() / 2);
    internal::OBJ_tokenizer tokenizer(m_text);
    result.append(m_text, 0, tokenizer.position());
    std::size_t begin = tokenizer.position();
    for(Words words; tokenizer.next_line(words); begin = tokenizer.position()) {
      const std::string_view line = std::string_view(m_text).substr(begin, tokenizer.position() - begin);
      if(words.empty())
        result += line;
      else
        append_line(words, line, result);
    }
    return result;
  }

  Numbered_images number(const Corner_images& images) const
  {
    Numbered_images result;
    internal::OBJ_reader reader(internal::OBJ_reader::Demand::points_only);
    reader.read(m_text);
    internal::Corner_numbers<std::size_t> numbers;
    std::int32_t size = 0;
    for(std::size_t i = 0; i < images.size(); ++i) {
      result.numbers.emplace_back();
      for(std::size_t k = 0; k < images[i].size(); ++k) {
        const Image& image = images[i][k];
        const std::int32_t t = numbers(reader.polygons[i][k], image[0], image[1]);
        result.numbers.back().push_back(t);
        if(t < size)
          continue;
        ++size;
        result.lines += "vt ";
        internal::append_number(result.lines, image[0]);
        result.lines += ' ';
        internal::append_number(result.lines, image[1]);
        result.lines += m_line_end;
      }
    }
    return result;
  }

  // The line with these texture coordinates at its corners, or without any.
  static void append_face(const Words& words, std::string_view line, const std::vector<std::int32_t>& numbers, std::string& result)
  {
    const char* copied = line.data();
    for(std::size_t k = 1; k < words.size(); ++k) {
      result.append(copied, words[k].data());
      result += point_word(words[k]);
      if(!numbers.empty()) {
        result += '/';
        internal::append_number(result, numbers[k - 1] + 1LL);
      } else if(normal_part(words[k]).size() > 1)
        result += '/';
      if(!numbers.empty() || normal_part(words[k]).size() > 1)
        result += normal_part(words[k]);
      copied = words[k].data() + words[k].size();
    }
    result.append(copied, line.data() + line.size());
  }

  std::string m_text, m_line_end = "\n";
};

} // namespace

std::unique_ptr<Polygon_document> make_OBJ_document(std::string text) { return std::make_unique<OBJ_document>(std::move(text)); }

} // namespace program
