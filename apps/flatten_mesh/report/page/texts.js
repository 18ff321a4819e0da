// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Numbers as people read them

// Whole numbers, with commas between thousands
function wholeText(n) {
  return String(n).replace(/\B(?=(\d{3})+$)/g, ",");
}

// With as many digits as are needed, and a real minus sign
function numberText(x, digits = 3) {
  if (!Number.isFinite(x)) {
    return Number.isNaN(x) ? "none" : x > 0 ? "∞" : "−∞";
  }
  const size = Math.abs(x), isOdd = size !== 0 && (size < 1e-3 || size >= 1e6);
  const text = isOdd ? x.toExponential(digits - 1)
    : String(Number(size < 1e3 ? x.toPrecision(digits) : x.toFixed(0)));
  return text.replace("-", "−");
}

function countText(n, noun) {
  return `${wholeText(n)} ${noun}${n === 1 ? "" : "s"}`;
}

function percentText(share) {
  const percents = 100 * share;
  const isTiny = percents > 0 && percents < 0.01;
  return isTiny ? "less than 0.01 %" : `${numberText(percents, percents < 1 ? 1 : 3)} %`;
}

// A value of a measure. Doublings are told as factors, halvings as divisors.
function valueText(measure, value) {
  if (Number.isNaN(value)) {
    return "none";
  }
  switch (measure.unit) {
  case "degrees":
    return `${numberText(value)}°`;
  case "doublings":
    return value < 0 ? `÷ ${numberText(2 ** -value)}` : `× ${numberText(2 ** value)}`;
  default:
    return measure.unit ? `${numberText(value)} ${measure.unit}` : numberText(value, 4);
  }
}

// What the numbers on a scale mean
function unitText(measure) {
  switch (measure.unit) {
  case "degrees":
    return "degrees, mean of the corners; 0 is best";
  case "doublings":
    return "factor, relative to the whole surface; 1 is best";
  default:
    return `${measure.unit ? measure.unit + "; " : ""}${numberText(measure.best)} is best`;
  }
}

// People count from 1, as OBJ files do.
function faceText(face) {
  return `Face ${wholeText(face + 1)}`;
}

function chartText(chart) {
  return chart < 0 ? "no chart" : `chart ${wholeText(chart + 1)}`;
}

function capitalized(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
