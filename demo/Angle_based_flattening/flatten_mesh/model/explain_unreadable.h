// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_EXPLAIN_UNREADABLE_H
#define FLATTEN_MESH_EXPLAIN_UNREADABLE_H

#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Some programs write a byte order mark at the start of text files. Readers take it for a word.
inline void open_file(const std::string& name, std::ifstream& file)
{
  file.open(name, std::ios::binary);
  std::array<char, 3> mark = {};
  file.read(mark.data(), mark.size());
  if(mark != std::array<char, 3>{'\xEF', '\xBB', '\xBF'}) {
    file.clear();
    file.seekg(0);
  }
}

// Whether a word is a non-finite number as programs write it: "nan", "-inf", "1.#IND".
inline bool is_not_a_finite_number(const std::string& word)
{
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  return word.find("1.#") != std::string::npos || (*end == '\0' && !std::isfinite(number));
}

inline bool is_number(const std::string& word)
{
  char* end = nullptr;
  std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}

// Reads, line by line, a text file that CGAL could not read. Expects one vertex or face per line in OFF and PLY
// files.
class Line_checker
{
public:
  explicit Line_checker(const std::string& name) : m_format(file_format(name)) { open_file(name, m_file); }

  // What is wrong with the first wrong line, or an empty string
  std::string complaint()
  {
    const bool has_elements = read_counts();
    if(m_format == "off" && !has_elements && !m_is_binary) {
      return "line " + std::to_string(m_number) +
             ": an OFF file begins with OFF and the numbers of its vertices, faces and edges; export the "
             "mesh again";
    }
    while(next_line()) {
      std::string what = not_finite();
      if(what.empty() && (has_elements || is_stl_vertex())) {
        what = has_elements && m_vertices == m_all_vertices ? wrong_face() : wrong_vertex();
      }
      if(what.empty() && m_format == "ts") {
        what = wrong_ts_line();
      }
      if(!what.empty()) {
        return "line " + std::to_string(m_number) + ": " + what;
      }
    }
    if(!has_elements || m_is_binary || (m_vertices == m_all_vertices && m_faces == m_all_faces)) {
      return "";
    }
    return "the file ends after line " + std::to_string(m_number) + " with " + std::to_string(m_vertices) +
           " of " + count_text(m_all_vertices, "vertex", "vertices") + " and " + std::to_string(m_faces) +
           " of " + count_text(m_all_faces, "face") + ": it was cut short; export the mesh again";
  }

private:
  // The next line with words, without comments
  bool next_line()
  {
    std::string line;
    m_words.clear();
    while(m_words.empty() && !m_is_binary && std::getline(m_file, line)) {
      ++m_number;
      m_is_binary = line.find('\0') != std::string::npos;
      std::istringstream words(line.substr(0, line.find('#')));
      for(std::string word; words >> word;) {
        m_words.push_back(word);
      }
    }
    return !m_words.empty() && !m_is_binary;
  }

  bool read_counts()
  {
    return m_format == "off" ? read_off_counts() : m_format == "ply" && read_ply_counts();
  }

  bool read_off_counts()
  {
    if(!next_line() || m_words[0].find("OFF") == std::string::npos ||
       m_words[0].find('4') != std::string::npos) {
      return false;
    }
    m_words.erase(m_words.begin());
    return (!m_words.empty() || next_line()) && m_words.size() > 2 &&
           read_number(m_words[0], m_all_vertices) && read_number(m_words[1], m_all_faces);
  }

  bool read_ply_counts()
  {
    bool is_text = false;
    while(next_line() && m_words[0] != "end_header") {
      is_text = is_text || (m_words[0] == "format" && m_words.size() > 1 && m_words[1] == "ascii");
      if(m_words[0] == "element" && m_words.size() > 2) {
        const bool is_known = m_words[1] == "vertex" || m_words[1] == "face";
        if(!is_known || !read_number(m_words[2], m_words[1] == "vertex" ? m_all_vertices : m_all_faces)) {
          return false;
        }
      }
    }
    return is_text;
  }

  static bool read_number(const std::string& word, std::size_t& number)
  {
    const char* const end = word.data() + word.size();
    const std::from_chars_result result = std::from_chars(word.data(), end, number);
    return result.ec == std::errc() && result.ptr == end;
  }

  // Standard C++ streams do not read "nan" and "inf".
  std::string not_finite() const
  {
    for(const std::string& word : m_words) {
      if(is_not_a_finite_number(word)) {
        return "the coordinate '" + word + "' is not a finite number; remove the vertex or repair the scan";
      }
    }
    return "";
  }

  // Whether the line is a vertex in a text file of the format STL. If so, only the coordinates remain.
  bool is_stl_vertex()
  {
    if(m_format != "stl" || m_words[0] != "vertex") {
      return false;
    }
    m_words.erase(m_words.begin());
    return true;
  }

  // GOCAD: a keyword, the numbers of vertices, and of vertices themselves the coordinates
  std::string wrong_ts_line() const
  {
    const bool is_vertex = m_words[0] == "VRTX" || m_words[0] == "PVRTX";
    const std::size_t numbers = is_vertex ? 1 : m_words[0] == "TRGL" ? 3 : 0;
    const std::size_t coordinates = is_vertex ? 3 : 0;
    for(std::size_t i = 1; i <= numbers + coordinates; ++i) {
      std::size_t number = 0;
      if(i >= m_words.size()) {
        return m_words[0] + " has fewer than " + std::to_string(numbers + coordinates) +
               " numbers; export the mesh again";
      }
      if(!(i <= numbers ? read_number(m_words[i], number) : is_number(m_words[i]))) {
        return "'" + m_words[i] + "' is not a " + (i <= numbers ? "vertex number" : "coordinate") +
               "; export the mesh again";
      }
    }
    return "";
  }

  std::string advice()
  {
    return std::string(m_file.peek() == std::ifstream::traits_type::eof()
                           ? ": the file ends here, so it was cut short"
                           : "") +
           "; export the mesh again";
  }

  std::string wrong_vertex()
  {
    ++m_vertices;
    for(std::size_t i = 0; i < 3; ++i) {
      if(i >= m_words.size()) {
        return vertex_name(m_vertices - 1) + " has fewer than three coordinates" + advice();
      }
      if(!is_number(m_words[i])) {
        return "the coordinate '" + m_words[i] + "' of " + vertex_name(m_vertices - 1) +
               " is not a number; export the mesh again";
      }
    }
    return "";
  }

  std::string wrong_face()
  {
    if(m_faces == m_all_faces) { // edges and other elements may follow
      return "";
    }
    const std::string name = face_name(m_faces++);
    std::size_t size = 0;
    if(!read_number(m_words[0], size) || size >= m_words.size()) {
      return name + " has fewer vertices than its count says" + advice();
    }
    for(std::size_t i = 1; i <= size; ++i) {
      std::size_t index = 0;
      if(!read_number(m_words[i], index) || index >= m_all_vertices) {
        return name + " names vertex '" + m_words[i] +
               "' (counted from 0), which does not exist: the file has only " +
               std::to_string(m_all_vertices) + "; export the mesh again";
      }
    }
    return "";
  }

  std::string m_format;
  std::ifstream m_file;
  std::vector<std::string> m_words;
  std::size_t m_number = 0; // of the line
  bool m_is_binary = false;
  std::size_t m_all_vertices = 0, m_all_faces = 0; // as the file says
  std::size_t m_vertices = 0, m_faces = 0;         // so far
};

} // namespace internal

// One line about a file that CGAL could not read.
inline std::string explain_unreadable_file(const std::string& name)
{
  const std::string complaint = internal::Line_checker(name).complaint();
  if(!complaint.empty()) {
    return "'" + name + "', " + complaint;
  }
  return "cannot read '" + name +
         "': it is damaged or cut short, a face names a vertex that does not exist, or it is not in the "
         "format "
         "that its name says; export the mesh again";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_EXPLAIN_UNREADABLE_H
