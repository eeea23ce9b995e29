// A click on a heading sorts its table, each group of rows by itself; another click turns it round.
// Rows without a number stay last where others have one.
const valueOf = (row, column) => {
  const text = row.cells[column].textContent.trim();
  const times = [...text.matchAll(/([\d.]+) (h|min|s)\b/g)];
  const seconds = times.reduce((sum, [, number, unit]) => sum + number * {h: 3600, min: 60, s: 1}[unit], 0);
  return {text, number: times.length ? seconds : parseFloat(text)};
};
const order = (a, b, sign) => {
  if (isNaN(a.number) !== isNaN(b.number)) return isNaN(a.number) ? 1 : -1;
  return sign * (isNaN(a.number) ? a.text.localeCompare(b.text) : a.number - b.number);
};
for (const table of document.querySelectorAll("table")) {
  const headings = [...table.querySelectorAll("thead th")];
  headings.forEach((heading, column) => {
    const button = document.createElement("button");
    button.append(...heading.childNodes);
    heading.append(button);
    button.onclick = () => {
      const sign = heading.getAttribute("aria-sort") === "ascending" ? -1 : 1;
      for (const other of headings) other.removeAttribute("aria-sort");
      heading.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
      for (const body of table.tBodies)
        body.append(...[...body.rows].filter(row => row.querySelector("td"))
          .sort((a, b) => order(valueOf(a, column), valueOf(b, column), sign)));
    };
  });
}
