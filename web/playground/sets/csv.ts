// Tables of text: columns parted by commas, semicolons, tabs or spaces, with or without their names
// in the first row. Blank rows, and comments after "#", are passed over, but counted.
import { dsvFormat } from "d3-dsv";
import { type Cells, type Column, columnAt, isNumber, kColumns, type Table } from "./columns.js";

const kSeparators = ["\t", ";", ","];
const kUsual: Column[] = ["x", "y", "r", "name"];

const isComment = ([first]: string[]) => first.trimStart().startsWith("#");
const isBlank = (row: string[]) => row.every((cell) => cell.trim() === "");

/** The sign between columns, by the first line that has some; spaces, if nothing else is there. */
function separatorOf(text: string) {
  const line = text.split("\n").find((line) => line.trim() !== "" && !line.startsWith("#")) ?? "";
  const unquoted = line.replace(/"[^"]*"/g, "").trim();
  return kSeparators.find((sign) => unquoted.includes(sign)) ?? (/ /.test(unquoted) ? " " : ",");
}

/** "1,5" as "1.5". */
const withPoint = (cell: string) =>
  /^\s*[+-]?(\d+,\d*|,\d+)(e[+-]?\d+)?\s*$/i.test(cell) ? cell.replace(",", ".") : cell;

/** "1,234,567.8" as "1234567.8". */
const withoutGroups = (cell: string) =>
  /^\s*[+-]?\d{1,3}(,\d{3})+(\.\d*)?\s*$/.test(cell) ? cell.replaceAll(",", "") : cell;

export function tableOfCsv(text: string): Table {
  const separator = separatorOf(text);
  const hasDecimalCommas = separator !== ",";
  // parseRows, not parse, which would make code from a string
  const lines = dsvFormat(separator)
    .parseRows(separator === " " ? text.replace(/^ +| +$/gm, "").replace(/ +/g, " ") : text)
    .map((cells, k) => ({ at: `row ${k + 1}`, cells }))
    .filter(({ cells }) => !isBlank(cells));
  const first = lines.findIndex(({ cells }) => !isComment(cells));
  if (first < 0) throw new Error("there are only comments");
  const head = lines[first].cells;
  // "1,234" beside semicolons is 1.234; with commas between columns, as within quotes, it is 1234.
  const number = (cell: string) => withoutGroups(hasDecimalCommas ? withPoint(cell) : cell);
  const isHead = head.slice(0, 2).some((cell) => cell.trim() !== "" && !isNumber(number(cell)));
  const places = isHead ? placesIn(head, lines[first].at) : new Map(kUsual.map((c, k) => [c, k]));
  const place = (column: Column) => places.get(column) ?? -1;
  const isData = (cells: string[]) =>
    // A first column of names may have a name such as "#1".
    !isComment(cells) || (place("name") === 0 && Boolean(cells[place("x")]?.trim()));
  const rows = lines
    .slice(isHead ? first + 1 : first)
    .filter(({ cells }) => isData(cells))
    .map(({ at, cells }): Cells => {
      const values: Cells["values"] = {};
      for (const [column, k] of places) {
        const isText = column === "name" || column === "detail";
        values[column] = isText ? cells[k] : number(cells[k] ?? "");
      }
      return { at, values };
    });
  const called = Object.fromEntries(
    Array.from(places, ([column, k]) => [column, isHead ? head[k].trim() : column]),
  );
  return { rows, called };
}

/** Which columns are where. */
function placesIn(head: string[], at: string) {
  const places = new Map(
    kColumns.map((column) => [column, columnAt(column, head)] as const).filter(([, k]) => k >= 0),
  );
  if (places.has("x") && places.has("y")) return places;
  const names = head.map((name) => `“${name.trim()}”`).join(", ");
  throw new Error(`${at} has no columns x and y, but ${names}`);
}
