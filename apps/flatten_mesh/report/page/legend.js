// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// What the colours mean, below the views

function legendOf(measure) {
  const colors = scaleOf(measure), stops = [];
  for (let i = 0; i <= 16; ++i) {
    stops.push(cssColor(colors[Math.round(i / 16 * 255)]));
  }
  const [low, high] = measure.limits, middle = isDiverging(measure) ? measure.best : (low + high) / 2;
  const first = isDiverging(measure) ? "≤ " : "";
  return element("div", {class: "legend-scale"},
    element("span", {class: "legend-title"}, capitalized(measure.title)),
    element("div", {class: "gradient"},
      element("div", {class: "strip", style: `background: linear-gradient(to right, ${stops.join(", ")})`}),
      element("div", {class: "ticks"}, element("span", {}, first + valueText(measure, low)),
        element("span", {}, valueText(measure, middle)),
        element("span", {}, "≥ " + valueText(measure, high)))),
    element("span", {class: "legend-unit"}, unitText(measure)));
}

function legendOfMode(mode, measure) {
  if (measure) {
    return legendOf(measure);
  }
  return element("p", {}, mode === "charts"
    ? "Each chart has a colour of its own."
    : "The squares are equally large in the plane. On the surface, they stay square where angles are kept, and "
      + "equally large where areas are.");
}
