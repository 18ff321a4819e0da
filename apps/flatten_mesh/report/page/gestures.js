// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// What mouse, fingers and keys do in a view. `view` has move(method, ...), where the methods are turn(dx,
// dy), pan(dx, dy) and zoom(factor, x, y), and fit(), hover(x, y), leave(), click(x, y). Lengths and places
// are in pixels of the page, places from the upper left of the view.

const CLICK_DISTANCE = 4; // a mouse that moves less has not dragged

class Gestures {
  constructor(element, view) {
    this.element = element;
    this.view = view;
    this.pointers = new Map(); // places of those that are down
    this.isClick = false;
    const listen = (type, method) =>
      element.addEventListener(type, (event) => this[method](event), {passive: false});
    listen("pointerdown", "press");
    listen("pointermove", "move");
    listen("pointerup", "release");
    listen("pointercancel", "cancel");
    listen("pointerleave", "leave");
    listen("wheel", "turnWheel");
    listen("keydown", "pressKey");
    element.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  placeOf(event) {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  press(event) {
    this.element.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, this.placeOf(event));
    this.isClick = this.pointers.size === 1 && event.button === 0;
    this.pressed = this.placeOf(event);
  }

  move(event) {
    const place = this.placeOf(event), before = this.pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType !== "touch") {
        this.view.hover(...place);
      }
      return;
    }
    if (this.isClick && Math.hypot(place[0] - this.pressed[0], place[1] - this.pressed[1]) < CLICK_DISTANCE) {
      return;
    }
    this.isClick = false;
    if (this.pointers.size === 1) {
      this.drag(event, place[0] - before[0], place[1] - before[1]);
    } else if (this.pointers.size === 2) {
      this.pinch(event.pointerId, before, place);
    }
    this.pointers.set(event.pointerId, place);
  }

  drag(event, dx, dy) {
    const isPan = event.shiftKey || event.ctrlKey || (event.buttons & 6) !== 0;
    this.view.move(isPan ? "pan" : "turn", dx, dy);
  }

  // The other finger rests meanwhile; its own moves come in events of their own.
  pinch(id, before, place) {
    const other = [...this.pointers].find(([key]) => key !== id)[1];
    const distance = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
    this.view.move("pan", (place[0] - before[0]) / 2, (place[1] - before[1]) / 2);
    this.view.move("zoom", Math.max(distance(place), 1) / Math.max(distance(before), 1),
      (place[0] + other[0]) / 2, (place[1] + other[1]) / 2);
  }

  release(event) {
    this.pointers.delete(event.pointerId);
    if (this.isClick) {
      this.isClick = false;
      this.view.click(...this.placeOf(event));
    }
  }

  cancel(event) {
    this.pointers.delete(event.pointerId);
    this.isClick = false;
  }

  leave() {
    this.view.leave();
  }

  turnWheel(event) {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1);
    const factor = Math.exp(-Math.min(Math.max(pixels, -200), 200) * (event.ctrlKey ? 0.01 : 0.002));
    this.view.move("zoom", factor, ...this.placeOf(event));
  }

  pressKey(event) {
    const step = 24, actions = {
      ArrowLeft: () => this.view.move("turn", -step, 0),
      ArrowRight: () => this.view.move("turn", step, 0),
      ArrowUp: () => this.view.move("turn", 0, -step),
      ArrowDown: () => this.view.move("turn", 0, step),
      "+": () => this.zoomInTheMiddle(1.25),
      "=": () => this.zoomInTheMiddle(1.25),
      "-": () => this.zoomInTheMiddle(0.8),
      Home: () => this.view.fit(),
    };
    if (actions[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      actions[event.key]();
    }
  }

  zoomInTheMiddle(factor) {
    this.view.move("zoom", factor, this.element.clientWidth / 2, this.element.clientHeight / 2);
  }
}
