// What the page imports and TypeScript finds no declarations of: as much as is used.
declare module "d3-dsv" {
  export function csvFormatRows(rows: readonly (readonly string[])[]): string;
  export function dsvFormat(separator: string): { parseRows(text: string): string[][] };
}

declare module "d3-geo" {
  export function geoDistance(a: readonly number[], b: readonly number[]): number;
  export const geoEqualEarthRaw: {
    (lambda: number, phi: number): [number, number];
    invert(x: number, y: number): [number, number];
  };
}
