// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The page about many reports: which status the models have, what they took, and which charts are the worst

const MEANINGS = ["each face has a chart", "the computation failed",
  "the input is wrong, parts of it cannot be flattened, or an output cannot be written", "the time was over",
  "memory ran out", "the process crashed, or was ended"]; // of exit statuses

const SHORTEST = 0.001; // seconds: reports have no shorter ones than these, and zero has no logarithm

function optionalText(digits) {
  return (x) => x === null ? "" : numberText(x, digits);
}

function optionalWhole(x) {
  return x === null ? "" : wholeText(x);
}

const MODEL_COLUMNS = [
  ["Model", (model) => model.name, (name, {input, message}) => element("div", {title: input}, name,
    ...message ? [element("p", {class: "remark"}, message)] : [])],
  ["Status", (model) => model.status, (x) => x],
  ["Triangles", (model) => model.triangles, optionalWhole],
  ["Charts", (model) => model.charts, optionalWhole],
  ["Density", (model) => model.density, optionalText(3)],
  ["L2 stretch", (model) => model.stretch, optionalText(4)],
  ["Seams", (model) => model.seam, optionalText(3)],
  ["Seconds", (model) => model.seconds, optionalText(3)],
  ["Memory, MB", (model) => model.peak_memory_mb, optionalText(3)],
];

const WORST_COLUMNS = [
  ["Model", (chart) => chart.model, (x) => x],
  ["Chart", (chart) => chart.number, (x) => wholeText(x + 1)],
  ["L2 stretch", (chart) => chart.l2_stretch ?? Infinity, (x) => numberText(x, 4)],
  ["Triangles", (chart) => chart.triangles, optionalWhole],
  ["Area", (chart) => chart.share_of_area, (x) => x === null ? "" : percentText(x)],
  ["Method", (chart) => chart.method, (x) => x],
];

// [status, its models], the most frequent first
function byStatus(models) {
  const groups = new Map();
  for (const model of models) {
    groups.set(model.status, [...groups.get(model.status) || [], model]);
  }
  return [...groups].sort(([, a], [, b]) => b.length - a.length);
}

function plotOfTimes(models) {
  const seconds = models.map((model) => model.seconds), axis = LogarithmicAxis.of(seconds);
  const bins = Math.round(axis.decades * (axis.decades > 4 ? 4 : 8));
  return histogram("Histogram of the seconds", "seconds (across), models (up)", seconds, axis, bins);
}

function plotOfDensities(models) {
  const values = models.map(({density}) => density);
  const title = "texel density (across), models (up)";
  return histogram("Histogram of the texel density", title, values, new LinearAxis(0, 1), 20);
}

function plotOfSizes(models) {
  return pointsPlot("Seconds and triangles", "triangles (across), seconds (up)", models.map((model) => ({
    x: model.triangles, y: model.seconds, failed: model.exit_status !== 0,
    text: `${model.name}: ${countText(model.triangles, "triangle")}, ${numberText(model.seconds)} s`,
  })));
}

class SummaryPage {
  constructor() {
    const {folder, version, columns, rows, worst, left_out: leftOut} =
      JSON.parse(document.getElementById("summary").textContent);
    this.models = rows.map((row) => Object.fromEntries(columns.map((column, k) => [column, row[k]])));
    this.part = Object.fromEntries([...document.querySelectorAll("[id]")].map((part) => [part.id, part]));
    this.part.title.textContent = `Reports in ${folder}`;
    this.part.subtitle.textContent = this.subtitle(version);
    this.addStatuses();
    this.addPlots();
    this.table = new SortedTable(MODEL_COLUMNS, this.models);
    this.table.fill();
    this.part.models.append(this.table.element);
    this.addWorst(worst);
    this.part["left-out"].append(element("ul", {}, ...leftOut.map((file) => element("li", {}, file))));
    this.part["left-out"].hidden = leftOut.length === 0;
  }

  subtitle(version) {
    const sum = (column) => this.models.reduce((total, model) => total + model[column], 0);
    const seconds = sum("seconds");
    return [countText(this.models.length, "report"), countText(sum("triangles"), "triangle"),
      countText(sum("charts"), "chart"), `${seconds < 1000 ? numberText(seconds) : wholeText(Math.round(seconds))} s`,
      `flatten_mesh ${version}`].join(" · ");
  }

  addStatuses() {
    const groups = byStatus(this.models);
    this.buttons = groups.map(([status]) =>
      element("button", {type: "button", "aria-pressed": "false", onclick: () => this.filter(status)}, status));
    const rows = groups.map(([, models], k) => element("tr", {},
      element("th", {scope: "row"}, this.buttons[k],
        element("p", {class: "remark"}, MEANINGS[models[0].exit_status] || "")),
      element("td", {}, wholeText(models.length)), element("td", {}, percentText(models.length / this.models.length))));
    this.part.statuses.append(element("table", {}, element("tbody", {}, ...rows)));
  }

  // Only the models with this status; all of them if it is the current one
  filter(status) {
    this.status = this.status === status ? null : status;
    this.buttons.forEach((button) => button.ariaPressed = String(button.textContent === this.status));
    this.table.only((model) => this.status === null || model.status === this.status);
  }

  addPlots() {
    const {time, density, size} = this.part;
    const timed = this.models.filter(({seconds}) => seconds !== null)
      .map((model) => ({...model, seconds: Math.max(model.seconds, SHORTEST)}));
    this.addPlot(time, timed, plotOfTimes);
    this.addPlot(density, this.models.filter((model) => model.density !== null), plotOfDensities);
    this.addPlot(size, timed.filter(({triangles}) => triangles > 0), plotOfSizes);
  }

  addPlot(part, models, draw) {
    const {length} = this.models;
    part.append(...models.length > 0 ? [draw(models)] : [], element("p", {class: "help"}, models.length === length ? ""
      : `${wholeText(models.length)} of ${countText(length, "model")}: the others have no such value`));
  }

  addWorst(worst) {
    const charts = worst.map((chart) => ({...chart, model: this.models[chart.row].name}));
    const table = new SortedTable(WORST_COLUMNS, charts);
    table.fill();
    this.part.worst.append(table.element);
    this.part.worst.hidden = worst.length === 0;
  }
}

document.addEventListener("DOMContentLoaded", () => new SummaryPage());
