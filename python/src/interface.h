// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The functions that Python calls, by ctypes: plain C, so that one library serves every version of Python. They change
// together with _core.py, and are no interface for others.

#ifndef ABF_PYTHON_INTERFACE_H
#define ABF_PYTHON_INTERFACE_H

#include <cstdint>

#define ABF_PYTHON_API extern "C" __attribute__((visibility("default")))

// An array of numpy with one or two dimensions, where it is. The Python side has checked its shape and its kind.
struct abf_array
{
  const void* data;
  std::int64_t shape[2];   // (n, 1) for one dimension
  std::int64_t strides[2]; // in bytes
  char kind;               // f, i, u or b as in numpy; 0: no array is given
  std::int8_t size;        // of an element, in bytes
  std::int8_t dimensions;
};

struct abf_mesh
{
  abf_array vertices;      // (n, 3)
  abf_array offsets;       // of polygons in `indices`; not given: `indices` has a row for each triangle
  abf_array indices;       // (m, 3) or (c,)
  abf_array marked_seams;  // (k, 2) vertices
  abf_array uv;            // (number of corners, 2)
  abf_array ignored_faces; // a flag for each face
};

// What a chart should look like
struct abf_prescriptions
{
  abf_array corners;   // of a rectangle
  double aspect_ratio; // if not 0, corners for this ratio are chosen
  abf_array angle_vertices, angles;
  abf_array pin_vertices, pins;
};

struct abf_progress;  // see progress.h
struct abf_result;    // see results.h
struct abf_flattener; // see charts.cpp

// Options are JSON: the name of each, and its value as a pair of its type in Python and its text.
ABF_PYTHON_API abf_result* abf_atlas(const abf_mesh* meshes, int number, int is_shared, const char* choices,
                                     const char* options, abf_progress*);
ABF_PYTHON_API abf_result* abf_make_flattener(const abf_mesh*, int is_hierarchical, const char* options,
                                              const abf_prescriptions*, abf_flattener**);
ABF_PYTHON_API abf_result* abf_solve(abf_flattener*, const abf_array* vertices, abf_progress*);
ABF_PYTHON_API void abf_free_flattener(abf_flattener*);
ABF_PYTHON_API abf_result* abf_lscm(const abf_mesh*, abf_progress*);
ABF_PYTHON_API abf_result* abf_measure(const abf_mesh*, abf_progress*);
ABF_PYTHON_API abf_result* abf_certify(const abf_mesh*, abf_progress*);
ABF_PYTHON_API abf_result* abf_pack(const abf_mesh*, const abf_array* first_faces, const char* options,
                                    abf_progress*);
ABF_PYTHON_API abf_result* abf_unshared(const abf_array* indices, const abf_array* uv, abf_progress*);
ABF_PYTHON_API abf_result* abf_seams(const abf_mesh*, const char* way, const char* options, abf_progress*);
ABF_PYTHON_API abf_result* abf_cones(const abf_mesh*, int number, double angle_multiple, int is_flattened,
                                     int threads, abf_progress*);
ABF_PYTHON_API abf_result* abf_bake(const abf_mesh*, const abf_mesh* fine, const abf_array* colors,
                                    const char* options, abf_progress*);

// The table of all options, and the version: JSON
ABF_PYTHON_API const char* abf_description();

// The program flatten_mesh: its exit status
ABF_PYTHON_API int abf_run_program(int argc, char** argv);

// The kind of a result: 0, or the number of the kind of its failure. Its text is JSON, or the message of the failure.
ABF_PYTHON_API int abf_kind(const abf_result*);
ABF_PYTHON_API const char* abf_text(const abf_result*);

// The next array of a result, to be freed by the caller; null after the last
ABF_PYTHON_API void* abf_take_array(abf_result*, abf_array*);
ABF_PYTHON_API void abf_free_array(void*);
ABF_PYTHON_API void abf_free_result(abf_result*);

#endif // ABF_PYTHON_INTERFACE_H
