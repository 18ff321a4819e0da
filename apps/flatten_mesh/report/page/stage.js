// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The canvas below both views. It is drawn only when something has changed.

class Stage {
  // null where there is no WebGL
  static on(container, canvas) {
    const context = canvas.getContext("webgl2", {alpha: true, antialias: true, powerPreference: "high-performance"});
    return context ? new Stage(container, canvas, context) : null;
  }

  constructor(container, canvas, context) {
    this.container = container;
    this.renderer = new THREE.WebGLRenderer({canvas, context, alpha: true});
    this.renderer.autoClear = false;
    this.renderer.setClearColor(0, 0);
    this.renderer.setScissorTest(true);
    this.views = [];
    this.tasks = new Map(); // what is to be done before the next drawing, by its key
    this.isChanged = false;
    this.frame = 0;
    this.pixel = new THREE.WebGLRenderTarget(1, 1);
    this.byte = new Uint8Array(4);
    canvas.addEventListener("webglcontextrestored", () => this.change());
  }

  add(view) {
    this.views.push(view);
  }

  // To be called once all views are there
  start() {
    new ResizeObserver(() => this.resize()).observe(this.container);
    this.watchPixelRatio();
    this.resize();
  }

  // The ratio changes when the window moves to another display, or with the browser's zoom.
  watchPixelRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
      this.watchPixelRatio();
      this.resize();
    }, {once: true});
  }

  resize() {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(this.container.clientWidth, this.container.clientHeight, false);
    this.draw();
  }

  // Draws before the browser shows the page next.
  change() {
    this.isChanged = true;
    this.requestFrame();
  }

  // Replaces a task of the same key that is still to be done.
  before(key, task) {
    this.tasks.set(key, task);
    this.requestFrame();
  }

  requestFrame() {
    if (!this.frame) {
      this.frame = requestAnimationFrame(() => {
        this.frame = 0;
        const tasks = [...this.tasks.values()];
        this.tasks.clear();
        tasks.forEach((task) => task());
        if (this.isChanged) {
          this.draw();
        }
      });
    }
  }

  draw() {
    this.isChanged = false;
    this.renderer.setRenderTarget(null);
    for (const view of this.views) {
      const {left, top, width, height} = view.box();
      const bottom = this.container.clientHeight - top - height;
      this.renderer.setViewport(left, bottom, width, height);
      this.renderer.setScissor(left, bottom, width, height);
      this.renderer.clear();
      view.draw(this.renderer);
    }
  }

  // The triangle that a scene of numbers shows at the only pixel of a camera, or -1
  numberAtPixel(scene, camera) {
    this.renderer.setRenderTarget(this.pixel);
    this.renderer.clear();
    this.renderer.render(scene, camera);
    this.renderer.readRenderTargetPixels(this.pixel, 0, 0, 1, 1, this.byte);
    this.renderer.setRenderTarget(null);
    const [a, b, c, d] = this.byte;
    return a + 256 * b + 65536 * c + 16777216 * d - 1;
  }
}
