// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Histograms, and points of two values

const PLOT = {width: 360, height: 220, left: 44, right: 12, top: 8, bottom: 34};

// Places of parts of the axes, as 0.5 for their middles
function plotX(part) {
  return PLOT.left + part * (PLOT.width - PLOT.left - PLOT.right);
}

function plotY(part) {
  return PLOT.height - PLOT.bottom - part * (PLOT.height - PLOT.top - PLOT.bottom);
}

// `title` is said below the horizontal axis.
function plot(label, title, x, y, ...marks) {
  const middle = {"text-anchor": "middle"};
  const across = x.ticks().map((value) => [plotX(x.part(value)), tickText(value)]);
  const up = y.ticks().map((value) => [plotY(y.part(value)), tickText(value)]);
  return svg("svg", {class: "plot", viewBox: `0 0 ${PLOT.width} ${PLOT.height}`, role: "img", "aria-label": label},
    ...up.map(([place]) => svg("line", {x1: plotX(0), x2: plotX(1), y1: place, y2: place})),
    ...up.map(([place, text]) => svg("text", {x: PLOT.left - 6, y: place + 4, "text-anchor": "end"}, text)),
    ...across.map(([place]) => svg("line", {x1: place, x2: place, y1: plotY(0), y2: plotY(0) + 4})),
    ...across.map(([place, text]) => svg("text", {x: place, y: PLOT.height - 19, ...middle}, text)),
    svg("text", {x: plotX(0.5), y: PLOT.height - 4, ...middle}, title), ...marks);
}

// How many of the values are in each of `bins` parts of the axis
function counts(values, axis, bins) {
  const result = Array(bins).fill(0);
  for (const value of values) {
    ++result[Math.min(Math.max(Math.floor(bins * axis.part(value) + 1e-9), 0), bins - 1)];
  }
  return result;
}

function histogram(label, title, values, axis, bins) {
  const numbers = counts(values, axis, bins), most = Math.max(...numbers);
  const y = new LinearAxis(0, most, 1);
  const bars = numbers.map((number, bin) => {
    const range = [bin, bin + 1].map((end) => numberText(axis.valueAt(end / bins)));
    return svg("rect", {
      x: plotX((bin + 0.06) / bins), y: plotY(number / most), width: plotX(0.94 / bins) - plotX(0),
      height: plotY(0) - plotY(number / most), "data-count": number,
    }, svg("title", {}, `${range.join(" to ")}: ${countText(number, "model")}`));
  });
  return plot(label, title, axis, y, ...bars);
}

// A point is {x, y, text, failed}.
function pointsPlot(label, title, points) {
  const [x, y] = ["x", "y"].map((name) => LogarithmicAxis.of(points.map((point) => point[name])));
  return plot(label, title, x, y, ...points.map((point) => svg("circle", {
    cx: plotX(x.part(point.x)), cy: plotY(y.part(point.y)), r: 3, class: point.failed ? "failed" : "done",
  }, svg("title", {}, point.text))));
}
