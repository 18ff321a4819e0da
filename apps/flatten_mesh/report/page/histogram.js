// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Histograms of the measures, which are legends of their colours as well, and the way to the worst faces

const HISTOGRAM = {width: 300, height: 74};

// "2° to 3°: 4.5 % of the area"
function binText(measure, bin) {
  const {first, width, shares} = measure.histogram, isLast = bin === shares.length - 1;
  const low = valueText(measure, first + bin * width), high = valueText(measure, first + (bin + 1) * width);
  const isOpen = bin === 0 && isDiverging(measure);
  const range = isLast ? `${low} and more` : isOpen ? `less than ${high}` : `${low} to ${high}`;
  return `${range}: ${percentText(shares[bin])} of the area`;
}

// Small shares are still seen.
function barHeight(share, largest) {
  return share > 0 ? Math.max(HISTOGRAM.height * share / largest, 1.5) : 0;
}

class HistogramBars {
  constructor(measure, tell) {
    this.measure = measure;
    this.tell = tell;
    const {shares} = measure.histogram, {width, height} = HISTOGRAM;
    this.bars = shares.map((share, bin) => this.bar(share, bin, Math.max(...shares, 1e-9)));
    this.element = svg("svg", {
      viewBox: `0 0 ${width} ${height + 1}`, preserveAspectRatio: "none", class: "bars", tabindex: "0",
      role: "img",
      "aria-label": `Histogram: ${measure.title}. The arrow keys tell the share of each bar.`,
    }, ...this.bars);
    this.bin = -1;
    this.element.addEventListener("pointermove", (event) => this.show(this.binAt(event)));
    this.element.addEventListener("pointerdown", (event) => this.show(this.binAt(event)));
    this.element.addEventListener("pointerleave", () => this.show(-1));
    this.element.addEventListener("blur", () => this.show(-1));
    this.element.addEventListener("keydown", (event) => this.pressKey(event));
  }

  bar(share, bin, largest) {
    const {shares, first, width: binWidth} = this.measure.histogram;
    const width = HISTOGRAM.width / shares.length, height = barHeight(share, largest);
    const middle = first + (bin + 0.5) * binWidth;
    return svg("g", {class: "bar"},
      svg("rect", {class: "column", x: bin * width, y: 0, width, height: HISTOGRAM.height + 1}),
      svg("rect", {
        x: bin * width + 0.06 * width, y: HISTOGRAM.height - height, width: 0.88 * width, height,
        fill: cssColor(colorOfValue(this.measure, middle)),
      }));
  }

  binAt(event) {
    const box = this.element.getBoundingClientRect();
    const bin = Math.floor((event.clientX - box.left) / box.width * this.bars.length);
    return Math.min(Math.max(bin, 0), this.bars.length - 1);
  }

  show(bin) {
    this.bars[this.bin]?.classList.remove("active");
    this.bin = bin;
    this.bars[bin]?.classList.add("active");
    this.tell(bin < 0 ? "" : binText(this.measure, bin));
  }

  pressKey(event) {
    const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (step) {
      event.preventDefault();
      this.show(Math.min(Math.max(this.bin + step, 0), this.bars.length - 1));
    }
  }
}

// Numbers below the bars: the ends of the scale, and the best value if it is between them
function histogramAxis(measure) {
  const {first, width, shares} = measure.histogram, end = first + width * shares.length;
  const values = [measure.limits[0], (measure.limits[0] + measure.limits[1]) / 2, measure.limits[1]];
  const ticks = values.map((value, k) => {
    const part = Math.min(Math.max((value - first) / (end - first), 0), 1);
    const sign = k === 0 && isDiverging(measure) ? "≤ " : k === 2 ? "≥ " : "";
    return element("span", {style: `left: ${(100 * part).toFixed(2)}%`}, sign + valueText(measure, value));
  });
  return element("div", {class: "axis"}, ...ticks);
}

// First, next and previous of the worst faces. `show` is called with one of them.
class WorstFaces {
  constructor(measure, show) {
    this.measure = measure;
    this.show = show;
    this.index = -1;
    this.text = element("span", {class: "which", role: "status"});
    const button = (label, title, onclick) =>
      element("button", {type: "button", title, "aria-label": `${title}: ${measure.title}`, onclick}, label);
    this.buttons = [
      button("Worst face", "Show the worst face", () => this.go(0)),
      button("‹", "Previous worst face", () => this.go(this.index - 1)),
      button("›", "Next worst face", () => this.go(this.index + 1)),
    ];
    this.element = element("div", {class: "worst"}, ...this.buttons, this.text);
    this.update();
  }

  go(index) {
    this.index = index;
    this.update();
    this.show(this.measure.worst[index]);
  }

  update() {
    const {worst} = this.measure, [first, previous, next] = this.buttons;
    first.disabled = worst.length === 0;
    previous.disabled = this.index <= 0;
    next.disabled = this.index + 1 >= worst.length;
    const current = worst[this.index];
    this.text.textContent = current
      ? `${this.index + 1} of ${worst.length}: ${valueText(this.measure, current.value)}` : "";
  }
}

// The panel of a measure
function measurePanel(measure, showMode, showWorst) {
  const hint = unitText(measure), told = element("p", {class: "told", role: "status"}, hint);
  const bars = new HistogramBars(measure, (text) => told.textContent = text || hint);
  const title = element("button", {
    type: "button", class: "title", title: "Colour the surface by this",
    onclick: () => showMode(measure.name),
  }, capitalized(measure.title));
  return element("section", {class: "measure", "data-measure": measure.name}, element("h3", {}, title),
    bars.element, histogramAxis(measure), told, new WorstFaces(measure, showWorst).element);
}
