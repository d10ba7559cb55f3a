// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_BIT_ROW_H
#define CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_BIT_ROW_H

#include <bitset>
#include <cstdint>

namespace CGAL {
namespace Flip_free_maps {
namespace internal {

// Rows of bits, in words.
using Bit_word = std::uint64_t;
constexpr int BITS_PER_WORD = 64;

// The number of the lowest bit that is set; some is.
inline int lowest_bit(Bit_word word)
{
#ifdef __GNUC__
  return __builtin_ctzll(word);
#else
  return static_cast<int>(std::bitset<BITS_PER_WORD>((word & (~word + 1)) - 1).count());
#endif
}

// The number of the highest bit that is set; some is.
inline int highest_bit(int number)
{
  int bit = 0;
  while(number >>= 1)
    ++bit;
  return bit;
}

// The word that begins at a bit of another one.
inline Bit_word bits_from(const Bit_word* word, int bit)
{
  // Shifted in two steps, since words cannot be shifted by their length.
  return (word[0] >> bit) | (word[1] << 1 << (BITS_PER_WORD - 1 - bit));
}

// The bits of word number w between the first and the last one of a row.
inline Bit_word bits_within(int w, int first, int last)
{
  const Bit_word from = w == first / BITS_PER_WORD ? ~Bit_word(0) << (first % BITS_PER_WORD) : ~Bit_word(0);
  return w == last / BITS_PER_WORD ? from & (~Bit_word(0) >> (BITS_PER_WORD - 1 - last % BITS_PER_WORD)) : from;
}

// Sets the bits of a row from the first to the last one.
inline void set_bits(Bit_word* row, int first, int last)
{
  for(int w = first / BITS_PER_WORD; w <= last / BITS_PER_WORD; ++w)
    row[w] |= bits_within(w, first, last);
}

// Calls f(first, end) for each run of bits that are set.
template <typename Function>
void for_each_run(const Bit_word* row, int number_of_words, Function&& f)
{
  int first = -1; // of a run that is not at its end
  for(int w = 0; w < number_of_words; ++w) {
    const int begin = BITS_PER_WORD * w;
    if(row[w] == (first < 0 ? Bit_word(0) : ~Bit_word(0)))
      continue;
    int bit = 0;
    for(Bit_word rest = row[w]; bit < BITS_PER_WORD;) {
      const Bit_word next = first < 0 ? rest : ~rest;
      if(next == 0)
        break;
      const int skip = lowest_bit(next);
      bit += skip;
      if(bit >= BITS_PER_WORD)
        break;
      rest >>= skip;
      if(first < 0)
        first = begin + bit;
      else {
        f(first, begin + bit);
        first = -1;
      }
    }
  }
  if(first >= 0)
    f(first, BITS_PER_WORD * number_of_words);
}

// Exchanges rows and columns of a square of bits, whose sides are a word.
inline void transpose_bits(Bit_word* square)
{
  Bit_word mask = ~Bit_word(0) >> (BITS_PER_WORD / 2);
  for(int half = BITS_PER_WORD / 2; half > 0; half /= 2, mask ^= mask << half)
    for(int y = 0; y < BITS_PER_WORD; y = (y + half + 1) & ~half) {
      const Bit_word change = ((square[y] >> half) ^ square[y + half]) & mask;
      square[y] ^= change << half;
      square[y + half] ^= change;
    }
}

} // namespace internal
} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_ATLAS_INTERNAL_BIT_ROW_H
