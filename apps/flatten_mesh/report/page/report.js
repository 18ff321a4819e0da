// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

"use strict";

// Starts the page, and offers it to the console as `flattenReport`:
//   ready               a promise, fulfilled when everything is drawn
//   show(mode)          "checkerboard", "charts", or the name of a measure
//   select(triangle)    counted from 0 among those that are shown; -1: none
//   selected()
//   screenOf(triangle)  {surface: [x, y], plane: [x, y]} in the window, as mouse events have them; null where it is
//                       hidden
//   camera()            from where both views are seen
//   thinned()           whether fewer triangles are shown than there are

const flattenReport = {ready: new Promise((resolve, reject) => {
  document.addEventListener("DOMContentLoaded", () => {
    try {
      const page = new ReportPage();
      Object.assign(flattenReport, {
        show: (mode) => page.showMode(mode),
        select: (triangle) => page.select(triangle),
        selected: () => page.selected,
        screenOf: (triangle) => page.drawing ? page.drawing.screenOf(triangle) : {surface: null, plane: null},
        camera: () => page.drawing && page.drawing.cameras(),
        thinned: () => page.isThinned(),
      });
      resolve(page);
    } catch (error) {
      document.getElementById("failure").hidden = false;
      document.getElementById("failure").textContent = `The report cannot be shown. ${error.message}`;
      reject(error);
    }
  });
})};
window.flattenReport = flattenReport;
