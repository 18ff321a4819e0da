// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The page: what is hovered, selected and shown, in both views and in the tables

// So many that charts have several of them
function firstSquares(charts) {
  return 2 ** Math.min(Math.max(Math.round(Math.log2(5 * Math.sqrt(charts))), 5), 9);
}

class ReportPage {
  constructor() {
    this.report = JSON.parse(document.getElementById("report").textContent);
    this.part = Object.fromEntries([...document.querySelectorAll("[id]")].map((part) => [part.id, part]));
    this.mode = "checkerboard";
    this.squares = firstSquares(this.report.charts.length);
    this.hovered = this.selected = this.seam = -1;
    this.chart = null; // the only one in colours
    this.writeParts();
    this.surface = new Surface(this.report.measures, this.report.up);
    this.drawing = Drawing.of(this.surface, this.report.box, this.part, this);
    this.part.views.hidden = !this.drawing;
    this.part.webgl.hidden = Boolean(this.drawing);
    this.part.up.value = this.drawing?.up;
    this.tooltip = new Tooltip(this.part.views);
    this.showMode(this.mode);
  }

  writeParts() {
    const {report, part} = this;
    writeTexts(report, part);
    writeThinning(report, part);
    addModes(report.measures, part, this);
    addSwitches(part, this);
    drawPages(report.pages, part.sheet);
    const toggleChart = (chart) => this.showChart(chart === this.chart ? null : chart);
    this.chartsTable = new ChartsTable(report.charts, toggleChart);
    part.charts.append(this.chartsTable.element);
    part.measures.append(...report.measures.map((measure) =>
      measurePanel(measure, (mode) => this.showMode(mode), (worst) => this.showWorst(measure, worst))));
  }

  isThinned() {
    return this.report.shown_triangles < this.report.triangles;
  }

  get measure() {
    return this.report.measures.find(({name}) => name === this.mode) || null;
  }

  showMode(mode) {
    const names = modesOf(this.report.measures).map(([name]) => name);
    if (!names.includes(mode)) {
      throw new Error(`There is no mode "${mode}", but: ${names.join(", ")}.`);
    }
    this.mode = mode;
    markMode(mode, this.measure, this.part);
    this.color();
  }

  showSquares(squares) {
    this.squares = squares;
    this.color();
  }

  color() {
    markSquares(this.squares, this.part);
    this.drawing?.color(this.measure, this.chart, this.mode === "checkerboard" ? this.squares : 0);
  }

  showSeams(areShown) {
    this.drawing?.showSeams(areShown);
  }

  setUp(axis) {
    this.drawing?.setUp(axis);
  }

  resetViews() {
    this.drawing?.views.forEach((view) => view.fit());
  }

  // `view` is the one with the mouse, at a place in it.
  hover(triangle, view = null, x = 0, y = 0) {
    const seam = this.drawing.seamAt(view, x, y);
    if (triangle !== this.hovered || seam !== this.seam) {
      this.hovered = triangle;
      this.seam = seam;
      this.drawing.hover(triangle, seam);
    }
    if (triangle < 0) {
      this.tooltip.hide();
    } else {
      const {left, top} = view.box();
      this.tooltip.show(this.linesAbout(triangle), left + x, top + y);
    }
  }

  // What people are told of a face: [text, value]
  linesAbout(triangle) {
    const {surface, report} = this, chart = surface.charts[triangle];
    const lines = [[`${faceText(surface.faces[triangle])}, ${chartText(chart)}`, ""]];
    if (chart >= 0) {
      lines.push(...report.measures.map((measure) =>
        [capitalized(measure.title), valueText(measure, surface.values.get(measure.name)[triangle])]));
    }
    return lines;
  }

  // `view` is the one that was clicked, and stays as it is.
  select(triangle, view = null) {
    this.selected = triangle;
    writeSelection(triangle < 0 ? null : this.linesAbout(triangle), this.part);
    this.drawing?.select(triangle);
    if (triangle >= 0) {
      this.drawing?.views.filter((other) => other !== view).forEach((other) => other.show(triangle, false));
    }
  }

  showInBoth(triangle) {
    this.drawing?.views.forEach((view) => view.show(triangle, true));
    this.scrollToViews();
  }

  showWorst(measure, worst) {
    this.showMode(measure.name);
    this.select(worst.triangle);
    this.showInBoth(worst.triangle);
  }

  // null: all of them
  showChart(chart) {
    this.chart = chart;
    this.chartsTable.mark(chart);
    this.color();
    if (chart !== null) {
      this.drawing?.views.forEach((view) => view.showChart(chart));
      this.scrollToViews();
    }
  }

  scrollToViews() {
    this.part.views.scrollIntoView({block: "nearest"});
  }

  letGo() {
    this.select(-1);
    if (this.chart !== null) {
      this.showChart(null);
    }
  }
}
