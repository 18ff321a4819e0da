// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The reader of CGAL's selection files: pairs of vertices, checked one by one, so that a report can name line and
// number. `seam_selection.h` marks the edges between them as seams.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_READ_VERTEX_PAIRS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_READ_VERTEX_PAIRS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Seam_report.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <istream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline Seam_selection_report failure(Diagnosis diagnosis, const std::string& message, std::size_t line = 0,
                                     std::size_t element = 0)
{
  Seam_selection_report report;
  report.status = diagnosis;
  report.line = line;
  report.element = element;
  if(line != 0)
    report.message += "line " + std::to_string(line) + ": ";
  if(element != 0)
    report.message += "number " + std::to_string(element) + ": ";
  report.message += message;
  return report;
}

// A number of a selection file, and where it is
struct Selection_number
{
  std::size_t value, line, element;
};

inline Seam_selection_report read_number(const std::string& word, std::size_t number_of_vertices,
                                         Selection_number& number)
{
  const bool negative = word.size() > 1 && word[0] == '-';
  const char *const begin = word.data() + negative, *const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(begin, end, number.value);
  if(result.ptr != end || result.ec == std::errc::invalid_argument)
    return failure(Diagnosis::NOT_A_NUMBER, "\"" + word + "\" is not a vertex number", number.line,
                   number.element);
  if(negative || result.ec == std::errc::result_out_of_range || number.value >= number_of_vertices)
    return failure(Diagnosis::NUMBER_OUT_OF_RANGE,
                   "there is no vertex " + word + ": the mesh has " + std::to_string(number_of_vertices) +
                       " vertices, numbered from 0",
                   number.line, number.element);
  return {};
}

// Reads the edges of a selection file: everything from the third line on, as `Seam_mesh::add_seams()` does.
inline Seam_selection_report read_numbers(std::istream& in, std::size_t number_of_vertices,
                                          std::vector<Selection_number>& numbers)
{
  std::string text;
  std::size_t line = 0;
  while(std::getline(in, text)) {
    if(++line < 3)
      continue;
    std::istringstream words(text);
    std::size_t element = 0;
    for(std::string word; words >> word;) {
      numbers.push_back({0, line, ++element});
      if(const auto report = read_number(word, number_of_vertices, numbers.back()); !report)
        return report;
    }
  }
  if(in.bad())
    return failure(Diagnosis::CANNOT_READ, "reading failed", line);
  if(line < 3)
    return failure(Diagnosis::TOO_FEW_LINES,
                   "there are only " + std::to_string(line) +
                       " lines, but edges are in the third line (after vertices and faces)");
  if(numbers.size() % 2 != 0)
    return failure(Diagnosis::ODD_COUNT,
                   "vertex " + std::to_string(numbers.back().value) +
                       " has no partner: an edge is a pair of numbers",
                   numbers.back().line, numbers.back().element);
  return {};
}

// Pairs of vertices that can be searched for
class Vertex_pairs
{
  struct Pair
  {
    std::pair<std::size_t, std::size_t> ends;
    std::size_t rank;
    bool found;
  };

public:
  explicit Vertex_pairs(const std::vector<Selection_number>& numbers)
  {
    for(std::size_t i = 0; i + 1 < numbers.size(); i += 2)
      m_pairs.push_back({std::minmax({numbers[i].value, numbers[i + 1].value}), i, false});
    std::stable_sort(m_pairs.begin(), m_pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.ends < b.ends; });
  }

  // Returns how often there is this pair.
  std::size_t find(std::size_t v, std::size_t w)
  {
    const std::pair<std::size_t, std::size_t> ends = std::minmax({v, w});
    const auto first = std::lower_bound(m_pairs.begin(), m_pairs.end(), ends,
                                        [](const Pair& pair, const auto& e) { return pair.ends < e; });
    auto last = first;
    for(; last != m_pairs.end() && last->ends == ends; ++last)
      last->found = true;
    return static_cast<std::size_t>(last - first);
  }

  // The rank of the first number of the first pair that was not found, or `none`
  std::size_t first_not_found(std::size_t none) const
  {
    for(const Pair& pair : m_pairs)
      if(!pair.found)
        none = (std::min)(none, pair.rank);
    return none;
  }

private:
  std::vector<Pair> m_pairs;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_READ_VERTEX_PAIRS_H
