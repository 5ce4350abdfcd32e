"use strict";
// Put at the end of a copy of the atlas by atlas_page.sh: goes through the page
// as a user does, and leaves what was wrong in an element atlas-check.
{
  const wrong = [];
  let checks = 0;
  const check = (ok, what) => {
    checks++;
    if (!ok)
      wrong.push(what);
  };
  const tipNow = document.getElementById("tip");

  // Moves the pointer to the middle of an element, as far as it can be seen.
  function hover(element) {
    element.scrollIntoView({ block: "center" });
    const box = element.getBoundingClientRect();
    const x = (box.left + box.right) / 2, y = (box.top + box.bottom) / 2;
    const hit = document.elementFromPoint(x, y);
    if (hit)
      hit.dispatchEvent(new MouseEvent("mousemove",
        { bubbles: true, clientX: x, clientY: y }));
  }

  function checkTip(element, where) {
    tipNow.style.display = "none";
    tipNow.textContent = "";
    hover(element);
    check(tipNow.offsetHeight > 0, where + ": no tooltip");
    check(/^\S.*: .*\n.*(build\/|make )/.test(tipNow.textContent),
      where + ": a tooltip without case or command: " + tipNow.textContent);
  }

  function checkFigure(figure) {
    const svg = figure.querySelector("svg");
    check(svg, figure.id + ": no picture");
    if (!svg)
      return;
    const box = svg.getBoundingClientRect();
    check(box.width > 300 && box.height > 100, figure.id + ": a tiny picture");
    const marks = [...svg.querySelectorAll("g[onmousemove]")];
    check(marks.length > 2, figure.id + ": an empty picture");
    for (const i of [0, marks.length >> 1, marks.length - 1])
      if (marks[i])
        checkTip(marks[i], figure.id);
    check(figure.querySelector("figcaption").textContent.length > 20,
      figure.id + ": no caption");
  }

  // Empty cells stand below all others going up.
  function isSorted(cells) {
    const numbers = cells.every((c) => c !== "" && !isNaN(c));
    for (let i = 1; i < cells.length; i++) {
      const a = cells[i - 1], b = cells[i];
      if (a === "" ? b !== "" : b !== "" &&
          (numbers ? Number(a) > Number(b) :
            isNaN(a) && isNaN(b) && a.localeCompare(b) > 0))
        return false;
    }
    return true;
  }

  function checkTable(details) {
    details.querySelector("summary").click();
    details.open = true;
    const table = details.querySelector("table");
    const before = table.tBodies[0].rows.length;
    check(before > 0, details.id + ": no rows");
    for (const head of table.tHead.rows[0].cells) {
      const column = () => [...table.tBodies[0].rows]
        .map((row) => row.cells[head.cellIndex].textContent);
      head.click();
      check(isSorted(column()), details.id + ": not sorted by " +
        head.textContent);
      head.click();
      check(isSorted(column().reverse()), details.id + ": not sorted down by " +
        head.textContent);
    }
    check(table.tBodies[0].rows.length === before, details.id + ": rows lost");
    checkTip(table.tBodies[0].rows[0], details.id);
    details.open = false;
  }

  document.querySelectorAll("figure").forEach(checkFigure);
  check(document.querySelectorAll("figure svg").length > 20, "few pictures");
  const tables = document.querySelectorAll("details");
  check(tables.length > 20, "few tables");
  tables.forEach(checkTable);
  for (const link of document.querySelectorAll("a")) {
    link.click();
    const target = link.getAttribute("href");
    check(location.hash === target && document.querySelector(target),
      "a link to nowhere: " + target);
  }
  const result = document.createElement("pre");
  result.id = "atlas-check";
  result.textContent = [...wrong.map((w) => "WRONG " + w),
    "CHECKED " + checks + ", " + wrong.length + " wrong"].join("\n");
  document.body.append(result);
}
