// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What another library reads in a file.

#ifndef TEST_ASSIMP_READER_H
#define TEST_ASSIMP_READER_H

#include "read_faces.h"

#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <stdexcept>
#include <string>
#include <vector>

// All faces in a file, in any order.
inline std::vector<Read_face> faces_by_assimp(const std::string& name)
{
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(name, 0);
  if(scene == nullptr)
    throw std::runtime_error(importer.GetErrorString());
  std::vector<Read_face> faces;
  for(unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for(unsigned f = 0; f < mesh.mNumFaces; ++f) {
      Read_face face;
      face.material = scene->mMaterials[mesh.mMaterialIndex]->GetName().C_Str();
      for(unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i) {
        const unsigned v = mesh.mFaces[f].mIndices[i];
        Read_corner corner;
        corner.point = {mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z};
        if(mesh.HasTextureCoords(0))
          corner.uv = {mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y};
        if(mesh.HasNormals())
          corner.normal = {mesh.mNormals[v].x, mesh.mNormals[v].y, mesh.mNormals[v].z};
        if(mesh.HasVertexColors(0))
          corner.color = {mesh.mColors[0][v].r, mesh.mColors[0][v].g, mesh.mColors[0][v].b};
        face.corners.push_back(corner);
      }
      faces.push_back(face);
    }
  }
  return faces;
}

#endif // TEST_ASSIMP_READER_H
