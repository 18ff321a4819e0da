// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The surface in space, or its charts in the plane: a part of the stage with a camera of its own. The
// listener is told of the triangle under the mouse by hover(triangle, view, x, y), without a view if there is
// none, and of clicks by select(triangle, view).

const THINNEST = 0.02; // pixels

class View {
  constructor(stage, element, control, surface, listener) {
    Object.assign(this, {stage, element, control, surface, listener});
    this.scene = new THREE.Scene();
    this.numbers = new THREE.Scene();
    this.motion = 0;
    this.whenPlaced = () => {};
    this.chartSize = Infinity; // of a usual chart
    this.marks = new Marks(this);
    this.gestures = new Gestures(element, this);
    stage.add(this);
  }

  addFaces(geometry, shared) {
    const add = (scene, material) => {
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false;
      scene.add(mesh);
    };
    add(this.scene, faceMaterial(this.control.inPlane, shared));
    add(this.numbers, numberMaterial(this.control.inPlane));
  }

  // Later lines are drawn over earlier ones.
  addLines(mesh) {
    mesh.renderOrder = 1 + this.scene.children.length;
    this.scene.add(mesh);
    return mesh;
  }

  box() {
    const {offsetLeft: left, offsetTop: top, clientWidth: width, clientHeight: height} = this.element;
    return {left, top, width: Math.max(width, 1), height: Math.max(height, 1)};
  }

  place() {
    const {width, height} = this.box();
    this.control.apply(width, height);
  }

  draw(renderer) {
    this.place();
    const ratio = renderer.getPixelRatio(), {width, height} = this.box(), lineRatio = ratio * this.lineWidth();
    for (const {material} of this.scene.children) {
      if (material.uniforms.viewport) {
        material.uniforms.viewport.value.set(width * ratio, height * ratio);
        material.uniforms.width.value = material.pixels * lineRatio;
      }
    }
    renderer.render(this.scene, this.control.camera);
    this.marks.place();
    this.whenPlaced();
  }

  // Lines are finer where charts are small, so that they do not cover them.
  lineWidth() {
    return Math.min(Math.max(this.chartSize / this.control.unitsPerPixel / 50, 0.35), 1);
  }

  // The triangle at a place, exactly there: the pixel in which it is looked for has its centre there.
  pick(x, y) {
    this.place();
    const {camera} = this.control, {width, height} = this.box();
    camera.setViewOffset(width, height, x - 0.5, y - 0.5, 1, 1);
    const triangle = this.stage.numberAtPixel(this.numbers, camera);
    camera.clearViewOffset();
    return triangle;
  }

  corners(triangle) {
    return this.surface.corners(triangle, this.control.inPlane);
  }

  // In pixels from the upper left of the view; null behind the eye
  projected(point) {
    const p = point.clone().project(this.control.camera), {width, height} = this.box();
    return Math.abs(p.z) <= 1 ? [(1 + p.x) * width / 2, (1 - p.y) * height / 2] : null;
  }

  // Where the middle of a triangle is, how large it is, and whether it is so thin that it covers no pixel; null if
  // it is nowhere
  appearance(triangle) {
    if (triangle < 0 || (this.control.inPlane && !this.surface.hasChart(triangle))) {
      return null;
    }
    this.place();
    const corners = this.corners(triangle);
    const [place, ...places] = [extentOf(corners).middle, ...corners].map((point) => this.projected(point));
    if (!place || places.includes(null)) {
      return null;
    }
    const sides = places.map(([x, y], k) => [places[(k + 1) % 3][0] - x, places[(k + 1) % 3][1] - y]);
    const length = Math.max(...sides.map(([x, y]) => Math.hypot(x, y)));
    const doubledArea = Math.abs(sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0]);
    return {place, length, isLine: doubledArea <= THINNEST * length};
  }

  isInFront(triangle, {place: [x, y], isLine}) {
    const {width, height} = this.box();
    if (x < 0 || y < 0 || x >= width || y >= height) {
      return false;
    }
    const seen = this.pick(x, y); // instead of a line, one of its neighbours
    return seen === triangle || (isLine && seen >= 0 && this.surface.haveCommonPoint(seen, triangle));
  }

  // Its place in the window, or null where it is hidden
  screenOf(triangle) {
    const appearance = this.appearance(triangle);
    if (!appearance || !this.isInFront(triangle, appearance)) {
      return null;
    }
    const {left, top} = this.element.getBoundingClientRect();
    return [left + appearance.place[0], top + appearance.place[1]];
  }

  // Moves so that a triangle is seen, unless it is seen well already and `always` is false.
  show(triangle, always) {
    const appearance = this.appearance(triangle), isInPlane = this.control.inPlane;
    const isWellSeen = appearance && appearance.length >= SMALLEST_SHOWN / 3
      && this.isWellInside(appearance.place) && this.isInFront(triangle, appearance);
    if ((always || !isWellSeen) && (!isInPlane || this.surface.hasChart(triangle))) {
      const corners = this.corners(triangle);
      this.moveTo(isInPlane ? this.control.stateLookingAt(extentOf(corners))
                            : this.freeState(triangle, corners));
    }
  }

  isWellInside([x, y]) {
    const {width, height} = this.box();
    return Math.min(x, width - x) > 0.08 * width && Math.min(y, height - y) > 0.08 * height;
  }

  // A state in which no other part of the surface is before the triangle. The direction remains if the triangle is
  // well seen from there.
  freeState(triangle, corners) {
    const extent = extentOf(corners), directions = directionsAround(normalOf(corners));
    if (this.control.direction(0, 0, 1).dot(directions[0]) > 0.6) {
      directions.unshift(null);
    }
    return this.freest(directions.map((direction) => this.control.stateLookingAt(extent, direction)), [triangle]);
  }

  // The first of some states in which all triangles are seen, or else that with the most of them
  freest(states, triangles) {
    const before = this.control.state();
    let best = states[0], most = 0;
    for (const state of states) {
      this.control.setState(state);
      this.place();
      const count = triangles.filter((triangle) => {
        const appearance = this.appearance(triangle);
        return appearance && this.isInFront(triangle, appearance);
      }).length;
      if (count > most) {
        most = count;
        best = state;
      }
      if (most === triangles.length) {
        break;
      }
    }
    this.control.setState(before);
    return best;
  }

  // Moves so that a whole chart is seen.
  showChart(chart) {
    const extent = chartExtent(this.surface, chart, this.control.inPlane);
    if (extent && this.control.inPlane) {
      this.moveTo(this.control.stateAround(extent));
    } else if (extent) {
      const states = directionsAround(extent.normal).map((direction) => this.control.stateAround(extent, direction));
      this.moveTo(this.freest(states, extent.samples));
    }
  }

  moveTo(goal) {
    cancelAnimationFrame(this.motion);
    const start = performance.now(), from = this.control.state();
    const duration = matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : 400;
    const step = (now) => {
      const part = duration ? Math.min(Math.max((now - start) / duration, 0), 1) : 1;
      this.control.setState(this.control.constructor.between(from, goal, part * part * (3 - 2 * part)));
      this.motion = part < 1 ? requestAnimationFrame(step) : 0;
      this.stage.change();
    };
    step(start);
  }

  fit() {
    this.moveTo(this.control.home);
  }

  // By hand
  move(method, ...values) {
    cancelAnimationFrame(this.motion);
    this.control[method](...values);
    this.listener.hover(-1);
    this.stage.change();
  }

  hover(x, y) {
    this.stage.before("hover", () => this.listener.hover(this.pick(x, y), this, x, y));
  }

  leave() {
    this.stage.before("hover", () => this.listener.hover(-1));
  }

  click(x, y) {
    this.listener.select(this.pick(x, y), this);
  }
}

// Directions towards the eye: along a normal first, then more and more from the sides
function directionsAround(normal) {
  const side = Math.abs(normal.x) > 0.9 ? new THREE.Vector3(0, 1, 0) : new THREE.Vector3(1, 0, 0);
  side.cross(normal).normalize();
  const other = normal.clone().cross(side), directions = [normal];
  for (const tilt of [30, 55, 78]) {
    const sine = Math.sin(tilt * Math.PI / 180), cosine = Math.cos(tilt * Math.PI / 180);
    for (let k = 0; k < 8; ++k) {
      directions.push(normal.clone().multiplyScalar(cosine)
        .addScaledVector(side, sine * Math.cos(k * Math.PI / 4))
        .addScaledVector(other, sine * Math.sin(k * Math.PI / 4)));
    }
  }
  return directions;
}
