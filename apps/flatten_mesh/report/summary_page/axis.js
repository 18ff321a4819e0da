// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Scales of plots

const MOST_TICKS = 7;

const COMPACT = new Intl.NumberFormat("en", {notation: "compact"});

function tickText(value) {
  return value >= 1000 ? COMPACT.format(value) : numberText(value);
}

// From `low` to `high`. Ticks are at least `leastStep` apart.
class LinearAxis {
  constructor(low, high, leastStep = 0) {
    this.low = low;
    this.high = high;
    this.leastStep = leastStep;
  }

  part(value) {
    return (value - this.low) / (this.high - this.low);
  }

  valueAt(part) {
    return this.low + part * (this.high - this.low);
  }

  // Multiples of 1, 2 or 5 times a power of ten
  ticks() {
    const least = Math.max((this.high - this.low) / MOST_TICKS, this.leastStep);
    const power = 10 ** Math.floor(Math.log10(least));
    const step = power * [1, 2, 5, 10].find((factor) => factor * power >= least * (1 - 1e-9));
    const first = Math.ceil(this.low / step - 1e-9), last = Math.floor(this.high / step + 1e-9);
    return Array.from({length: last - first + 1}, (_, k) => (first + k) * step);
  }
}

// The ends are quarters of a decade.
class LogarithmicAxis {
  static of(values) {
    const low = Math.floor(4 * Math.log10(values.reduce((a, b) => Math.min(a, b))));
    const high = Math.ceil(4 * Math.log10(values.reduce((a, b) => Math.max(a, b))));
    return new LogarithmicAxis(10 ** (low / 4), 10 ** (Math.max(high, low + 1) / 4));
  }

  constructor(low, high) {
    this.low = low;
    this.high = high;
    this.decades = Math.log10(high / low);
  }

  part(value) {
    return Math.log10(value / this.low) / this.decades;
  }

  valueAt(part) {
    return this.low * 10 ** (part * this.decades);
  }

  // Powers of ten, and twice and five times these if there is room for them
  ticks() {
    const first = Math.floor(Math.log10(this.low)), last = Math.ceil(Math.log10(this.high));
    const powers = Array.from({length: last - first + 1}, (_, k) => 10 ** (first + k));
    const within = (ticks) => ticks.filter((x) => x >= this.low * (1 - 1e-9) && x <= this.high * (1 + 1e-9));
    const all = within(powers.flatMap((power) => [power, 2 * power, 5 * power])), few = within(powers);
    return all.length <= MOST_TICKS ? all : few.filter((_, k) => k % Math.ceil(few.length / MOST_TICKS) === 0);
  }
}
