// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

// The outer form of glTF 2.0: a JSON document and its buffers, in one binary file or in several.
//
// The document is edited, and data are added to a buffer. tinygltf and its like build a model and serialise it anew: what they do not
// know, as properties, chunks and the order of keys, is lost, which must not happen here.

#ifndef FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_CONTAINER_H
#define FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_CONTAINER_H

#include "../../Failure.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace program {

using Json = nlohmann::ordered_json; // keys keep their order

// The value of a key, or null. Nothing that is not an object has keys.
const Json* member(const Json& object, const char* key);

// A number that counts or names something; `what` is for the message. The first form demands it.
std::size_t count_of(const Json& object, const char* key, const std::string& what);
std::size_t count_of(const Json& object, const char* key, const std::string& what, std::size_t if_missing);

// The array under a key of a document; an empty one if there is none.
const Json& list(const Json& object, const char* key);

// Element `i` of such an array of the document.
const Json& element(const Json& document, const char* key, std::size_t i, const std::string& what);

std::string base64(std::string_view bytes);

// All functions throw a Failure that says what is wrong with the file.
class Gltf_container
{
public:
  // `path` tells where other files are.
  Gltf_container(const std::string& path, const std::string& text);

  // The content of a buffer, as long as the document says. Other files are read when they are asked for.
  std::string_view buffer(std::size_t i);

  // How many bytes were read. Documents may name the same bytes again and again, but what they ask for must be in proportion.
  std::size_t size() const { return m_size; }

  // Adds data, and returns the number of a new buffer view of it. A stride of 0 is none.
  std::size_t add_view(std::string_view bytes, std::size_t stride = 0, std::size_t target = 0);

  // Removes buffer views, and the bytes that none of the others has if their buffer will be in the file `path`.
  void remove_views(const std::vector<char>& is_removed, const std::string& path);

  // The file that `path` is to hold: binary if it ends with .glb, otherwise text. Other files that the document names stay where they
  // are, and added data are part of the text.
  std::string written(const std::string& path);

  Json json;

private:
  void read_chunks(std::string_view text);
  void parse(std::string_view text);
  void check_version() const;
  bool is_chunk(std::size_t buffer) const;
  bool is_within(std::size_t buffer, const std::string& path) const;
  void cut(std::size_t buffer, const Json& removed_views);
  void add_buffer();
  void add_to_buffer(std::size_t buffer);
  void make_binary_buffer();
  void make_data_buffers();
  void move_references(const std::string& path);

  std::string m_path;
  std::size_t m_size;
  bool m_is_binary, m_has_chunk = false;
  std::string m_chunk;                               // the binary one, until it is a buffer
  std::string m_further_chunks;                      // with their heads
  std::vector<std::optional<std::string>> m_buffers; // the first one may be the binary chunk
  std::string m_added;
  std::size_t m_first_added_view; // the others follow
};

} // namespace program

#endif // FLIP_FREE_MAPS_PROGRAM_FORMATS_GLTF_CONTAINER_H
