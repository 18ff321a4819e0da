// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_NOTES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_NOTES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <functional>
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

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_NOTES_H
