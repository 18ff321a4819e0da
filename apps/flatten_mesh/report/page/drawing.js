// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// All that is drawn: the surface and its charts in two views, with seams, and highlighted faces

const SEAM_DISTANCE = 5; // pixels between the mouse and a seam that it points at

class Drawing {
  // null where there is no WebGL. `listener` is told of faces under the mouse, see View.
  static of(surface, box, part, listener) {
    const stage = Stage.on(part.views, part.canvas);
    return stage && new Drawing(surface, box, part, listener, stage);
  }

  constructor(surface, box, part, listener, stage) {
    Object.assign(this, {surface, box, stage, sheet: part.sheet, outline: []});
    this.colors = triangleTexture(surface.size);
    const faces = triangleTexture(surface.size);
    new Uint32Array(faces.image.data.buffer).set(surface.faces);
    faces.needsUpdate = true;
    this.shared = {
      colors: {value: this.colors}, faces: {value: faces}, selected: {value: -1}, hovered: {value: -1},
      squares: {value: 0}, origin: {value: new THREE.Vector2(box[0], box[1])},
    };
    this.views = [
      new View(stage, part.surface, new SurfaceCamera(surface), surface, listener),
      new View(stage, part.plane, new PlaneCamera(box), surface, listener),
    ];
    const geometry = cornerGeometry(surface);
    this.views.forEach((view) => view.addFaces(geometry, this.shared));
    this.borders = this.addLines(borderSegments(surface, false), {color: [70, 70, 70], width: 1.25});
    this.seams = this.addLines(borderSegments(surface, true), {color: [20, 20, 24], width: 1.75});
    this.setChartSizes();
    this.finder = new SeamFinder(surface, box);
    this.views[1].whenPlaced = () => this.placeSheet();
    stage.start();
  }

  addLines(segments, style) {
    return segments.meshes(style).map((mesh, k) => this.views[k].addLines(mesh));
  }

  get up() {
    return this.views[0].control.up;
  }

  setUp(axis) {
    this.views[0].control.setUp(axis);
    this.views[0].fit();
  }

  // As if all were equally large
  setChartSizes() {
    const charts = 1 + this.surface.charts.reduce((a, b) => Math.max(a, b), 0);
    const [left, bottom, right, top] = this.box;
    this.views[0].chartSize = Math.sqrt(areaVector(this.surface).area / 2 / charts);
    this.views[1].chartSize = Math.sqrt((right - left) * (top - bottom) / charts);
  }

  // The box lies below the charts, like a sheet of paper.
  placeSheet() {
    const [left, top, width, height] = this.views[1].control.boxInView();
    Object.assign(this.sheet.style,
      {left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px`});
  }

  // See colorTriangles(); `squares` is their number along the box, 0 without checkerboard.
  color(measure, chart, squares) {
    colorTriangles(this.surface, measure, chart, this.colors.image.data);
    this.colors.needsUpdate = true;
    const [left, bottom, right, top] = this.box;
    this.shared.squares.value = squares / Math.max(right - left, top - bottom);
    this.stage.change();
  }

  showSeams(areShown) {
    [...this.seams, ...this.borders].forEach((mesh) => mesh.visible = areShown);
    this.stage.change();
  }

  // The seam that a place of the plane is near to, or -1
  seamAt(view, x, y) {
    if (!view?.control.inPlane || !this.seams[1].visible) {
      return -1;
    }
    return this.finder.near(...view.control.place(x, y), SEAM_DISTANCE * view.control.unitsPerPixel);
  }

  hover(triangle, seam) {
    this.mark("hovered", triangle);
    this.seams.forEach((mesh) => mesh.material.uniforms.seam.value = seam);
  }

  select(triangle) {
    this.mark("selected", triangle);
    this.outline.forEach((mesh, k) => {
      this.views[k].scene.remove(mesh);
      mesh.material.dispose();
      mesh.geometry.dispose();
    });
    const style = {color: [0, 40, 60], width: 2, isOnTop: true};
    this.outline = triangle < 0 ? [] : this.addLines(outlineSegments(this.surface, triangle), style);
  }

  mark(kind, triangle) {
    this.shared[kind].value = triangle < 0 ? -1 : this.surface.faces[triangle];
    this.views.forEach((view) => view.marks.set(kind, triangle));
    this.stage.change();
  }

  screenOf(triangle) {
    const [surface, plane] = this.views.map((view) => view.screenOf(triangle));
    return {surface, plane};
  }

  cameras() {
    return {surface: this.views[0].control.state(), plane: this.views[1].control.state()};
  }
}
