// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// From where the surface is seen. Both cameras have turn(), pan(), zoom() and apply(), and states, which can
// be read, written and interpolated; `home` is the one that shows everything.

const TANGENT = Math.tan(15 * Math.PI / 180);   // of half the angle that the smaller side of a view spans
const SMALLEST_SHOWN = 14, LARGEST_SHOWN = 110; // pixels of a triangle that is to be seen
const CLOSEST = 1 / 60; // of the size of the whole, so that the surroundings are seen, too

// The size of a pixel, as near to the current one as a triangle of this size can be seen well
function shownPixel(length, current, whole) {
  const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
  return clamp(clamp(current, length / LARGEST_SHOWN, length / SMALLEST_SHOWN), CLOSEST * whole, whole);
}

class SurfaceCamera {
  constructor(surface) {
    this.camera = new THREE.PerspectiveCamera();
    this.inPlane = false;
    this.surface = surface;
    this.radius = surface.radius();
    this.height = 0; // until there is a view
    this.setUp(surface.up);
  }

  // "x", "y" or "z": the axis that points upwards when the surface is seen as a whole
  setUp(axis) {
    this.up = axis;
    this.firstRotation = firstRotation(this.surface, axis);
    this.upwards = new THREE.Vector3(0, 1, 0).applyQuaternion(this.firstRotation);
    if (this.height) {
      this.home = this.wholeState();
    }
  }

  state() {
    return {target: this.target.clone(), rotation: this.rotation.clone(), distance: this.distance};
  }

  setState({target, rotation, distance}) {
    this.target = target.clone();
    this.rotation = rotation.clone();
    this.distance = distance;
  }

  static between(from, to, part) {
    return {
      target: from.target.clone().lerp(to.target, part),
      rotation: from.rotation.clone().slerp(to.rotation, part),
      distance: from.distance * (to.distance / from.distance) ** part,
    };
  }

  // As near as the whole surface is seen, in the middle of the view
  wholeState() {
    const matrix = new THREE.Matrix3().setFromMatrix4(
      new THREE.Matrix4().makeRotationFromQuaternion(this.firstRotation.clone().conjugate()));
    const places = this.surface.points.slice();
    matrix.applyToBufferAttribute(new THREE.BufferAttribute(places, 3));
    const box = new THREE.Box3().setFromArray(places), middle = box.getCenter(new THREE.Vector3()).setZ(0);
    const across = TANGENT * Math.max(1, this.width / this.height);
    const upright = TANGENT * Math.max(1, this.height / this.width);
    let distance = 0;
    for (let i = 0; i < places.length; i += 3) {
      const x = Math.abs(places[i] - middle.x) / across, y = Math.abs(places[i + 1] - middle.y) / upright;
      distance = Math.max(distance, places[i + 2] + 1.1 * Math.max(x, y));
    }
    const target = middle.applyQuaternion(this.firstRotation);
    return {target, rotation: this.firstRotation, distance: distance || this.radius};
  }

  // The size of a pixel at the target
  get unitsPerPixel() {
    return 2 * this.distance * TANGENT / Math.min(this.width, this.height);
  }

  direction(x, y, z) {
    return new THREE.Vector3(x, y, z).applyQuaternion(this.rotation);
  }

  // A drag across the view is about half a turn.
  turn(dx, dy) {
    const angle = Math.PI * Math.hypot(dx, dy) / Math.min(this.width, this.height);
    const axis = new THREE.Vector3(-dy, -dx, 0).normalize();
    this.rotation.multiply(new THREE.Quaternion().setFromAxisAngle(axis, angle)).normalize();
  }

  pan(dx, dy) {
    this.target.addScaledVector(this.direction(-dx, dy, 0), this.unitsPerPixel);
  }

  // What is at this place of the view, as near as the target, stays there.
  zoom(factor, x, y) {
    const distance = Math.min(Math.max(this.distance / factor, 1e-5 * this.radius), 20 * this.radius);
    const shift = this.unitsPerPixel * (1 - distance / this.distance);
    this.target.addScaledVector(this.direction(x - this.width / 2, this.height / 2 - y, 0), shift);
    this.distance = distance;
  }

  // What was seen as a whole is still so when the view changes its size.
  apply(width, height) {
    if (width !== this.width || height !== this.height) {
      const before = this.home;
      Object.assign(this, {width, height});
      this.home = this.wholeState();
      if (before) {
        this.distance *= this.home.distance / before.distance;
      } else {
        this.setState(this.home);
      }
    }
    const {camera} = this;
    camera.fov = 2 * Math.atan(TANGENT * Math.max(1, height / width)) * 180 / Math.PI;
    camera.aspect = width / height;
    camera.position.copy(this.target).addScaledVector(this.direction(0, 0, 1), this.distance);
    camera.quaternion.copy(this.rotation);
    const fromCentre = camera.position.length();
    camera.far = fromCentre + 1.01 * this.radius;
    camera.near = Math.max(fromCentre - 1.01 * this.radius, 0.01 * Math.min(5 * this.distance, this.radius));
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  // Upright, unless that direction is nearly upright itself
  rotationTowards(direction) {
    if (Math.abs(direction.dot(this.upwards)) < 0.97) {
      return rotationWith(direction, this.upwards);
    }
    return new THREE.Quaternion().setFromUnitVectors(this.direction(0, 0, 1), direction)
      .multiply(this.rotation).normalize();
  }

  // null: the direction remains.
  stateLookingAt({middle, length}, towardsEye) {
    const unit = this.unitsPerPixel / this.distance;
    const distance = shownPixel(length, this.distance * unit, this.home.distance * unit) / unit;
    const rotation = towardsEye ? this.rotationTowards(towardsEye) : this.rotation.clone();
    return {target: middle, rotation, distance};
  }

  stateAround({box}, towardsEye) {
    const middle = box.getCenter(new THREE.Vector3()), radius = box.getSize(new THREE.Vector3()).length() / 2;
    const distance = Math.min(Math.max(1.2 * radius / this.radius, CLOSEST), 1) * this.home.distance;
    return {target: middle, rotation: this.rotationTowards(towardsEye), distance};
  }
}

function rotationWith(towardsEye, up) {
  return new THREE.Quaternion().setFromRotationMatrix(
    new THREE.Matrix4().lookAt(towardsEye, new THREE.Vector3(), up));
}

// The first of the axes along which the surface is shortest
function thinnestAxis(surface, axes) {
  const extent = new THREE.Box3().setFromArray(surface.points).getSize(new THREE.Vector3());
  return axes.reduce((best, axis) => extent[axis] < 0.99 * extent[best] ? axis : best);
}

// Surfaces that face mainly one way are seen from there, others along their shortest extent, a little from above
// and from the right.
function firstRotation(surface, axis) {
  const up = new THREE.Vector3(), {sum, area} = areaVector(surface), towardsEye = new THREE.Vector3();
  up[axis] = 1;
  if (sum.length() > 0.5 * area) {
    towardsEye.copy(sum).normalize();
  } else {
    towardsEye[thinnestAxis(surface, ["z", "x", "y"].filter((other) => other !== axis))] = axis === "z" ? -1 : 1;
    const right = up.clone().cross(towardsEye);
    towardsEye.addScaledVector(right, 0.45).addScaledVector(up, 0.3).normalize();
  }
  if (Math.abs(towardsEye.dot(up)) > 0.95) {
    up.set(up.z, up.x, up.y);
  }
  return rotationWith(towardsEye, up);
}

// The sum of the normals of all triangles, times their areas, and that of the areas
function areaVector({points, triangles, wedgePoints}) {
  const sum = new THREE.Vector3();
  let area = 0;
  for (let c = 0; c < triangles.length; c += 3) {
    const i = 3 * wedgePoints[triangles[c]], j = 3 * wedgePoints[triangles[c + 1]];
    const k = 3 * wedgePoints[triangles[c + 2]];
    const ax = points[j] - points[i], ay = points[j + 1] - points[i + 1], az = points[j + 2] - points[i + 2];
    const bx = points[k] - points[i], by = points[k + 1] - points[i + 1], bz = points[k + 2] - points[i + 2];
    const x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
    sum.x += x;
    sum.y += y;
    sum.z += z;
    area += Math.sqrt(x * x + y * y + z * z);
  }
  return {sum, area};
}
