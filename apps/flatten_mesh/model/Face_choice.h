// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FACE_CHOICE_H
#define FLATTEN_MESH_FACE_CHOICE_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// Which faces of a model are flattened, by names. The others keep the texture coordinates that they have.
struct Face_choice
{
  std::vector<std::string> only_materials; // empty: all, and faces without material
  std::vector<std::string> ignored;        // materials, objects and groups

  bool is_everything() const { return only_materials.empty() && ignored.empty(); }
};

namespace internal {

inline bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The groups or the object that an OBJ statement begins: polygons belong to several groups, but to one object.
inline std::vector<std::string> names_of_statement(const std::string& text)
{
  std::vector<std::string> names;
  if(boost::algorithm::starts_with(text, "o ")) {
    names.push_back(boost::algorithm::trim_copy(text.substr(2)));
  } else if(boost::algorithm::starts_with(text, "g ")) {
    const std::string words = boost::algorithm::trim_copy(text.substr(2));
    boost::algorithm::split(names, words, boost::algorithm::is_space(), boost::algorithm::token_compress_on);
  }
  return names;
}

inline std::vector<std::string> objects_and_groups(const std::vector<const Model*>& models)
{
  std::vector<std::string> names;
  for(const Model* model : models) {
    for(const Statement& statement : model->statements) {
      for(const std::string& name : names_of_statement(statement.text)) {
        if(!contains(names, name)) {
          names.push_back(name);
        }
      }
    }
  }
  return names;
}

inline std::vector<std::string> materials_of(const std::vector<const Model*>& models)
{
  std::vector<std::string> names;
  for(const Model* model : models) {
    names.insert(names.end(), model->material_names.begin(), model->material_names.end());
  }
  return names;
}

// "; the materials are 'a', 'b'"
inline std::string known_names_text(const std::string& nouns, std::vector<std::string> names)
{
  const std::size_t most = 20, number = names.size();
  names.resize((std::min)(most, number));
  return number == 0 ? "; there are no " + nouns
                     : "; the " + nouns + " are '" + boost::algorithm::join(names, "', '") + "'" +
                           (number > most ? " and " + std::to_string(number - most) + " more" : "");
}

} // namespace internal

// Throws an `Input_error` if none of the models has a name.
inline void check_choice(const Face_choice& choice, const std::vector<const Model*>& models)
{
  const std::vector<std::string> materials = internal::materials_of(models),
                                 others = internal::objects_and_groups(models);
  for(const std::string& name : choice.only_materials) {
    if(!internal::contains(materials, name)) {
      throw Input_error("--only-material: there is no material '" + name + "'" +
                        internal::known_names_text("materials", materials));
    }
  }
  for(const std::string& name : choice.ignored) {
    if(!internal::contains(materials, name) && !internal::contains(others, name)) {
      throw Input_error("--ignore: there is no material, object or group '" + name + "'" +
                        internal::known_names_text("materials", materials) +
                        internal::known_names_text("objects and groups", others));
    }
  }
}

// Of each polygon: whether it is not chosen. Empty if all are.
inline std::vector<bool> left_out_polygons(const Face_choice& choice, const Model& model)
{
  std::vector<bool> is_left_out;
  const auto is_ignored = [&choice](const std::string& name) {
    return internal::contains(choice.ignored, name);
  };
  bool ignores_object = false, ignores_group = false;
  auto statement = model.statements.begin();
  for(Index p = 0; p < model.number_of_polygons() && !choice.is_everything(); ++p) {
    for(; statement != model.statements.end() && statement->polygon <= p; ++statement) {
      const std::vector<std::string> names = internal::names_of_statement(statement->text);
      if(statement->text[0] == 'o' || statement->text[0] == 'g') {
        (statement->text[0] == 'o' ? ignores_object : ignores_group) =
            std::any_of(names.begin(), names.end(), is_ignored);
      }
    }
    const Index material = model.material(p);
    const std::string name = material == no_index ? "" : model.material_names[material];
    is_left_out.push_back(ignores_object || ignores_group || (material != no_index && is_ignored(name)) ||
                          (!choice.only_materials.empty() &&
                           (material == no_index || !internal::contains(choice.only_materials, name))));
  }
  return is_left_out;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FACE_CHOICE_H
