// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXT_READER_H
#define FLATTEN_MESH_TEXT_READER_H

#include "flatten_mesh/model/Degenerate_faces.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Text_lines.h"
#include "flatten_mesh/model/text_numbers.h"
#include "flatten_mesh/texts.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flatten_mesh {

// A word of a file, for a message
inline std::string quoted_word(const std::string_view word)
{
  const std::size_t longest = 40;
  return "'" + std::string(word.substr(0, longest)) + (word.size() > longest ? "..." : "") + "'";
}

// The common part of the readers of text formats: items, such as vertices, with their words, and errors that name the
// line.
class Text_reader
{
public:
  Text_reader(const std::string_view text, Model& model, const Degenerate_faces degenerate,
              const Text_lines::Joining joining = Text_lines::NOTHING)
      : lines(text, joining), m_file(model.name), m_keeps_all(degenerate == Degenerate_faces::KEPT)
  {}

  bool keeps_all() const { return m_keeps_all; }

  [[noreturn]] void refuse(const std::string& what) const { refuse_at(lines.number(), what); }

  [[noreturn]] void refuse_at(const std::size_t line, const std::string& what) const
  {
    throw Input_error("'" + m_file + "', line " + std::to_string(line) + ": " + what);
  }

  // Whether the word that was read last is a coordinate
  double coordinate(const std::string_view word, const std::size_t vertex) const
  {
    double number = 0;
    if(word.empty()) {
      refuse(vertex_name(vertex) + " has fewer than three coordinates; export the mesh again");
    }
    if(!read_number(word, number)) {
      refuse("the coordinate " + quoted_word(word) + " of " + vertex_name(vertex) +
             " is not a number; export the mesh again");
    }
    if(!m_keeps_all && !std::isfinite(number)) {
      refuse("the coordinate " + quoted_word(word) + " of " + vertex_name(vertex) +
             " is not a finite number; remove the vertex or repair the scan");
    }
    return number;
  }

  // Reads the words of a line that is not empty. False at the end of the text
  bool next_item(std::vector<std::string_view>& words)
  {
    words.clear();
    return append_words(words);
  }

  // Also those of further lines, until there are enough. False at the end of the text
  bool complete_item(std::vector<std::string_view>& words, const std::size_t enough)
  {
    while(words.size() < enough) {
      if(!append_words(words)) {
        return false;
      }
    }
    return true;
  }

  Text_lines lines;

private:
  bool append_words(std::vector<std::string_view>& words)
  {
    std::string_view word = lines.word_in_any_line();
    const bool is_there = !word.empty();
    for(; !word.empty(); word = lines.word()) {
      words.push_back(word);
    }
    return is_there;
  }

  const std::string& m_file;
  bool m_keeps_all;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXT_READER_H
