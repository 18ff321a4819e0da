// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Lines on the surface and in the plane: seams, borders, the outline of a face

const NO_SEAM = 0xffffffff;

class Segments {
  // Wedges in pairs, and the number of each pair's seam
  constructor(surface, pairs, seams) {
    const count = pairs.length / 2;
    const ends = [new Float32Array(3 * count), new Float32Array(3 * count)];
    const endsInPlane = [new Float32Array(2 * count), new Float32Array(2 * count)];
    for (let i = 0; i < pairs.length; ++i) {
      const k = i >> 1, p = 3 * surface.wedgePoints[pairs[i]];
      ends[i & 1].set(surface.points.subarray(p, p + 3), 3 * k);
      endsInPlane[i & 1].set(surface.wedgeUv.subarray(2 * pairs[i], 2 * pairs[i] + 2), 2 * k);
    }
    this.geometry = new THREE.InstancedBufferGeometry();
    this.geometry.setIndex([0, 1, 2, 2, 1, 3]);
    const corners = new Float32Array([0, -1, 0, 1, 1, -1, 1, 1]);
    this.geometry.setAttribute("position", new THREE.BufferAttribute(corners, 2));
    const add = (name, values, dimension) =>
      this.geometry.setAttribute(name, new THREE.InstancedBufferAttribute(values, dimension));
    add("from", ends[0], 3);
    add("to", ends[1], 3);
    add("from_uv", endsInPlane[0], 2);
    add("to_uv", endsInPlane[1], 2);
    add("seam_of_line", seams, 1);
    this.geometry.maxInstancedCount = count;
  }

  // One for each of both views. The width is in pixels of the page.
  meshes({color, width, isOnTop = false}) {
    return [false, true].map((inPlane) => {
      const mesh = new THREE.Mesh(this.geometry, lineMaterial(inPlane, color, isOnTop));
      mesh.material.pixels = width;
      mesh.frustumCulled = false;
      return mesh;
    });
  }
}

// Those of the seams, or those of the surface's own borders
function borderSegments(surface, areSeams) {
  const pairs = [], seams = [], {borders} = surface;
  for (let i = 0; i < borders.length; i += 3) {
    if ((borders[i + 2] !== NO_SEAM) === areSeams) {
      pairs.push(borders[i], borders[i + 1]);
      seams.push(areSeams ? borders[i + 2] : -1);
    }
  }
  return new Segments(surface, pairs, new Float32Array(seams));
}

// The border of a triangle's face
function outlineSegments(surface, triangle) {
  const sides = new Map();
  for (const t of surface.trianglesOfFace(surface.faces[triangle])) {
    for (let k = 0; k < 3; ++k) {
      const a = surface.triangles[3 * t + k], b = surface.triangles[3 * t + (k + 1) % 3];
      const key = Math.min(a, b) + "," + Math.max(a, b);
      if (!sides.delete(key)) { // the diagonals of a polygon come twice
        sides.set(key, [a, b]);
      }
    }
  }
  return new Segments(surface, [...sides.values()].flat(), new Float32Array(sides.size).fill(-1));
}

// Finds the seam whose line is nearest to a place in the plane, by a grid.
class SeamFinder {
  constructor(surface, box) {
    this.surface = surface;
    this.box = box;
    this.cells = new Map();
    this.cell = Math.max(box[2] - box[0], box[3] - box[1]) / 256 || 1;
    const {borders} = surface;
    for (let i = 0; i < borders.length; i += 3) {
      if (borders[i + 2] !== NO_SEAM) {
        this.add(i);
      }
    }
  }

  place(wedge) {
    return [this.surface.wedgeUv[2 * wedge], this.surface.wedgeUv[2 * wedge + 1]];
  }

  cellsBetween([x0, y0], [x1, y1]) {
    const index = (x, low) => Math.floor((x - low) / this.cell), result = [];
    for (let i = index(Math.min(x0, x1), this.box[0]); i <= index(Math.max(x0, x1), this.box[0]); ++i) {
      for (let j = index(Math.min(y0, y1), this.box[1]); j <= index(Math.max(y0, y1), this.box[1]); ++j) {
        result.push(i * 65536 + j);
      }
    }
    return result;
  }

  add(i) {
    const {borders} = this.surface;
    for (const key of this.cellsBetween(this.place(borders[i]), this.place(borders[i + 1]))) {
      if (!this.cells.has(key)) {
        this.cells.set(key, []);
      }
      this.cells.get(key).push(i);
    }
  }

  // The number of a seam within the distance, or -1
  near(x, y, distance) {
    const {borders} = this.surface, reach = Math.min(distance, 2 * this.cell);
    let seam = -1, nearest = reach;
    for (const key of this.cellsBetween([x - reach, y - reach], [x + reach, y + reach])) {
      for (const i of this.cells.get(key) || []) {
        const d = distanceToSegment([x, y], this.place(borders[i]), this.place(borders[i + 1]));
        if (d <= nearest) {
          nearest = d;
          seam = borders[i + 2];
        }
      }
    }
    return seam;
  }
}

function distanceToSegment([x, y], [ax, ay], [bx, by]) {
  const dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
  const part = square > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / square, 0), 1) : 0;
  return Math.hypot(x - ax - part * dx, y - ay - part * dy);
}
