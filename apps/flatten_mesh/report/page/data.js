// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The surface and what is known of its triangles, from the arrays that the program wrote into the page

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) {
    return Uint8Array.fromBase64(text);
  }
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) {
    bytes[i] = binary.charCodeAt(i);
  }
  return bytes;
}

// The numbers of an array, whose text is then no longer kept
function takeArray(name, Type) {
  const element = document.getElementById("array-" + name);
  if (!element) {
    throw new Error(`The array "${name}" is missing.`);
  }
  const bytes = bytesOfBase64(element.textContent.trim());
  element.remove();
  return new Type(bytes.buffer, 0, bytes.byteLength / Type.BYTES_PER_ELEMENT);
}

class Surface {
  // `up` is the axis that points upwards: "x", "y" or "z".
  constructor(measures, up) {
    this.up = up;
    this.points = takeArray("points", Float32Array);
    this.wedgePoints = takeArray("wedge_points", Uint32Array);
    this.wedgeUv = takeArray("wedge_uv", Float32Array);
    this.triangles = takeArray("triangles", Uint32Array);
    this.charts = takeArray("charts", Int32Array);
    this.faces = takeArray("faces", Uint32Array);
    this.borders = takeArray("borders", Uint32Array);
    this.values = new Map(measures.map((measure) => [measure.name, takeArray(measure.name, Float32Array)]));
    this.size = this.charts.length;
  }

  corners(triangle, inPlane) {
    return [0, 1, 2].map((k) => {
      const wedge = this.triangles[3 * triangle + k];
      return inPlane ? new THREE.Vector3(this.wedgeUv[2 * wedge], this.wedgeUv[2 * wedge + 1], 0)
                     : new THREE.Vector3().fromArray(this.points, 3 * this.wedgePoints[wedge]);
    });
  }

  hasChart(triangle) {
    return this.charts[triangle] >= 0;
  }

  // A polygon has several.
  trianglesOfFace(face) {
    const triangles = [];
    for (let t = this.faces.indexOf(face); t >= 0; t = this.faces.indexOf(face, t + 1)) {
      triangles.push(t);
    }
    return triangles;
  }

  haveCommonPoint(s, t) {
    const pointsOf = (triangle) => [0, 1, 2].map((k) => this.wedgePoints[this.triangles[3 * triangle + k]]);
    const others = pointsOf(t);
    return pointsOf(s).some((p) => others.includes(p));
  }

  // The distance of the point farthest from the origin, which is the centre of the bounding box
  radius() {
    let largest = 0;
    for (let i = 0; i < this.points.length; i += 3) {
      const x = this.points[i], y = this.points[i + 1], z = this.points[i + 2];
      largest = Math.max(largest, x * x + y * y + z * z);
    }
    return Math.sqrt(largest) || 1;
  }
}

// Of length 1, whatever the triangle
function normalOf([a, b, c]) {
  const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
  return normal.lengthSq() > 0.5 ? normal : normal.set(0, 0, 1);
}

// The box of a chart, its mean normal, and some of its triangles; null if it has none
function chartExtent(surface, chart, inPlane) {
  const all = [], box = new THREE.Box3(), normal = new THREE.Vector3();
  for (let t = 0; t < surface.size; ++t) {
    if (surface.charts[t] === chart) {
      const [a, b, c] = surface.corners(t, inPlane);
      all.push(t);
      [a, b, c].forEach((p) => box.expandByPoint(p));
      normal.add(b.sub(a).cross(c.sub(a)));
    }
  }
  if (all.length === 0) {
    return null;
  }
  const samples = [0.15, 0.4, 0.6, 0.85].map((part) => all[Math.floor(part * all.length)]);
  return {box, normal: normal.lengthSq() > 0 ? normal.normalize() : normal.set(0, 0, 1), samples};
}

// The middle of a triangle, and the length of its longest side
function extentOf(corners) {
  const middle = corners[0].clone().add(corners[1]).add(corners[2]).divideScalar(3);
  const length = Math.max(...[0, 1, 2].map((k) => corners[k].distanceTo(corners[(k + 1) % 3])));
  return {middle, length};
}
