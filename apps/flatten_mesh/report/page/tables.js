// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// The report for people, the charts, and what could not be flattened

function rowsTable(rows) {
  const body = element("tbody");
  for (const [label, value, remark] of rows) {
    const cells = value === undefined
      ? [element("th", {colspan: "3", scope: "colgroup", class: "group"}, capitalized(label))]
      : [element("th", {scope: "row"}, label),
        ...remark ? [element("td", {}, value), element("td", {}, remark)] : [element("td", {colspan: "2"}, value)]];
    body.append(element("tr", {}, ...cells));
  }
  const columns = ["label", "value", "remark"].map((name) => element("col", {class: name}));
  return element("table", {class: "rows"}, element("colgroup", {}, ...columns), body);
}

const CHART_COLUMNS = [
  ["Chart", (chart, i) => i],
  ["Triangles", (chart) => chart.triangles, (x) => wholeText(x)],
  ["Area", (chart) => chart.share_of_area, (x) => percentText(x)],
  ["Method", (chart) => chart.method, (x) => x],
  ["L2 stretch", (chart) => chart.l2_stretch ?? Infinity, (x) => numberText(x, 4)],
  ["Scale stretch", (chart) => chart.scale_stretch ?? Infinity, (x) => numberText(x, 4)],
  ["Seam jump", (chart) => chart.seam_jump, (x) => x === null ? "" : numberText(x, 4)],
];

class ChartsTable extends SortedTable {
  // `show` is called with the number of a chart.
  constructor(charts, show) {
    super(CHART_COLUMNS, charts);
    this.show = show;
    this.current = null;
    this.element.classList.add("charts");
    this.fill();
  }

  row(i) {
    const button = element("button", {type: "button", title: "Show this chart in both views"},
      element("i", {class: "swatch", style: `background: ${cssColor(colorOfChart(i))}`}), wholeText(i + 1));
    const attributes = {"data-chart": i, class: i === this.current ? "current" : "", onclick: () => this.show(i)};
    return element("tr", attributes, element("th", {scope: "row"}, button), ...this.cells(i));
  }

  mark(chart) {
    this.current = chart;
    for (const row of this.body.children) {
      row.classList.toggle("current", Number(row.dataset.chart) === chart);
    }
  }
}

function skippedList(skipped) {
  return element("ul", {}, ...skipped.map(({faces, first_face: face, message, diagnosis}) => element("li", {},
    element("strong", {}, `${countText(faces, "face")} from face ${wholeText(face + 1)} on: `),
    message || diagnosis)));
}
