// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The corners of all triangles, one after the other, as WebGL draws them. Corners are not shared, so that the
// number of a corner tells its triangle.

const CREASE = Math.cos(40 * Math.PI / 180); // sharper edges are not smoothed
const LARGEST_SMOOTHED_DEGREE = 64;          // the effort grows with its square

// Three times the triangle's area times its unit normal, for each triangle
function areaVectors(surface, positions) {
  const vectors = new Float32Array(3 * surface.size), lengths = new Float32Array(surface.size);
  for (let t = 0; t < surface.size; ++t) {
    const i = 9 * t;
    const ax = positions[i + 3] - positions[i], ay = positions[i + 4] - positions[i + 1];
    const az = positions[i + 5] - positions[i + 2], bx = positions[i + 6] - positions[i];
    const by = positions[i + 7] - positions[i + 1], bz = positions[i + 8] - positions[i + 2];
    const x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
    vectors[3 * t] = x;
    vectors[3 * t + 1] = y;
    vectors[3 * t + 2] = z;
    lengths[t] = Math.hypot(x, y, z);
  }
  return {vectors, lengths};
}

// The corners at each point: those of point p are corners[first[p]], ..., corners[first[p + 1] - 1].
function cornersAtPoints(surface) {
  const {triangles, wedgePoints} = surface;
  const first = new Uint32Array(surface.points.length / 3 + 1);
  for (let c = 0; c < triangles.length; ++c) {
    ++first[wedgePoints[triangles[c]] + 1];
  }
  for (let p = 1; p < first.length; ++p) {
    first[p] += first[p - 1];
  }
  const next = first.slice(), corners = new Uint32Array(triangles.length);
  for (let c = 0; c < triangles.length; ++c) {
    corners[next[wedgePoints[triangles[c]]]++] = c;
  }
  return {first, corners};
}

// The normal at each corner, in four signed bytes: the mean of the triangles at its point that do not lie
// beyond a crease
function cornerNormals(surface, positions) {
  const {vectors, lengths} = areaVectors(surface, positions);
  const {first, corners} = cornersAtPoints(surface);
  const normals = new Int8Array(12 * surface.size);
  for (let p = 0; p + 1 < first.length; ++p) {
    const isSmoothed = first[p + 1] - first[p] <= LARGEST_SMOOTHED_DEGREE;
    for (let i = first[p]; i < first[p + 1]; ++i) {
      const s = Math.floor(corners[i] / 3);
      const sx = vectors[3 * s], sy = vectors[3 * s + 1], sz = vectors[3 * s + 2];
      let x = sx, y = sy, z = sz;
      for (let k = first[p]; isSmoothed && k < first[p + 1]; ++k) {
        const t = Math.floor(corners[k] / 3);
        const tx = vectors[3 * t], ty = vectors[3 * t + 1], tz = vectors[3 * t + 2];
        if (t !== s && sx * tx + sy * ty + sz * tz > CREASE * lengths[s] * lengths[t]) {
          x += tx;
          y += ty;
          z += tz;
        }
      }
      const scale = 127 / (Math.sqrt(x * x + y * y + z * z) || 1), target = 4 * corners[i];
      normals[target] = Math.round(scale * x);
      normals[target + 1] = Math.round(scale * y);
      normals[target + 2] = Math.round(scale * z);
    }
  }
  return normals;
}

// Triangles without chart have no area in the plane.
function cornerPlaces(surface) {
  const {triangles, wedgePoints, points, wedgeUv} = surface;
  const positions = new Float32Array(3 * triangles.length), uvs = new Float32Array(2 * triangles.length);
  for (let c = 0; c < triangles.length; ++c) {
    const w = triangles[c], p = 3 * wedgePoints[w];
    positions[3 * c] = points[p];
    positions[3 * c + 1] = points[p + 1];
    positions[3 * c + 2] = points[p + 2];
    uvs[2 * c] = wedgeUv[2 * w] || 0;
    uvs[2 * c + 1] = wedgeUv[2 * w + 1] || 0;
  }
  return {positions, uvs};
}

function cornerGeometry(surface) {
  const {positions, uvs} = cornerPlaces(surface);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute("uv", new THREE.BufferAttribute(uvs, 2));
  geometry.setAttribute("normal", new THREE.BufferAttribute(cornerNormals(surface, positions), 4, true));
  return geometry;
}
