// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Rings around the selected and the hovered face, which would often be too small to be seen, and the text
// beside the mouse

const RING_DIAMETER = 22;
const REST = 100; // milliseconds without drawing after which is found out whether faces are behind others

class Marks {
  constructor(view) {
    this.view = view;
    this.rings = new Map(["selected", "hovered"].map((kind) => {
      const ring = element("div", {class: `ring ${kind}`, hidden: "", "aria-hidden": "true"});
      view.element.append(ring);
      return [kind, {ring, triangle: -1, appearance: null}];
    }));
    this.timer = 0;
  }

  set(kind, triangle) {
    this.rings.get(kind).triangle = triangle;
  }

  // Rings follow the camera at once. That a face is hidden is found out when the view rests, because it takes a
  // drawing of its own.
  place() {
    clearTimeout(this.timer);
    for (const mark of this.rings.values()) {
      mark.appearance = this.view.appearance(mark.triangle);
      this.showRing(mark);
      if (mark.appearance) {
        const [x, y] = mark.appearance.place;
        mark.ring.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
        this.timer = setTimeout(() => this.distinguish(), REST);
      }
    }
  }

  // Large faces need no ring, unless they are behind others.
  showRing({ring, appearance}) {
    const isBehind = ring.classList.contains("behind");
    ring.hidden = !appearance || (appearance.length > RING_DIAMETER && !isBehind);
  }

  distinguish() {
    for (const mark of this.rings.values()) {
      const {ring, triangle, appearance} = mark;
      ring.classList.toggle("behind", appearance !== null && !this.view.isInFront(triangle, appearance));
      this.showRing(mark);
    }
  }
}

class Tooltip {
  constructor(container) {
    this.container = container;
    this.box = element("div", {class: "tooltip", role: "status", hidden: ""});
    container.append(this.box);
  }

  // Beside a place in the container, where there is room. `lines` begin with a title.
  show([[title], ...lines], x, y) {
    this.box.replaceChildren(element("strong", {}, title),
      ...lines.map(([text, value]) => element("span", {}, text, element("b", {}, value))));
    this.box.hidden = false;
    const beside = (place, size, room) =>
      place + 16 + size < room ? place + 16 : Math.max(place - 16 - size, 4);
    const left = beside(x, this.box.offsetWidth, this.container.clientWidth);
    const top = beside(y, this.box.offsetHeight, this.container.clientHeight);
    this.box.style.transform = `translate(${left}px, ${top}px)`;
  }

  hide() {
    this.box.hidden = true;
  }
}
