// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Which part of the plane is seen, with what is asked of the camera of the surface

class PlaneCamera {
  constructor(box) {
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1);
    this.inPlane = true;
    this.box = box;
    this.center = new THREE.Vector2();
    this.height = 0; // until there is a view
  }

  state() {
    return {center: this.center.clone(), unitsPerPixel: this.unitsPerPixel};
  }

  setState({center, unitsPerPixel}) {
    this.center = center.clone();
    this.unitsPerPixel = unitsPerPixel;
  }

  static between(from, to, part) {
    return {
      center: from.center.clone().lerp(to.center, part),
      unitsPerPixel: from.unitsPerPixel * (to.unitsPerPixel / from.unitsPerPixel) ** part,
    };
  }

  get home() {
    const [left, bottom, right, top] = this.box, margin = 1.06;
    return {
      center: new THREE.Vector2((left + right) / 2, (bottom + top) / 2),
      unitsPerPixel: margin * Math.max((right - left) / this.width, (top - bottom) / this.height) || 1,
    };
  }

  turn(dx, dy) {
    this.pan(dx, dy);
  }

  pan(dx, dy) {
    this.center.x -= dx * this.unitsPerPixel;
    this.center.y += dy * this.unitsPerPixel;
  }

  zoom(factor, x, y) {
    const whole = this.home.unitsPerPixel;
    const unitsPerPixel = Math.min(Math.max(this.unitsPerPixel / factor, 1e-5 * whole), 10 * whole);
    const shift = this.unitsPerPixel - unitsPerPixel;
    this.center.x += (x - this.width / 2) * shift;
    this.center.y += (this.height / 2 - y) * shift;
    this.unitsPerPixel = unitsPerPixel;
  }

  place(x, y) {
    return [this.center.x + (x - this.width / 2) * this.unitsPerPixel,
      this.center.y + (this.height / 2 - y) * this.unitsPerPixel];
  }

  // What was seen as a whole is still so when the view changes its size.
  apply(width, height) {
    const isFirst = !this.height, before = isFirst ? null : this.home.unitsPerPixel;
    const changed = width !== this.width || height !== this.height;
    this.width = width;
    this.height = height;
    if (isFirst) {
      this.setState(this.home);
    } else if (changed) {
      this.unitsPerPixel *= this.home.unitsPerPixel / before;
    }
    const {camera} = this, x = this.unitsPerPixel * width / 2, y = this.unitsPerPixel * height / 2;
    Object.assign(camera, {left: -x, right: x, bottom: -y, top: y});
    camera.position.set(this.center.x, this.center.y, 0);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  stateLookingAt({middle, length}) {
    const unitsPerPixel = shownPixel(length, this.unitsPerPixel, this.home.unitsPerPixel);
    return {center: new THREE.Vector2(middle.x, middle.y), unitsPerPixel};
  }

  stateAround({box}) {
    const middle = box.getCenter(new THREE.Vector3()), {x, y} = box.getSize(new THREE.Vector3());
    const unitsPerPixel = 1.15 * Math.max(x / this.width, y / this.height, CLOSEST * this.home.unitsPerPixel);
    return {center: new THREE.Vector2(middle.x, middle.y), unitsPerPixel};
  }

  // Where the box is in the view: left, top, width, height
  boxInView() {
    const [left, bottom, right, top] = this.box, unit = this.unitsPerPixel;
    return [this.width / 2 + (left - this.center.x) / unit, this.height / 2 - (top - this.center.y) / unit,
      (right - left) / unit, (top - bottom) / unit];
  }
}
