// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Tables that can be sorted by each column

const ROWS_AT_FIRST = 100; // there can be thousands

// A column is [title, value of an item and its number, text of the value and the item]; a text may be an element.
class SortedTable {
  constructor(columns, items) {
    this.columns = columns;
    this.items = items;
    this.order = items.map((item, i) => i);
    this.limit = ROWS_AT_FIRST;
    this.isShown = () => true;
    this.body = element("tbody");
    this.headers = columns.map(([title], column) => element("th", {scope: "col"},
      element("button", {type: "button", title: "Sort", onclick: () => this.sort(column)}, title)));
    this.more = element("button", {type: "button", class: "more", onclick: () => this.showAll()});
    this.element = element("div", {class: "sorted"}, element("div", {class: "scroll"},
      element("table", {}, element("thead", {}, element("tr", {}, ...this.headers)), this.body)), this.more);
  }

  fill() {
    const shown = this.order.filter((i) => this.isShown(this.items[i]));
    this.body.replaceChildren(...shown.slice(0, this.limit).map((i) => this.row(i)));
    this.more.hidden = shown.length <= this.limit;
    this.more.textContent = `Show all ${wholeText(shown.length)}`;
  }

  // Shows those items for which `isShown` is true.
  only(isShown) {
    this.isShown = isShown;
    this.fill();
  }

  row(i) {
    return element("tr", {}, element("th", {scope: "row"}, this.text(this.columns[0], i)), ...this.cells(i));
  }

  text([, value, text], i) {
    return text(value(this.items[i], i), this.items[i]);
  }

  // Those of all columns but the first
  cells(i) {
    return this.columns.slice(1).map((column) => element("td", {}, this.text(column, i)));
  }

  // Large numbers first; in the same column again: the other way round. What is not known is last.
  sort(column) {
    const value = (i) => this.columns[column][1](this.items[i], i), header = this.headers[column];
    const sign = (header.ariaSort ? header.ariaSort === "ascending" : column !== 0) ? -1 : 1;
    this.headers.forEach((other) => other.ariaSort = null);
    header.ariaSort = sign < 0 ? "descending" : "ascending";
    const compare = (a, b) => (a === null) - (b === null) || sign * (a < b ? -1 : a > b ? 1 : 0);
    this.order.sort((i, j) => compare(value(i), value(j)) || i - j);
    this.fill();
  }

  showAll() {
    this.limit = Infinity;
    this.fill();
  }
}
