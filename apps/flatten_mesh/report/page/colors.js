// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Colours of charts and of measures, as [red, green, blue] from 0 to 255. Lightness differs where hue does,
// so that they are told apart by people who see fewer hues.

const GREY = [176, 176, 172];          // triangles without chart
const HIGHLIGHT = [0, 214, 240];       // not on any of the scales
const FADED = [222, 222, 220];         // charts other than the one that was asked for

// A colour of Oklab, where distances are visual differences
function oklab(lightness, a, b) {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3;
  const byte = (linear) => {
    const x = Math.min(Math.max(linear, 0), 1);
    return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  };
  return [byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    byte(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)];
}

// 256 colours between some of given [lightness, chroma, hue in degrees], at equal distances
function scaleThrough(stops) {
  const places = stops.map(([lightness, chroma, hue]) =>
    [lightness, chroma * Math.cos(hue * Math.PI / 180), chroma * Math.sin(hue * Math.PI / 180)]);
  const colors = [];
  for (let i = 0; i < 256; ++i) {
    const x = i / 255 * (stops.length - 1), k = Math.min(Math.floor(x), stops.length - 2);
    colors.push(oklab(...places[k].map((from, j) => from + (x - k) * (places[k + 1][j] - from))));
  }
  return colors;
}

// From little to much
const SEQUENTIAL = scaleThrough(
  [[0.97, 0.02, 95], [0.86, 0.12, 85], [0.70, 0.17, 50], [0.52, 0.19, 15], [0.33, 0.13, 320]]);
// From smaller over equal to larger
const DIVERGING = scaleThrough(
  [[0.36, 0.13, 262], [0.66, 0.12, 245], [0.97, 0, 0], [0.74, 0.14, 60], [0.42, 0.12, 40]]);

function isDiverging(measure) {
  return measure.limits[0] < measure.best && measure.best < measure.limits[1];
}

function scaleOf(measure) {
  return isDiverging(measure) ? DIVERGING : SEQUENTIAL;
}

// Where on its scale a value lies, from 0 to 1; the best one is in the middle of a diverging scale.
function partOfScale(measure, value) {
  const [low, high] = measure.limits;
  let part = (value - low) / (high - low);
  if (isDiverging(measure)) {
    part = value < measure.best ? 0.5 * (value - low) / (measure.best - low)
                                : 0.5 + 0.5 * (value - measure.best) / (high - measure.best);
  }
  return Math.min(Math.max(part, 0), 1);
}

function colorOfValue(measure, value) {
  return Number.isNaN(value) ? GREY : scaleOf(measure)[Math.round(255 * partOfScale(measure, value))];
}

// Those of successive numbers differ much.
function colorOfChart(chart) {
  const hue = (250 + 137.508 * chart) * Math.PI / 180, lightness = [0.64, 0.72, 0.57][chart % 3];
  return chart < 0 ? GREY : oklab(lightness, 0.115 * Math.cos(hue), 0.115 * Math.sin(hue));
}

function cssColor([red, green, blue]) {
  return `rgb(${red}, ${green}, ${blue})`;
}

function mixedColors(from, to, part) {
  return from.map((x, i) => Math.round(x + part * (to[i] - x)));
}

// Writes red, green and blue of each triangle, and whether it has a checkerboard. `measure` is null for the
// colours of charts; `chart` is the only one that keeps its colours, or null.
function colorTriangles(surface, measure, chart, bytes) {
  const values = measure && surface.values.get(measure.name), colorsOfCharts = new Map();
  const ofChart = (number) => {
    if (!colorsOfCharts.has(number)) {
      colorsOfCharts.set(number, colorOfChart(number));
    }
    return colorsOfCharts.get(number);
  };
  for (let t = 0; t < surface.size; ++t) {
    const itsChart = surface.charts[t], isFaded = chart !== null && itsChart !== chart;
    let color = values ? colorOfValue(measure, values[t]) : ofChart(itsChart);
    if (isFaded) {
      color = mixedColors(color, FADED, 0.85);
    }
    bytes[4 * t] = color[0];
    bytes[4 * t + 1] = color[1];
    bytes[4 * t + 2] = color[2];
    bytes[4 * t + 3] = measure || isFaded || itsChart < 0 ? 0 : 255;
  }
}
