// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#include "Gltf_container.h"

#include "../Binary_reader.h"
#include "../Polygon_file.h"

#include <CGAL/Flip_free_maps/IO/internal/file_helpers.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

namespace program {

namespace fs = std::filesystem;

namespace {

const std::uint32_t magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

// Of one object, and of one path from the top. Real documents are far from these, and without them small files take minutes.
const std::size_t most_keys = 10000, deepest_nesting = 200;

std::string little_endian(std::size_t value)
{
  std::string bytes;
  for(int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

void pad(std::string& bytes, char filling) { bytes.append((4 - bytes.size() % 4) % 4, filling); }

// Before the text is parsed.
void check_shape(std::string_view text)
{
  std::vector<std::size_t> keys;
  bool is_string = false;
  for(std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if(is_string && c == '\\')
      ++i;
    else if(c == '"')
      is_string = !is_string;
    else if(is_string)
      continue;
    else if(c == '{' || c == '[') {
      keys.push_back(0);
      if(keys.size() > deepest_nesting)
        throw Failure{Status::file_error, "its JSON is nested deeper than " + std::to_string(deepest_nesting) + " levels"};
    } else if((c == '}' || c == ']') && !keys.empty())
      keys.pop_back();
    else if(c == ':' && !keys.empty() && ++keys.back() > most_keys)
      throw Failure{Status::file_error, "an object of its JSON has more than " + std::to_string(most_keys) + " keys"};
  }
}

int base64_digit(char c)
{
  return c >= 'A' && c <= 'Z'   ? c - 'A'
         : c >= 'a' && c <= 'z' ? c - 'a' + 26
         : c >= '0' && c <= '9' ? c - '0' + 52
         : c == '+'             ? 62
         : c == '/'             ? 63
                                : -1;
}

std::string decoded_base64(std::string_view text, const std::string& who)
{
  while(!text.empty() && text.back() == '=')
    text.remove_suffix(1);
  std::string bytes;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for(const char c : text) {
    const int digit = base64_digit(c);
    check(digit >= 0, who + " is not in base64");
    bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xffff;
    number_of_bits += 6;
    if(number_of_bits >= 8) {
      number_of_bits -= 8;
      bytes += static_cast<char>(bits >> number_of_bits & 255);
    }
  }
  return bytes;
}

bool is_data(const std::string& uri) { return uri.compare(0, 5, "data:") == 0; }

// Names of other files are relative; others are links to somewhere.
bool is_relative(const std::string& uri)
{
  return !uri.empty() && uri[0] != '/' && uri.substr(0, uri.find_first_of("/?#")).find(':') == std::string::npos;
}

fs::path decoded_path(const std::string& uri)
{
  std::string path;
  for(std::size_t i = 0; i < uri.size(); ++i)
    if(uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
       std::isxdigit(static_cast<unsigned char>(uri[i + 2]))) {
      path += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else
      path += uri[i];
  return fs::path(path);
}

std::string encoded_path(const fs::path& path)
{
  const char* digits = "0123456789ABCDEF";
  std::string uri;
  for(const char c : path.generic_string())
    if(std::isalnum(static_cast<unsigned char>(c)) || std::string("-._~/!$&'()*+,;=@").find(c) != std::string::npos)
      uri += c;
    else {
      uri += '%';
      uri += digits[static_cast<unsigned char>(c) >> 4];
      uri += digits[static_cast<unsigned char>(c) & 15];
    }
  return uri;
}

// Bytes of a buffer.
struct Range
{
  std::size_t begin, end;
};

// What the first views of a list have of a buffer, with what fills up to multiples of `alignment`: disjoint, and in order.
std::vector<Range> ranges(const Json& views, std::size_t number, std::size_t buffer, std::size_t alignment)
{
  std::vector<Range> all, result;
  for(std::size_t i = 0; i < number; ++i)
    if(count_of(views[i], "buffer", "a buffer view") == buffer) {
      const std::size_t begin = count_of(views[i], "byteOffset", "a buffer view", 0);
      const std::size_t end = begin + count_of(views[i], "byteLength", "a buffer view");
      all.push_back({begin, (end + alignment - 1) / alignment * alignment});
    }
  std::sort(all.begin(), all.end(), [](const Range& a, const Range& b) { return a.begin < b.begin; });
  for(const Range& range : all)
    if(!result.empty() && range.begin <= result.back().end)
      result.back().end = (std::max)(result.back().end, range.end);
    else
      result.push_back(range);
  return result;
}

std::vector<Range> without(const std::vector<Range>& ranges, const std::vector<Range>& others)
{
  std::vector<Range> result;
  auto other = others.begin();
  for(Range range : ranges) {
    for(; other != others.end() && other->end <= range.begin; ++other)
      ;
    for(auto i = other; i != others.end() && i->begin < range.end; ++i) {
      if(range.begin < i->begin)
        result.push_back({range.begin, i->begin});
      range.begin = (std::max)(range.begin, i->end);
    }
    if(range.begin < range.end)
      result.push_back(range);
  }
  return result;
}

std::string data_uri(std::string_view bytes) { return "data:application/octet-stream;base64," + base64(bytes); }

std::string text_of(const Json& object, const char* key)
{
  const Json* value = member(object, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : "";
}

} // namespace

const Json* member(const Json& object, const char* key)
{
  if(!object.is_object())
    return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::size_t count_of(const Json& object, const char* key, const std::string& what)
{
  const Json* value = member(object, key);
  check(value != nullptr, what + " has no " + key);
  const double number = value->is_number() ? value->get<double>() : -1;
  check(number >= 0 && number == std::floor(number) && number < 9e15, what + ": " + key + " is no natural number");
  return static_cast<std::size_t>(number);
}

std::size_t count_of(const Json& object, const char* key, const std::string& what, std::size_t if_missing)
{
  return member(object, key) == nullptr ? if_missing : count_of(object, key, what);
}

const Json& list(const Json& object, const char* key)
{
  static const Json none = Json::array();
  const Json* value = member(object, key);
  check(value == nullptr || value->is_array(), std::string("its ") + key + " are no array");
  return value == nullptr ? none : *value;
}

const Json& element(const Json& document, const char* key, std::size_t i, const std::string& what)
{
  const Json& all = list(document, key);
  check(i < all.size(),
        what + " names number " + std::to_string(i) + " (from 0) of the " + key + ", of which there are " + std::to_string(all.size()));
  check(all[i].is_object(), "number " + std::to_string(i) + " (from 0) of the " + key + " is no object");
  return all[i];
}

std::string base64(std::string_view bytes)
{
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for(std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

Gltf_container::Gltf_container(const std::string& path, const std::string& text)
  : m_path(path), m_size(text.size()), m_is_binary(text.size() >= 4 && Binary_reader(text, false).read<std::uint32_t>() == magic)
{
  if(m_is_binary)
    read_chunks(text);
  else
    parse(text);
  check_version();
  m_buffers.resize(list(json, "buffers").size());
  if(m_has_chunk && !m_buffers.empty() && is_chunk(0))
    m_buffers[0] = std::move(m_chunk);
  m_first_added_view = list(json, "bufferViews").size();
}

void Gltf_container::read_chunks(std::string_view text)
{
  Binary_reader head(text.substr(4), false);
  const std::uint32_t version = head.read<std::uint32_t>(), length = head.read<std::uint32_t>();
  check(!head.has_failed() && length <= text.size(),
        "it claims " + std::to_string(length) + " bytes, but ends after " + std::to_string(text.size()));
  check(version == 2, "it has version " + std::to_string(version) + " of binary glTF, and only version 2 is read");
  text = text.substr(0, length);
  bool is_first = true;
  for(std::size_t begin = 12; begin + 8 <= text.size();) {
    Binary_reader chunk(text.substr(begin), false);
    const std::uint32_t size = chunk.read<std::uint32_t>(), type = chunk.read<std::uint32_t>();
    check(size <= chunk.left(),
          "a chunk claims " + std::to_string(size) + " bytes, but the file ends after " + std::to_string(chunk.left()));
    check(is_first == (type == json_chunk), is_first ? "its first chunk is not JSON" : "it has several chunks of JSON");
    if(is_first)
      parse(text.substr(begin + 8, size));
    else if(type == binary_chunk && !m_has_chunk) {
      m_has_chunk = true;
      m_chunk = text.substr(begin + 8, size);
    } else
      m_further_chunks += text.substr(begin, 8 + std::size_t(size));
    is_first = false;
    begin += 8 + std::size_t(size);
  }
  check(!is_first, "it has no chunk of JSON");
}

void Gltf_container::parse(std::string_view text)
{
  check_shape(text);
  try {
    json = Json::parse(text);
  } catch(const Json::exception& exception) {
    // The name of the exception comes first.
    const std::string what = exception.what();
    throw Failure{Status::file_error, what.substr(what.find("] ") == std::string::npos ? 0 : what.find("] ") + 2)};
  }
  check(json.is_object(), "its JSON is no object");
}

void Gltf_container::check_version() const
{
  const Json* asset = member(json, "asset");
  check(asset != nullptr && asset->is_object(), "it has no asset, hence it is not a glTF file");
  const std::string version = text_of(*asset, "version"), least = text_of(*asset, "minVersion");
  check(version.compare(0, 2, "2.") == 0 && (least.empty() || least == "2.0"),
        "it has version '" + (least.empty() ? version : least) + "' of glTF, and only 2.0 is read");
}

std::string_view Gltf_container::buffer(std::size_t i)
{
  const std::string who = "buffer number " + std::to_string(i) + " (from 0)";
  const Json& buffer = element(json, "buffers", i, "a buffer view");
  const std::size_t length = count_of(buffer, "byteLength", who);
  const std::string uri = text_of(buffer, "uri");
  if(!m_buffers[i]) {
    check(!uri.empty(), who + " has no data");
    if(is_data(uri)) {
      const std::size_t comma = uri.find(";base64,");
      check(comma != std::string::npos, who + " is not in base64");
      m_buffers[i] = decoded_base64(std::string_view(uri).substr(comma + 8), who);
    } else {
      check(is_relative(uri), who + " is in no file beside this one: " + FFM::internal::quoted_word(uri));
      const std::string path = (fs::path(m_path).parent_path() / decoded_path(uri)).string();
      std::error_code error;
      check(fs::is_regular_file(path, error), "its " + who + " is the file " + path + ", which does not exist");
      std::string content, message;
      check(FFM::internal::read_whole_file(path, content, &message), message);
      m_size += content.size();
      m_buffers[i] = std::move(content);
    }
  }
  check(length <= m_buffers[i]->size(),
        who + " claims " + std::to_string(length) + " bytes, but has " + std::to_string(m_buffers[i]->size()));
  return std::string_view(*m_buffers[i]).substr(0, length);
}

std::size_t Gltf_container::add_view(std::string_view bytes, std::size_t stride, std::size_t target)
{
  pad(m_added, '\0');
  check((m_added.size() + bytes.size()) / 64 <= m_size + 65536,
        "its vertices share so many data that the result would be 64 times as long");
  Json view = {{"buffer", 0}, {"byteOffset", m_added.size()}, {"byteLength", bytes.size()}};
  if(stride != 0)
    view["byteStride"] = stride;
  if(target != 0)
    view["target"] = target;
  m_added += bytes;
  json["bufferViews"].push_back(view);
  return json["bufferViews"].size() - 1;
}

bool Gltf_container::is_chunk(std::size_t buffer) const
{
  return buffer == 0 && m_has_chunk && text_of(element(json, "buffers", buffer, "a buffer view"), "uri").empty();
}

// Whether a buffer is a part of the file that `path` is to hold.
bool Gltf_container::is_within(std::size_t buffer, const std::string& path) const
{
  return is_chunk(buffer) || is_data(text_of(json["buffers"][buffer], "uri")) || (buffer == 0 && small_extension(path) == ".glb");
}

void Gltf_container::remove_views(const std::vector<char>& is_removed, const std::string& path)
{
  Json left = Json::array(), removed = Json::array();
  for(std::size_t i = 0; i < is_removed.size(); ++i)
    (is_removed[i] ? removed : left).push_back(std::move(json["bufferViews"][i]));
  if(removed.empty() && left.empty())
    return;
  m_first_added_view -= removed.size();
  json["bufferViews"] = std::move(left);
  for(std::size_t i = 0; i < m_buffers.size(); ++i)
    if(is_within(i, path))
      cut(i, removed);
}

// Removes what views of a buffer have that were removed, and none of those that are left has.
void Gltf_container::cut(std::size_t buffer, const Json& removed_views)
{
  const std::vector<Range> removed = ranges(removed_views, removed_views.size(), buffer, 4);
  const std::vector<Range> left = ranges(json["bufferViews"], m_first_added_view, buffer, 1);
  if(removed.empty())
    return;
  std::string content(this->buffer(buffer)), result;
  std::vector<Range> cuts;
  for(const Range& range : without(removed, left)) {
    // Nothing loses its alignment.
    const Range aligned{(range.begin + 3) / 4 * 4, (std::min)(range.end, content.size()) / 4 * 4};
    if(aligned.begin < aligned.end)
      cuts.push_back(aligned);
  }
  std::vector<std::size_t> cut_before(1, 0);
  std::size_t copied = 0;
  for(const Range& range : cuts) {
    result.append(content, copied, range.begin - copied);
    copied = range.end;
    cut_before.push_back(cut_before.back() + range.end - range.begin);
  }
  result.append(content, copied, std::string::npos);
  if(cuts.empty() || result.empty())
    return;
  for(std::size_t i = 0; i < m_first_added_view; ++i) {
    Json& view = json["bufferViews"][i];
    if(count_of(view, "buffer", "a buffer view") != buffer)
      continue;
    const std::size_t offset = count_of(view, "byteOffset", "a buffer view", 0);
    const auto after = std::partition_point(cuts.begin(), cuts.end(), [&](const Range& range) { return range.end <= offset; });
    if(offset > 0)
      view["byteOffset"] = offset - cut_before[static_cast<std::size_t>(after - cuts.begin())];
  }
  json["buffers"][buffer]["byteLength"] = result.size();
  if(!is_chunk(buffer))
    json["buffers"][buffer]["uri"] = data_uri(result);
  m_buffers[buffer] = std::move(result);
}

// Adds the data that were added to the end of a buffer.
void Gltf_container::add_to_buffer(std::size_t buffer)
{
  std::string content(this->buffer(buffer));
  if(!m_added.empty())
    pad(content, '\0');
  for(std::size_t i = m_first_added_view; i < list(json, "bufferViews").size(); ++i) {
    Json& view = json["bufferViews"][i];
    view["buffer"] = buffer;
    view["byteOffset"] = content.size() + view["byteOffset"].get<std::size_t>();
  }
  content += m_added;
  json["buffers"][buffer]["byteLength"] = content.size();
  m_buffers[buffer] = std::move(content);
}

void Gltf_container::add_buffer()
{
  json["buffers"].push_back(Json::object({{"byteLength", 0}}));
  m_buffers.push_back("");
}

// The first buffer becomes the binary chunk, wherever it was, so that no number of a buffer changes.
void Gltf_container::make_binary_buffer()
{
  m_has_chunk = !m_buffers.empty() || !m_added.empty();
  if(!m_has_chunk)
    return;
  if(m_buffers.empty())
    add_buffer();
  add_to_buffer(0);
  json["buffers"][0].erase("uri");
}

void Gltf_container::make_data_buffers()
{
  if(!m_buffers.empty() && is_chunk(0))
    json["buffers"][0]["uri"] = data_uri(buffer(0));
  if(m_added.empty())
    return;
  if(m_buffers.empty() || !is_data(text_of(json["buffers"].back(), "uri")))
    add_buffer();
  add_to_buffer(m_buffers.size() - 1);
  json["buffers"].back()["uri"] = data_uri(*m_buffers.back());
}

void Gltf_container::move_references(const std::string& path)
{
  std::error_code error;
  const fs::path from = fs::weakly_canonical(fs::absolute(m_path, error).parent_path(), error);
  const fs::path to = fs::weakly_canonical(fs::absolute(path, error).parent_path(), error);
  if(from == to)
    return;
  for(const char* key : {"buffers", "images"})
    if(json.contains(key))
      for(Json& object : json[key]) {
        const std::string uri = text_of(object, "uri");
        if(!uri.empty() && !is_data(uri) && is_relative(uri))
          object["uri"] = encoded_path((from / decoded_path(uri)).lexically_normal().lexically_relative(to));
      }
}

std::string Gltf_container::written(const std::string& path)
{
  const auto dump = [&](int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); };
  const bool is_binary = small_extension(path) == ".glb";
  is_binary ? make_binary_buffer() : make_data_buffers();
  move_references(path);
  if(!is_binary)
    return dump(2) + '\n';
  std::string body = dump(-1);
  pad(body, ' ');
  body = little_endian(body.size()) + little_endian(json_chunk) + body;
  if(m_has_chunk) {
    std::string content = *m_buffers[0];
    pad(content, '\0');
    body += little_endian(content.size()) + little_endian(binary_chunk) + content;
  }
  body += m_further_chunks;
  check(body.size() + 12 <= std::numeric_limits<std::uint32_t>::max(), "binary glTF holds no more than 4 GB");
  return little_endian(magic) + little_endian(2) + little_endian(body.size() + 12) + body;
}

} // namespace program
