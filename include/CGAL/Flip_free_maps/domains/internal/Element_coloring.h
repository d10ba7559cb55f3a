// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_ELEMENT_COLORING_H
#define CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_ELEMENT_COLORING_H

#include <CGAL/Flip_free_maps/internal/for_each_index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Splits the elements into chunks of consecutive ones and colours the chunks so that two of one colour share no vertex. Chunks of
// one colour may scatter to the vertices in parallel without atomics; since neither chunks nor colours depend on the number of
// threads, every sum is formed in the same order whatever that number is.
class Element_coloring
{
public:
  struct Chunk
  {
    std::int64_t begin;
    std::int64_t end;
  };

  // Sums and minima are those of the first `counted` elements.
  template <std::size_t N>
  void build(const std::vector<std::array<std::int32_t, N>>& elements, std::int32_t number_of_vertices,
             std::int64_t counted = (std::numeric_limits<std::int64_t>::max)())
  {
    m_chunks.clear();
    m_colors.clear();
    const std::int64_t n = static_cast<std::int64_t>(elements.size());
    counted = counted < n ? counted : n;
    split(0, counted);
    m_counted_chunks = m_chunks.size();
    split(counted, n);

    // Colours beyond the width of the masks hold one chunk each; only meshes with a vertex in very many chunks need them.
    constexpr int WIDTH = 64;
    std::vector<std::uint64_t> masks(number_of_vertices, 0);
    m_colors.resize(WIDTH);
    for(std::size_t c = 0; c < m_chunks.size(); ++c) {
      std::uint64_t used = 0;
      for(std::int64_t e = m_chunks[c].begin; e < m_chunks[c].end; ++e)
        for(std::int32_t v : elements[e])
          used |= masks[v];
      int color = 0;
      while(color < WIDTH && ((used >> color) & 1u))
        ++color;
      if(color == WIDTH) {
        m_colors.push_back({c});
        continue;
      }
      m_colors[color].push_back(c);
      for(std::int64_t e = m_chunks[c].begin; e < m_chunks[c].end; ++e)
        for(std::int32_t v : elements[e])
          masks[v] |= std::uint64_t(1) << color;
    }
  }

  // Calls f(element) for all elements; f may write to the element's vertices.
  template <typename ConcurrencyTag, typename F>
  void scatter(F&& f) const
  {
    scatter_chunks<ConcurrencyTag>([&f](std::int64_t begin, std::int64_t end) {
      for(std::int64_t e = begin; e < end; ++e)
        f(e);
    });
  }

  // Calls f(begin, end) for chunks of consecutive elements; f may write to their vertices.
  template <typename ConcurrencyTag, typename F>
  void scatter_chunks(F&& f) const
  {
    for(const std::vector<std::size_t>& color : m_colors)
      for_each_index<ConcurrencyTag>(color.size(), [&](std::size_t i) {
        const Chunk& chunk = m_chunks[color[i]];
        f(chunk.begin, chunk.end);
      });
  }

  // Calls f(element) for all elements; f must not write to anything that elements share.
  template <typename ConcurrencyTag, typename F>
  void for_each(F&& f) const
  {
    for_each_index<ConcurrencyTag>(m_chunks.size(), [&](std::size_t c) {
      for(std::int64_t e = m_chunks[c].begin; e < m_chunks[c].end; ++e)
        f(e);
    });
  }

  // What f(element, sums) adds up in `sums`, which begin as Sums() in each chunk and are joined by +=, always in the same order.
  template <typename ConcurrencyTag, typename Sums, typename F>
  Sums accumulate(F&& f) const
  {
    std::vector<Sums> partial(m_counted_chunks);
    for_each_index<ConcurrencyTag>(m_counted_chunks, [&](std::size_t c) {
      Sums sums;
      for(std::int64_t e = m_chunks[c].begin; e < m_chunks[c].end; ++e)
        f(e, sums);
      partial[c] = sums;
    });
    Sums total;
    for(const Sums& sums : partial)
      total += sums;
    return total;
  }

  // The sum of f(element), always added in the same order.
  template <typename ConcurrencyTag, typename F>
  double sum(F&& f) const
  {
    return sum_of_chunks<ConcurrencyTag>([&f](std::int64_t begin, std::int64_t end) {
      double s = 0;
      for(std::int64_t e = begin; e < end; ++e)
        s += f(e);
      return s;
    });
  }

  // The sum of f(begin, end) over chunks of consecutive elements, always added in the same order.
  template <typename ConcurrencyTag, typename F>
  double sum_of_chunks(F&& f) const
  {
    std::vector<double> partial(m_counted_chunks);
    for_each_index<ConcurrencyTag>(m_counted_chunks, [&](std::size_t c) { partial[c] = f(m_chunks[c].begin, m_chunks[c].end); });
    double s = 0;
    for(double p : partial)
      s += p;
    return s;
  }

  // The smallest f(element); +infinity without elements.
  template <typename ConcurrencyTag, typename F>
  double minimum(F&& f) const
  {
    std::vector<double> partial(m_counted_chunks);
    for_each_index<ConcurrencyTag>(m_counted_chunks, [&](std::size_t c) {
      double m = std::numeric_limits<double>::infinity();
      for(std::int64_t e = m_chunks[c].begin; e < m_chunks[c].end; ++e) {
        const double value = f(e);
        m = value < m ? value : m;
      }
      partial[c] = m;
    });
    double m = std::numeric_limits<double>::infinity();
    for(double p : partial)
      m = p < m ? p : m;
    return m;
  }

  // The elements of which f(element) is true, in ascending order.
  template <typename ConcurrencyTag, typename F>
  std::vector<std::int64_t> collect(F&& f) const
  {
    std::vector<std::vector<std::int64_t>> partial(m_chunks.size());
    for_each_index<ConcurrencyTag>(m_chunks.size(), [&](std::size_t c) {
      for(std::int64_t e = m_chunks[c].begin; e < m_chunks[c].end; ++e)
        if(f(e))
          partial[c].push_back(e);
    });
    std::vector<std::int64_t> elements;
    for(const std::vector<std::int64_t>& p : partial)
      elements.insert(elements.end(), p.begin(), p.end());
    return elements;
  }

private:
  static constexpr std::int64_t CHUNK_SIZE = 512;

  void split(std::int64_t begin, std::int64_t end)
  {
    for(; begin < end; begin += CHUNK_SIZE)
      m_chunks.push_back({begin, begin + CHUNK_SIZE < end ? begin + CHUNK_SIZE : end});
  }

  std::vector<Chunk> m_chunks;
  std::size_t m_counted_chunks = 0;
  std::vector<std::vector<std::size_t>> m_colors;
};

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_DOMAINS_INTERNAL_ELEMENT_COLORING_H
