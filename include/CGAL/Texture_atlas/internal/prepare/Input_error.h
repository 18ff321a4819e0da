// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_INPUT_ERROR_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_INPUT_ERROR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// What users should know about a surface that was repaired, in sentences
class Notes
{
public:
  // `tell` is called with each sentence, and may change its words.
  explicit Notes(std::function<void(std::string&)> tell = {}) : m_tell(std::move(tell)) {}

  // Names what the next texts are about, unless they do: a file in quotes, or nothing.
  void set_subject(const std::string& subject) { m_subject = subject; }

  void add(std::string text)
  {
    if(!m_subject.empty() && text.compare(0, m_subject.size(), m_subject) != 0) {
      text = m_subject + ": " + text;
    }
    if(m_tell) {
      m_tell(text);
    }
    m_texts.push_back(std::move(text));
  }

  const std::vector<std::string>& texts() const { return m_texts; }

private:
  std::function<void(std::string&)> m_tell;
  std::string m_subject;
  std::vector<std::string> m_texts;
};

using Surface_mesh_parameterization::Diagnosis;

// An error that the user has to correct, in a file or in arguments. The text is one line that names the error
// and the remedy.
struct Input_error : public std::runtime_error
{
  std::vector<std::size_t> faces, vertices; // of the file, from 0, that the text names
  Diagnosis status;
  std::size_t soup = 0; // its number, if there are several

  Input_error(const std::string& text, std::vector<std::size_t> wrong_faces = {},
              std::vector<std::size_t> wrong_vertices = {},
              const Diagnosis diagnosis = Diagnosis::WRONG_INPUT)
      : std::runtime_error(text), faces(std::move(wrong_faces)), vertices(std::move(wrong_vertices)),
        status(diagnosis)
  {}

  // The same, about one of several inputs
  Input_error about(const std::string& name, const std::size_t number) const
  {
    Input_error error(name + ": " + what(), faces, vertices, status);
    error.soup = number;
    return error;
  }
};

// Vertices and faces counted from 1, as in OBJ files.
inline std::string vertex_name(const std::size_t index)
{
  return "vertex " + std::to_string(index + 1);
}

inline std::string face_name(const std::size_t index)
{
  return "face " + std::to_string(index + 1);
}

// A count with its noun: "1 border", "3 borders".
inline std::string count_text(const std::size_t count, const std::string& noun,
                              const std::string& plural = "")
{
  return std::to_string(count) + " " + (count == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_INPUT_ERROR_H
