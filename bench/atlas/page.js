"use strict";
// Tables sort by a click on a column's head, again for the other way round; what
// the pointer is over shows its case and command. gnuplot's pictures call
// gnuplot_svg by themselves.
const tip = document.getElementById("tip");

function showTip(event, text) {
  tip.textContent = text.replace(" | ", "\n");
  tip.style.display = "block";
  const right = Math.max(0, innerWidth - tip.offsetWidth - 8);
  tip.style.left = Math.min(event.clientX + 14, right) + "px";
  tip.style.top = event.clientY + 18 + "px";
}

function hideTip() {
  tip.style.display = "none";
}

window.gnuplot_svg = { showHypertext: showTip, hideHypertext: hideTip };

function compareCells(a, b) {
  const x = Number(a), y = Number(b);
  if (a === "" || b === "")
    return (a === "") - (b === "");
  return isNaN(x) || isNaN(y) ? a.localeCompare(b) : x - y;
}

function sortTable(head) {
  const column = head.cellIndex;
  const body = head.closest("table").tBodies[0];
  const way = head.dataset.way === "up" ? -1 : 1;
  for (const other of head.parentNode.cells)
    delete other.dataset.way;
  head.dataset.way = way > 0 ? "up" : "down";
  const cell = (row) => row.cells[column].textContent;
  const rows = [...body.rows];
  rows.sort((a, b) => way * compareCells(cell(a), cell(b)));
  body.append(...rows);
}

for (const table of document.querySelectorAll("table")) {
  table.tHead.addEventListener("click", (event) => {
    if (event.target.tagName === "TH")
      sortTable(event.target);
  });
  table.addEventListener("mousemove", (event) => {
    const row = event.target.closest("tbody tr");
    if (row)
      showTip(event, row.cells[0].textContent + ": " +
              row.cells[1].textContent + " | " +
              row.cells[row.cells.length - 1].textContent);
  });
  table.addEventListener("mouseleave", hideTip);
}
