// What the page imports and TypeScript finds no declarations of: as much as is used.
declare module "d3-dsv" {
  export function csvFormatRows(rows: readonly (readonly string[])[]): string;
  export function dsvFormat(separator: string): { parseRows(text: string): string[][] };
}
