// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DRAW_WORD_H
#define FLATTEN_MESH_DRAW_WORD_H

#include "flatten_mesh/pictures/Canvas.h"

#include <cstddef>
#include <map>
#include <string>

namespace flatten_mesh {

namespace internal {

// Letters as lines between places on a grid, 4 wide and 6 high, from below: pairs of digits. A blank ends a line.
// Those of the names of the six sides.
inline const std::map<char, std::string>& letters()
{
  static const std::map<char, std::string> all = {
      {'A', "002640 1232"},         {'B', "0006364544330333424130 0030"},
      {'C', "4536160501103041"},    {'E', "46060040 0333"},
      {'F', "000646 0333"},         {'G', "453616050110304143 4323"},
      {'H', "0006 4046 0343"},      {'I', "2026"},
      {'K', "0006 460340"},         {'L', "060040"},
      {'M', "0006234640"},          {'N', "00064046"},
      {'O', "103041453616050110"},  {'P', "00063645443303"},
      {'R', "00063645443303 2340"}, {'T', "0646 2026"}};
  return all;
}

} // namespace internal

// Writes a word of the letters there are in front of all else, with its upper left corner at this place of the canvas.
inline void draw_word(Canvas& canvas, const std::string& word, const double left, const double top,
                      const double height, const Color& color)
{
  const double unit = height / 6, width = height / 7, in_front = 1e300;
  double start = left;
  for(const char letter : word) {
    const std::string& lines = internal::letters().at(letter);
    const auto place = [&](const std::size_t i) {
      return Canvas::Corner{
          start + unit * (lines[i] - '0'), top + height - unit * (lines[i + 1] - '0'), in_front, {}};
    };
    for(std::size_t i = 0; i + 3 < lines.size(); i += lines[i + 2] == ' ' ? 3 : 2) {
      if(lines[i + 2] != ' ') {
        canvas.draw_line(place(i), place(i + 2), width, color);
      }
    }
    start += 6 * unit;
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DRAW_WORD_H
