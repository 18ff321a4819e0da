// Copyright (c) 2026 The Angle_based_flattening authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints what a library reads of each file, in a line of JSON, as the script `run` wants it. A face is the list of its
// corners: x, y, z, and u, v of each set of texture coordinates.
// Usage: read_in_cpp assimp|openmesh FILE...

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

typedef std::vector<std::vector<std::vector<float>>> Faces;

Faces read_by_assimp(const std::string& name)
{
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(name, 0);
  if(scene == nullptr)
    throw std::runtime_error(importer.GetErrorString());
  Faces faces;
  for(unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for(unsigned f = 0; f < mesh.mNumFaces; ++f) {
      faces.emplace_back();
      for(unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i) {
        const unsigned v = mesh.mFaces[f].mIndices[i];
        const aiVector3D& point = mesh.mVertices[v];
        faces.back().push_back({point.x, point.y, point.z});
        for(unsigned k = 0; k < mesh.GetNumUVChannels(); ++k) {
          const aiVector3D& uv = mesh.mTextureCoords[k][v];
          faces.back().back().insert(faces.back().back().end(), {uv.x, uv.y});
        }
      }
    }
  }
  return faces;
}

Faces read_by_openmesh(const std::string& name)
{
  typedef OpenMesh::PolyMesh_ArrayKernelT<> Mesh;
  Mesh mesh;
  mesh.request_halfedge_texcoords2D();
  mesh.request_vertex_texcoords2D();
  OpenMesh::IO::Options options = OpenMesh::IO::Options::FaceTexCoord;
  options += OpenMesh::IO::Options::VertexTexCoord;
  if(!OpenMesh::IO::read_mesh(mesh, name, options))
    throw std::runtime_error("read_mesh() returns false");
  Faces faces;
  for(const auto face : mesh.faces()) {
    faces.emplace_back();
    for(const auto halfedge : mesh.fh_range(face)) {
      const auto vertex = mesh.to_vertex_handle(halfedge);
      const auto& point = mesh.point(vertex);
      faces.back().push_back({point[0], point[1], point[2]});
      if(options.face_has_texcoord() || options.vertex_has_texcoord()) {
        const auto uv = options.face_has_texcoord() ? mesh.texcoord2D(halfedge) : mesh.texcoord2D(vertex);
        faces.back().back().insert(faces.back().back().end(), {uv[0], uv[1]});
      }
    }
  }
  return faces;
}

// Lists of numbers, or of lists, as JSON
void print(const float x)
{
  std::cout << x;
}

template <class T>
void print(const std::vector<T>& list)
{
  for(std::size_t i = 0; i < list.size(); ++i) {
    std::cout << (i == 0 ? "[" : ", ");
    print(list[i]);
  }
  std::cout << (list.empty() ? "[]" : "]");
}

int main(int argc, char** argv)
{
  const bool with_assimp = argv[1] == std::string("assimp");
  omerr().disable();
  std::cout.precision(9);
  for(int i = 2; i < argc; ++i) {
    try {
      const Faces faces = with_assimp ? read_by_assimp(argv[i]) : read_by_openmesh(argv[i]);
      std::cout << "{\"faces\": ";
      print(faces);
      std::cout << "}" << std::endl;
    } catch(const std::exception& error) { // The messages have no quotation marks and backslashes.
      std::cout << "{\"error\": \"" << error.what() << "\"}" << std::endl;
    }
  }
}
