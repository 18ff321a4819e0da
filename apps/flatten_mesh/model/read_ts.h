// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_TS_H
#define FLATTEN_MESH_READ_TS_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Text_reader.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

namespace flatten_mesh {

namespace internal {

// Reads a GOCAD file with triangulated surfaces. CGAL's reader needs vertices whose numbers follow one another.
class Ts_reader
{
public:
  Ts_reader(const std::string_view text, Model& model, const Degenerate_faces degenerate)
      : m_text(text, model, degenerate), m_model(model)
  {}

  void read()
  {
    while(m_text.lines.next()) {
      read_line(m_text.lines.word());
    }
    if(!m_is_ended) {
      m_text.refuse("the file ends without END, so it was cut short; export the mesh again");
    }
  }

private:
  void read_line(const std::string_view keyword)
  {
    if(keyword == "GOCAD") { // another object, with numbers of its own
      m_numbers.clear();
    } else if(keyword == "VRTX" || keyword == "PVRTX") {
      read_vertex(std::string(keyword));
    } else if(keyword == "ATOM" || keyword == "PATOM") {
      const std::size_t number = vertex_number(std::string(keyword), 2);
      add_vertex(number, vertex(vertex_number(std::string(keyword), 2)));
    } else if(keyword == "TRGL") {
      for(int i = 0; i < 3; ++i) {
        m_model.vertices.push_back(vertex(vertex_number("TRGL", 3)));
      }
      m_model.end_polygon();
    }
    m_is_ended = keyword.empty() ? m_is_ended : keyword == "END";
  }

  void read_vertex(const std::string& keyword)
  {
    const std::size_t number = vertex_number(keyword, 4);
    double point[3];
    for(double& coordinate : point) {
      const std::string_view word = m_text.lines.word();
      if(word.empty()) {
        refuse_short(keyword, 4);
      }
      coordinate = m_text.coordinate(word, m_model.points.size());
    }
    add_vertex(number, static_cast<Index>(m_model.points.size()));
    m_model.points.emplace_back(point[0], point[1], point[2]);
  }

  void add_vertex(const std::size_t number, const Index index)
  {
    if(!m_numbers.emplace(number, index).second) {
      m_text.refuse("there are two vertices " + std::to_string(number) + "; export the mesh again");
    }
  }

  Index vertex(const std::size_t number) const
  {
    const auto found = m_numbers.find(number);
    if(found == m_numbers.end()) {
      m_text.refuse("vertex " + std::to_string(number) +
                    " does not exist, or comes later; export the mesh again");
    }
    return found->second;
  }

  std::size_t vertex_number(const std::string& keyword, const int numbers)
  {
    const std::string_view word = m_text.lines.word();
    std::size_t number = 0;
    if(word.empty()) {
      refuse_short(keyword, numbers);
    }
    if(!read_count(word, number)) {
      m_text.refuse(quoted_word(word) + " is not a vertex number; export the mesh again");
    }
    return number;
  }

  [[noreturn]] void refuse_short(const std::string& keyword, const int numbers) const
  {
    m_text.refuse(keyword + " has fewer than " + std::to_string(numbers) + " numbers; export the mesh again");
  }

  Text_reader m_text;
  Model& m_model;
  std::unordered_map<std::size_t, Index> m_numbers; // of vertices: in the file, and in the model
  bool m_is_ended = true;
};

} // namespace internal

// Reads a GOCAD file. Throws an `Input_error` with the number of the line that is wrong.
inline void read_ts(const std::string_view text, Model& model, const Degenerate_faces degenerate)
{
  internal::Ts_reader(text, model, degenerate).read();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_TS_H
