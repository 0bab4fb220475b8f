// Microseconds per site against n as an SVG, three panels: construction, one by one, queries. Both
// axes are logarithmic.

const series = [
  { contender: "wasm", op: "build", name: "apollonius-diagram (wasm)", colour: "#d1495b" },
  { contender: "native", op: "build", name: "apollonius-diagram (native)", colour: "#edae49" },
  { contender: "cgal", op: "build", name: "CGAL hierarchy (native)", colour: "#00798c" },
  { contender: "delaunator", op: "build", name: "delaunator (points)", colour: "#6a4c93" },
  { contender: "flatbush", op: "build", name: "flatbush (points)", colour: "#66a182" },
  { contender: "d3-delaunay", op: "find", name: "d3-delaunay (points)", colour: "#8d6e63" },
];
const panels = [
  { title: "Construction, µs per site", op: "build" },
  { title: "Insertion one by one, µs per site", op: "insert" },
  { title: "Nearest site of a random point, µs", op: "find" },
];

const kWidth = 300;
const kHeight = 240;
const kLeft = 44;
const kTop = 34;
const kGap = 30;
const kLegend = 54;

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
const round = (value) => Math.round(value * 10) / 10;

/** The numbers of one panel: [{contender, points: [[n, us]...]}]. */
function lines(records, op) {
  return series
    .map((line) => ({
      ...line,
      points: records
        .filter(
          (record) =>
            record.part === "scaling" &&
            record.op === op &&
            record.contender === line.contender &&
            record.us > 0,
        )
        .map(({ n, us, fastest, slowest }) => ({ n, us, fastest, slowest }))
        .sort((a, b) => a.n - b.n),
    }))
    .filter(({ points }) => points.length > 0);
}

function ticks([low, high]) {
  const found = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
    for (const digit of [1, 2, 5]) {
      const value = digit * 10 ** power;
      if (value >= low / 1.001 && value <= high * 1.001) found.push(value);
    }
  }
  return found;
}

const label = (value) =>
  value >= 1e6
    ? `${value / 1e6} M`
    : value >= 1000
      ? `${value / 1000} k`
      : String(Number(value.toPrecision(2)));

function panel({ title, op }, records, index) {
  const drawn = lines(records, op);
  if (drawn.length === 0) return "";
  const all = drawn.flatMap(({ points }) => points);
  const ns = [Math.min(...all.map(({ n }) => n)), Math.max(...all.map(({ n }) => n))];
  const range = [
    Math.min(...all.map(({ us }) => us)) / 1.3,
    Math.max(...all.map(({ us }) => us)) * 1.3,
  ];
  const scale = (value, [low, high]) =>
    high === low ? 0.5 : Math.log(value / low) / Math.log(high / low);
  const x = (n) => round(kLeft + scale(n, ns) * kWidth);
  const y = (us) => round(kTop + (1 - scale(us, range)) * kHeight);
  const parts = [`<text x="${kLeft}" y="20" class="title">${escaped(title)}</text>`];
  for (const us of ticks(range)) {
    parts.push(
      `<path class="grid" d="M${kLeft},${y(us)}h${kWidth}"/>` +
        `<text x="${kLeft - 6}" y="${y(us) + 4}" text-anchor="end">${label(us)}</text>`,
    );
  }
  for (const n of ticks(ns).filter((value) => /^10*$/.test(String(value)))) {
    parts.push(
      `<path class="grid" d="M${x(n)},${kTop}v${kHeight}"/>` +
        `<text x="${x(n)}" y="${kTop + kHeight + 16}" text-anchor="middle">${label(n)}</text>`,
    );
  }
  for (const { points, colour } of drawn) {
    const path = points.map(({ n, us }, k) => `${k === 0 ? "M" : "L"}${x(n)},${y(us)}`).join("");
    parts.push(`<path d="${path}" fill="none" stroke="${colour}" stroke-width="2"/>`);
    for (const { n, us, fastest, slowest } of points) {
      const [top, bottom] = [Math.min(slowest, range[1]), Math.max(fastest, range[0])].map(y);
      parts.push(
        `<path d="M${x(n)},${top}V${bottom}" stroke="${colour}" opacity="0.4"/>` +
          `<circle cx="${x(n)}" cy="${y(us)}" r="3" fill="${colour}"/>`,
      );
    }
  }
  return `<g transform="translate(${index * (kWidth + kLeft + kGap)},0)">${parts.join("\n")}</g>`;
}

function legend(width) {
  const column = width / 3;
  return series
    .map(({ name, colour }, k) => {
      const [left, top] = [kLeft + (k % 3) * column, kTop + kHeight + 38 + Math.floor(k / 3) * 18];
      return (
        `<path d="M${round(left)},${top - 4}h18" stroke="${colour}" stroke-width="3"/>` +
        `<text x="${round(left + 24)}" y="${top}">${escaped(name)}</text>`
      );
    })
    .join("\n");
}

/** An SVG document; `caption` says on what machine. */
export function picture(records, caption) {
  const width = panels.length * (kWidth + kLeft + kGap);
  const height = kTop + kHeight + kLegend + 44;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}"
  width="${width}" height="${height}" font-family="sans-serif" font-size="11" fill="#333">
<style>.title { font-size: 13px; font-weight: bold } .grid { stroke: #ddd; fill: none }</style>
<rect width="${width}" height="${height}" fill="#fff"/>
${panels.map((each, k) => panel(each, records, k)).join("\n")}
${legend(width)}
<text x="${kLeft}" y="${height - 8}" fill="#777">${escaped(caption)}</text>
</svg>
`;
}
